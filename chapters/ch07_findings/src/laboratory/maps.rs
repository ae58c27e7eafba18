//! Failure maps: a scenario over two of its numbers, a panel a method, with the line among the cells that
//! theory draws. Every cell is a run of the laboratory's own set-up under its own measure, and a line of a table
//! that is kept, so that a map that was cut short goes on where it stopped.

mod aliasing;
mod chain;
mod directions;
pub mod edges;
mod mass_ratio;
mod slope;
mod stack;
mod stall;
mod tell;
mod tunnelling;
pub mod who;

use std::path::Path;
use std::time::Instant;

use ch00_scenes::Scene;

use super::cell::End;
use super::runs::watched;
use super::scenario::{Verdict, Watch};
use super::store::{Kept, Store};
use crate::FindingsError;
use crate::chart::{Axis, Class};
use crate::product::{Product, Say};
pub use who::{Knob, Law, Who};

/// A map: a scenario over two numbers.
#[derive(Clone, Copy)]
pub struct Map {
    /// Of the scenario, with its letter where it has one.
    pub number: &'static str,
    /// As `chart failure_NAME` says it.
    pub name: &'static str,
    /// What happens, in a few words.
    pub title: &'static str,
    /// What a cell's number is, with its unit.
    pub value: &'static str,
    /// The axes.
    pub axes: fn() -> [Axis; 2],
    /// Places along both; fewer in a hurry.
    pub grid: fn(bool) -> [Vec<f64>; 2],
    /// A cell is as it should be up to the first, and lost from the second on.
    pub bounds: [f64; 2],
    /// What the three classes are called.
    pub classes: [&'static str; 3],
    /// Whether cells get better upwards.
    pub better_upwards: bool,
    /// What theory's lines are.
    pub theory: &'static str,
    /// Who is shown.
    pub who: fn() -> Vec<Who>,
    /// The set-up of a cell; shorter in a hurry.
    pub scene: fn(f64, f64, bool) -> Result<Scene, FindingsError>,
    /// Who looks at it.
    pub watcher: fn(&Scene, f64, f64) -> Box<dyn Watch>,
}

/// All of them, in the order of the scenarios.
pub const MAPS: [Map; 8] = [
    stall::MAP,
    aliasing::MAP,
    slope::MAP,
    directions::MAP,
    stack::MAP,
    mass_ratio::MAP,
    chain::MAP,
    tunnelling::MAP,
];

/// A cell of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Name of the map.
    pub map: String,
    /// Name of the panel.
    pub who: String,
    /// Where, along both axes.
    pub at: [f64; 2],
    /// What was measured.
    pub value: f64,
    /// How it ended.
    pub end: End,
}

impl Kept for Place {
    const HEADINGS: &'static str = "map,method,x,y,value,end";

    fn line(&self) -> String {
        let [x, y] = self.at;
        let (map, who, end) = (&self.map, &self.who, self.end.line());
        format!("{map},{who},{x:?},{y:?},{:e},{end}", self.value)
    }

    fn read(line: &str) -> Option<Self> {
        let fields: Vec<&str> = line.split(',').collect();
        let [map, who, x, y, value, end] = fields[..] else {
            return None;
        };
        Some(Self {
            map: map.to_owned(),
            who: who.to_owned(),
            at: [x.parse().ok()?, y.parse().ok()?],
            value: value.parse().ok()?,
            end: End::of(end)?,
        })
    }
}

impl Place {
    fn is(&self, map: &Map, who: &Who, at: [f64; 2]) -> bool {
        self.at == at && self.who == who.name && self.map == map.name
    }
}

impl Map {
    /// What became of a cell; None of one that a method can't be asked for.
    #[must_use]
    pub fn class(&self, place: &Place) -> Option<Class> {
        let [held, lost] = self.bounds;
        match &place.end {
            End::Cannot(_) => None,
            End::Measured if place.value <= held => Some(Class::Held),
            End::Measured if place.value < lost => Some(Class::Worse),
            End::Measured | End::Failed(_) => Some(Class::Failed),
        }
    }

    /// The cells of one of its panels.
    pub fn places<'a>(
        &self,
        who: &'a Who,
        places: &'a [Place],
    ) -> impl Iterator<Item = &'a Place> + 'a {
        let name = self.name;
        places
            .iter()
            .filter(move |place| place.map == name && place.who == who.name)
    }
}

/// All maps: every cell that isn't in the folder's table yet is measured, then all is drawn.
///
/// # Errors
/// [`FindingsError`] where a scene can't be built, or the table can't be read or written.
pub fn product(quick: bool, folder: &Path, say: Say) -> Result<Product, FindingsError> {
    let store = filled(&MAPS, quick, folder, say)?;
    let mut charts = vec![tell::overview(&store.cells).into()];
    charts.extend(MAPS.iter().map(|map| tell::picture(map, &store.cells)));
    Ok(Product {
        charts,
        csv: tell::edges_csv(&store.cells),
        page: Some(tell::page(&store.cells)),
    })
}

