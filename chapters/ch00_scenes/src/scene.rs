//! A scene: plain data, in f64, exactly as the JSON file says it.
//!
//! Units are SI and radians, y is up, axes are right-handed. Quaternions are `[x, y, z, w]`
//! and turn body axes into world axes. Shapes are centred on the body's origin.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

use crate::Shape;

/// What is simulated: bodies, what joins them, what pulls them, and for how long.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// A name for tables and snapshots.
    pub name: String,
    /// Acceleration of every free body, m/s².
    pub gravity: DVec3,
    /// Time step, s.
    #[serde(default = "default_dt")]
    pub dt: f64,
    /// How many steps a headless run makes.
    #[serde(default = "default_steps")]
    pub steps: u32,
    /// Rate at which velocities decay, 1/s: the report's F. Both velocities.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub drag: f64,
    /// Impacts slower than this don't bounce, m/s. `None`: the method's own threshold.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub restitution_threshold: Option<f64>,
    /// The bodies; their index is their name everywhere.
    pub bodies: Vec<Body>,
    /// What joins them.
    #[serde(default)]
    pub joints: Vec<Joint>,
    /// Forces and torques beyond gravity, each a callback in chapter 2.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub forces: Vec<Force>,
    /// Prescribed motions, which chapter 1 runs as nested nodes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub orbits: Vec<Orbit>,
    /// Free notes: kept, and read by measures only.
    #[serde(default)]
    pub meta: serde_json::Map<String, serde_json::Value>,
}

/// One body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Its solid.
    pub shape: Shape,
    /// kg; 0 is static, that is of infinite mass.
    pub mass: f64,
    /// World position of its origin, m.
    pub position: DVec3,
    /// Body to world.
    #[serde(default = "identity")]
    pub orientation: DQuat,
    /// m/s.
    #[serde(default)]
    pub linear_velocity: DVec3,
    /// rad/s, world frame.
    #[serde(default)]
    pub angular_velocity: DVec3,
    /// e of the report; a pair has the mean of the two.
    #[serde(default)]
    pub restitution: f64,
    /// Kinetic coefficient; a pair has the geometric mean of the two.
    #[serde(default = "default_friction")]
    pub friction: f64,
    /// Static coefficient, at least `friction`, which it equals if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub static_friction: Option<f64>,
}

/// What joins two bodies. Anchors and axes are in the bodies' own coordinates; bodies that
/// a joint connects don't collide with each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Joint {
    /// Two points that stay together; b may turn about a within its limits.
    Ball {
        /// Index of the first body (a ragdoll's parent).
        a: usize,
        /// Index of the second body.
        b: usize,
        /// Point in a, m.
        anchor_a: DVec3,
        /// Point in b, m.
        anchor_b: DVec3,
        /// Largest angle of b's y axis from where it rests in a, rad.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        cone: Option<f64>,
        /// Range of the turn about b's y axis, rad.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        twist: Option<[f64; 2]>,
        /// The report's limits, instead of cone and twist.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        limits: Option<EulerLimits>,
        /// Orientation of b in a at rest; as loaded if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        rest: Option<DQuat>,
    },
    /// Two points that keep their distance.
    Distance {
        /// Index of the first body.
        a: usize,
        /// Index of the second body.
        b: usize,
        /// Point in a, m.
        anchor_a: DVec3,
        /// Point in b, m.
        anchor_b: DVec3,
        /// Distance to keep, m.
        length: f64,
    },
    /// Two axes that stay together.
    Hinge {
        /// Index of the first body.
        a: usize,
        /// Index of the second body.
        b: usize,
        /// Point in a, m.
        anchor_a: DVec3,
        /// Point in b, m.
        anchor_b: DVec3,
        /// Unit axis in a.
        axis_a: DVec3,
        /// Unit axis in b.
        axis_b: DVec3,
        /// Range of the turn of b relative to a, zero as loaded, rad.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        range: Option<[f64; 2]>,
    },
}

/// The report's angle limits: about x, y (the twist) and z of b's rest frame, rad.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EulerLimits {
    /// About x.
    pub pitch: [f64; 2],
    /// About y.
    pub yaw: [f64; 2],
    /// About z.
    pub roll: [f64; 2],
}

impl Joint {
    /// A ball joint without limits: a point of `a` and a point of `b` that stay together, m.
    #[must_use]
    pub fn pin(a: usize, b: usize, anchor_a: DVec3, anchor_b: DVec3) -> Self {
        Self::Ball {
            a,
            b,
            anchor_a,
            anchor_b,
            cone: None,
            twist: None,
            limits: None,
            rest: None,
        }
    }

