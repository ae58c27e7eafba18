//! The orbits of a scene as game objects of a level, whoever else lives in it: chapters 2
//! and 3 call this too.
//!
//! [`ch00_scenes::orbits`] says in closed form where the orbits lead; here they are nested
//! nodes. What the scene says about the body's own position and orientation is not read.

use std::iter::successors;

use ch00_scenes::{Orbit, Scene, State};
use glam::{DQuat, DVec2, DVec3, Quat, Vec3};

use crate::Transform;
use crate::{Circle, Level, Motion, NodeId, Orbiter, SceneGraph, Shared, Spin, SteadyAngle};

/// A body on an orbit in a level.
#[derive(Clone, Debug)]
pub struct Member {
    /// Index of the body in the scene.
    pub body: usize,
    /// Index of the body that it circles; `None` for the world's origin.
    pub parent: Option<usize>,
    /// The game object.
    pub orbiter: Shared<Orbiter>,
}

/// The orbiters of a level.
#[derive(Clone, Debug, Default)]
pub struct Orrery {
    /// Each after what it circles.
    members: Vec<Member>,
}

impl Orrery {
    // ANCHOR: add_to
    /// Adds a game object to `level` for each orbit of a valid `scene`.
    ///
    /// `nodes` has an entry for each body: its node if the level has one already, such as a
    /// rigid body's that something circles. The bodies on orbits get theirs.
    ///
    /// # Panics
    /// If `nodes` is shorter than the scene's list of bodies, or lacks the node of a body
    /// that is circled without being on an orbit itself.
    pub fn add_to(level: &mut Level, scene: &Scene, nodes: &mut [Option<NodeId>]) -> Self {
        let mut members = Vec::new();
        let mut carriers = nodes.to_vec();
        for orbit in parents_first(scene) {
            let above = orbit.parent.map(|parent| {
                carriers[parent].unwrap_or_else(|| panic!("body {parent} has no node to circle"))
            });
            let orbiter = Orbiter::add_to(&mut level.graph, orbit, above);
            carriers[orbit.body] = Some(orbiter.carrier);
            nodes[orbit.body] = Some(orbiter.body);
            members.push(Member {
                body: orbit.body,
                parent: orbit.parent,
                orbiter: level.add(orbiter),
            });
        }
        Self { members }
    }
    // ANCHOR_END: add_to

    /// The bodies on orbits, each after what it circles.
    #[must_use]
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    // ANCHOR: read_into
    /// Writes the rows of the bodies on orbits into `state`. The rows of the others must be
    /// there already, as the velocity of a body follows from that of what it circles.
    ///
    /// # Panics
    /// If `state` has fewer rows than the scene has bodies.
    pub fn read_into(&self, graph: &SceneGraph, state: &mut State) {
        let mut motions: Vec<Motion> = (0..state.len()).map(|row| motion(state, row)).collect();
        for Member {
            body,
            parent,
            orbiter,
        } in &self.members
        {
            let orbiter = orbiter.borrow();
            let above = parent.map_or(Motion::default(), |parent| motions[parent]);
            let carrier = orbiter.carrier_motion(graph, above);
            let spin = graph.world(orbiter.carrier).vector(orbiter.spin.omega());
            write_row(
                state,
                *body,
                graph.world(orbiter.body),
                carrier.of_arm(spin, Vec3::ZERO),
            );
            motions[*body] = carrier;
        }
    }
    // ANCHOR_END: read_into

    /// Goes on from where `state` has the bodies: finds the angles that put them there. A
    /// body on a circle of radius 0 keeps its angle, and its spin takes up the difference.
    ///
    /// # Panics
    /// If `state` has fewer rows than the scene has bodies.
    pub fn take_over(&self, level: &mut Level, state: &State) {
        let mut frames = state.orientation.clone();
        for member in &self.members {
            let above = member
                .parent
                .map_or((DVec3::ZERO, DQuat::IDENTITY), |parent| {
                    (state.position[parent], frames[parent])
                });
            let (position, orientation) =
                (state.position[member.body], state.orientation[member.body]);
            let mut orbiter = member.orbiter.borrow_mut();
            frames[member.body] = orbiter.take_over(above, position, orientation);
            orbiter.place(&mut level.graph);
        }
        level.graph.update_world();
    }
}

impl Orbiter {
    /// The nodes and parts of one orbit, placed where it starts.
    fn add_to(graph: &mut SceneGraph, orbit: &Orbit, above: Option<NodeId>) -> Self {
        let Orbit { body, .. } = orbit;
        let carrier = graph.add(format!("orbit of body {body}"), above, Transform::IDENTITY);
        let body = graph.add(format!("body {body}"), Some(carrier), Transform::IDENTITY);
        let mut orbiter = Self {
            carrier,
            body,
            circle: Circle {
                radius: orbit.radius as f32,
                plane: Quat::from_rotation_x(orbit.tilt as f32),
                angle: SteadyAngle::new(orbit.phase, orbit.rate),
            },
            spin: Spin {
                angle: SteadyAngle::new(0.0, orbit.spin),
            },
        };
        orbiter.place(graph);
        orbiter
    }

    /// How the carrier moves if what it hangs below moves like `above`.
    fn carrier_motion(&self, graph: &SceneGraph, above: Motion) -> Motion {
        let frame = graph.parent(self.carrier);
        let frame = frame.map_or(Transform::IDENTITY, |parent| graph.world(parent));
        let tip = graph
            .world(self.carrier)
            .vector(Vec3::X * self.circle.radius);
        above.of_arm(frame.vector(self.circle.omega()), tip)
    }

    /// Sets both angles so that the body is at `position` and turned to `orientation`, in a
    /// frame at `origin` turned by `frame`; gives the carrier's orientation.
    fn take_over(
        &mut self,
        (origin, frame): (DVec3, DQuat),
        position: DVec3,
        orientation: DQuat,
    ) -> DQuat {
        let plane = frame * self.circle.plane.as_dquat();
        let arm = plane.conjugate() * (position - origin);
        if self.circle.radius > 0.0 {
            self.circle
                .angle
                .restart_at(DVec2::new(arm.x, -arm.z).to_angle());
        }
        let carrier = plane * DQuat::from_rotation_y(f64::from(self.circle.angle.now()));
        let turn = carrier.conjugate() * orientation;
        self.spin
            .angle
            .restart_at(2.0 * DVec2::new(turn.w, turn.y).to_angle());
        carrier
    }
}

/// The orbits, each after that of the body it circles.
fn parents_first(scene: &Scene) -> Vec<&Orbit> {
    let mut orbit_of = vec![None; scene.bodies.len()];
    for orbit in &scene.orbits {
        orbit_of[orbit.body] = Some(orbit);
    }
    let depth = |orbit: &&Orbit| {
        let upwards = successors(Some(*orbit), |orbit| orbit_of[orbit.parent?]);
        upwards.take(scene.orbits.len()).count()
    };
    let mut orbits: Vec<&Orbit> = scene.orbits.iter().collect();
    orbits.sort_by_cached_key(depth);
    orbits
}

fn motion(state: &State, row: usize) -> Motion {
    Motion {
        linear: state.linear_velocity[row].as_vec3(),
        angular: state.angular_velocity[row].as_vec3(),
    }
}

fn write_row(state: &mut State, row: usize, world: Transform, motion: Motion) {
    state.position[row] = world.translation.as_dvec3();
    state.orientation[row] = world.rotation.as_dquat();
    state.linear_velocity[row] = motion.linear.as_dvec3();
    state.angular_velocity[row] = motion.angular.as_dvec3();
}
