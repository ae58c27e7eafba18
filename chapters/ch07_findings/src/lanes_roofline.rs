//! How near to what a thread can do the passes of engine `lanes` come: drawn from a table that is kept in the
//! book, as times on a machine that does other work, too, are no use beside each other.

use std::fmt::Write as _;

use crate::FindingsError;
use crate::chart::{Axis, Chart, Series, Style};
use crate::draw;
use crate::kept::{Kept, Line, Source};
use crate::product::{Product, Say};
use crate::table::{Table, percent, three_digits};

/// The kept table.
const SOURCE: Source = Source {
    file: "ch06_roofline.csv",
    command: "cargo run --release -p ch06_compute --no-default-features --example roofline -- --csv FILE",
};
/// What a line of a ceiling has as its scene.
const MACHINE: &str = "machine";
/// What a line of the roof's flat part is.
const PEAK: &str = "multiply and add";
/// What lines of its slopes begin with.
const COPY: &str = "copy ";
/// The scenes, with their pictures.
const SCENES: [(&str, &str); 2] = [
    ("pile", "lanes_roofline"),
    ("ragdolls", "lanes_roofline_ragdolls"),
];
/// The passes, each with its looks.
const PASSES: [(&str, Style); 6] = [
    ("pairs", Style::Marks(0)),
    ("limits", Style::Marks(1)),
    ("gather", Style::Marks(2)),
    ("bodies", Style::Marks(3)),
    ("exchange", Style::Marks(4)),
    ("trees", Style::Corrected),
];
/// Slopes that are no further apart than by this factor have one note.
const ALIKE: f64 = 1.25;
/// Ends of the roof, operations a byte.
const ENDS: [f64; 2] = [0.1, 100.0];

/// A pass of a scene, or a ceiling.
#[derive(Clone, Debug, PartialEq)]
struct Sample {
    processor: String,
    instructions: String,
    scene: String,
    bodies: u64,
    what: String,
    /// µs a step.
    us: f64,
    /// Read and written.
    bytes: f64,
    /// Operations in all lanes.
    done: f64,
    /// Without those of idle lanes.
    needed: f64,
}

/// Lays out pictures, CSV and page; nothing is measured.
///
/// # Errors
/// [`FindingsError::Kept`] where the table is missing or can't be read.
pub fn product(_quick: bool, say: Say) -> Result<Product, FindingsError> {
    SOURCE.drawn(say, drawn)
}

fn drawn(kept: &Kept) -> Result<Product, FindingsError> {
    let samples = kept.samples(Sample::of)?;
    let charts = SCENES.map(|(scene, name)| chart(&samples, scene, name).into());
    Ok(Product {
        charts: charts.to_vec(),
        csv: csv(&samples),
        page: Some(page(&samples, &kept.origin())),
    })
}

impl Sample {
    fn of(line: Line) -> Result<Self, FindingsError> {
        line.one_of("scene", &[MACHINE, SCENES[0].0, SCENES[1].0])?;
        Ok(Self {
            processor: line.text("processor")?.to_owned(),
            instructions: line.text("instructions")?.to_owned(),
            scene: line.text("scene")?.to_owned(),
            bodies: line.number("bodies")?,
            what: line.text("what")?.to_owned(),
            us: line.positive("us_a_step")?,
            bytes: line.number("bytes")?,
            done: line.number("done")?,
            needed: line.number("needed")?,
        })
    }

    /// Operations a byte.
    fn intensity(&self) -> f64 {
        self.done / self.bytes
    }

    /// 10⁹ operations a second.
    fn speed(&self) -> f64 {
        1e-3 * self.done / self.us
    }

    /// GB/s.
    fn bandwidth(&self) -> f64 {
        1e-3 * self.bytes / self.us
    }
}

/// The instructions of the first line: those of which the charts are drawn.
fn first(samples: &[Sample]) -> &str {
    samples
        .first()
        .map_or("", |sample| sample.instructions.as_str())
}

