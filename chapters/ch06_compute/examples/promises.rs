//! What WGSL leaves to the device, and what this device makes of it: whether a product and a sum are
//! rounded once or twice, how good sine and arc tangent are beside ours, and whether a comparison finds
//! what isn't a number. The answer to an exercise of the page on kernels.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example promises`

use std::f64::consts::PI;

use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, StreamError, behind_needs};
use glam::Vec4;

/// How many values each question is asked with.
const VALUES: usize = 10_000;

fn main() -> Result<(), StreamError> {
    let gpu = Gpu::open()?;
    println!("{}", gpu.name);
    fused(&gpu)?;
    println!("largest error            built in        ours");
    sines(&gpu, PI)?;
    sines(&gpu, 1000.0)?;
    arc_tangents(&gpu)?;
    not_numbers(&gpu)
}

// ANCHOR: by_wgsl
/// What a WGSL expression over `x` makes of each value.
fn by_wgsl(gpu: &Gpu, expression: &str, values: &[Vec4]) -> Result<Vec<Vec4>, StreamError> {
    let shader = format!(
        "// Needs common/index, common/trigonometry, rows, common/grid.
        @group(0) @binding(0) var<storage, read_write> values: array<vec4f>;
        @compute @workgroup_size(WORKGROUP)
        fn main(@builtin(global_invocation_id) id: vec3u) {{
            let row = row_index(id);
            if row >= arrayLength(&values) {{ return; }}
            let x = values[row];
            values[row] = {expression};
        }}"
    );
    let mut columns = Columns::new(gpu);
    columns.add::<Vec4>("values", values.len())?;
    columns.write("values", values)?;
    let kernel = Kernel::new(gpu, "main", &behind_needs(&shader)?, "main", &[])?;
    let mut passes = Passes::new(&columns);
    passes.run(&kernel, values.len())?;
    passes.submit()?;
    columns.read("values")
}
// ANCHOR_END: by_wgsl

// ANCHOR: fused
/// x y − z, where z is the product as it is rounded here: 0 if the device rounds the product too, and
/// what rounding left if it rounds only once.
fn fused(gpu: &Gpu) -> Result<(), StreamError> {
    let values: Vec<Vec4> = (1..=VALUES)
        .map(|n| {
            let (x, y) = (1.0 + n as f32 * 1e-4, 1.0 + n as f32 * 3e-5);
            Vec4::new(x, y, x * y, 0.0)
        })
        .collect();
    let found = by_wgsl(gpu, "vec4f(x.x * x.y - x.z)", &values)?;
    let once = found.iter().filter(|found| found.x != 0.0).count();
    println!("x y - z rounded once: {once} of {VALUES}");
    Ok(())
}
// ANCHOR_END: fused

/// Sines of angles up to `most`, rad.
fn sines(gpu: &Gpu, most: f64) -> Result<(), StreamError> {
    let angle = |n: usize| (most * (2.0 * n as f64 / VALUES as f64 - 1.0)) as f32;
    let values: Vec<Vec4> = (0..VALUES).map(|n| Vec4::splat(angle(n))).collect();
    let found = by_wgsl(gpu, "vec4f(sin(x.x), sine(x.x), 0.0, 0.0)", &values)?;
    let exact = |value: &Vec4| f64::from(value.x).sin();
    tell(&format!("sine up to {most:.0} rad"), &values, &found, exact);
    Ok(())
}

fn arc_tangents(gpu: &Gpu) -> Result<(), StreamError> {
    let point = |n: usize| {
        let angle = 2.0 * PI * (n as f64 + 0.5) / VALUES as f64 - PI;
        Vec4::new(angle.sin() as f32, angle.cos() as f32, 0.0, 0.0)
    };
    let values: Vec<Vec4> = (0..VALUES).map(point).collect();
    let found = by_wgsl(
        gpu,
        "vec4f(atan2(x.x, x.y), arc_tangent_of(x.x, x.y), 0.0, 0.0)",
        &values,
    )?;
    let exact = |value: &Vec4| f64::from(value.x).atan2(f64::from(value.y));
    tell("angle of a point, rad", &values, &found, exact);
    Ok(())
}

/// The largest errors of x and of y.
fn tell(what: &str, values: &[Vec4], found: &[Vec4], exact: impl Fn(&Vec4) -> f64) {
    let most = |part: fn(&Vec4) -> f32| {
        let errors = values.iter().zip(found);
        let errors = errors.map(|(value, found)| (f64::from(part(found)) - exact(value)).abs());
        errors.fold(0.0, f64::max)
    };
    println!(
        "{what:<21}{:>12.1e}{:>12.1e}",
        most(|found| found.x),
        most(|found| found.y)
    );
}

// ANCHOR: not_numbers
/// One value in a hundred is no number. Who finds them?
fn not_numbers(gpu: &Gpu) -> Result<(), StreamError> {
    let value = |n: usize| {
        if n.is_multiple_of(100) {
            f32::NAN
        } else {
            n as f32
        }
    };
    let values: Vec<Vec4> = (0..VALUES).map(|n| Vec4::splat(value(n))).collect();
    let by_comparing = "select(0.0, 1.0, x.x != x.x)";
    let by_bits = "select(1.0, 0.0, is_finite(x.x))";
    let expression = format!("vec4f({by_comparing}, {by_bits}, 0.0, 0.0)");
    let found = by_wgsl(gpu, &expression, &values)?;
    let count = |part: fn(&Vec4) -> f32| found.iter().filter(|found| part(found) == 1.0).count();
    println!(
        "of {} that are no numbers x != x finds {}, the bits {}",
        VALUES / 100,
        count(|found| found.x),
        count(|found| found.y)
    );
    Ok(())
}
// ANCHOR_END: not_numbers
