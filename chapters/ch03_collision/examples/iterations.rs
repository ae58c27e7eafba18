//! Exercise 1 of the page on GJK: how many iterations it takes, and EPA where two solids overlap, for
//! solids of every shape in a thousand random places each.
//!
//! `cargo run --release -p ch03_collision --no-default-features --example iterations`

use ch00_maths::f32::shape::Shape;
use ch00_scenes::random::SplitMix64;
use ch03_collision::narrow::Placed;
use ch03_collision::narrow::epa;
use ch03_collision::narrow::gjk::{self, Gjk};
use ch03_collision::narrow::support_point::Core;
use glam::Vec3;

/// Of each pair of shapes.
const PLACES: u32 = 1000;

fn main() {
    let half_extents = Vec3::new(0.3, 0.2, 0.5);
    let (radius, half_height) = (0.2, 0.4);
    let solids = [
        ("box", Shape::Box { half_extents }),
        (
            "capsule",
            Shape::Capsule {
                radius,
                half_height,
            },
        ),
        (
            "cylinder",
            Shape::Cylinder {
                radius,
                half_height,
            },
        ),
    ];
    println!("                      GJK             EPA");
    println!("                      mean   most     mean   most");
    for (i, (name_a, a)) in solids.iter().enumerate() {
        for (name_b, b) in &solids[i..] {
            let (gjk, epa) = counts(a, b);
            println!(
                "{:<20} {}    {}",
                format!("{name_a}, {name_b}"),
                told(&gjk),
                told(&epa)
            );
        }
    }
}

/// Iterations of GJK in all places, and of EPA in those where the cores overlap.
fn counts(a: &Shape, b: &Shape) -> (Vec<usize>, Vec<usize>) {
    let mut random = SplitMix64::new(1);
    let (mut of_gjk, mut of_epa) = (Vec::new(), Vec::new());
    for _ in 0..PLACES {
        let mut placed = |shape, size| {
            let p = random.vector(size).as_vec3();
            Placed {
                shape,
                p,
                q: random.rotation().as_quat(),
                p_before: p,
            }
        };
        let (a, b) = Core::pair(&placed(a, 0.6), &placed(b, 0.0));
        let mut count = 0;
        let end = gjk::watched(&a, &b, f32::INFINITY, |_| count += 1);
        of_gjk.push(count);
        if let Gjk::Overlapping(simplex) = end {
            let mut count = 0;
            epa::watched(&a, &b, &simplex, |_| count += 1);
            of_epa.push(count);
        }
    }
    (of_gjk, of_epa)
}

/// Mean and most.
fn told(counts: &[usize]) -> String {
    let Some(most) = counts.iter().max() else {
        return "   –      –".to_owned();
    };
    let mean = counts.iter().sum::<usize>() as f64 / counts.len() as f64;
    format!("{mean:4.1}   {most:4}")
}
