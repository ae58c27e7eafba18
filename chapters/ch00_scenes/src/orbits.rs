//! Prescribed motions in closed form: where bodies with an [`Orbit`] are at any time.
//!
//! An orbit is three nested nodes. The *frame* of a body is the frame of its parent (the
//! world's if it has none), tilted about x, turned about y by φ = phase + rate · t, and
//! moved out along x by radius:
//!
//! ```text
//! R = R_parent · R_x(tilt) · R_y(φ)        p = p_parent + R · (radius, 0, 0)
//! ```
//!
//! Its children hang in this frame. The body itself is turned in it by spin · t about y,
//! which its children don't feel: otherwise a planet's day would sweep its moons along.
//! A moon's rate is thus relative to the line from the sun to its planet, as in any scene
//! graph. [`Orbit`]s that engines nest as nodes are compared with this.

use glam::{DQuat, DVec3};

use crate::{Orbit, Scene, State};

/// A frame in the world and how it moves.
#[derive(Clone, Copy)]
struct Frame {
    origin: DVec3,
    rotation: DQuat,
    velocity: DVec3,
    omega: DVec3,
}

/// The state at `time` seconds after the start: bodies with an orbit where it takes them,
/// with the velocities of that motion; all others as the scene has them.
///
/// The scene must be valid: the parents of orbits form trees.
#[must_use]
pub fn state_at(scene: &Scene, time: f64) -> State {
    let mut state = State::start_of(scene);
    for orbit in &scene.orbits {
        let frame = frame_of(scene, orbit.body, time);
        let spin = frame.rotation * DQuat::from_rotation_y(orbit.spin * time);
        let body = orbit.body;
        state.position[body] = frame.origin;
        state.orientation[body] = spin;
        state.linear_velocity[body] = frame.velocity;
        state.angular_velocity[body] = frame.omega + frame.rotation * DVec3::Y * orbit.spin;
    }
    state
}

/// The frame in which children of `body` hang.
fn frame_of(scene: &Scene, body: usize, time: f64) -> Frame {
    match scene.orbits.iter().find(|orbit| orbit.body == body) {
        Some(orbit) => step_out(parent_frame(scene, orbit, time), orbit, time),
        None => Frame {
            origin: scene.bodies[body].position,
            rotation: scene.bodies[body].orientation,
            velocity: DVec3::ZERO,
            omega: DVec3::ZERO,
        },
    }
}

fn parent_frame(scene: &Scene, orbit: &Orbit, time: f64) -> Frame {
    const WORLD: Frame = Frame {
        origin: DVec3::ZERO,
        rotation: DQuat::IDENTITY,
        velocity: DVec3::ZERO,
        omega: DVec3::ZERO,
    };
    orbit
        .parent
        .map_or(WORLD, |parent| frame_of(scene, parent, time))
}

/// From the parent's frame to that of the body which circles it.
fn step_out(parent: Frame, orbit: &Orbit, time: f64) -> Frame {
    let plane = parent.rotation * DQuat::from_rotation_x(orbit.tilt);
    let rotation = plane * DQuat::from_rotation_y(orbit.phase + orbit.rate * time);
    let arm = rotation * DVec3::X * orbit.radius;
    let omega = parent.omega + plane * DVec3::Y * orbit.rate;
    Frame {
        origin: parent.origin + arm,
        rotation,
        velocity: parent.velocity + omega.cross(arm),
        omega,
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::{Body, Shape, builtin};

    fn orbit(body: usize, parent: Option<usize>, radius: f64, rate: f64) -> Orbit {
        Orbit {
            body,
            parent,
            radius,
            tilt: 0.0,
            phase: 0.0,
            rate,
            spin: 0.0,
        }
    }

    fn system(orbits: Vec<Orbit>) -> Scene {
        let mut scene = Scene::new("system");
        let ball = Shape::Sphere { radius: 0.1 };
        scene.bodies = vec![Body::new(ball, 1.0, DVec3::ZERO); 3];
        scene.orbits = orbits;
        scene
    }

    fn assert_near(a: DVec3, b: DVec3, tolerance: f64) {
        assert!(a.distance(b) <= tolerance, "{a} is not {b}");
    }

    #[test]
    fn a_quarter_turn_about_y_leads_from_x_to_minus_z() {
        let scene = system(vec![orbit(0, None, 2.0, FRAC_PI_2)]);
        let state = state_at(&scene, 1.0);
        assert_near(state.position[0], DVec3::new(0.0, 0.0, -2.0), 1e-15);
    }

    #[test]
    fn a_tilt_of_a_right_angle_turns_the_plane_upright() {
        let upright = Orbit {
            tilt: FRAC_PI_2,
            ..orbit(0, None, 2.0, FRAC_PI_2)
        };
        let state = state_at(&system(vec![upright]), 1.0);
        assert_near(state.position[0], DVec3::new(0.0, 2.0, 0.0), 1e-15);
    }

    #[test]
    fn a_moon_at_rest_in_its_planets_frame_is_carried_round() {
        let scene = system(vec![orbit(0, None, 2.0, PI), orbit(1, Some(0), 0.5, 0.0)]);
        let state = state_at(&scene, 1.0);
        assert_near(state.position[1], DVec3::new(-2.5, 0.0, 0.0), 1e-15);
    }

    #[test]
    fn a_planets_day_does_not_sweep_its_moon_along() {
        let spinning = Orbit {
            spin: 5.0,
            ..orbit(0, None, 2.0, 0.0)
        };
        let scene = system(vec![spinning, orbit(1, Some(0), 0.5, 0.0)]);
        let state = state_at(&scene, 1.0);
        assert_near(state.position[1], DVec3::new(2.5, 0.0, 0.0), 1e-15);
        assert_near(state.angular_velocity[0], DVec3::Y * 5.0, 1e-15);
    }

    #[test]
    fn a_moon_of_a_body_without_orbit_circles_where_that_body_stands() {
        let mut scene = system(vec![orbit(1, Some(2), 0.5, 0.0)]);
        scene.bodies[2].position = DVec3::new(0.0, 3.0, 0.0);
        let state = state_at(&scene, 0.0);
        assert_near(state.position[1], DVec3::new(0.5, 3.0, 0.0), 1e-15);
    }

    #[test]
    fn velocities_are_the_slopes_of_the_positions() {
        let scene = builtin::build("orrery", None, None).unwrap();
        let (time, step) = (3.7, 1e-5);
        let [before, now, after] = [time - step, time, time + step].map(|t| state_at(&scene, t));
        for i in 0..scene.bodies.len() {
            let slope = (after.position[i] - before.position[i]) / (2.0 * step);
            // Off by step²/6 times the third derivative, 1e3 m/s³ at the most here.
            assert_near(slope, now.linear_velocity[i], 1e-7);
            let turn = after.orientation[i] * before.orientation[i].conjugate();
            let omega = turn.to_scaled_axis() / (2.0 * step);
            assert_near(omega, now.angular_velocity[i], 1e-7);
        }
    }
}
