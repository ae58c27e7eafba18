//! What pulls bodies beyond gravity: magnetic poles, constant forces, the mouse's spring, and points about which tops
//! turn.

use ch00_maths::f32::impulse::Velocity;
use ch00_maths::f32::inertia::about_point;
use ch00_maths::f32::{force, rotation};
use ch00_scenes::{Force, Scene};
use glam::Vec3;

use crate::bodies::Bodies;
use crate::own_row::body::{Moving, Pull};
use crate::rows::Step;

/// All forces of a scene.
#[derive(Clone, Debug, Default)]
pub struct Forces {
    poles: Vec<Pole>,
    /// Constant forces: rows of bodies, and N.
    pub pushes: Vec<(usize, Vec3)>,
    /// Bodies that turn about a point fixed in the world.
    pub pivots: Vec<Pivot>,
    /// The mouse, if it pulls.
    pub mouse: Option<Spring>,
    /// By body; empty where nothing pulls.
    pub pulls: Vec<Pull>,
}

#[derive(Clone, Copy, Debug)]
struct Pole {
    body: usize,
    /// Which of the scene's forces it belongs to: poles feel those of their own.
    force: usize,
    place: Vec3,
    strength: f32,
    softening: f32,
}

/// A body that turns about a point fixed in the world. It has no inverse mass of its own; its inverse
/// inertia is about the point.
#[derive(Clone, Copy, Debug)]
pub struct Pivot {
    /// Row of the body.
    pub body: usize,
    /// The fixed point, world, m.
    pub point: Vec3,
    /// From it to the body's origin, in the body's axes, m.
    pub arm: Vec3,
    /// kg.
    pub mass: f32,
}

/// A critically damped spring between a point of a body and the mouse.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Row of the body.
    pub body: usize,
    /// Where it is held, in its axes, m.
    pub anchor: Vec3,
    /// Where it is pulled to, world, m.
    pub target: Vec3,
    /// kg.
    pub mass: f32,
}

/// Whether no body that turns about a fixed point has a joint. Such a body has no mass of its own, by which a
/// joint could pull it. A pin to a static body holds it as well, and goes with other joints.
///
/// # Errors
/// The first such joint, and its body.
pub fn check_fixed_points(scene: &Scene) -> Result<(), (String, usize)> {
    let is_fixed = |row: usize| {
        let fixes = |force: &Force| matches!(force, Force::FixedPoint { body, .. } if *body == row);
        scene.forces.iter().any(fixes)
    };
    for (index, joint) in scene.joints.iter().enumerate() {
        let (a, b) = joint.bodies();
        if let Some(body) = [a, b].into_iter().find(|&row| is_fixed(row)) {
            let what = format!(
                "joints[{index}] of a body on a fixed point (hold it by a pin to a static body instead)"
            );
            return Err((what, body));
        }
    }
    Ok(())
}

/// Whether nothing pushes bodies all the time: the kernels know poles, fixed points and the mouse.
///
/// # Errors
/// The first such force, and its body.
pub fn check_no_push(scene: &Scene) -> Result<(), (String, usize)> {
    let pushed = |(index, force): (usize, &Force)| match force {
        Force::Constant { body, .. } => Some((format!("forces[{index}], a constant force"), *body)),
        Force::Magnets { .. } | Force::FixedPoint { .. } => None,
    };
    scene
        .forces
        .iter()
        .enumerate()
        .find_map(pushed)
        .map_or(Ok(()), Err)
}

impl Forces {
    /// The forces of a scene; bodies on a fixed point get their inertia about it.
    ///
    /// # Errors
    /// What is wrong with the arm of a fixed point, and its body.
    pub fn of(scene: &Scene, bodies: &mut Bodies) -> Result<Self, (String, usize)> {
        let mut forces = Self::default();
        for (index, force) in scene.forces.iter().enumerate() {
            match force {
                Force::Magnets { poles, softening } => {
                    forces.poles.extend(poles.iter().map(|pole| Pole {
                        body: pole.body,
                        force: index,
                        place: pole.position.as_vec3(),
                        strength: pole.strength as f32,
                        softening: *softening as f32,
                    }));
                }
                Force::Constant { body, force } => forces.pushes.push((*body, force.as_vec3())),
                Force::FixedPoint { body, arm } => {
                    let mass = scene.bodies[*body].mass as f32;
                    let arm = arm.as_vec3();
                    let solid = &mut bodies.solid[*body];
                    let inertia = about_point(solid.inverse_inertia.recip(), mass, arm);
                    let inertia = inertia.ok_or_else(|| {
                        let what = format!("a fixed point {arm} off its body's axes");
                        (what, *body)
                    })?;
                    solid.inverse_inertia = inertia.recip();
                    bodies.spin[*body].inverse_mass = 0.0;
                    bodies.read_momentum(*body);
                    let q = bodies.attitude[*body];
                    let point = bodies.place[*body].position - q * arm;
                    forces.pivots.push(Pivot {
                        body: *body,
                        point,
                        arm,
                        mass,
                    });
                }
            }
        }
        Ok(forces)
    }

