//! One of the two bodies of a pair, a limit or a joint that closes a loop, as the row sees it.

use crate::bodies::Bodies;
use crate::simd::{Inertia, Quat, Real, Round, Symmetric, Vec3, gather};

// ANCHOR: side
/// One of the two bodies, as the row sees it; a body a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Side<R, I = Symmetric<R>> {
    /// World position, m.
    pub position: Vec3<R>,
    /// Body to world.
    pub attitude: Quat<R>,
    /// m/s.
    pub velocity: Vec3<R>,
    /// rad/s.
    pub angular_velocity: Vec3<R>,
    /// 1/m: with the whole mass.
    pub inverse_mass: R,
    /// n/m: with the share of the mass that the row has.
    pub shared_mass: R,
    /// n I⁻¹ in world axes.
    pub shared_inertia: I,
}
// ANCHOR_END: side

// ANCHOR: side_of
impl<R: Real> Side<R> {
    /// Gathers it from the bodies' columns, for as many rows as there are lanes.
    #[inline(always)]
    #[must_use]
    pub fn of(bodies: &Bodies, rows: &[u32]) -> Self {
        let [x, y, z, _] = gather::<R>(bytemuck::cast_slice(&bodies.place), rows);
        let [i, j, k, w] = gather::<R>(bytemuck::cast_slice(&bodies.attitude), rows);
        let [vx, vy, vz, shares] = gather::<R>(bytemuck::cast_slice(&bodies.motion), rows);
        let [wx, wy, wz, inverse_mass] = gather::<R>(bytemuck::cast_slice(&bodies.spin), rows);
        let inverse_inertia = Vec3::of(|lane| bodies.solid[rows[lane] as usize].inverse_inertia);
        let attitude = Quat {
            v: Vec3::new(i, j, k),
            w,
        };
        Self {
            position: Vec3::new(x, y, z),
            attitude,
            velocity: Vec3::new(vx, vy, vz),
            angular_velocity: Vec3::new(wx, wy, wz),
            inverse_mass,
            shared_mass: shares * inverse_mass,
            shared_inertia: Symmetric::turned(attitude.matrix(), inverse_inertia * shares),
        }
    }
}
// ANCHOR_END: side_of

impl<R: Real> Side<R, Round<R>> {
    /// The same for balls: their attitude is of no matter.
    #[inline(always)]
    #[must_use]
    pub fn of_balls(bodies: &Bodies, rows: &[u32]) -> Self {
        let [x, y, z, _] = gather::<R>(bytemuck::cast_slice(&bodies.place), rows);
        let [vx, vy, vz, shares] = gather::<R>(bytemuck::cast_slice(&bodies.motion), rows);
        let [wx, wy, wz, inverse_mass] = gather::<R>(bytemuck::cast_slice(&bodies.spin), rows);
        let inverse_inertia = R::of(|lane| bodies.solid[rows[lane] as usize].inverse_inertia.x);
        Self {
            position: Vec3::new(x, y, z),
            attitude: Quat::identity(),
            velocity: Vec3::new(vx, vy, vz),
            angular_velocity: Vec3::new(wx, wy, wz),
            inverse_mass,
            shared_mass: shares * inverse_mass,
            shared_inertia: Round(inverse_inertia * shares),
        }
    }
}

impl<R: Real, I: Inertia<R>> Side<R, I> {
    /// The same body, moved by an impulse through its origin and a turning impulse: what the row alone
    /// makes of it.
    #[inline(always)]
    pub fn take(&mut self, impulse: Vec3<R>, turning: Vec3<R>) {
        self.velocity += impulse * self.shared_mass;
        self.angular_velocity += self.shared_inertia.answer(turning);
    }

    /// World velocity of the body's point at `arm`, m/s.
    #[inline(always)]
    #[must_use]
    pub fn velocity_at(&self, arm: Vec3<R>) -> Vec3<R> {
        self.velocity + self.angular_velocity.cross(arm)
    }
}
