//! A heavy cube on a light one, scenario 21: edge 1 m, 1 kg under k kg, exactly touching.
//!
//! It should stand for ever; the floor carries (1 + k) g and the upper contact k g. A
//! sequential solver leaves k/(k + 1) of the error at each sweep: to 1 % it takes 463
//! sweeps for k = 100 and 4607 for k = 1000.

use crate::Scene;

use super::stack::tower;

/// The scene in which the upper cube, body 2, has `ratio` times the mass of the lower.
pub(super) fn build(ratio: u64) -> Scene {
    tower("heavy_on_light", [1.0, ratio as f64].into_iter())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_cube_has_the_mass_that_was_asked_for() {
        let scene = build(1000);
        let masses: Vec<f64> = scene.bodies.iter().map(|body| body.mass).collect();
        assert_eq!(masses, [0.0, 1.0, 1000.0]);
    }
}
