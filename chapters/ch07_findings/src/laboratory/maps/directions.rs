//! 15: how far a box slides in every direction. Friction that is one cone lets it stop on a circle; friction
//! that is limited along two axes by themselves, on another curve.

use glam::DVec3;

use super::{Map, Who, thinned};
use crate::chart::Axis;
use crate::lab::Moment;
use crate::laboratory::scenario::{Verdict, Watch, timed};
use crate::laboratory::scenarios::friction_directions::{HALF, WAY, scene};

/// 1/s.
const RATE: u32 = 60;

/// A cell of the first y has where the box stops along x, one of the second where along z.
pub const X: f64 = 0.0;
pub const Z: f64 = 1.0;

pub const MAP: Map = Map {
    number: "15",
    name: "directions",
    title: "Where boxes stop that slide in every direction",
    value: "where the box stops after 1.5 s, x (under y = 0) and z (under y = 1) (m)",
    axes: || [Axis::linear("x (m)"), Axis::linear("z (m)")],
    grid: |quick| {
        let angles = (0..48).map(|k| 7.5 * f64::from(k));
        [thinned(angles.collect(), quick), vec![X, Z]]
    },
    bounds: [f64::INFINITY, f64::INFINITY],
    classes: ["", "", ""],
    better_upwards: true,
    theory: "one cone, a circle; two axes by themselves, a square",
    who: || {
        let names = [
            "corrected",
            "own-row",
            "coloured",
            "sequential-impulses",
            "soft-step",
            "xpbd",
            "direct-joints",
            "rapier",
            "rapier tuned",
        ];
        Who::all(names).collect()
    },
    scene: |angle, _, _| {
        let start = DVec3::Y * HALF.y;
        let boxes = [(start, direction(angle))];
        Ok(timed(scene(boxes.into_iter()), RATE, 1.5))
    },
    watcher: |_, _, part| Box::new(Stop { part, at: f64::NAN }),
};

/// Looks at the last step.
struct Stop {
    part: f64,
    /// m.
    at: f64,
}

impl Watch for Stop {
    fn see(&mut self, now: &Moment) {
        let at = now.state.position[1];
        self.at = if self.part == X { at.x } else { at.z };
    }

    fn verdict(&self) -> Verdict {
        Verdict::of(self.at)
    }
}

/// A direction over the floor, degrees from x.
fn direction(angle: f64) -> DVec3 {
    let (sin, cos) = angle.to_radians().sin_cos();
    DVec3::new(cos, 0.0, sin)
}

/// Where boxes stop by theory: on a circle, and where each axis has its own limit.
pub fn theory() -> [Vec<(f64, f64)>; 2] {
    let angles = || (0..=180).map(|k| 2.0 * f64::from(k));
    let circle = angles().map(|angle| {
        let at = direction(angle) * WAY;
        (at.x, at.z)
    });
    let pyramid = angles().map(|angle| {
        let (sin, cos) = angle.to_radians().sin_cos();
        // Both axes brake until they stand still: to cos α |cos α| and sin α |sin α| of the way.
        (WAY * cos * cos.abs(), WAY * sin * sin.abs())
    });
    [circle.collect(), pyramid.collect()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pyramid_is_that_of_the_reference() {
        let [circle, pyramid] = theory();
        let far = |(x, z): (f64, f64)| x.hypot(z);
        assert!(
            circle
                .iter()
                .all(|at| (far(*at) - 1.630_988_787).abs() < 1e-9)
        );
        // 22.5° isn't among them; 45° is not either, 44° and 46° are its neighbours.
        let at_45 = 0.5 * (far(pyramid[22]) + far(pyramid[23]));
        assert!((at_45 - 1.153_283_231).abs() < 2e-3, "{at_45}");
    }
}
