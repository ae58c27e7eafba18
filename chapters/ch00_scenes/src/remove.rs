//! Taking a body out of a scene: what names bodies by index must go on naming the same ones.

use thiserror::Error;

use crate::{Body, Force, Joint, Orbit, Scene};

/// Why a body can't be removed.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum RemoveError {
    /// There is no such body.
    #[error("there is no body {body}: the scene has {bodies}")]
    NoSuchBody {
        /// Index that was asked for.
        body: usize,
        /// How many there are.
        bodies: usize,
    },
    /// A joint holds it.
    #[error("body {body} is held by joint {joint}; remove that first")]
    HeldByJoint {
        /// Index of the body.
        body: usize,
        /// Index of the joint.
        joint: usize,
    },
    /// A force acts on it by name: a magnet sits in it, or it hangs on a fixed point.
    #[error("body {body} is named by force {force}")]
    HeldByForce {
        /// Index of the body.
        body: usize,
        /// Index of the force.
        force: usize,
    },
    /// It is moved along an orbit, or another body's orbit goes round it.
    #[error("body {body} is named by orbit {orbit}")]
    HeldByOrbit {
        /// Index of the body.
        body: usize,
        /// Index of the orbit.
        orbit: usize,
    },
    /// The engine can't remove bodies.
    #[error("engine `{engine}` can't remove bodies in mid-run; `properties` can")]
    Unsupported {
        /// Name of the engine.
        engine: &'static str,
    },
}

impl Scene {
    /// Says why this body can't be removed, if it can't.
    ///
    /// # Errors
    /// [`RemoveError`] with what holds it.
    pub fn check_removal(&self, body: usize) -> Result<(), RemoveError> {
        if body >= self.bodies.len() {
            let bodies = self.bodies.len();
            return Err(RemoveError::NoSuchBody { body, bodies });
        }
        let holds = |joint: &Joint| joint.bodies().0 == body || joint.bodies().1 == body;
        if let Some(joint) = self.joints.iter().position(holds) {
            return Err(RemoveError::HeldByJoint { body, joint });
        }
        let acts = |force: &Force| match force {
            Force::Magnets { poles, .. } => poles.iter().any(|pole| pole.body == body),
            Force::FixedPoint { body: held, .. } | Force::Constant { body: held, .. } => {
                *held == body
            }
        };
        if let Some(force) = self.forces.iter().position(acts) {
            return Err(RemoveError::HeldByForce { body, force });
        }
        let names = |orbit: &Orbit| orbit.body == body || orbit.parent == Some(body);
        if let Some(orbit) = self.orbits.iter().position(names) {
            return Err(RemoveError::HeldByOrbit { body, orbit });
        }
        Ok(())
    }

    /// Removes a body; those after it move up by one, wherever they are named.
    ///
    /// # Errors
    /// [`RemoveError`] with what holds it; nothing has changed then.
    pub fn remove_body(&mut self, body: usize) -> Result<Body, RemoveError> {
        self.check_removal(body)?;
        let moved_up = |index: &mut usize| *index -= usize::from(*index > body);
        for joint in &mut self.joints {
            let (Joint::Ball { a, b, .. }
            | Joint::Distance { a, b, .. }
            | Joint::Hinge { a, b, .. }) = joint;
            moved_up(a);
            moved_up(b);
        }
        for force in &mut self.forces {
            match force {
                Force::Magnets { poles, .. } => {
                    for pole in poles {
                        moved_up(&mut pole.body);
                    }
                }
                Force::FixedPoint { body: held, .. } | Force::Constant { body: held, .. } => {
                    moved_up(held);
                }
            }
        }
        for orbit in &mut self.orbits {
            moved_up(&mut orbit.body);
            orbit.parent.iter_mut().for_each(moved_up);
        }
        Ok(self.bodies.remove(body))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_after_a_removed_body_is_still_named() {
        let mut scene = Scene::open("door", None, None).expect("a built-in");
        let lone = Body::new(scene.bodies[0].shape, 1.0, glam::DVec3::new(9.0, 9.0, 9.0));
        scene.bodies.insert(0, lone);
        for joint in &mut scene.joints {
            let (Joint::Ball { a, b, .. }
            | Joint::Distance { a, b, .. }
            | Joint::Hinge { a, b, .. }) = joint;
            *a += 1;
            *b += 1;
        }
        scene.remove_body(0).expect("nothing holds it");
        assert_eq!(scene, Scene::open("door", None, None).expect("a built-in"));
    }

    #[test]
    fn a_body_that_something_holds_stays() {
        let held = |name: &str, body| {
            let mut scene = Scene::open(name, None, None).expect("a built-in");
            let before = scene.clone();
            let error = scene.remove_body(body).expect_err("it is held");
            assert_eq!(scene, before);
            error
        };
        let joint = held("chain", 1);
        assert_eq!(joint, RemoveError::HeldByJoint { body: 1, joint: 0 });
        let force = held("magnets", 1);
        assert_eq!(force, RemoveError::HeldByForce { body: 1, force: 0 });
        assert!(matches!(held("orrery", 1), RemoveError::HeldByOrbit { .. }));
        assert!(matches!(
            held("pair", 9),
            RemoveError::NoSuchBody { body: 9, bodies: 2 }
        ));
    }
}
