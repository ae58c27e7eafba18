//! What passes, bytes and waiting cost on this device.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example gpu_costs -- [--rows N] [--csv FILE]
//! [--from FILE]`
//!
//! Each time is the median of seven, by the device's own clock where it has one. Rows are 16 bytes.
//! `--from` measures nothing, and tells what a file of `--csv` holds.

use std::fmt::Write as _;
use std::fs;
use std::process::ExitCode;
use std::time::Instant;

use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, Timer, behind_needs};
use glam::Vec4;

type Problem = Box<dyn std::error::Error>;

/// Passes in a chain, each of which needs the one before.
const CHAIN: usize = 1000;
/// How often each thing is done, of which the first isn't counted.
const TIMES: usize = 8;
/// Steps of the walk from number to number.
const WALK: usize = 4096;

/// All kernels. Each writes its own rows.
const SHADER: &str = "// Needs common/index.
@group(0) @binding(0) var<storage, read> here: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> there: array<vec4f>;
@group(0) @binding(2) var<storage, read> order: array<u32>;
@group(0) @binding(3) var<storage, read_write> number: array<u32>;

// One number, and no more.
@compute @workgroup_size(WORKGROUP)
fn count(@builtin(global_invocation_id) id: vec3u) {
    if row_index(id) == 0u { number[0] += 1u; }
}

@compute @workgroup_size(WORKGROUP)
fn copy(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row < arrayLength(&here) { there[row] = here[row]; }
}

@compute @workgroup_size(WORKGROUP)
fn gather(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row < arrayLength(&here) { there[row] = here[order[row]]; }
}

// Each number says where the next one is, so that none can be asked for before the last has come. A walk
// goes on where the last one ended.
@compute @workgroup_size(1)
fn walk() {
    var place = number[0];
    for (var n = 0u; n < STEPS; n++) { place = order[place]; }
    number[0] = place;
}
";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Problem> {
    let (mut rows, mut csv) = (1_usize << 22, None);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let value = words.next().ok_or(format!("{word} needs a value"))?;
        match word.as_str() {
            "--rows" => rows = value.parse::<usize>()?.next_power_of_two(),
            "--csv" => csv = Some(value),
            "--from" => return tell(&fs::read_to_string(value)?),
            _ => return Err(format!("`{word}` is none of --rows, --csv, --from").into()),
        }
    }
    let mut costs = Costs::on(Gpu::open()?, rows)?;
    costs.passes()?;
    costs.workgroups()?;
    costs.reserved()?;
    costs.orders()?;
    costs.walks()?;
    if let Some(file) = csv {
        fs::write(file, costs.csv)?;
    }
    Ok(())
}

/// Tells what a file holds.
fn tell(file: &str) -> Result<(), Problem> {
    for (number, line) in file.lines().skip(1).enumerate() {
        let parts: Vec<&str> = line.splitn(3, '"').collect();
        let ["", device, rest] = parts[..] else {
            return Err(format!("`{line}` does not begin with a name in quotes").into());
        };
        let ["", what, how, value, unit] = rest.split(',').collect::<Vec<_>>()[..] else {
            return Err(format!("`{line}` has other values than `--csv` writes").into());
        };
        if number == 0 {
            println!("{device}");
        }
        println!("{}", text(what, how, value.parse()?, unit));
    }
    Ok(())
}

fn text(what: &str, how: &str, value: f64, unit: &str) -> String {
    format!("{what:<25}{how:<26}{value:>9.1} {unit}")
}

struct Costs {
    gpu: Gpu,
    columns: Columns,
    timer: Timer,
    rows: usize,
    csv: String,
}

impl Costs {
    fn on(gpu: Gpu, rows: usize) -> Result<Self, Problem> {
        let mut columns = Columns::new(&gpu);
        columns.add::<Vec4>("here", rows)?;
        columns.add::<Vec4>("there", rows)?;
        columns.add::<u32>("order", rows)?;
        columns.add::<u32>("number", 1)?;
        let timer = Timer::new(&gpu, 2);
        println!("{}", gpu.name);
        Ok(Self {
            gpu,
            columns,
            timer,
            rows,
            csv: "device,what,how,value,unit\n".to_owned(),
        })
    }

    // ANCHOR: passes
    /// What it costs to wait for the pass before: a long chain of passes with next to nothing to do.
    fn passes(&mut self) -> Result<(), Problem> {
        let count = self.kernel("count", "", 64)?;
        for groups in [1, 1024] {
            let rows = groups * count.workgroup() as usize;
            let time = self.time(|passes| {
                for _ in 0..CHAIN {
                    passes.run(&count, rows)?;
                }
                Ok(())
            })?;
            let how = format!("{groups} workgroups");
            self.say("a pass in a chain", &how, 1e6 * time / CHAIN as f64, "µs");
        }
        Ok(())
    }
    // ANCHOR_END: passes

    /// Copying by workgroups of different sizes.
    fn workgroups(&mut self) -> Result<(), Problem> {
        for size in [1, 4, 16, 32, 64, 128, 256] {
            let copy = self.kernel("copy", "", size)?;
            let how = format!("workgroups of {size}");
            self.moved("copied", &how, &copy, 32)?;
        }
        Ok(())
    }

