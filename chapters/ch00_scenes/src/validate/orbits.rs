//! The checks of one orbit, and that orbits form trees.

use super::Place;
use crate::{Orbit, SceneError};

pub(super) fn check(orbits: &[Orbit], index: usize, at: &Place) -> Result<(), SceneError> {
    let orbit = &orbits[index];
    at.body("body", orbit.body)?;
    at.at_least_zero("radius", orbit.radius)?;
    at.finite("tilt", orbit.tilt)?;
    at.finite("phase", orbit.phase)?;
    at.finite("rate", orbit.rate)?;
    at.finite("spin", orbit.spin)?;
    at.demand(
        orbits[..index].iter().all(|other| other.body != orbit.body),
        "body",
        || orbit.body.to_string(),
        "a body has one orbit at most",
    )?;
    let Some(parent) = orbit.parent else {
        return Ok(());
    };
    at.body("parent", parent)?;
    at.demand(
        !circles_itself(orbits, orbit),
        "parent",
        || parent.to_string(),
        "a body can't circle itself, not even by way of others",
    )
}

/// Whether the parents of `orbit` lead back to its body. Each step goes to another orbit
/// of the list, so a walk longer than the list has met one twice: a ring further up.
fn circles_itself(orbits: &[Orbit], orbit: &Orbit) -> bool {
    let mut ancestor = orbit.parent;
    for _ in 0..=orbits.len() {
        let Some(body) = ancestor else {
            return false;
        };
        if body == orbit.body {
            return true;
        }
        let above = orbits.iter().find(|other| other.body == body);
        ancestor = above.and_then(|other| other.parent);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::super::assert_refused;
    use crate::Orbit;

    fn orbit(body: usize, parent: Option<usize>) -> Orbit {
        Orbit {
            body,
            parent,
            radius: 1.0,
            tilt: 0.0,
            phase: 0.0,
            rate: 1.0,
            spin: 0.0,
        }
    }

    #[test]
    fn a_ring_of_parents_is_refused() {
        assert_refused(
            |scene| scene.orbits = vec![orbit(0, Some(1)), orbit(1, Some(0))],
            "file.json: orbits[0].parent = 1: a body can't circle itself",
        );
    }

    #[test]
    fn a_body_that_circles_itself_is_refused() {
        assert_refused(
            |scene| scene.orbits = vec![orbit(1, Some(1))],
            "file.json: orbits[0].parent = 1: a body can't circle itself",
        );
    }

    #[test]
    fn a_second_orbit_of_a_body_is_refused() {
        assert_refused(
            |scene| scene.orbits = vec![orbit(1, None), orbit(1, Some(0))],
            "file.json: orbits[1].body = 1: a body has one orbit",
        );
    }

    #[test]
    fn a_parent_that_does_not_exist_is_named() {
        assert_refused(
            |scene| scene.orbits = vec![orbit(1, Some(9))],
            "file.json: orbits[0].parent = 9 (of 2 bodies): ",
        );
    }

    #[test]
    fn an_endless_rate_is_refused() {
        assert_refused(
            |scene| {
                scene.orbits = vec![Orbit {
                    rate: f64::NAN,
                    ..orbit(1, None)
                }];
            },
            "file.json: orbits[0].rate = NaN: ",
        );
    }
}
