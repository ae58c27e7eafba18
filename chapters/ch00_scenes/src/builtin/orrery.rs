//! A sun, planets, moons and a moon's moon: nothing but nested nodes, each of which
//! circles its parent on a tilted plane and spins. The motions are prescribed, not
//! simulated, and known in closed form ([`crate::orbits`]).

use glam::DVec3;

use crate::{Body, Orbit, Scene, Shape, orbits};

const SUN: usize = 0;
const BLUE_PLANET: usize = 2;
const GIANT: usize = 4;
const FAR_MOON: usize = 6;

/// The scene, with every body where its orbit has it at the start.
pub(super) fn build() -> Scene {
    let mut scene = Scene::new("orrery");
    scene.gravity = DVec3::ZERO;
    for (shape, orbit) in nodes() {
        let mass = 1000.0 * shape.volume();
        scene.bodies.push(Body::new(shape, mass, DVec3::ZERO));
        scene.orbits.push(orbit);
    }
    let start = orbits::state_at(&scene, 0.0);
    for (i, body) in scene.bodies.iter_mut().enumerate() {
        body.position = start.position[i];
        body.orientation = start.orientation[i];
        body.linear_velocity = start.linear_velocity[i];
        body.angular_velocity = start.angular_velocity[i];
    }
    scene
}

/// The bodies in the order of their indices; parents come before what circles them.
fn nodes() -> Vec<(Shape, Orbit)> {
    let sphere = |radius| Shape::Sphere { radius };
    let station = Shape::Box {
        half_extents: DVec3::new(0.07, 0.02, 0.03),
    };
    let around = |body, parent, radius, tilt, phase, rate, spin| Orbit {
        body,
        parent: Some(parent),
        radius,
        tilt,
        phase,
        rate,
        spin,
    };
    let sun = Orbit {
        parent: None,
        ..around(SUN, SUN, 0.0, 0.1, 0.0, 0.0, 0.3)
    };
    vec![
        (sphere(0.8), sun),
        (sphere(0.14), around(1, SUN, 1.5, 0.12, 0.4, 1.3, 0.2)),
        (
            sphere(0.24),
            around(BLUE_PLANET, SUN, 2.5, 0.0, 2.0, 0.8, 4.0),
        ),
        (
            sphere(0.07),
            around(3, BLUE_PLANET, 0.55, 0.4, 0.0, 2.9, 0.0),
        ),
        (sphere(0.5), around(GIANT, SUN, 4.9, -0.1, 4.2, 0.35, 2.5)),
        (sphere(0.1), around(5, GIANT, 0.75, 0.05, 1.0, 2.4, 0.0)),
        (
            sphere(0.16),
            around(FAR_MOON, GIANT, 1.3, -0.5, 3.0, 1.1, 0.0),
        ),
        (sphere(0.05), around(7, FAR_MOON, 0.28, 0.9, 0.0, 4.5, 0.0)),
        (sphere(0.2), around(8, SUN, 7.4, 0.3, 5.5, -0.2, 1.0)),
        (station, around(9, BLUE_PLANET, 0.34, 1.4, 1.5, 3.7, 1.0)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::State;
    use crate::measures::Penetration;

    #[test]
    fn every_body_starts_where_its_orbit_has_it() {
        let scene = build();
        assert_eq!(State::start_of(&scene), orbits::state_at(&scene, 0.0));
    }

    #[test]
    fn no_two_bodies_meet_in_ten_minutes() {
        let scene = build();
        for tenth in 0..6000 {
            let state = orbits::state_at(&scene, f64::from(tenth) * 0.1);
            let found = Penetration::of(&scene, &state);
            assert_eq!(found.pairs_touching, 0, "at {tenth} tenths of a second");
        }
    }

    #[test]
    fn a_moon_of_a_moon_circles_three_bodies_at_once() {
        let scene = build();
        let mut body = Some(7);
        let mut depth = 0;
        while let Some(orbit) = scene.orbits.iter().find(|o| Some(o.body) == body) {
            body = orbit.parent;
            depth += 1;
        }
        assert_eq!(depth, 4, "the moon's moon, its moon, the giant and the sun");
    }
}
