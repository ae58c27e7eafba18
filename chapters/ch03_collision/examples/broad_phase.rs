//! Exercise 1 of chapter 3's first page: finding overlapping boxes by asking all pairs, by a KD-tree, and
//! by a grid.
//!
//! `cargo run --release -p ch03_collision --no-default-features --example broad_phase`

use std::time::Instant;

use ch00_maths::f32::shape::Shape;
use ch00_scenes::Scene;
use ch03_collision::aabb::Aabb;
use ch03_collision::brute_force;
use ch03_collision::grid::Grid;
use ch03_collision::kd_tree::KdTree;
use glam::{Quat, Vec3};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("balls   pairs   all pairs (ms)   KD-tree (ms)   grid (ms)");
    for count in [10, 30, 100, 300, 1000, 3000, 10_000] {
        let scene = Scene::open("balls", Some(count), None)?;
        let boxes: Vec<Aabb> = scene.bodies.iter().map(box_of).collect();
        let (asked, all) = best_of(5, || all_pairs(&boxes));
        let (found, tree) = best_of(5, || pairs_by_tree(&boxes));
        let (sorted, grid) = best_of(5, || pairs_by_grid(&boxes));
        assert_eq!((asked, asked), (found, sorted));
        println!("{count:5}   {found:5}   {all:14.4}   {tree:12.4}   {grid:9.4}");
    }
    Ok(())
}

/// The box about a ball a little larger than the real one, so that neighbours overlap.
fn box_of(body: &ch00_scenes::Body) -> Aabb {
    let centre = body.position.as_vec3();
    match body.shape {
        ch00_scenes::Shape::Sphere { radius } => {
            let radius = 2.0 * radius as f32;
            Aabb::of_shape(&Shape::Sphere { radius }, centre, Quat::IDENTITY)
        }
        _ => Aabb {
            min: centre - Vec3::splat(0.1),
            max: centre + Vec3::splat(0.1),
        },
    }
}

fn all_pairs(boxes: &[Aabb]) -> usize {
    let mut found = 0;
    brute_force::all_pairs(boxes, |_, _| found += 1);
    found
}

fn pairs_by_tree(boxes: &[Aabb]) -> usize {
    let mut tree = KdTree::default();
    tree.build(boxes);
    let mut found = 0;
    for (i, one) in boxes.iter().enumerate() {
        tree.overlapping(boxes, one, |j| found += usize::from(j > i));
    }
    found
}

fn pairs_by_grid(boxes: &[Aabb]) -> usize {
    let mut grid = Grid::default();
    grid.build(boxes);
    let mut found = 0;
    for (i, one) in boxes.iter().enumerate() {
        grid.overlapping(boxes, one, |j| found += usize::from(j > i));
    }
    found
}

/// The shortest of some runs, ms, with what was found.
fn best_of(runs: u32, find: impl Fn() -> usize) -> (usize, f64) {
    let (mut found, mut best) = (0, f64::INFINITY);
    for _ in 0..runs {
        let start = Instant::now();
        found = find();
        best = best.min(start.elapsed().as_secs_f64() * 1000.0);
    }
    (found, best)
}
