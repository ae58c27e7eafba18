//! How deep the bodies of a state overlap.

use std::collections::BTreeSet;

use super::broad::near_pairs;
use super::depth::{Placed, depth};
use crate::{Scene, Shape, State};

/// Overlaps of all pairs of bodies that may collide: not two static ones, and not those
/// that a joint connects.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Penetration {
    /// The deepest overlap, m; 0 if nothing overlaps.
    pub deepest: f64,
    /// 99 of 100 overlapping pairs overlap by no more than this, m; 0 if none do.
    pub p99: f64,
    /// The same overlaps as parts of what overlaps.
    pub relative: RelativePenetration,
    /// Pairs that overlap.
    pub pairs_touching: usize,
    /// Pairs whose bounding boxes meet but whose depth is not known: those with a cylinder,
    /// unless a routine for them was given.
    pub pairs_not_measured: usize,
}

/// Overlaps of pairs, each divided by the radius of the smaller of the two: of balls the radius, of other
/// solids that of the largest ball that fits into them. 1 mm is much for a marble and little for a
/// boulder. All are 0 if nothing overlaps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RelativePenetration {
    /// Half of the overlapping pairs overlap by no more than this.
    pub p50: f64,
    /// 99 of 100 overlapping pairs overlap by no more than this.
    pub p99: f64,
    /// The largest.
    pub deepest: f64,
}

impl Penetration {
    /// Measures `state`: the pairs that have a closed form. Bodies with a number that is not
    /// finite are passed over.
    #[must_use]
    pub fn of(scene: &Scene, state: &State) -> Self {
        Self::with(scene, state, |_, _| None)
    }

    /// Measures all pairs of `state`, those without a closed form through parry3d.
    #[cfg(feature = "parry")]
    #[must_use]
    pub fn of_all_pairs(scene: &Scene, state: &State) -> Self {
        Self::with(scene, state, super::convex_depth)
    }

    /// Measures `state`; `others` gives the depth, m, of pairs that have no closed form, or
    /// `None` where it has none either. It means what [`depth`] does.
    #[must_use]
    pub fn with(
        scene: &Scene,
        state: &State,
        others: impl Fn(&Placed, &Placed) -> Option<f64>,
    ) -> Self {
        let solids: Vec<_> = (0..state.len())
            .filter(|&i| state.position[i].is_finite() && state.orientation[i].is_finite())
            .map(|i| (i, Placed::new(scene, state, i)))
            .collect();
        let joined = joined_pairs(scene);
        let (mut depths, mut relative) = (Vec::new(), Vec::new());
        let mut not_measured = 0;
        near_pairs(&solids, |a, b| {
            let both_static = scene.bodies[a].is_static() && scene.bodies[b].is_static();
            if both_static || joined.contains(&(a, b)) {
                return;
            }
            let solid = |i| Placed::new(scene, state, i);
            let (a, b) = (solid(a), solid(b));
            match depth(&a, &b).or_else(|| others(&a, &b)) {
                Some(depth) if depth > 0.0 => {
                    depths.push(depth);
                    relative.push(depth / inner_radius(&a.shape).min(inner_radius(&b.shape)));
                }
                Some(_) => {}
                None => not_measured += 1,
            }
        });
        Self {
            pairs_not_measured: not_measured,
            relative: RelativePenetration::of(relative),
            ..Self::from_depths(depths)
        }
    }

    fn from_depths(mut depths: Vec<f64>) -> Self {
        depths.sort_by(f64::total_cmp);
        Self {
            deepest: percentile(&depths, 100),
            p99: percentile(&depths, 99),
            pairs_touching: depths.len(),
            ..Self::default()
        }
    }
}

impl RelativePenetration {
    fn of(mut depths: Vec<f64>) -> Self {
        depths.sort_by(f64::total_cmp);
        Self {
            p50: percentile(&depths, 50),
            p99: percentile(&depths, 99),
            deepest: percentile(&depths, 100),
        }
    }
}