    /// A body that no force holds is gone, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        let moved = |other: usize| if other > row { other - 1 } else { other };
        for pole in &mut self.poles {
            pole.body = moved(pole.body);
        }
        for pivot in &mut self.pivots {
            pivot.body = moved(pivot.body);
        }
        for (body, _) in &mut self.pushes {
            *body = moved(*body);
        }
        self.mouse = self.mouse.filter(|spring| spring.body != row);
        if let Some(spring) = &mut self.mouse {
            spring.body = moved(spring.body);
        }
    }

    /// Whether anything pulls that isn't gravity.
    #[must_use]
    pub fn any_pull(&self) -> bool {
        !(self.poles.is_empty() && self.pushes.is_empty()) || self.mouse.is_some()
    }

    /// Rows of the bodies that anything but gravity pulls, some more than once.
    pub fn pulled(&self) -> impl Iterator<Item = usize> {
        let poles = self.poles.iter().map(|pole| pole.body);
        let pivots = self.pivots.iter().map(|pivot| pivot.body);
        let mouse = self.mouse.iter().map(|spring| spring.body);
        let pushes = self.pushes.iter().map(|push| push.0);
        poles.chain(pivots).chain(pushes).chain(mouse)
    }

    /// Sums what pulls each body where it is now.
    pub fn gather(&mut self, bodies: &Bodies) {
        self.pulls.clear();
        if !self.any_pull() {
            return;
        }
        self.pulls.resize(bodies.rows(), Pull::default());
        for own in 0..self.poles.len() {
            self.feel(own, bodies);
        }
        for &(row, force) in &self.pushes {
            self.pulls[row].acceleration += force * bodies.spin[row].inverse_mass;
        }
        if let Some(spring) = self.mouse {
            self.drag(&spring, bodies);
        }
    }

    // ANCHOR: turn_about
    /// Bodies on a fixed point move: half of gravity's torque, a free turn, the other half.
    pub fn turn_pivots(&self, bodies: &mut Bodies, step: &Step) {
        for pivot in &self.pivots {
            turn_about(pivot, bodies, step);
        }
    }
    // ANCHOR_END: turn_about

    // ANCHOR: feel
    /// What a pole feels of all others of its force that sit in other bodies.
    fn feel(&mut self, own: usize, bodies: &Bodies) {
        let pole = self.poles[own];
        let arm = bodies.attitude[pole.body] * pole.place;
        let here = bodies.place[pole.body].position + arm;
        for other in &self.poles {
            if other.force != pole.force || other.body == pole.body {
                continue;
            }
            let there =
                bodies.place[other.body].position + bodies.attitude[other.body] * other.place;
            let strength = pole.strength * other.strength;
            let pull = force::pole(here - there, strength, pole.softening);
            let sum = &mut self.pulls[pole.body];
            sum.acceleration += pull * bodies.spin[pole.body].inverse_mass;
            sum.torque += arm.cross(pull);
        }
    }
    // ANCHOR_END: feel

    fn drag(&mut self, spring: &Spring, bodies: &Bodies) {
        let row = spring.body;
        let arm = bodies.attitude[row] * spring.anchor;
        let stretch = spring.target - (bodies.place[row].position + arm);
        let velocity = Velocity {
            v: bodies.motion[row].velocity,
            omega: bodies.spin[row].angular_velocity,
        };
        let (force, torque) = force::spring(spring.mass, arm, stretch, velocity);
        self.pulls[row].acceleration += force * bodies.spin[row].inverse_mass;
        self.pulls[row].torque += torque;
    }
}

/// A body on a fixed point moves for a substep.
fn turn_about(pivot: &Pivot, bodies: &mut Bodies, step: &Step) {
    let Pivot {
        body,
        point,
        arm,
        mass,
    } = *pivot;
    let half_weight = (0.5 * step.h * mass) * step.gravity;
    let inverse_inertia = bodies.solid[body].inverse_inertia;
    let mut momentum = bodies.momentum[body];
    momentum += (bodies.attitude[body] * arm).cross(half_weight);
    let mut moving = Moving::<f32> {
        attitude: bodies.attitude[body].into(),
        momentum: momentum.into(),
        inverse_inertia: inverse_inertia.into(),
        angular_velocity: bodies.spin[body].angular_velocity.into(),
        ..Moving::default()
    };
    moving.turn(bodies.push[body].angular_velocity.into(), step.h);
    let q = moving.attitude.lane(0);
    momentum += (q * arm).cross(half_weight);
    let w = rotation::moment(q, inverse_inertia, momentum);
    bodies.momentum[body] = momentum;
    bodies.attitude[body] = q;
    bodies.spin[body].angular_velocity = w;
    bodies.place[body].position = point + q * arm;
    bodies.motion[body].velocity = w.cross(q * arm);
}
