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

/// The most of it where a pair has several points, which push against each other.
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

/// [`SUBSTEPS`] of the method of colours.
pub const COLOURED_SUBSTEPS: u32 = 6;

/// [`SUBSTEPS_OF_BALLS`] of the method of colours.
pub const COLOURED_SUBSTEPS_OF_BALLS: u32 = 3;

/// More than these cost more than any accuracy that f32 has left.
pub const MOST_SUBSTEPS: u32 = 1000;

/// The coarsest that positions may be, in radii of a body.
pub const COARSEST: f32 = 0.05;

/// The name of the method of own rows, which every engine of this chapter has.
pub const METHOD: &str = "own-row";

/// The name of the method of colours, which the CPU alone has.
pub const COLOURED: &str = "coloured";

/// How contacts are solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// All pairs at once, each with a share of its bodies' masses.
    #[default]
    OwnRow,
    /// Pairs of one colour at once, which share no body that moves, with its whole mass; a colour after
    /// another.
    Coloured,
}

impl Method {
    /// What the user asked for.
    #[must_use]
    pub fn of(settings: &Settings) -> Self {
        match settings.method.as_deref() {
            Some(COLOURED) => Self::Coloured,
            _ => Self::OwnRow,
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::OwnRow => METHOD,
            Self::Coloured => COLOURED,
        }
    }
}

/// Parts of a step unless the user says otherwise.
#[must_use]
pub fn default_substeps(scene: &Scene, method: Method) -> u32 {
    match (method, only_balls(scene)) {
        (Method::OwnRow, true) => SUBSTEPS_OF_BALLS,
        (Method::OwnRow, false) => SUBSTEPS,
        (Method::Coloured, true) => COLOURED_SUBSTEPS_OF_BALLS,
        (Method::Coloured, false) => COLOURED_SUBSTEPS,
    }
}

/// Whether all that moves are balls that nothing joins.
#[must_use]
pub fn only_balls(scene: &Scene) -> bool {
    let is_ball = |body: &Body| matches!(body.shape, Shape::Sphere { .. });
    let mut bodies = scene.bodies.iter();
    scene.joints.is_empty() && bodies.all(|body| body.is_static() || is_ball(body))
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
    /// How contacts are solved.
    pub method: Method,
    /// Whether a sweep over the colours goes forth and back rather than forth alone.
    pub back: bool,
    /// Whether islands of bodies that have come to rest sleep.
    pub sleeping: bool,
}

impl Rules {
    /// # Errors
    /// [`LoadError::Setting`] for sweeps, which this method has none of, and for no substeps.
    pub fn of(scene: &Scene, settings: &Settings) -> Result<Self, LoadError> {
        let method = Method::of(settings);
        let refuse = |setting, value: u32, why: &str| LoadError::Setting {
            method: method.name(),
            setting,
            value: value.to_string(),
            why: why.to_owned(),
        };
        if let Some(sweeps) = settings.sweeps {
            let why = "it has no sweeps over all contacts; accuracy comes from --substeps";
            return Err(refuse("sweeps", sweeps, why));
        }
        let substeps = settings.substeps;
        let substeps = substeps.unwrap_or_else(|| default_substeps(scene, method));
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
            method,
            back: !only_balls(scene),
            sleeping: settings.sleeping,
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
            push_share_of_many: self.push_share.min(PUSH_SHARE_OF_MANY),
            fastest_push: FASTEST_PUSH,
            impact_speed: IMPACT_SPEED,
            bodies: bodies as u32,
            ..Step::default()
        }
    }
}