/// The smallest of the sorted values that at least so many in a hundred don't exceed (nearest rank); 0
/// of none.
#[must_use]
pub fn percentile(sorted: &[f64], in_a_hundred: usize) -> f64 {
    let rank = (sorted.len() * in_a_hundred).div_ceil(100);
    rank.checked_sub(1).map_or(0.0, |last| sorted[last])
}

/// Radius of the largest ball that fits into a solid, m.
fn inner_radius(shape: &Shape) -> f64 {
    match *shape {
        Shape::Sphere { radius } | Shape::Capsule { radius, .. } => radius,
        Shape::Box { half_extents } => half_extents.min_element(),
        Shape::Cylinder {
            radius,
            half_height,
        } => radius.min(half_height),
    }
}

/// Pairs that a joint connects, the lower index first.
fn joined_pairs(scene: &Scene) -> BTreeSet<(usize, usize)> {
    scene
        .joints
        .iter()
        .map(|joint| {
            let (a, b) = joint.bodies();
            (a.min(b), a.max(b))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::{Body, Joint, Shape};

    fn row_of_balls(gaps: &[f64]) -> Scene {
        let ball = Shape::Sphere { radius: 0.5 };
        let mut scene = Scene::new("row");
        let mut x = 0.0;
        scene.bodies.push(Body::new(ball, 1.0, DVec3::ZERO));
        for gap in gaps {
            x += 1.0 + gap;
            scene.bodies.push(Body::new(ball, 1.0, DVec3::X * x));
        }
        scene
    }

    fn start(scene: &Scene) -> Penetration {
        Penetration::of(scene, &State::start_of(scene))
    }

    #[test]
    fn the_deepest_of_three_overlaps_is_found() {
        let found = start(&row_of_balls(&[-0.01, 0.02, -0.03, -0.02]));
        assert!((found.deepest - 0.03).abs() < 1e-12, "{found:?}");
        assert_eq!(found.pairs_touching, 3);
    }

    #[test]
    fn the_99th_percentile_of_a_hundred_depths_leaves_out_the_deepest() {
        let depths = (1..=100).map(f64::from).rev().collect();
        let found = Penetration::from_depths(depths);
        assert_eq!((found.p99, found.deepest), (99.0, 100.0));
    }

    #[test]
    fn the_99th_percentile_of_few_depths_is_the_deepest() {
        let found = Penetration::from_depths(vec![2.0, 1.0]);
        assert_eq!((found.p99, found.deepest), (2.0, 2.0));
    }

    #[test]
    fn half_of_the_overlaps_are_no_deeper_than_the_50th_percentile() {
        let found = RelativePenetration::of(vec![0.4, 0.1, 0.3, 0.2]);
        assert_eq!((found.p50, found.p99, found.deepest), (0.2, 0.4, 0.4));
        assert_eq!(RelativePenetration::of(vec![0.5]).p50, 0.5);
    }

    #[test]
    fn an_overlap_is_divided_by_the_radius_of_the_smaller_ball() {
        let mut scene = row_of_balls(&[-0.01, -0.02]);
        // Shrunk about its centre, the last overlaps the middle one by 0.02 − 0.01.
        scene.bodies[2].shape = Shape::Sphere { radius: 0.49 };
        let found = start(&scene).relative;
        let exact = [0.01 / 0.5, 0.01 / 0.49];
        assert!((found.p50 - exact[0]).abs() < 1e-12, "{found:?}");
        assert!((found.deepest - exact[1]).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn a_solid_that_is_no_ball_counts_as_the_largest_ball_in_it() {
        let half_extents = DVec3::new(2.0, 0.25, 3.0);
        let (radius, half_height) = (0.4, 0.3);
        let solids = [
            (Shape::Sphere { radius }, 0.4),
            (Shape::Box { half_extents }, 0.25),
            (
                Shape::Capsule {
                    radius,
                    half_height,
                },
                0.4,
            ),
            (
                Shape::Cylinder {
                    radius,
                    half_height,
                },
                0.3,
            ),
        ];
        for (shape, expected) in solids {
            assert_eq!(inner_radius(&shape), expected, "{shape:?}");
        }
    }

    #[test]
    fn without_overlap_all_is_zero() {
        assert_eq!(start(&row_of_balls(&[0.1])), Penetration::default());
    }

    #[test]
    fn bodies_that_a_joint_connects_may_overlap() {
        let mut scene = row_of_balls(&[-0.1, -0.2]);
        scene.joints.push(Joint::Distance {
            a: 2,
            b: 1,
            anchor_a: DVec3::ZERO,
            anchor_b: DVec3::ZERO,
            length: 0.8,
        });
        let found = start(&scene);
        assert_eq!(found.pairs_touching, 1);
        assert!((found.deepest - 0.1).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn static_bodies_may_overlap_each_other_but_not_a_ball() {
        let mut scene = row_of_balls(&[-0.1, -0.2]);
        scene.bodies[0].mass = 0.0;
        scene.bodies[1].mass = 0.0;
        let found = start(&scene);
        assert_eq!(found.pairs_touching, 1);
        assert!((found.deepest - 0.2).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn a_tower_of_boxes_is_measured() {
        let text = include_str!("../../../../tests/reference/scenes/half_metre_boxes_15.json");
        let mut scene = Scene::from_json(text, "half_metre_boxes_15.json").unwrap();
        assert!(start(&scene).deepest < 1e-12, "{:?}", start(&scene));
        scene.bodies[8].position.y -= 0.03;
        let found = start(&scene);
        assert!((found.deepest - 0.03).abs() < 1e-12, "{found:?}");
        assert_eq!(found.pairs_not_measured, 0);
    }

    /// A cylinder that stands a centimetre deep in a floor.
    fn cylinder_on_floor() -> Scene {
        let (radius, half_height) = (0.3, 0.2);
        let cylinder = Shape::Cylinder {
            radius,
            half_height,
        };
        let half_extents = DVec3::new(2.0, 0.5, 2.0);
        let mut scene = Scene::new("cylinder");
        scene.bodies = vec![
            Body::new(Shape::Box { half_extents }, 0.0, DVec3::Y * -0.5),
            Body::new(cylinder, 1.0, DVec3::Y * 0.19),
        ];
        scene
    }

    #[test]
    fn a_cylinder_is_counted_as_not_measured_unless_a_routine_is_given() {
        let scene = cylinder_on_floor();
        let found = start(&scene);
        assert_eq!((found.pairs_touching, found.pairs_not_measured), (0, 1));
        let state = State::start_of(&scene);
        let found = Penetration::with(&scene, &state, |_, _| Some(0.01));
        assert_eq!((found.pairs_touching, found.pairs_not_measured), (1, 0));
        assert_eq!(found.deepest, 0.01);
    }

    #[cfg(feature = "parry")]
    #[test]
    fn with_parry_all_pairs_are_measured() {
        let scene = cylinder_on_floor();
        let found = Penetration::of_all_pairs(&scene, &State::start_of(&scene));
        assert!((found.deepest - 0.01).abs() < 1e-9, "{found:?}");
        assert_eq!(found.pairs_not_measured, 0);
    }

    #[test]
    fn a_ball_sunk_into_the_floor_is_measured() {
        let mut scene = crate::builtin::build("bounce", None, None).unwrap();
        scene.bodies[1].position.y = 0.08;
        let found = start(&scene);
        assert!((found.deepest - 0.02).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn the_ragdolls_of_the_reference_start_apart() {
        let text = include_str!("../../../../tests/reference/scenes/ragdolls_5.json");
        let scene = Scene::from_json(text, "ragdolls_5.json").unwrap();
        let found = start(&scene);
        assert_eq!(found.pairs_not_measured, 0);
        assert!(found.deepest < 0.1, "{found:?}");
    }
}