/// What was measured of the machine, or of a scene.
fn of<'a>(
    samples: &'a [Sample],
    instructions: &'a str,
    scene: &'a str,
) -> impl Iterator<Item = &'a Sample> {
    let is_of = move |s: &&Sample| s.instructions == instructions && s.scene == scene;
    samples.iter().filter(is_of)
}

/// 10⁹ multiplications and additions a second.
fn peak(samples: &[Sample], instructions: &str) -> f64 {
    let mut ceilings = of(samples, instructions, MACHINE);
    let found = ceilings.find(|sample| sample.what == PEAK);
    found.map_or(f64::NAN, Sample::speed)
}

fn chart(samples: &[Sample], scene: &str, name: &'static str) -> Chart {
    let built = first(samples);
    let peak = peak(samples, built);
    let mut series = Vec::new();
    for (pass, style) in PASSES {
        let found = of(samples, built, scene).filter(|sample| sample.what == pass);
        let points: Vec<_> = found.map(|s| (s.intensity(), s.speed())).collect();
        if !points.is_empty() {
            series.push(Series::new(pass, style, points));
        }
    }
    let copies = of(samples, built, MACHINE).filter(|sample| sample.what.starts_with(COPY));
    let mut copies: Vec<&Sample> = copies.collect();
    copies.sort_by(|a, b| b.bandwidth().total_cmp(&a.bandwidth()));
    for group in copies.chunk_by(|a, b| a.bandwidth() < ALIKE * b.bandwidth()) {
        for (place, copy) in (1..).zip(group) {
            let bandwidth = copy.bandwidth();
            let ridge = peak / bandwidth;
            let roof = [ENDS[0], ridge, ENDS[1]].map(|x| (x, (x * bandwidth).min(peak)));
            let mut notes = vec![String::new(); roof.len()];
            if place == group.len() {
                notes[0] = copied(group);
            }
            series.push(Series::new("", Style::Theory, roof).with_notes(notes));
        }
    }
    let machine = samples.first().map_or("", |s| s.processor.as_str());
    let bodies = of(samples, built, scene).next().map_or(0, |s| s.bodies);
    Chart {
        name,
        title: format!(
            "Passes of {scene}, {} bodies, on one thread of {machine}, {built}, under what it can copy and compute",
            draw::grouped(&bodies.to_string())
        ),
        x: Axis::log("operations a byte"),
        y: Axis::log("10⁹ operations a second"),
        series,
    }
}

/// What these copy, from the quickest on.
fn copied(group: &[&Sample]) -> String {
    let size = |copy: &&Sample| copy.what.trim_start_matches(COPY).to_owned();
    let sizes: Vec<_> = group.iter().map(size).collect();
    let (first, last) = (group[0].bandwidth(), group[group.len() - 1].bandwidth());
    let speed = if group.len() == 1 {
        three_digits(first)
    } else {
        format!("{} to {}", three_digits(last), three_digits(first))
    };
    format!("{}: {speed} GB/s", sizes.join(", "))
}

fn csv(samples: &[Sample]) -> String {
    let mut text =
        "processor,instructions,scene,bodies,what,us_a_step,bytes,operations,operations_a_byte,\
                    gb_s,gop_s,idle_share\n"
            .to_owned();
    for s in samples {
        // Writing into a String can't fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{:?},{},{},{:?},{:?},{:?},{:?}",
            draw::quoted(&s.processor),
            s.instructions,
            s.scene,
            s.bodies,
            s.what,
            s.us,
            s.bytes,
            s.done,
            s.intensity(),
            s.bandwidth(),
            s.speed(),
            1.0 - s.needed / s.done,
        );
    }
    text
}

/// Time of the same with other instructions, µs.
fn with(samples: &[Sample], instructions: &str, s: &Sample) -> Option<f64> {
    let mut found = of(samples, instructions, &s.scene).filter(|other| other.what == s.what);
    found.next().map(|other| other.us)
}

