//! What judges a run: energy, momentum, penetration, what is wrong with joints, escapes; from
//! scene and state alone, in f64, in closed form. No engine shares this code.
//!
//! Spheres, capsules and boxes against each other are measured here. Pairs with a cylinder
//! have no short closed form: they are counted in [`Penetration::pairs_not_measured`], unless
//! whoever measures brings a routine for them ([`Penetration::with`]). With the feature
//! `parry` there is one, `convex_depth`; the tests and the laboratory switch it on.

mod boxes;
mod broad;
mod conserved;
#[cfg(feature = "parry")]
mod convex;
mod depth;
mod joints;
mod limits;
mod penetration;

use crate::{Scene, State};

pub use conserved::{Conserved, Reference, kinetic_energy_of, magnet_energy};
#[cfg(feature = "parry")]
pub use convex::convex_depth;
pub use depth::{Placed, depth};
pub use joints::{joint_separation, joint_separations};
pub use limits::{hinge_misalignment, limit_excess, limit_excesses};
pub use penetration::{Penetration, RelativePenetration, percentile};

/// Everything that is measured of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Energy and momentum.
    pub conserved: Conserved,
    /// How deep bodies overlap.
    pub penetration: Penetration,
    /// The largest distance between points that a joint holds together, m; `None` in a
    /// scene without joints.
    pub joint_separation: Option<f64>,
    /// The largest angle by which a joint is beyond its limits, rad; `None` in a scene
    /// without such limits.
    pub limit_excess: Option<f64>,
    /// The largest angle between the two axes of a hinge, rad; `None` in a scene without
    /// hinges.
    pub hinge_misalignment: Option<f64>,
    /// Bodies outside the box; `None` where the scene's `meta` has no
    /// `inner_half_extents`.
    pub escaped: Option<usize>,
    /// Bodies with a number that is not finite. Sums over such a state are not finite
    /// either; the other measures pass over these bodies.
    pub not_finite: usize,
}

impl Measures {
    /// Measures `state`, which has the scene's bodies.
    #[must_use]
    pub fn of(scene: &Scene, state: &State) -> Self {
        Self::with_penetration(scene, state, Penetration::of(scene, state))
    }

    /// The same with the overlaps of pairs that have no closed form.
    #[cfg(feature = "parry")]
    #[must_use]
    pub fn of_all_pairs(scene: &Scene, state: &State) -> Self {
        Self::with_penetration(scene, state, Penetration::of_all_pairs(scene, state))
    }

    /// The same where the overlaps have been measured already.
    #[must_use]
    pub fn with_penetration(scene: &Scene, state: &State, penetration: Penetration) -> Self {
        Self {
            conserved: Conserved::of(scene, state),
            penetration,
            joint_separation: joint_separation(scene, state),
            limit_excess: limit_excess(scene, state),
            hinge_misalignment: hinge_misalignment(scene, state),
            escaped: escaped(scene, state),
            not_finite: state.not_finite(),
        }
    }
}

/// Bodies that can move and whose centre is outside the inner half-extents in x or z, or
/// under the floor's top y = 0; `None` where the scene's `meta` has no such box. The box
/// has no lid, so above is not outside.
#[must_use]
pub fn escaped(scene: &Scene, state: &State) -> Option<usize> {
    let [inner_x, inner_z] = scene.meta_pair("inner_half_extents")?;
    let outside = |i: &usize| {
        let p = state.position[*i];
        p.x.abs() > inner_x || p.z.abs() > inner_z || p.y < 0.0
    };
    let moving = (0..state.len()).filter(|&i| !scene.bodies[i].is_static());
    Some(moving.filter(outside).count())
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::builtin;

    fn balls() -> (Scene, State) {
        let scene = builtin::build("balls", Some(3), None).unwrap();
        let state = State::start_of(&scene);
        (scene, state)
    }

    #[test]
    fn a_ball_above_the_open_box_has_not_escaped() {
        let (scene, mut state) = balls();
        state.position[5] = DVec3::new(0.0, 1000.0, 0.0);
        assert_eq!(escaped(&scene, &state), Some(0));
    }

    #[test]
    fn balls_beyond_a_wall_and_under_the_floor_have_escaped() {
        let (scene, mut state) = balls();
        state.position[5] = DVec3::new(1.51, 1.0, 0.0);
        state.position[7] = DVec3::new(0.0, -0.01, 0.0);
        assert_eq!(escaped(&scene, &state), Some(2));
    }

    #[test]
    fn a_scene_without_a_box_has_no_escapes_to_count() {
        let scene = builtin::build("pair", None, None).unwrap();
        assert_eq!(escaped(&scene, &State::start_of(&scene)), None);
    }

    #[test]
    fn a_body_that_is_not_a_number_is_counted_and_breaks_no_other_measure() {
        let (scene, mut state) = balls();
        state.position[6] = DVec3::NAN;
        let measures = Measures::of(&scene, &state);
        assert_eq!(measures.not_finite, 1);
        assert!(measures.conserved.potential_energy.is_nan());
        assert_eq!(measures.penetration.pairs_touching, 0);
    }
}
