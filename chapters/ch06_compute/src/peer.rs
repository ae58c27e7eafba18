//! A scene in rapier3d: the same bodies, materials and joints, as near as it has them. For comparisons; behind
//! the feature `rapier`.

use ch00_scenes::{Body, EulerLimits, Force, Joint, Scene, Shape, State};
use glam::{DQuat, DVec3};
use rapier3d::prelude::{
    CoefficientCombineRule, ColliderBuilder, GenericJoint, GenericJointBuilder, JointAxesMask,
    JointAxis, MassProperties, PhysicsWorld, Pose, RigidBodyBuilder, RigidBodyHandle, Rotation,
    Vector,
};
use rapier3d::rayon::{ThreadPool, ThreadPoolBuilder};

/// Why a scene can't be had.
type Problem = Box<dyn std::error::Error>;

/// How rapier is set up.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Who step.
    pub threads: u32,
    /// Its substeps, which it calls solver iterations.
    pub iterations: u32,
    /// How it hears of cones.
    pub cone: Cone,
    /// Its own tolerances: false takes them to 0, so that it mends what it would leave alone.
    pub tolerant: bool,
    /// Its continuous collision detection: a body that moves farther in a step than half its thinnest extent is
    /// swept against what nothing moves. As rapier comes it is on.
    pub ccd: bool,
}

/// How a ball joint's cone is told to rapier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cone {
    /// As a cone: two coupled axes, which rapier solves one joint at a time.
    Coupled,
    /// As a range about each of two axes, which it solves four joints at a time: a pyramid about the cone.
    Ranges,
}

/// A scene in rapier, and the threads that step it.
pub struct Rapier {
    world: PhysicsWorld,
    /// By the scene's index.
    handles: Vec<RigidBodyHandle>,
    pool: ThreadPool,
    setup: Setup,
}

impl Rapier {
    /// Its own defaults throughout but those in `setup`, and that nothing sleeps.
    ///
    /// # Errors
    /// What the scene has that rapier hasn't; no threads.
    pub fn load(scene: &Scene, setup: Setup) -> Result<Self, Problem> {
        let known = |force: &Force| !matches!(force, Force::Magnets { .. });
        if !(scene.forces.iter().all(known) && scene.orbits.is_empty()) {
            return Err(
                "rapier is told of bodies, joints, fixed points and constant forces only".into(),
            );
        }
        let mut world = PhysicsWorld::new();
        world.gravity = vector(scene.gravity);
        world.integration_parameters.dt = scene.dt as f32;
        world.integration_parameters.num_solver_iterations = setup.iterations as usize;
        if !setup.ccd {
            world.integration_parameters.max_ccd_substeps = 0;
        }
        if !setup.tolerant {
            world.integration_parameters.normalized_allowed_linear_error = 0.0;
        }
        let handles: Vec<_> = scene
            .bodies
            .iter()
            .map(|body| world.insert(rigid_body(body, scene.drag), collider(body)).0)
            .collect();
        for joint in &scene.joints {
            let (a, b) = joint.bodies();
            let joint = generic_joint(scene, joint, setup.cone);
            world.insert_impulse_joint(handles[a], handles[b], joint);
        }
        for force in &scene.forces {
            match *force {
                Force::FixedPoint { body, arm } => {
                    hold(&mut world, handles[body], &scene.bodies[body], arm);
                }
                Force::Constant { body, force } => {
                    world.bodies[handles[body]].add_force(vector(force), true);
                }
                Force::Magnets { .. } => {}
            }
        }
        let pool = ThreadPoolBuilder::new().num_threads(setup.threads as usize);
        Ok(Self {
            world,
            handles,
            pool: pool.build()?,
            setup,
        })
    }
}

impl Rapier {
    /// How it was set up.
    #[must_use]
    pub fn setup(&self) -> Setup {
        self.setup
    }

    /// Does something inside its threads, so that no step pays for the way there.
    pub fn inside<T: Send>(&mut self, work: impl FnOnce(&mut PhysicsWorld) -> T + Send) -> T {
        let world = &mut self.world;
        self.pool.install(|| work(world))
    }

    /// Writes where every body is, in the scene's order.
    pub fn read(&self, state: &mut State) {
        state.clear();
        for handle in &self.handles {
            let body = &self.world.bodies[*handle];
            // It takes a body out whose numbers are no longer finite, and says where that was.
            let position = if body.is_enabled() {
                of_vector(body.translation())
            } else {
                DVec3::NAN
            };
            let q = body.rotation();
            let q = DQuat::from_array([q.x, q.y, q.z, q.w].map(f64::from));
            let (v, w) = (of_vector(body.linvel()), of_vector(body.angvel()));
            state.push(position, q.normalize(), v, w);
        }
    }
}

// Bodies.

fn rigid_body(body: &Body, drag: f64) -> RigidBodyBuilder {
    let builder = if body.is_static() {
        RigidBodyBuilder::fixed()
    } else {
        RigidBodyBuilder::dynamic()
    };
    builder
        .pose(pose(body.position, body.orientation))
        .linvel(vector(body.linear_velocity))
        .angvel(vector(body.angular_velocity))
        .linear_damping(drag as f32)
        .angular_damping(drag as f32)
        .can_sleep(false)
}

/// The solid, with the mass and the moments of inertia that our engines give it.
fn collider(body: &Body) -> ColliderBuilder {
    let inertia = vector(body.shape.inertia(body.mass));
    solid(body.shape)
        .mass_properties(MassProperties::new(Vector::ZERO, body.mass as f32, inertia))
        .friction(body.friction as f32)
        .friction_combine_rule(CoefficientCombineRule::GeometricMean)
        .restitution(body.restitution as f32)
        .restitution_combine_rule(CoefficientCombineRule::Average)
}

