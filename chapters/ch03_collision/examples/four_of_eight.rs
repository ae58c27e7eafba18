//! Exercise 1 of the page on contact points: a cube stands on a cube of the same size, turned about the
//! vertical. How large is the area that they share, and how much of it is between the four points?
//!
//! `cargo run --release -p ch03_collision --no-default-features --example four_of_eight`

use ch00_maths::f32::shape::Shape;
use ch03_collision::narrow::clip::clip;
use ch03_collision::narrow::support_point::Core;
use ch03_collision::narrow::{Placed, touch};
use glam::{Quat, Vec3};

fn main() {
    let shape = Shape::Box {
        half_extents: Vec3::splat(0.5),
    };
    println!("turn   corners   shared (m²)   four of them (m²)   names");
    for degrees in [0.0, 1.0, 10.0, 20.0, 30.0, 45.0_f32] {
        let placed = |p, q| Placed {
            shape: &shape,
            p,
            q,
            p_before: p,
        };
        let lower = placed(Vec3::ZERO, Quat::IDENTITY);
        let upper = placed(Vec3::Y, Quat::from_rotation_y(degrees.to_radians()));
        let (a, b) = Core::pair(&upper, &lower);
        let (above, below) = (a.widest_feature(Vec3::NEG_Y), b.widest_feature(Vec3::Y));
        let shared: Vec<Vec3> = clip(&above, &below, Vec3::Y, 0.0)
            .points()
            .iter()
            .map(|point| point.at)
            .collect();
        let touch = touch(&upper, &lower, 0.01).expect("it stands there");
        let four: Vec<Vec3> = touch.spots().iter().map(|spot| spot.point).collect();
        let names: Vec<String> = touch
            .spots()
            .iter()
            .map(|spot| format!("{:02x}", spot.feature & 0xff))
            .collect();
        println!(
            "{degrees:3.0}°   {:7}   {:11.4}   {:17.4}   {}",
            shared.len(),
            area(&shared),
            area(&four),
            names.join(" ")
        );
    }
}

/// Of the convex polygon of these corners, in any order, as seen from above.
fn area(corners: &[Vec3]) -> f32 {
    let centre = corners.iter().sum::<Vec3>() / corners.len() as f32;
    let mut around: Vec<Vec3> = corners.iter().map(|corner| corner - centre).collect();
    around.sort_by(|a, b| a.x.atan2(a.z).total_cmp(&b.x.atan2(b.z)));
    let pairs = around.iter().zip(around.iter().cycle().skip(1));
    pairs.map(|(a, b)| 0.5 * a.cross(*b).y.abs()).sum()
}
