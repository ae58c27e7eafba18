//! Where the bodies of a crowd hang before they fall into the open box, and how large that
//! is: `balls` and `mixed`.
//!
//! A layer is a spiral r = s (1 + θ/2π) about a body in the middle, with steps of about
//! 1.02 s along the arc, s = 0.66 m being 1.1 diameters of the largest body. Layers lie s
//! apart, each turned against the one below by the golden angle, so that no body hangs
//! right above another; odd layers run from the outside in.

use ch00_maths::f64::real::{PI, cos, sin};
use glam::DVec3;

use super::parts::in_open_box;
use crate::Scene;

/// What a body of a crowd reaches from its centre, at most, m.
pub(super) const LARGEST_RADIUS: f64 = 0.3;
const SPACING: f64 = 2.2 * LARGEST_RADIUS;
const LOWEST_LAYER: f64 = 1.0;
/// The golden angle π (3 − √5), rad, to six places: as in the reference scene.
const TURN: f64 = 2.399_963;

/// A scene with the box for `count` bodies, and the places where these start. The box
/// grows with the cube root of their number.
pub(super) fn open_box_for(name: &str, count: u64, seed: u64) -> (Scene, Vec<DVec3>) {
    let inner = inner_half_extent(count);
    let centres = spiral(count, inner);
    let top = centres.last().map_or(LOWEST_LAYER, |centre| centre.y);
    let wall_height = 10.0 + 3.0 * (top + SPACING);
    let scene = in_open_box(name, [inner, inner], wall_height, seed);
    (scene, centres)
}

/// Half of the inner width of the box, m: 1.5 up to 60 bodies.
#[expect(clippy::cast_precision_loss, reason = "count is at most 100,000")]
fn inner_half_extent(count: u64) -> f64 {
    1.5 * libm::cbrt(count as f64 / 60.0).max(1.0)
}

/// The centres of `count` bodies, layer upon layer.
fn spiral(count: u64, inner: f64) -> Vec<DVec3> {
    let layer = spiral_layer(inner - 0.4);
    let inwards: Vec<_> = layer.iter().rev().copied().collect();
    let mut centres = Vec::new();
    let mut level = 0.0;
    let mut left = usize::try_from(count).unwrap_or(usize::MAX);
    for points in [&layer, &inwards].into_iter().cycle() {
        if left == 0 {
            break;
        }
        for &(radius, angle) in points.iter().take(left) {
            let turned = angle - level * TURN;
            centres.push(DVec3::new(
                radius * cos(turned),
                LOWEST_LAYER + level * SPACING,
                radius * sin(turned),
            ));
        }
        left = left.saturating_sub(points.len());
        level += 1.0;
    }
    centres
}

/// Radius and angle of the points of a layer, from the middle outwards.
fn spiral_layer(outermost: f64) -> Vec<(f64, f64)> {
    let mut points = vec![(0.0, 0.0)];
    let (mut radius, mut angle) = (SPACING, 0.0);
    while radius <= outermost {
        points.push((radius, angle));
        angle += 1.02 * SPACING / radius;
        radius = SPACING * (1.0 + angle / (2.0 * PI));
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measures::Penetration;
    use crate::{Body, Shape, State};

    #[test]
    fn every_place_has_room_for_the_largest_body() {
        for count in [10, 60, 1000, 10_000] {
            let (mut scene, centres) = open_box_for("crowd", count, 1);
            let radius = LARGEST_RADIUS;
            let shape = Shape::Sphere { radius };
            let largest = |centre| Body::new(shape, 1.0, centre);
            scene.bodies.extend(centres.into_iter().map(largest));
            let start = Penetration::of(&scene, &State::start_of(&scene));
            assert_eq!(start.pairs_touching, 0, "{count} bodies: {start:?}");
        }
    }
}