/// One map.
///
/// # Errors
/// As [`product`].
pub fn product_of(
    map: &'static Map,
    quick: bool,
    folder: &Path,
    say: Say,
) -> Result<Product, FindingsError> {
    let store = filled(std::slice::from_ref(map), quick, folder, say)?;
    let mine = store.cells.iter().filter(|place| place.map == map.name);
    let lines: Vec<String> = mine.map(Place::line).collect();
    Ok(Product {
        charts: vec![tell::picture(map, &store.cells)],
        csv: format!("{}\n{}\n", Place::HEADINGS, lines.join("\n")),
        page: Some(tell::page_of(map, &store.cells)),
    })
}

/// Measures what the table lacks, a line at a time; what it has, it keeps.
fn filled(
    maps: &'static [Map],
    quick: bool,
    folder: &Path,
    say: Say,
) -> Result<Store<Place>, FindingsError> {
    let name = if quick {
        "failure_maps_quick.csv"
    } else {
        "failure_maps.csv"
    };
    let mut store = Store::<Place>::open(&folder.join(name))?;
    let mut missing = Vec::new();
    for map in maps {
        let [xs, ys] = (map.grid)(quick);
        for who in (map.who)() {
            let at = xs.iter().flat_map(|&x| ys.iter().map(move |&y| [x, y]));
            let known = |at: &[f64; 2]| store.cells.iter().any(|one| one.is(map, &who, *at));
            let at: Vec<_> = at.filter(|at| !known(at)).collect();
            missing.push((map, who, at));
        }
    }
    let all: usize = missing.iter().map(|(_, _, at)| at.len()).sum();
    let (start, mut done) = (Instant::now(), 0);
    for (map, who, at) in &missing {
        for &at in at {
            store.add(measured(map, who, at, quick)?)?;
        }
        if !at.is_empty() {
            done += at.len();
            let left = start.elapsed().as_secs_f64() / done as f64 * (all - done) as f64;
            say(&format!(
                "{done} of {all}, {left:.0} s left: {} by {}",
                map.title, who.name
            ));
        }
    }
    Ok(store)
}

// ANCHOR: measured
/// One cell: the map's set-up at a place, by a method, under the map's own eyes.
///
/// # Errors
/// [`FindingsError`] where the scene can't be built.
pub fn measured(map: &Map, who: &Who, at: [f64; 2], quick: bool) -> Result<Place, FindingsError> {
    let mut scene = (map.scene)(at[0], at[1], quick)?;
    let mut watch = match who.instead {
        None => (map.watcher)(&scene, at[0], at[1]),
        Some((steps, watcher)) => {
            scene.steps = steps;
            watcher(&scene)
        }
    };
    let run = watched(&scene, None, who.engine, &who.settings(at[1]), &mut *watch);
    let (value, end) = match run.map(|run| run.verdict) {
        Err(why) => (f64::INFINITY, End::Cannot(why.to_string())),
        Ok(Verdict { error, failed }) => {
            let failed = failed.map(|how| End::Failed(how.to_owned()));
            (error, failed.unwrap_or(End::Measured))
        }
    };
    Ok(Place {
        map: map.name.to_owned(),
        who: who.name.to_owned(),
        at,
        value,
        end,
    })
}
// ANCHOR_END: measured

/// Every third of some places, and the last, where it must be quick.
fn thinned(all: Vec<f64>, quick: bool) -> Vec<f64> {
    if !quick {
        return all;
    }
    let last = all.len().saturating_sub(1);
    let kept = |k: &usize| k.is_multiple_of(3) || *k == last;
    (0..all.len()).filter(kept).map(|k| all[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn place(value: f64, end: End) -> Place {
        Place {
            map: "stall".to_owned(),
            who: "printed".to_owned(),
            at: [60.0, 1.5 * 65536.0],
            value,
            end,
        }
    }

    #[test]
    fn what_is_written_is_read_again_and_what_is_cut_off_is_not() {
        for end in [
            End::Measured,
            End::Failed("fell".to_owned()),
            End::Cannot("no sweeps".to_owned()),
        ] {
            let place = place(1.0 / 3.0, end);
            let line = place.line();
            assert_eq!(Place::read(&line), Some(place));
            assert_eq!(Place::read(&line[..line.len() - 10]), None);
        }
    }

    #[test]
    fn a_class_follows_from_the_bounds_and_a_failure_is_one() {
        let map = &stall::MAP;
        let class = |value, end| map.class(&place(value, end));
        assert_eq!(class(0.01, End::Measured), Some(Class::Held));
        assert_eq!(class(0.02, End::Measured), Some(Class::Worse));
        assert_eq!(class(1.0, End::Measured), Some(Class::Failed));
        let fell = End::Failed("fell".to_owned());
        assert_eq!(class(0.0, fell), Some(Class::Failed));
        let cannot = End::Cannot("why".to_owned());
        assert_eq!(class(0.0, cannot), None);
    }
}