fn solid(shape: Shape) -> ColliderBuilder {
    match shape {
        Shape::Sphere { radius } => ColliderBuilder::ball(radius as f32),
        Shape::Box { half_extents } => {
            let half = half_extents.as_vec3();
            ColliderBuilder::cuboid(half.x, half.y, half.z)
        }
        Shape::Capsule {
            radius,
            half_height,
        } => ColliderBuilder::capsule_y(half_height as f32, radius as f32),
        Shape::Cylinder {
            radius,
            half_height,
        } => ColliderBuilder::cylinder(half_height as f32, radius as f32),
    }
}

// Joints.

/// Holds a body at a point of the world, by a joint to a body that has no solid.
fn hold(world: &mut PhysicsWorld, handle: RigidBodyHandle, body: &Body, arm: DVec3) {
    let point = body.position - body.orientation * arm;
    let nothing = RigidBodyBuilder::fixed().translation(vector(point));
    let nothing = world.bodies.insert(nothing);
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_SPHERICAL_AXES)
        .local_anchor1(Vector::ZERO)
        .local_anchor2(vector(-arm))
        .build();
    world.insert_impulse_joint(nothing, handle, joint);
}

fn generic_joint(scene: &Scene, joint: &Joint, cone: Cone) -> GenericJoint {
    let builder = match joint {
        Joint::Ball { .. } => ball(scene, joint, cone),
        Joint::Hinge { .. } => hinge(scene, joint),
        Joint::Distance { .. } => distance(joint),
    };
    builder.contacts_enabled(false).build()
}

/// A ball joint whose axes rest on those of b: y is the bone's.
fn ball(scene: &Scene, joint: &Joint, how: Cone) -> GenericJointBuilder {
    let &Joint::Ball {
        anchor_a,
        anchor_b,
        cone,
        twist,
        limits,
        rest,
        ..
    } = joint
    else {
        unreachable!("it is called for ball joints");
    };
    let rest = rest.unwrap_or_else(|| as_loaded(scene, joint));
    let mut builder = GenericJointBuilder::new(JointAxesMask::LOCKED_SPHERICAL_AXES)
        .local_frame1(pose(anchor_a, rest))
        .local_frame2(pose(anchor_b, DQuat::IDENTITY));
    if let Some(angle) = cone {
        let angle = angle as f32;
        builder = match how {
            // The limit of the first of two coupled axes is that of the angle between the third axis in a
            // and in b, which is never below 0.
            Cone::Coupled => builder
                .coupled_axes(JointAxesMask::ANG_X | JointAxesMask::ANG_Z)
                .limits(JointAxis::AngX, [-1.0, angle]),
            Cone::Ranges => builder
                .limits(JointAxis::AngX, [-angle, angle])
                .limits(JointAxis::AngZ, [-angle, angle]),
        };
    }
    if let Some(range) = twist {
        builder = builder.limits(JointAxis::AngY, range.map(|end| end as f32));
    }
    if let Some(EulerLimits { pitch, yaw, roll }) = limits {
        let axes = [JointAxis::AngX, JointAxis::AngY, JointAxis::AngZ];
        for (axis, range) in axes.into_iter().zip([pitch, yaw, roll]) {
            builder = builder.limits(axis, range.map(|end| end as f32));
        }
    }
    builder
}

/// A hinge about the x axes of two frames, which lie on each other as loaded.
fn hinge(scene: &Scene, joint: &Joint) -> GenericJointBuilder {
    let &Joint::Hinge {
        anchor_a,
        anchor_b,
        axis_a,
        axis_b,
        range,
        ..
    } = joint
    else {
        unreachable!("it is called for hinges");
    };
    let in_a = DQuat::from_rotation_arc(DVec3::X, axis_a);
    let from_a = as_loaded(scene, joint).conjugate();
    let onto_b = DQuat::from_rotation_arc(from_a * axis_a, axis_b);
    let builder = GenericJointBuilder::new(JointAxesMask::LOCKED_REVOLUTE_AXES)
        .local_frame1(pose(anchor_a, in_a))
        .local_frame2(pose(anchor_b, onto_b * from_a * in_a));
    match range {
        Some(range) => builder.limits(JointAxis::AngX, range.map(|end| end as f32)),
        None => builder,
    }
}

/// A rope: rapier keeps two points from getting further apart, and has nothing that keeps them from
/// getting nearer.
fn distance(joint: &Joint) -> GenericJointBuilder {
    let &Joint::Distance {
        anchor_a,
        anchor_b,
        length,
        ..
    } = joint
    else {
        unreachable!("it is called for distance joints");
    };
    GenericJointBuilder::new(JointAxesMask::empty())
        .coupled_axes(JointAxesMask::LIN_AXES)
        .local_anchor1(vector(anchor_a))
        .local_anchor2(vector(anchor_b))
        .limits(JointAxis::LinX, [0.0, length as f32])
}

/// The orientation of b in a at the start.
fn as_loaded(scene: &Scene, joint: &Joint) -> DQuat {
    let (a, b) = joint.bodies();
    scene.bodies[a].orientation.conjugate() * scene.bodies[b].orientation
}

// Its numbers and ours: its glam is another version.

fn vector(v: DVec3) -> Vector {
    Vector::from_array(v.as_vec3().to_array())
}

fn of_vector(v: Vector) -> DVec3 {
    DVec3::from_array(v.to_array().map(f64::from))
}

fn pose(position: DVec3, orientation: DQuat) -> Pose {
    let orientation = Rotation::from_array(orientation.as_quat().to_array());
    Pose::from_parts(vector(position), orientation)
}

#[cfg(test)]
mod tests;
