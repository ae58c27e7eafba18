//! What a round trip to the GPU costs every frame, and from how many bodies on it is worth it: chapter 5's
//! integration on the CPU, and the same with upload, kernels and download.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example round_trip -- [--counts N,N,…]
//! [--boxes] [--csv FILE] [--from FILE]`
//!
//! Times are medians, ms a frame. The parts are measured in frames of their own, with a wait after each, so
//! together they take longer than the whole. `--from` measures nothing, and tells what a file of `--csv`
//! holds.

use std::fs;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use ch00_scenes::random::SplitMix64;
use ch01_hierarchy::styles::report::{processor, thousands};
use ch05_properties::columns::Table;
use ch05_properties::data::{Bodies, Body};
use ch05_properties::systems::Pull;
use ch05_properties::systems::advance::{self, Step};
use ch06_compute::round_trip::{Parts, RoundTrip};
use ch06_compute::stream::Gpu;
use glam::{Quat, Vec3};

type Problem = Box<dyn std::error::Error>;

const GRAVITY: Vec3 = Vec3::new(0.0, -9.81, 0.0);
const STEP: Step = Step {
    dt: 1.0 / 60.0,
    dt_last: 1.0 / 60.0,
    kept: 1.0,
};
/// What each measurement lasts at least.
const SHORTEST: Duration = Duration::from_millis(500);
/// Frames that each measurement has at least, after one that isn't counted.
const FEWEST: usize = 7;

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
    let options = Options::of(std::env::args().skip(1))?;
    if let Some(file) = options.from {
        return tell(&fs::read_to_string(file)?);
    }
    let gpu = Gpu::open()?;
    println!("{}; {}, one thread", gpu.name, machine());
    println!("{HEADER}");
    let mut lines = Vec::new();
    for &count in &options.counts {
        let line = Line::measured(&gpu, count, options.boxes)?;
        println!("{}", line.text());
        lines.push(line);
    }
    println!("{}", crossover(&lines));
    if let Some(file) = options.csv {
        fs::write(file, csv(&gpu, &lines))?;
    }
    Ok(())
}

/// Tells what a file holds.
fn tell(file: &str) -> Result<(), Problem> {
    let mut lines = Vec::new();
    for line in file.lines().skip(1) {
        // The two names stand in quotes, as they may have commas in them.
        let parts: Vec<&str> = line.splitn(5, '"').collect();
        let ["", gpu, ",", cpu, values] = parts[..] else {
            return Err(format!("`{line}` does not begin with two names in quotes").into());
        };
        if lines.is_empty() {
            println!("{gpu}; {cpu}, one thread\n{HEADER}");
        }
        let values: Vec<&str> = values.split(',').skip(1).collect();
        let line = Line::read(&values)?;
        println!("{}", line.text());
        lines.push(line);
    }
    println!("{}", crossover(&lines));
    Ok(())
}

/// What the command line says.
struct Options {
    counts: Vec<usize>,
    boxes: bool,
    csv: Option<String>,
    from: Option<String>,
}

impl Options {
    fn of(mut arguments: impl Iterator<Item = String>) -> Result<Self, Problem> {
        let powers = (3..6).map(|power| 10_usize.pow(power));
        let steps = powers.flat_map(|power| [power, 2 * power, 5 * power]);
        let mut options = Self {
            counts: steps.chain([1_000_000]).collect(),
            boxes: false,
            csv: None,
            from: None,
        };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--counts" => {
                    let counts = value()?;
                    let counts = counts.split(',').map(str::parse);
                    options.counts = counts.collect::<Result<_, _>>()?;
                }
                "--csv" => options.csv = Some(value()?),
                "--from" => options.from = Some(value()?),
                "--boxes" => options.boxes = true,
                _ => {
                    return Err(format!(
                        "`{argument}` is none of --counts, --boxes, --csv, --from"
                    )
                    .into());
                }
            }
        }
        Ok(options)
    }
}

/// What was measured for one number of bodies.
struct Line {
    count: usize,
    properties: f64,
    round_trip: f64,
    parts: [f64; 3],
    /// By the GPU's clock; not a number where it has none.
    kernels: f64,
    bytes: usize,
}

const HEADER: &str =
    "     bodies      ch05   round trip   upload  compute  download   kernels alone   (ms a frame)";

impl Line {
    fn measured(gpu: &Gpu, count: usize, boxes: bool) -> Result<Self, Problem> {
        let mut bodies = bodies(count, boxes);
        let mut trip = RoundTrip::new(gpu, &bodies)?;
        let round_trip = frames(|| {
            let start = Instant::now();
            trip.step(&mut bodies, GRAVITY, STEP)?;
            Ok(milliseconds(start.elapsed()))
        })?;
        let parts = frames(|| Ok(trip.step_in_parts(&mut bodies, GRAVITY, STEP)?))?;
        let properties = frames(|| {
            let start = Instant::now();
            advance(&mut bodies);
            Ok(milliseconds(start.elapsed()))
        })?;
        let part = |of: fn(&Parts) -> Duration| median(parts.iter().map(of).map(milliseconds));
        let kernels = parts.iter().filter_map(|parts| parts.kernels);
        Ok(Self {
            count,
            properties: median(properties.into_iter()),
            round_trip: median(round_trip.into_iter()),
            parts: [
                part(|parts| parts.upload),
                part(|parts| parts.compute),
                part(|parts| parts.download),
            ],
            kernels: median(kernels.map(milliseconds)),
            bytes: trip.bytes_a_body(),
        })
    }

