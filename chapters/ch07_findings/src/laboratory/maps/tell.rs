//! Maps as pictures and as tables.

use std::fmt::Write as _;

use super::directions::{X, Z, theory};
use super::edges::Edge;
use super::{MAPS, Map, Place, Who};
use crate::chart::{Bar, Bars, Group, Maps, Panel, Picture, Scale, Series, Style};
use crate::laboratory::cell::End;
use crate::laboratory::scenarios::friction_directions::WAY;
use crate::table::{Table, three_digits};

/// Points of a line of theory.
const FINE: u32 = 400;

/// Names of charts live as long as the program.
fn chart_name(map: &Map) -> &'static str {
    Box::leak(format!("failure_{}", map.name).into_boxed_str())
}

/// A map's panels: of those that can do anything in it.
pub fn picture(map: &Map, places: &[Place]) -> Picture {
    let [x, y] = (map.axes)();
    let is_polar = map.name == "directions";
    let who = (map.who)().into_iter().filter(|who| can(map, who, places));
    let panels = who.map(|who| {
        if is_polar {
            stops(map, &who, places)
        } else {
            panel(map, &who, places)
        }
    });
    let classes = map.classes.iter().filter(|name| !name.is_empty());
    Maps {
        name: chart_name(map),
        title: format!("{}. {}", map.number, map.title),
        x,
        y,
        classes: classes.map(|&name| name.to_owned()).collect(),
        theory: format!("theory: {}", map.theory),
        panels: panels.collect(),
    }
    .into()
}

fn can(map: &Map, who: &Who, places: &[Place]) -> bool {
    let does = |place: &Place| !matches!(place.end, End::Cannot(_));
    map.places(who, places).any(does)
}

fn panel(map: &Map, who: &Who, places: &[Place]) -> Panel {
    let cells = map.places(who, places).filter_map(|place| {
        let [x, y] = place.at;
        Some((x, y, map.class(place)?))
    });
    let cells: Vec<_> = cells.collect();
    let least = cells
        .iter()
        .map(|cell| cell.0)
        .fold(f64::INFINITY, f64::min);
    let largest = cells.iter().map(|cell| cell.0).fold(0.0, f64::max);
    let log = (map.axes)()[0].scale == Scale::Log;
    let fine = (0..=FINE).map(|k| {
        let share = f64::from(k) / f64::from(FINE);
        if log {
            least * (largest / least).powf(share)
        } else {
            least + share * (largest - least)
        }
    });
    let fine: Vec<f64> = fine.collect();
    let lines = who.laws.iter();
    Panel {
        name: who.name.to_owned(),
        cells,
        curves: lines
            .map(|law| Series::of("", Style::Theory, &fine, &law.y))
            .collect(),
    }
}

/// Where boxes stopped, over where theory has it.
fn stops(map: &Map, who: &Who, places: &[Place]) -> Panel {
    let mut curves: Vec<Series> = theory()
        .into_iter()
        .map(|points| Series::new("", Style::Theory, points))
        .collect();
    let points = stopped(map, who, places).into_iter().map(|(_, at)| at);
    curves.push(Series::new("", Style::Marks(0), points));
    Panel {
        name: who.name.to_owned(),
        cells: Vec::new(),
        curves,
    }
}

/// The directions, degrees, and where boxes stopped, m.
fn stopped(map: &Map, who: &Who, places: &[Place]) -> Vec<(f64, (f64, f64))> {
    let of = |part: f64| {
        let same = move |place: &&Place| place.at[1] == part && place.end == End::Measured;
        map.places(who, places).filter(same)
    };
    let both = of(X).filter_map(|x| {
        let z = of(Z).find(|z| z.at[0] == x.at[0])?;
        Some((x.at[0], (x.value, z.value)))
    });
    both.collect()
}

/// The edges that theory tells something of.
fn edges<'a>(map: &'a Map, places: &'a [Place]) -> impl Iterator<Item = (Who, Edge)> + 'a {
    let who = (map.who)().into_iter();
    who.filter(|who| can(map, who, places)).filter_map(|who| {
        let edge = Edge::of(map, &who, places)?;
        Some((who, edge))
    })
}

