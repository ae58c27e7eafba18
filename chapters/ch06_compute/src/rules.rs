//! The constants of the own-row method, and what a scene and the user say about a run.

use ch00_maths::f32::drag;
use ch00_scenes::{Body, LoadError, Scene, Settings, Shape};

use crate::rows::Step;

/// Two bodies are a pair when they are this near, m, beyond what they may move in the step.
pub const MARGIN: f32 = 0.005;

/// Depth that is left alone, m: who rests stays a little inside, or contacts would come and go.
pub const SLOP: f32 = 0.0005;

/// The share of the depth beyond the slop that a substep pushes out, measured by `--example settled`: with
/// 0.2 the 99th percentile of the depths of a pile is 1.8 times as deep, the deepest nearly four times.
pub const PUSH_SHARE: f32 = 0.9;

/// The same where a pair has several points, which push against each other.
pub const PUSH_SHARE_OF_MANY: f32 = 0.5;

/// A new contact that changes the speed by more, m/s, is an impact: what it pressed is over with the
/// substep. Begun with again, it would be taken back only in part, and make energy.
pub const IMPACT_SPEED: f32 = 0.2;

/// The fastest push, m/s. It adds no speed, so it may be fast: with 3 m/s a thousand balls that crash sink 1.3 R
/// into each other, with 30 m/s 0.4 R; and of 80 ragdolls none is squeezed out of the box.
pub const FASTEST_PUSH: f32 = 30.0;

/// Slower approaches don't bounce, m/s, unless the scene says otherwise: chapter 3's threshold.
pub const RESTITUTION_THRESHOLD: f32 = 0.5;

/// Parts of a step unless the user says otherwise.
pub const SUBSTEPS: u32 = 10;

/// The same where all that moves are balls that nothing joins: their contacts have one point.
pub const SUBSTEPS_OF_BALLS: u32 = 8;

/// More than these cost more than any accuracy that f32 has left.
pub const MOST_SUBSTEPS: u32 = 1000;

/// The coarsest that positions may be, in radii of a body.
pub const COARSEST: f32 = 0.05;

/// The name of the method.
pub const METHOD: &str = "own-row";

/// Parts of a step unless the user says otherwise.
#[must_use]
pub fn default_substeps(scene: &Scene) -> u32 {
    let is_ball = |body: &Body| matches!(body.shape, Shape::Sphere { .. });
    let balls = scene
        .bodies
        .iter()
        .all(|body| body.is_static() || is_ball(body));
    if balls && scene.joints.is_empty() {
        SUBSTEPS_OF_BALLS
    } else {
        SUBSTEPS
    }
}

/// What the scene and the user say about the steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// World acceleration of every free body, m/s².
    pub gravity: glam::Vec3,
    /// Rate at which velocities decay, 1/s.
    pub drag: f32,
    /// m/s.
    pub restitution_threshold: f32,
    /// Parts of a step.
    pub substeps: u32,
    /// [`PUSH_SHARE`], or what an experiment puts in its place.
    pub push_share: f32,
}

impl Rules {
    /// # Errors
    /// [`LoadError::Setting`] for sweeps, which this method has none of, and for no substeps.
    pub fn of(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        let refuse = |setting, value: u32, why: &str| LoadError::Setting {
            method: METHOD,
            setting,
            value: value.to_string(),
            why: why.to_owned(),
        };
        if let Some(sweeps) = settings.sweeps {
            let why = "it has no sweeps over all contacts; accuracy comes from --substeps";
            return Err(refuse("sweeps", sweeps, why));
        }
        let substeps = settings.substeps.unwrap_or_else(|| default_substeps(scene));
        if substeps == 0 || substeps > MOST_SUBSTEPS {
            let why = format!("a step has 1 to {MOST_SUBSTEPS} of them");
            return Err(refuse("substeps", substeps, &why));
        }
        Ok(Self {
            gravity: scene.gravity.as_vec3(),
            drag: scene.drag as f32,
            restitution_threshold: scene
                .restitution_threshold
                .map_or(RESTITUTION_THRESHOLD, |threshold| threshold as f32),
            substeps,
            push_share: PUSH_SHARE,
        })
    }

    /// Whether f32 resolves the scene: a position far out is a multiple of a step that must be small beside
    /// the bodies.
    ///
    /// # Errors
    /// What the resolution is there, and the body.
    pub fn check_resolution(scene: &Scene) -> Result<(), (String, usize)> {
        for (index, body) in scene.bodies.iter().enumerate() {
            let far = body.position.abs().max_element() as f32;
            let step = far.next_up() - far;
            let size = body.shape.single().bounding_radius();
            if !body.is_static() && step > COARSEST * size {
                let what = format!(
                    "at {far:.0} m from the origin positions are {step} m apart in f32, too coarse for a body of {size} m"
                );
                return Err((what, index));
            }
        }
        Ok(())
    }

    /// The uniform of a step of `dt` seconds.
    #[must_use]
    pub fn step(&self, dt: f32, bodies: usize) -> Step {
        let h = dt / self.substeps as f32;
        Step {
            gravity: self.gravity,
            h,
            drag: drag::kept(self.drag, h),
            restitution_threshold: self.restitution_threshold,
            slop: SLOP,
            push_share: self.push_share,
            push_share_of_many: PUSH_SHARE_OF_MANY,
            fastest_push: FASTEST_PUSH,
            impact_speed: IMPACT_SPEED,
            bodies: bodies as u32,
            ..Step::default()
        }
    }
}