    // ANCHOR: reserved
    /// Copying while each workgroup reserves memory that it shares, so that fewer fit beside each other.
    fn reserved(&mut self) -> Result<(), Problem> {
        let most = self.gpu.limits.max_compute_workgroup_storage_size as usize / 1024;
        for kib in [1, 4, 8, 16, 24, 32, 48]
            .into_iter()
            .filter(|&kib| kib <= most)
        {
            let text = format!(
                "var<workgroup> hold: array<u32, {}>;
                @compute @workgroup_size(WORKGROUP)
                fn holding(
                    @builtin(global_invocation_id) id: vec3u,
                    @builtin(local_invocation_index) lane: u32,
                ) {{
                    let row = row_index(id);
                    hold[lane] = row;
                    workgroupBarrier();
                    let own = hold[lane ^ 1u] ^ 1u;
                    if own < arrayLength(&here) {{ there[own] = here[own]; }}
                }}",
                kib * 256
            );
            let copy = self.kernel("holding", &text, 64)?;
            let how = format!("{kib} KiB a workgroup of 64");
            self.moved("copied", &how, &copy, 32)?;
        }
        Ok(())
    }
    // ANCHOR_END: reserved

    /// Rows fetched in their order, in disorder near by, and from anywhere.
    fn orders(&mut self) -> Result<(), Problem> {
        let gather = self.kernel("gather", "", 64)?;
        for (how, reach) in [
            ("in order", 1),
            ("within 1024 rows", 1024),
            ("anywhere", self.rows),
        ] {
            let order: Vec<u32> = (0..self.rows).map(|row| scattered(row, reach)).collect();
            self.columns.write("order", &order)?;
            self.moved("gathered", how, &gather, 36)?;
        }
        Ok(())
    }

    /// A walk of one invocation from number to number, through tables of different sizes. A copy of all rows
    /// before it takes the place of what caches still hold.
    fn walks(&mut self) -> Result<(), Problem> {
        let walk = self.kernel("walk", "", 1)?;
        let copy = self.kernel("copy", "", 256)?;
        let most = self.rows;
        let sizes = [12, 16, 20, 24, 26].map(|power| 1_usize << power);
        for size in sizes.into_iter().filter(|&size| size <= most) {
            // An odd stride comes by every number before it comes back.
            let stride = (size as f64 * 0.618) as usize | 1;
            let order: Vec<u32> = (0..size).map(|n| ((n + stride) % size) as u32).collect();
            self.columns.write_at("order", 0, &order)?;
            self.columns.write_at("number", 0, &[0_u32])?;
            let rows = self.rows;
            let time = self.time(|passes| {
                passes.section("before");
                passes.run(&copy, rows)?;
                passes.section("all");
                Ok(passes.run_workgroups(&walk, 1)?)
            })?;
            let how = format!("a table of {} KiB", size / 256);
            self.say(
                "a number after the other",
                &how,
                1e9 * time / WALK as f64,
                "ns",
            );
        }
        Ok(())
    }

    fn kernel(&self, entry: &'static str, more: &str, workgroup: u32) -> Result<Kernel, Problem> {
        let text = SHADER.replace("STEPS", &format!("{WALK}u")) + more;
        let constants = [("WORKGROUP", f64::from(workgroup))];
        Ok(Kernel::new(
            &self.gpu,
            entry,
            &behind_needs(&text)?,
            entry,
            &constants,
        )?)
    }

    /// Runs a kernel over all rows, and says how many bytes a second that moved.
    fn moved(
        &mut self,
        what: &str,
        how: &str,
        kernel: &Kernel,
        row_bytes: usize,
    ) -> Result<(), Problem> {
        let rows = self.rows;
        let time = self.time(|passes| Ok(passes.run(kernel, rows)?))?;
        self.say(what, how, 1e-9 * (row_bytes * rows) as f64 / time, "GB/s");
        Ok(())
    }

    /// How long passes take, s.
    fn time(
        &mut self,
        record: impl Fn(&mut Passes<'_>) -> Result<(), Problem>,
    ) -> Result<f64, Problem> {
        let mut times = Vec::new();
        for _ in 0..TIMES {
            let mut passes = Passes::timed(&self.columns, &mut self.timer);
            passes.section("all");
            record(&mut passes)?;
            let start = Instant::now();
            passes.submit()?;
            self.gpu.wait()?;
            let seen = start.elapsed();
            let by_device = self.timer.latest(&self.gpu);
            let all =
                by_device.and_then(|times| times.into_iter().find(|(name, _)| *name == "all"));
            times.push(all.map_or(seen, |(_, time)| time).as_secs_f64());
        }
        times.remove(0);
        times.sort_by(f64::total_cmp);
        Ok(times[times.len() / 2])
    }

    fn say(&mut self, what: &str, how: &str, value: f64, unit: &str) {
        println!("{}", text(what, how, value, unit));
        let _ = writeln!(
            self.csv,
            "\"{}\",{what},{how},{value:.3},{unit}",
            self.gpu.name
        );
    }
}

/// A row at most `reach`, a power of two, away from this one; each row is that of one other.
fn scattered(row: usize, reach: usize) -> u32 {
    let within = row & (reach - 1);
    // An odd factor makes every number of every other one.
    let other = within.wrapping_mul(0x9e37_79b1) & (reach - 1);
    (row - within + other) as u32
}
