//! Twelve numbers for each of many places, added up in two ways: every number adds itself to its place, by
//! atomics, or every place gathers its numbers, in their order. How long does it take, and do two runs give the
//! same bits? From the page on own rows.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example atomics -- [PLACES]`

use std::time::{Duration, Instant};

use ch00_scenes::random::SplitMix64;
use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, StreamError, Timer, behind_needs};

/// Numbers for each place.
const EACH: usize = 12;
/// How often each way is gone, of which the first isn't counted.
const TIMES: usize = 6;

const SHADER: &str = "// Needs common/index.
// ANCHOR: shader
@group(0) @binding(0) var<storage, read> numbers: array<f32>;
// Where each number belongs, and where the numbers of each place are.
@group(0) @binding(1) var<storage, read> places: array<u32>;
@group(0) @binding(2) var<storage, read> lists: array<u32>;
@group(0) @binding(3) var<storage, read_write> sums: array<f32>;
@group(0) @binding(4) var<storage, read_write> shared_sums: array<atomic<u32>>;

@compute @workgroup_size(WORKGROUP)
fn gather(@builtin(global_invocation_id) id: vec3u) {
    let place = row_index(id);
    if place >= arrayLength(&sums) { return; }
    var sum = 0.0;
    for (var k = 0u; k < EACH; k++) { sum += numbers[lists[EACH * place + k]]; }
    sums[place] = sum;
}

// WGSL has no atomic sum of f32: read, add, and write if nobody else has written meanwhile.
@compute @workgroup_size(WORKGROUP)
fn add(@builtin(global_invocation_id) id: vec3u) {
    let n = row_index(id);
    if n >= arrayLength(&numbers) { return; }
    let sum = &shared_sums[places[n]];
    var seen = atomicLoad(sum);
    for (var tries = 0u; tries < 1000000u; tries++) {
        let wanted = bitcast<u32>(bitcast<f32>(seen) + numbers[n]);
        let found = atomicCompareExchangeWeak(sum, seen, wanted);
        if found.exchanged { return; }
        seen = found.old_value;
    }
}
// ANCHOR_END: shader
";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let places: usize = std::env::args()
        .nth(1)
        .map_or(Ok(100_000), |count| count.parse())?;
    let gpu = Gpu::open()?;
    println!("{}: {EACH} numbers for each of {places} places", gpu.name);
    let columns = columns(&gpu, places)?;
    let text = SHADER.replace("EACH", &format!("{EACH}u"));
    for (entry, column, rows) in [
        ("add", "shared_sums", EACH * places),
        ("gather", "sums", places),
    ] {
        let kernel = Kernel::new(&gpu, entry, &behind_needs(&text)?, entry, &[])?;
        let (time, [one, other]) = measured(&columns, &kernel, column, rows)?;
        let differ = one
            .iter()
            .zip(&other)
            .filter(|(one, other)| one != other)
            .count();
        println!(
            "{entry:<7}{:>9.3} ms; of {places} sums of two runs {differ} differ",
            1e3 * time.as_secs_f64()
        );
    }
    Ok(())
}

/// Numbers of all sizes, in no order, and where they belong.
fn columns(gpu: &Gpu, places: usize) -> Result<Columns, StreamError> {
    let mut random = SplitMix64::new(12);
    let count = EACH * places;
    let numbers: Vec<f32> = (0..count)
        .map(|_| random.between(-1.0, 1.0) as f32)
        .collect();
    // The numbers of a place stand far from each other, as contacts of a body do that were found one by one.
    let place_of: Vec<u32> = (0..count).map(|n| (n % places) as u32).collect();
    let lists = (0..places).flat_map(|place| (0..EACH).map(move |k| (k * places + place) as u32));
    let mut columns = Columns::new(gpu);
    columns.add::<f32>("numbers", count)?;
    columns.add::<u32>("places", count)?;
    columns.add::<u32>("lists", count)?;
    columns.add::<f32>("sums", places)?;
    columns.add::<u32>("shared_sums", places)?;
    columns.set_rows("sums", places)?;
    columns.set_rows("shared_sums", places)?;
    columns.write("numbers", &numbers)?;
    columns.write("places", &place_of)?;
    columns.write("lists", &lists.collect::<Vec<_>>())?;
    Ok(columns)
}

/// The median time of a kernel, and the bits of the sums of its last two runs.
fn measured(
    columns: &Columns,
    kernel: &Kernel,
    sums: &str,
    rows: usize,
) -> Result<(Duration, [Vec<u32>; 2]), StreamError> {
    let mut timer = Timer::new(columns.gpu(), 1);
    let mut times = Vec::new();
    let mut found = [Vec::new(), Vec::new()];
    for _ in 0..TIMES {
        columns.clear(sums)?;
        let mut passes = Passes::timed(columns, &mut timer);
        passes.section("sums");
        passes.run(kernel, rows)?;
        let start = Instant::now();
        passes.submit()?;
        columns.gpu().wait()?;
        let by_device = timer.latest(columns.gpu()).map(|times| times[0].1);
        times.push(by_device.unwrap_or(start.elapsed()));
        found.swap(0, 1);
        found[1] = columns.read(sums)?;
    }
    times.remove(0);
    times.sort_unstable();
    Ok((times[times.len() / 2], found))
}
