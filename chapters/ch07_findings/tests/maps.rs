//! Failure maps: where theory is known best, a map's edge lies where theory has it.

use ch07_findings::laboratory::maps::edges::Edge;
use ch07_findings::laboratory::maps::{MAPS, Map, Place, Who, measured};

fn map(name: &str) -> &'static Map {
    let found = MAPS.iter().find(|map| map.name == name);
    found.expect("it is in the list")
}

fn panel(map: &Map, name: &str) -> Who {
    let found = (map.who)().into_iter().find(|who| who.name == name);
    found.expect("it is in the list")
}

/// The edge of a panel over the quick grid.
fn edge(map: &Map, who: &Who) -> Edge {
    let [xs, ys] = (map.grid)(true);
    let mut places: Vec<Place> = Vec::new();
    for &x in &xs {
        for &y in &ys {
            places.push(measured(map, who, [x, y], true).expect("it can be built"));
        }
    }
    Edge::of(map, who, &places).expect("theory says something")
}

#[test]
fn theory_lies_in_the_cell_of_the_edge_where_it_is_known_best() {
    for (name, who) in [
        ("stall", "printed"),
        ("stall", "corrected"),
        ("stall", "xpbd in single precision"),
        ("stall", "own-row"),
        ("aliasing", "printed"),
        ("aliasing", "corrected"),
        ("aliasing", "xpbd"),
        ("slope", "corrected"),
        ("slope", "own-row"),
        ("stack", "sequential-impulses: first step"),
        ("mass_ratio", "sequential-impulses: first step"),
        ("tunnelling", "printed"),
        ("tunnelling", "corrected"),
    ] {
        let map = map(name);
        let edge = edge(map, &panel(map, who));
        let (agreeing, columns) = edge.agreement();
        assert_eq!(agreeing, columns, "{name} by {who}: {:#?}", edge.columns);
        assert!(columns >= 4, "{name} by {who}");
    }
}

#[test]
fn a_finer_grid_finds_the_edge_of_tunnelling_within_a_twentieth() {
    let map = map("tunnelling");
    let who = panel(map, "printed");
    // At 60 Hz a ball isn't seen beyond 18 m/s; fifty phases find that one of them isn't by 2 % more.
    for (speed, through) in [(17.9, false), (18.9, true)] {
        let place = measured(map, &who, [speed, 60.0], true).expect("it can be built");
        assert_eq!(place.value > 0.0, through, "{place:?}");
    }
}

#[test]
fn a_joint_of_a_chain_stays_as_far_open_as_its_tension_says() {
    let map = map("chain");
    let who = panel(map, "xpbd");
    // A long chain still swings up and down in the third second.
    for (links, rate, bound) in [(1.0, 120.0, 1e-3), (5.0, 120.0, 0.03), (40.0, 240.0, 0.1)] {
        let place = measured(map, &who, [links, rate], false).expect("it can be built");
        let h: f64 = 1.0 / (20.0 * rate);
        let theory = 9.81 * (672.0 + links - 1.0) * h * h;
        let off = place.value / theory - 1.0;
        assert!(off.abs() < bound, "{place:?} beside {theory} m");
    }
}

#[test]
fn names_of_maps_and_panels_are_their_own_and_hold_no_comma() {
    for map in &MAPS {
        let mut names: Vec<_> = (map.who)().iter().map(|who| who.name).collect();
        assert!(names.iter().all(|name| !name.contains(',')), "{names:?}");
        let all = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all, "{}", map.name);
    }
}