/// Measured edges over theory's, in powers of ten.
pub fn overview(places: &[Place]) -> Bars {
    let bar = |(who, edge): (Who, Edge)| {
        let (agreeing, of) = edge.agreement();
        let note = format!("{agreeing} of {of}");
        let ratio = edge.ratio();
        Bar {
            name: who.name.to_owned(),
            lengths: vec![ratio.map_or(f64::NAN, |[middle, ..]| middle.log10())],
            spread: ratio.map(|[_, least, largest]| (least.log10(), largest.log10())),
            note: if ratio.is_some() {
                note
            } else {
                format!("{note}, no edge")
            },
        }
    };
    let group = |map: &Map| Group {
        name: format!("{}. {}", map.number, map.title),
        bars: edges(map, places).map(bar).collect(),
    };
    let groups = MAPS.iter().map(group);
    Bars {
        name: "failure_edges",
        title:
            "Where maps have their edges, over where theory has them: middle, least and largest; \
                in how many columns theory lies in the edge"
                .to_owned(),
        label: "measured edge over theory's".to_owned(),
        powers: true,
        parts: vec!["middle of the columns"],
        groups: groups.filter(|group| !group.bars.is_empty()).collect(),
    }
}

/// A line a column of every panel that has a law.
pub fn edges_csv(places: &[Place]) -> String {
    let mut text = "map,method,x,last_good,first_bad,law,agrees\n".to_owned();
    let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:?}"));
    for map in &MAPS {
        for (who, edge) in edges(map, places) {
            for column in &edge.columns {
                // Writing into a String can't fail.
                let _ = writeln!(
                    text,
                    "{},{},{:?},{},{},{:?},{}",
                    map.name,
                    who.name,
                    column.x,
                    number(column.good),
                    number(column.bad),
                    column.law,
                    edge.agrees(column)
                );
            }
        }
    }
    text
}

/// All maps, one table after the other, between anchors by which the book includes them one by one.
pub fn page(places: &[Place]) -> String {
    let part = |map: &Map| {
        let (name, table) = (map.name, page_of(map, places));
        format!("<!-- ANCHOR: {name} -->\n{table}\n<!-- ANCHOR_END: {name} -->\n")
    };
    MAPS.iter().map(part).collect()
}

/// What a map shows, as a table.
pub fn page_of(map: &Map, places: &[Place]) -> String {
    if map.name == "directions" {
        return directions(map, places);
    }
    let mut table = Table::new(&[
        "method",
        "theory lies in the edge",
        "measured edge / theory's: middle (least … largest)",
        "good throughout",
        "bad throughout",
    ]);
    for (who, edge) in edges(map, places) {
        let (agreeing, of) = edge.agreement();
        let [good, bad] = edge.whole();
        let ratio = edge.ratio().map_or("–".to_owned(), |ratio| {
            let [middle, least, largest] = ratio.map(three_digits);
            format!("{middle} ({least} … {largest})")
        });
        table.push(vec![
            format!("`{}`", who.name),
            format!("{agreeing} of {of} columns"),
            ratio,
            good.to_string(),
            bad.to_string(),
        ]);
    }
    let free = |who: &Who| who.laws.iter().all(|law| law.until.is_none());
    for who in (map.who)().into_iter().filter(free) {
        if let Some(row) = without_law(map, &who, places) {
            table.push(row);
        }
    }
    format!(
        "A cell's number is the {}; it is “{}” up to {}.\n\n{}",
        map.value,
        map.classes[0],
        three_digits(map.bounds[0]),
        table.markdown(1)
    )
}

/// Of a method that theory says nothing of: how many cells are good.
fn without_law(map: &Map, who: &Who, places: &[Place]) -> Option<Vec<String>> {
    let classes = || map.places(who, places).filter_map(|place| map.class(place));
    let all = classes().count();
    let good = classes().filter(|class| *class == crate::chart::Class::Held);
    let told = format!("{} of {all} cells are good", good.count());
    let none = || "–".to_owned();
    (all > 0).then(|| vec![format!("`{}`", who.name), told, none(), none(), none()])
}

fn directions(map: &Map, places: &[Place]) -> String {
    let mut table = Table::new(&[
        "method",
        "stops after, of 1.63 m: least … most",
        "farthest to the side, of the same",
    ]);
    for who in (map.who)().into_iter().filter(|who| can(map, who, places)) {
        let (mut least, mut most, mut aside) = (f64::INFINITY, 0.0f64, 0.0f64);
        for (angle, (x, z)) in stopped(map, &who, places) {
            let (sin, cos) = angle.to_radians().sin_cos();
            let along = (x * cos + z * sin) / WAY;
            (least, most) = (least.min(along), most.max(along));
            aside = aside.max((z * cos - x * sin).abs() / WAY);
        }
        table.push(vec![
            format!("`{}`", who.name),
            format!("{least:.4} … {most:.4}"),
            three_digits(aside),
        ]);
    }
    format!(
        "Boxes at 4 m/s, μ = 0.5, every 7.5° of the full circle, at 60 Hz.\n\n{}",
        table.markdown(1)
    )
}