    /// The two bodies that it connects.
    #[must_use]
    pub fn bodies(&self) -> (usize, usize) {
        match *self {
            Joint::Ball { a, b, .. } | Joint::Distance { a, b, .. } | Joint::Hinge { a, b, .. } => {
                (a, b)
            }
        }
    }

    /// The points, in a and in b, that it holds.
    #[must_use]
    pub fn anchors(&self) -> (DVec3, DVec3) {
        match *self {
            Joint::Ball {
                anchor_a, anchor_b, ..
            }
            | Joint::Distance {
                anchor_a, anchor_b, ..
            }
            | Joint::Hinge {
                anchor_a, anchor_b, ..
            } => (anchor_a, anchor_b),
        }
    }
}

/// What acts on bodies beside gravity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Force {
    /// Magnetic poles: every pair on different bodies pulls (unlike) or pushes (like) along the line
    /// between them with strength_i · strength_j / (d² + softening²), N.
    Magnets {
        /// The poles.
        poles: Vec<Pole>,
        /// Length that keeps the force finite where poles meet, m.
        softening: f64,
    },
    /// A body that turns about a point fixed in the world. Gravity acts on it as a torque.
    FixedPoint {
        /// Index of the body.
        body: usize,
        /// From the fixed point to the body's origin, in the body's coordinates, m.
        arm: DVec3,
    },
    /// A force that stays the same, on a body's centre of mass.
    Constant {
        /// Index of the body.
        body: usize,
        /// World axes, N.
        force: DVec3,
    },
}

/// One end of a magnet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pole {
    /// Index of the body it sits in.
    pub body: usize,
    /// Where in the body, m.
    pub position: DVec3,
    /// Positive for north, √(N m²).
    pub strength: f64,
}

/// A body that is moved as a node in a tree: it circles its parent and spins about its own y.
/// [`crate::orbits`] says exactly how the nodes nest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Orbit {
    /// Index of the body that is moved.
    pub body: usize,
    /// Index of the body it circles; the world's origin if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<usize>,
    /// Distance from the parent, m.
    pub radius: f64,
    /// Tilt of the orbit's plane about the x of the parent's frame, rad.
    #[serde(default)]
    pub tilt: f64,
    /// Angle along the orbit at the start, rad.
    #[serde(default)]
    pub phase: f64,
    /// Rate of circling in the parent's frame, right-handed about the plane's y, rad/s.
    pub rate: f64,
    /// Rate of the body's own spin, rad/s.
    #[serde(default)]
    pub spin: f64,
}

impl Body {
    /// A body at rest with the format's defaults.
    #[must_use]
    pub fn new(shape: Shape, mass: f64, position: DVec3) -> Self {
        Self {
            shape,
            mass,
            position,
            orientation: DQuat::IDENTITY,
            linear_velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            restitution: 0.0,
            friction: default_friction(),
            static_friction: None,
        }
    }

    /// Whether nothing moves it.
    #[must_use]
    pub fn is_static(&self) -> bool {
        self.mass == 0.0
    }

    /// The static coefficient of friction, which is the kinetic one unless given.
    #[must_use]
    pub fn static_friction(&self) -> f64 {
        self.static_friction.unwrap_or(self.friction)
    }
}

impl Scene {
    /// An empty scene under the Earth's gravity at 60 Hz.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            gravity: DVec3::new(0.0, -9.81, 0.0),
            dt: default_dt(),
            steps: default_steps(),
            drag: 0.0,
            restitution_threshold: None,
            bodies: Vec::new(),
            joints: Vec::new(),
            forces: Vec::new(),
            orbits: Vec::new(),
            meta: serde_json::Map::new(),
        }
    }

    /// How many bodies can move.
    #[must_use]
    pub fn dynamic_count(&self) -> usize {
        self.bodies.iter().filter(|body| !body.is_static()).count()
    }

    /// A pair of numbers from `meta`, such as `inner_half_extents`.
    #[must_use]
    pub fn meta_pair(&self, key: &str) -> Option<[f64; 2]> {
        let values = self.meta.get(key)?.as_array()?;
        Some([values.first()?.as_f64()?, values.get(1)?.as_f64()?])
    }
}

fn default_dt() -> f64 {
    1.0 / 60.0
}

fn default_steps() -> u32 {
    600
}

fn default_friction() -> f64 {
    0.5
}

fn identity() -> DQuat {
    DQuat::IDENTITY
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde passes a reference"
)]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}
