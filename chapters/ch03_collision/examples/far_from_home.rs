//! Exercise 2 of the page on GJK: what is left of a gap of 5 mm between two turned boxes, far away from
//! the world's origin: as their places are stored, and as GJK finds it in the pair's coordinates and in the world's.
//!
//! `cargo run --release -p ch03_collision --no-default-features --example far_from_home`

use ch00_maths::f32::shape::Shape;
use ch03_collision::narrow::Placed;
use ch03_collision::narrow::gjk::{Gjk, gjk};
use ch03_collision::narrow::support_point::Core;
use glam::{Quat, Vec3};

fn main() {
    let shape = Shape::Box {
        half_extents: Vec3::new(0.3, 0.2, 0.5),
    };
    let q = Quat::from_axis_angle(Vec3::new(2.0, 1.0, 3.0).normalize(), 0.7);
    println!("away (m)   stored (mm)   pair's (mm)   world's (mm)");
    for away in [0.0, 10.0, 100.0, 1000.0, 10_000.0] {
        let p = Vec3::splat(away);
        // One box beside the other, along an axis of both; the places are what an f32 holds.
        let beside = p + q * Vec3::Y * 0.405;
        let placed = |p| Placed {
            shape: &shape,
            p,
            q,
            p_before: p,
        };
        let (a, b) = Core::pair(&placed(beside), &placed(p));
        let in_the_world = |core: Core, p| Core { centre: p, ..core };
        let (far_a, far_b) = (in_the_world(a, beside), in_the_world(b, p));
        let stored = (beside - p).as_dvec3().dot((q * Vec3::Y).as_dvec3()) - 0.4;
        println!(
            "{away:8.0}   {:11.4}   {:>11}   {:>12}",
            1e3 * stored,
            gap(&a, &b),
            gap(&far_a, &far_b)
        );
    }
}

/// In millimetres.
fn gap(a: &Core, b: &Core) -> String {
    match gjk(a, b, f32::INFINITY) {
        Gjk::Apart(apart) => format!("{:.4}", 1e3 * apart.distance),
        Gjk::Overlapping(_) => "overlap".to_owned(),
        Gjk::Far => "far".to_owned(),
    }
}