fn page(samples: &[Sample], origin: &str) -> String {
    let built = first(samples);
    let mut wider = samples.iter().map(|sample| sample.instructions.as_str());
    let wider = wider.rfind(|name| *name != built);
    let wide_heading = format!("µs, {}", wider.unwrap_or("wider"));
    let mut table = Table::new(&[
        "scene",
        "pass",
        &format!("µs a step, {built}"),
        &wide_heading,
        "operations a byte",
        "GB/s",
        "10⁹ operations/s",
        "of the peak",
        "idle lanes",
    ]);
    let none = || "–".to_owned();
    let peak = peak(samples, built);
    for s in samples
        .iter()
        .filter(|s| s.instructions == built && s.scene != MACHINE)
    {
        let is_counted = s.done > 0.0;
        let counted = |text: String| if is_counted { text } else { none() };
        let wide = wider.and_then(|wider| with(samples, wider, s));
        table.push(vec![
            s.scene.clone(),
            s.what.clone(),
            three_digits(s.us),
            wide.map_or_else(none, three_digits),
            counted(three_digits(s.intensity())),
            counted(three_digits(s.bandwidth())),
            counted(three_digits(s.speed())),
            counted(percent(s.speed() / peak)),
            counted(percent(1.0 - s.needed / s.done)),
        ]);
    }
    let machine = samples.first().map_or("", |s| s.processor.as_str());
    format!(
        "One thread of {machine}; {origin}. {}\n\n{}",
        ceilings(samples, built),
        table.markdown(2)
    )
}

/// What the machine can do, in words.
fn ceilings(samples: &[Sample], built: &str) -> String {
    let copies = of(samples, built, MACHINE).filter(|sample| sample.what.starts_with(COPY));
    let copies = copies.map(|copy| {
        let size = copy.what.trim_start_matches(COPY);
        format!(
            "{} GB/s for columns of {size}",
            three_digits(copy.bandwidth())
        )
    });
    let copies: Vec<String> = copies.collect();
    format!(
        "It copies {}, and multiplies and adds {} · 10⁹ times a second with {built}.",
        copies.join(", "),
        three_digits(peak(samples, built))
    )
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::chart::Picture;

    const NAMES: &str = "processor,instructions,scene,bodies,what,us_a_step,bytes,done,needed\n";

    fn drawn_from(lines: &str) -> Result<Product, FindingsError> {
        let text = NAMES.to_owned() + lines;
        drawn(&SOURCE.parse(PathBuf::from(SOURCE.file), &text)?)
    }

    #[test]
    fn a_pass_stands_under_the_roof_where_its_operations_and_bytes_put_it() {
        let made = drawn_from(
            "C,SSE2,machine,0,copy 8 KiB,1,10000,0,0\n\
             C,SSE2,machine,0,multiply and add,1,0,40000,40000\n\
             C,SSE2,pile,5,pairs,2,10000,20000,15000\n\
             C,AVX2,pile,5,pairs,1,10000,20000,15000\n",
        );
        let made = made.expect("a table");
        let Picture::Curves(chart) = &made.charts[0] else {
            panic!("curves are drawn");
        };
        assert_eq!(chart.series[0].points, [(2.0, 10.0)]);
        assert_eq!(
            chart.series[1].points,
            [(0.1, 1.0), (4.0, 40.0), (100.0, 40.0)]
        );
        let page = made.page.expect("there is one");
        let last = page.lines().last().expect("a line");
        let cells: Vec<&str> = last.split('|').map(str::trim).collect();
        assert_eq!(
            cells[1..10],
            [
                "pile", "pairs", "2.00", "1.00", "2.00", "5.00", "10.0", "25.0 %", "25.0 %"
            ]
        );
    }

    #[test]
    fn a_scene_without_a_picture_is_refused() {
        let error = drawn_from("C,SSE2,tops,5,pairs,2,1,2,1\n").expect_err("it has none");
        assert!(error.to_string().contains("`scene`"), "{error}");
    }
}
