//! What the seven steps share: a ball's properties, the balls themselves, and the two things that
//! happen to a ball. The formulas are those of chapter 2; the floor is the simplest there is.

use ch00_maths::f32::{inertia, verlet};
use ch00_scenes::random::SplitMix64;
use glam::{Quat, Vec3};

/// Gravity, m/s².
const GRAVITY: Vec3 = Vec3::new(0.0, -9.81, 0.0);

// ANCHOR: ball
/// A ball with all that report 8.1 gives a body, the radius of its collider, and a colour.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)] // In memory as it stands here. Otherwise the compiler may choose the order.
pub struct Ball {
    pub position: Vec3,
    pub last_position: Vec3,
    pub orientation: Quat,
    pub last_orientation: Quat,
    pub mass: f32,
    pub inertia: Vec3,
    pub radius: f32,
    pub restitution: f32,
    pub static_friction: f32,
    pub friction: f32,
    pub colour: Vec3,
}
// ANCHOR_END: ball

/// A struct of this type with another's properties, and one more if it has one more.
macro_rules! properties {
    ($Type:ident of $other:expr $(, $more:ident: $value:expr)?) => {
        $Type {
            position: $other.position,
            last_position: $other.last_position,
            orientation: $other.orientation,
            last_orientation: $other.last_orientation,
            mass: $other.mass,
            inertia: $other.inertia,
            radius: $other.radius,
            restitution: $other.restitution,
            static_friction: $other.static_friction,
            friction: $other.friction,
            colour: $other.colour,
            $($more: $value,)?
        }
    };
}
pub(crate) use properties;

// ANCHOR: formulas
/// p and p* of a ball that has flown on for `dt` seconds.
pub fn fly(p: Vec3, p_last: Vec3, dt: f32) -> (Vec3, Vec3) {
    (p + verlet::displacement(p, p_last, GRAVITY, 1.0, dt, dt), p)
}

/// p and p* of a ball above the floor: if it has sunk in, it stands on the floor and goes up again.
pub fn above_floor(p: Vec3, p_last: Vec3, radius: f32, restitution: f32, dt: f32) -> (Vec3, Vec3) {
    let v = verlet::velocity_now(p, p_last, GRAVITY, dt);
    if p.y >= radius || v.y >= 0.0 {
        return (p, p_last);
    }
    let p = p.with_y(radius);
    let v = v.with_y(-restitution * v.y);
    (p, verlet::last_position(p, v, GRAVITY, dt))
}
// ANCHOR_END: formulas

/// Balls in the air, no two alike, which begin a step of `dt` seconds.
pub fn balls(count: usize, dt: f32) -> Vec<Ball> {
    let mut random = SplitMix64::new(5);
    let ball = |_| {
        let radius = random.between(0.1, 0.5) as f32;
        let mass = 1000.0 * radius.powi(3);
        let position = random.vector(5.0).as_vec3() + Vec3::Y * 10.0;
        let velocity = random.vector(3.0).as_vec3();
        let orientation = random.rotation().as_quat();
        Ball {
            position,
            last_position: verlet::last_position(position, velocity, GRAVITY, dt),
            orientation,
            last_orientation: orientation,
            mass,
            inertia: inertia::sphere(mass, radius),
            radius,
            restitution: random.between(0.3, 0.9) as f32,
            static_friction: 0.6,
            friction: 0.5,
            colour: random.vector(0.5).as_vec3() + 0.5,
        }
    };
    (0..count).map(ball).collect()
}
