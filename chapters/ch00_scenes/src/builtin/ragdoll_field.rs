//! The ragdolls of `ragdolls` over a wide floor: stacks of one, two and three in turn, so low that
//! ten thousand of them lie still after ten seconds.
//!
//! The floor grows with their number, so that what a step costs per ragdoll can be compared. What a
//! ragdoll is, how it starts and how wide a stack is are as in `ragdolls`.

use glam::DVec3;

use super::parts::in_open_box;
use super::ragdolls::{DRAG, INNER, PIVOT, SPACING, add_ragdoll};
use crate::Scene;
use crate::random::SplitMix64;

/// Ragdolls of a highest stack. Stack k has 1 + k mod this.
const HIGHEST_STACK: u64 = 3;
/// Height of the lowest soles in a stack, m.
const LOWEST_SOLES: f64 = 0.1;
const WALL_HEIGHT: f64 = LOWEST_SOLES + SPACING * HIGHEST_STACK as f64 + 2.0;

/// The scene with `count` ragdolls.
pub(super) fn build(count: u64, seed: u64) -> Scene {
    let places = places(count);
    let stacks = places.last().map_or(1, |[stack, _]| stack + 1);
    let along_x = stacks.isqrt();
    let along_z = stacks.div_ceil(along_x);
    let inner = [along_x, along_z].map(|stacks| INNER * stacks as f64);

    let mut scene = in_open_box("ragdoll_field", inner, WALL_HEIGHT, seed);
    scene.drag = DRAG;
    let mut random = SplitMix64::new(seed);
    for [stack, layer] in places {
        let middle = |k: u64, inner: f64| INNER * (2.0 * k as f64 + 1.0) - inner;
        let pivot = DVec3::new(
            middle(stack % along_x, inner[0]),
            LOWEST_SOLES + PIVOT + SPACING * layer as f64,
            middle(stack / along_x, inner[1]),
        );
        add_ragdoll(&mut scene, pivot, &mut random);
    }
    scene
}

/// Stack and layer of each ragdoll, from the bottom of the first stack to the top of the last.
fn places(count: u64) -> Vec<[u64; 2]> {
    let layers = |stack| (0..=stack % HIGHEST_STACK).map(move |layer| [stack, layer]);
    (0..).flat_map(layers).take(count as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::builtin::ragdolls::{BONES, body};
    use crate::measures::{Penetration, escaped, joint_separation, limit_excess};

    #[test]
    fn stacks_have_one_two_and_three_ragdolls_in_turn() {
        let expected = [[0, 0], [1, 0], [1, 1], [2, 0], [2, 1], [2, 2], [3, 0]];
        assert_eq!(places(7), expected);
    }

    #[test]
    fn ragdolls_start_in_one_piece_within_their_limits_and_touch_nothing() {
        for count in [1, 2, 6, 20, 1000] {
            let scene = build(count, 3);
            assert_eq!(scene.dynamic_count(), BONES.len() * count as usize);
            let start = State::start_of(&scene);
            let touching = Penetration::of(&scene, &start).pairs_touching;
            assert_eq!(touching, 0, "{count} ragdolls");
            assert_eq!(escaped(&scene, &start), Some(0));
            assert!(joint_separation(&scene, &start).unwrap() < 1e-14);
            assert!(limit_excess(&scene, &start).unwrap() < 1e-14);
        }
    }

    #[test]
    fn the_floor_grows_with_the_number_of_ragdolls() {
        // Half a stack each, of 1.7 m by 1.7 m.
        for (count, off) in [(6, 0.4), (60, 0.1), (6000, 0.02)] {
            let [x, z] = build(count, 1).meta_pair("inner_half_extents").unwrap();
            let each = 4.0 * x * z / count as f64;
            assert!((each / 1.445 - 1.0).abs() < off, "{count}: {each}");
        }
    }

    #[test]
    fn bones_have_the_names_of_ragdolls() {
        let scene = build(6, 1);
        let thigh = BONES.iter().position(|bone| *bone == "left thigh").unwrap();
        let [first, fifth] = [0, 4].map(|ragdoll| &scene.bodies[body(ragdoll, thigh)]);
        assert_eq!(first.shape, fifth.shape);
        assert!((fifth.position.y - first.position.y - SPACING).abs() < 0.1);
    }

    #[test]
    fn the_same_seed_gives_the_same_ragdolls_and_another_seed_others() {
        assert_eq!(build(2, 5), build(2, 5));
        assert_ne!(build(2, 5).bodies, build(2, 6).bodies);
    }
}