    /// The values of a line of a file, behind the names.
    fn read(values: &[&str]) -> Result<Self, Problem> {
        let [
            count,
            bytes,
            properties,
            round_trip,
            up,
            compute,
            down,
            kernels,
        ] = values
        else {
            return Err("a line has other values than `--csv` writes".into());
        };
        Ok(Self {
            count: count.parse()?,
            properties: properties.parse()?,
            round_trip: round_trip.parse()?,
            parts: [up.parse()?, compute.parse()?, down.parse()?],
            kernels: kernels.parse()?,
            bytes: bytes.parse()?,
        })
    }

    fn text(&self) -> String {
        let sum: f64 = self.parts.iter().sum();
        let [up, compute, down] = self.parts.map(|part| 100.0 * part / sum);
        format!(
            "{:>11}{:>10.3}{:>13.3}{up:>7.0} %{compute:>7.0} %{down:>8.0} %{:>16.3}",
            thousands(self.count),
            self.properties,
            self.round_trip,
            self.kernels
        )
    }
}

/// Bodies that fly and turn.
fn bodies(count: usize, boxes: bool) -> Bodies {
    let mut random = SplitMix64::new(6);
    let mut number = || 2.0 * random.unit() as f32 - 1.0;
    let mut bodies = Bodies::default();
    let inertia = if boxes {
        Vec3::new(0.2, 0.3, 0.4)
    } else {
        Vec3::splat(0.4)
    };
    for _ in 0..count {
        let position = 10.0 * Vec3::new(number(), number(), number());
        let orientation = Quat::from_xyzw(number(), number(), number(), 2.0).normalize();
        let turn = Quat::from_xyzw(0.02 * number(), 0.02 * number(), 0.02 * number(), 1.0);
        bodies.push(Body {
            position,
            last_position: position - STEP.dt * Vec3::new(number(), number(), number()),
            orientation,
            last_orientation: (turn * orientation).normalize(),
            inverse_mass: 1.0,
            inertia,
            inverse_inertia: inertia.recip(),
            ..Body::default()
        });
    }
    bodies
}

/// Chapter 5's way.
fn advance(bodies: &mut Bodies) {
    advance::positions(
        &mut bodies.position,
        &mut bodies.last_position,
        &bodies.inverse_mass,
        Pull::Gravity(GRAVITY),
        STEP,
    );
    advance::orientations(
        &mut bodies.orientation,
        &mut bodies.last_orientation,
        &bodies.inertia,
        &bodies.inverse_inertia,
        &[],
        &bodies.inverse_mass,
        STEP,
    );
}

/// What a frame gives, again and again.
fn frames<T>(mut frame: impl FnMut() -> Result<T, Problem>) -> Result<Vec<T>, Problem> {
    frame()?;
    let start = Instant::now();
    let mut found = Vec::new();
    while found.len() < FEWEST || start.elapsed() < SHORTEST {
        found.push(frame()?);
    }
    Ok(found)
}

/// The processor's name, or its kind where nobody tells it.
fn machine() -> String {
    processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}

/// Not a number if there are none.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

fn milliseconds(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}

/// From how many bodies on the round trip takes less time than chapter 5, between two lines.
fn crossover(lines: &[Line]) -> String {
    let gain = |line: &Line| (line.properties / line.round_trip).ln();
    let found = lines
        .windows(2)
        .find(|pair| gain(&pair[0]) < 0.0 && gain(&pair[1]) >= 0.0);
    match (found, lines.first(), lines.last()) {
        (Some(pair), ..) => {
            let [before, after] = [&pair[0], &pair[1]].map(gain);
            let [few, many] = [&pair[0], &pair[1]].map(|line| (line.count as f64).ln());
            let count = (few - before * (many - few) / (after - before)).exp();
            format!(
                "The round trip is faster from about {} bodies on.",
                thousands(count as usize)
            )
        }
        (None, Some(first), _) if gain(first) >= 0.0 => {
            format!(
                "The round trip is faster from {} bodies on, or fewer.",
                thousands(first.count)
            )
        }
        (None, _, Some(last)) => {
            format!(
                "The round trip isn't faster up to {} bodies.",
                thousands(last.count)
            )
        }
        _ => "Nothing was measured.".to_owned(),
    }
}

/// The same for a file; the device's name in every line.
fn csv(gpu: &Gpu, lines: &[Line]) -> String {
    let names = "device,processor,bodies,bytes_a_body,ch05_ms,round_trip_ms,upload_ms,compute_ms,\
                 download_ms,kernels_ms\n";
    let machines = format!("\"{}\",\"{}\"", gpu.name, machine());
    let lines = lines.iter().map(|line| {
        let [up, compute, down] = line.parts;
        format!(
            "{machines},{},{},{:.4},{:.4},{up:.4},{compute:.4},{down:.4},{:.4}\n",
            line.count, line.bytes, line.properties, line.round_trip, line.kernels
        )
    });
    let lines: Vec<String> = lines.collect();
    names.to_owned() + &lines.concat()
}
