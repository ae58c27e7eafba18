//! Which bodies are near each other: a grid of cubes, each as wide as the largest body of
//! ordinary size, so that neighbours lie in adjacent cubes. Bodies far above ordinary
//! size, such as floors, are paired with all others by their bounding boxes.
//!
//! The grid is a list of (cube, body) in order of cubes; a row of cubes along x is one
//! stretch of it, found by bisection. So nothing depends on the extent of the world.

use glam::{DMat3, DVec3};

use super::depth::Placed;
use crate::Shape;

/// Bodies this many times wider than the median are kept out of the grid.
const OVERSIZE: f64 = 8.0;

/// A cube of the grid: z, y, x, so that the order of cubes runs along x first.
type Cube = [i64; 3];

/// A body's box along the world's axes.
#[derive(Clone, Copy)]
struct Aabb {
    centre: DVec3,
    half: DVec3,
}

impl Aabb {
    fn of(solid: &Placed) -> Self {
        let r = DMat3::from_quat(solid.orientation);
        let turned = |half: DVec3| {
            r.x_axis.abs() * half.x + r.y_axis.abs() * half.y + r.z_axis.abs() * half.z
        };
        let half = match solid.shape {
            Shape::Sphere { radius } => DVec3::splat(radius),
            Shape::Box { half_extents } => turned(half_extents),
            Shape::Capsule {
                radius,
                half_height,
            } => turned(DVec3::Y * half_height) + DVec3::splat(radius),
            // The box about the cylinder, turned: wider than it must be.
            Shape::Cylinder {
                radius,
                half_height,
            } => turned(DVec3::new(radius, half_height, radius)),
        };
        Self {
            centre: solid.position,
            half,
        }
    }

    fn meets(&self, other: &Self) -> bool {
        let gap = (self.centre - other.centre).abs() - (self.half + other.half);
        gap.max_element() <= 0.0
    }

    fn width(&self) -> f64 {
        2.0 * self.half.max_element()
    }
}

/// Calls `found` once for every two solids whose bounding boxes meet, the lower index
/// first. `solids` are index and solid, every number finite.
pub(super) fn near_pairs(solids: &[(usize, Placed)], mut found: impl FnMut(usize, usize)) {
    let boxes: Vec<_> = solids
        .iter()
        .map(|(i, solid)| (*i, Aabb::of(solid)))
        .collect();
    let limit = OVERSIZE * median_width(&boxes);
    let (ordinary, oversize): (Vec<_>, Vec<_>) = boxes
        .into_iter()
        .partition(|(_, aabb)| aabb.width() <= limit);
    let mut test = |a: &(usize, Aabb), b: &(usize, Aabb)| {
        if a.1.meets(&b.1) {
            found(a.0.min(b.0), a.0.max(b.0));
        }
    };
    for (k, big) in oversize.iter().enumerate() {
        for other in oversize[k + 1..].iter().chain(&ordinary) {
            test(big, other);
        }
    }
    pairs_in_grid(&ordinary, test);
}

fn median_width(boxes: &[(usize, Aabb)]) -> f64 {
    let mut widths: Vec<f64> = boxes.iter().map(|(_, aabb)| aabb.width()).collect();
    widths.sort_by(f64::total_cmp);
    widths.get(widths.len() / 2).copied().unwrap_or(0.0)
}

/// Calls `test` once for every two boxes in the same cube or in adjacent ones.
fn pairs_in_grid(boxes: &[(usize, Aabb)], mut test: impl FnMut(&(usize, Aabb), &(usize, Aabb))) {
    let width = boxes
        .iter()
        .map(|(_, aabb)| aabb.width())
        .fold(0.0, f64::max);
    let mut grid: Vec<(Cube, usize)> = boxes
        .iter()
        .enumerate()
        .map(|(k, (_, aabb))| (cube(aabb.centre, width), k))
        .collect();
    grid.sort_unstable();
    for (place, &([z, y, x], k)) in grid.iter().enumerate() {
        // What follows in the own row, and the four rows of cubes that come later: the
        // other half of the neighbours finds this one.
        let mut rows = [&grid[place + 1..]; 5];
        let later = [(0, 1), (1, -1), (1, 0), (1, 1)];
        for (row, (dz, dy)) in rows[1..].iter_mut().zip(later) {
            *row = from(&grid, [z + dz, y + dy, x - 1]);
        }
        let ys_and_zs = [(0, 0), (0, 1), (1, -1), (1, 0), (1, 1)];
        for (row, (dz, dy)) in rows.into_iter().zip(ys_and_zs) {
            let last = [z + dz, y + dy, x + 1];
            for &(_, other) in row.iter().take_while(|(cube, _)| *cube <= last) {
                test(&boxes[k], &boxes[other]);
            }
        }
    }
}

/// The part of the grid from `first` on.
fn from(grid: &[(Cube, usize)], first: Cube) -> &[(Cube, usize)] {
    &grid[grid.partition_point(|(cube, _)| *cube < first)..]
}

/// Bodies beyond 10¹⁸ widths share the outermost cubes.
#[expect(
    clippy::cast_possible_truncation,
    reason = "clamped to what an i64 holds"
)]
fn cube(position: DVec3, width: f64) -> Cube {
    let edge = DVec3::splat(1e18);
    let cell = (position / width).floor().clamp(-edge, edge);
    [cell.z as i64, cell.y as i64, cell.x as i64]
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::random::SplitMix64;

    fn crowd(count: usize, size: f64) -> Vec<(usize, Placed)> {
        let mut random = SplitMix64::new(9);
        (0..count)
            .map(|i| {
                let shape = match i % 50 {
                    0 => Shape::Box {
                        half_extents: DVec3::new(4.0, 0.2, 2.0),
                    },
                    1 => Shape::Capsule {
                        radius: 0.1,
                        half_height: 0.4,
                    },
                    2 => Shape::Cylinder {
                        radius: 0.3,
                        half_height: 0.1,
                    },
                    _ => Shape::Sphere {
                        radius: random.between(0.1, 0.3),
                    },
                };
                let orientation = DQuat::from_axis_angle(
                    random.vector(1.0).normalize(),
                    random.between(0.0, 3.0),
                );
                let position = random.vector(size);
                let solid = Placed {
                    shape,
                    position,
                    orientation,
                };
                (i, solid)
            })
            .collect()
    }

    fn all_pairs(solids: &[(usize, Placed)]) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for (k, (i, a)) in solids.iter().enumerate() {
            for (j, b) in &solids[k + 1..] {
                if Aabb::of(a).meets(&Aabb::of(b)) {
                    pairs.push((*i, *j));
                }
            }
        }
        pairs
    }

    fn pairs_of(solids: &[(usize, Placed)]) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        near_pairs(solids, |a, b| pairs.push((a, b)));
        pairs.sort_unstable();
        pairs
    }

    #[test]
    fn the_grid_finds_what_testing_all_pairs_finds() {
        let solids = crowd(800, 3.0);
        let exhaustive = all_pairs(&solids);
        assert!(exhaustive.len() > 1000, "{}", exhaustive.len());
        assert_eq!(pairs_of(&solids), exhaustive);
    }

    #[test]
    fn bodies_that_flew_very_far_break_nothing() {
        let mut solids = crowd(100, 3.0);
        solids[10].1.position = DVec3::splat(1e300);
        solids[20].1.position = DVec3::splat(-1e300);
        assert_eq!(pairs_of(&solids), all_pairs(&solids));
    }

    #[test]
    fn no_bodies_make_no_pairs() {
        assert_eq!(pairs_of(&[]), []);
    }
}
