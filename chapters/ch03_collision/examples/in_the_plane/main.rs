//! GJK, EPA and clipping on flat shapes, where they can be drawn. Everything in the drawings comes from
//! the engine's own functions, but for EPA in the plane, which is an exercise (`epa.rs`).
//!
//! `cargo run --release -p ch03_collision --no-default-features --example in_the_plane -- [minkowski | gjk |
//! epa | regions | clip]` prints an SVG; without a word, the numbers of the two runs.

mod draw;
mod epa;
mod svg;

use ch03_collision::narrow::gjk::{self, Gjk};
use ch03_collision::narrow::simplex::Simplex;
use ch03_collision::narrow::support_point::{Core, Hull, Vertex};
use glam::{Mat3, Vec3};

/// What one iteration of GJK looked at.
struct Look {
    simplex: Simplex,
    support: Vertex,
    at_least: f32,
}

fn main() {
    match std::env::args().nth(1).as_deref() {
        None => print_runs(),
        Some("minkowski") => println!("{}", draw::minkowski()),
        Some("gjk") => println!("{}", draw::gjk()),
        Some("epa") => println!("{}", draw::epa()),
        Some("regions") => println!("{}", draw::regions()),
        Some("clip") => println!("{}", draw::clip()),
        Some(other) => eprintln!("no drawing of `{other}`: minkowski, gjk, epa, regions, clip"),
    }
}

/// A rectangle in the plane z = 0, turned by so many degrees.
fn rectangle(half: [f32; 2], centre: [f32; 2], degrees: f32) -> Core {
    Core {
        hull: Hull::Box {
            half_extents: Vec3::new(half[0], half[1], 0.0),
        },
        radius: 0.0,
        centre: Vec3::new(centre[0], centre[1], 0.0),
        axes: Mat3::from_rotation_z(degrees.to_radians()),
    }
}

/// Two rectangles that are apart.
fn apart() -> [Core; 2] {
    [
        rectangle([1.1, 0.55], [2.1, 0.9], 24.0),
        rectangle([0.9, 0.4], [0.0, 0.0], -38.0),
    ]
}

/// The same, nearer to each other.
fn overlapping() -> [Core; 2] {
    let [mut a, b] = apart();
    a.centre = Vec3::new(0.75, 0.35, 0.0);
    [a, b]
}

/// A disc above a slanting bar: a cylinder without height, seen along its axis.
fn disc_and_bar() -> [Core; 2] {
    let disc = Core {
        hull: Hull::Cylinder {
            radius: 0.8,
            half_height: 0.0,
        },
        radius: 0.0,
        centre: Vec3::new(0.8, 1.8, 0.0),
        axes: Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y),
    };
    [disc, rectangle([1.3, 0.25], [0.0, 0.0], -24.0)]
}

/// GJK's iterations on two cores, and its end.
fn watch(a: &Core, b: &Core) -> (Vec<Look>, Gjk) {
    let mut looks = Vec::new();
    let end = gjk::watched(a, b, f32::INFINITY, |step| {
        looks.push(Look {
            simplex: *step.simplex,
            support: step.support,
            at_least: step.at_least,
        });
    });
    (looks, end)
}

/// The triangle with which GJK ends on [`overlapping`].
fn triangle() -> Simplex {
    let [a, b] = overlapping();
    match watch(&a, &b).1 {
        Gjk::Overlapping(simplex) => simplex,
        Gjk::Apart(_) | Gjk::Far => unreachable!("they overlap"),
    }
}

fn print_runs() {
    let [a, b] = disc_and_bar();
    println!("GJK         v on        |v| (m)   at least (m)");
    for (i, look) in watch(&a, &b).0.iter().enumerate() {
        let carrier = match look.simplex.vertices().len() {
            1 => "a vertex",
            2 => "an edge",
            _ => "a triangle",
        };
        let distance = look.simplex.nearest().length();
        println!(
            "{:<11} {carrier:<10} {distance:8.4} {:14.4}",
            i + 1,
            look.at_least
        );
    }
    let [a, b] = overlapping();
    println!("EPA         edges   at least (m)   w at (m)");
    for (i, look) in epa::epa(&a, &b, triangle().vertices()).iter().enumerate() {
        let edges = look.polygon.len();
        println!(
            "{:<11} {edges:<5} {:14.4} {:10.4}",
            i + 1,
            look.distance,
            look.at_most()
        );
    }
}
