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

/// How bodies turn, as a row needs it: of balls the attitude is of no matter.
pub trait Turns<R: Real>: Inertia<R> + Default {
    /// Attitudes, for as many rows as there are lanes.
    fn attitude(bodies: &Bodies, rows: &[u32]) -> Quat<R>;

    /// I⁻¹ times `shares` in world axes.
    fn inertia(bodies: &Bodies, rows: &[u32], attitude: Quat<R>, shares: R) -> Self;
}

impl<R: Real> Turns<R> for Symmetric<R> {
    #[inline(always)]
    fn attitude(bodies: &Bodies, rows: &[u32]) -> Quat<R> {
        attitude(bodies, rows)
    }

    #[inline(always)]
    fn inertia(bodies: &Bodies, rows: &[u32], attitude: Quat<R>, shares: R) -> Self {
        let inverse_inertia = Vec3::of(|lane| bodies.solid[rows[lane] as usize].inverse_inertia);
        Symmetric::turned(attitude.matrix(), inverse_inertia * shares)
    }
}

impl<R: Real> Turns<R> for Round<R> {
    #[inline(always)]
    fn attitude(_: &Bodies, _: &[u32]) -> Quat<R> {
        Quat::identity()
    }

    #[inline(always)]
    fn inertia(bodies: &Bodies, rows: &[u32], _: Quat<R>, shares: R) -> Self {
        let inverse_inertia = R::of(|lane| bodies.solid[rows[lane] as usize].inverse_inertia.x);
        Round(inverse_inertia * shares)
    }
}

/// How a ball turns, and what stands still: neither is turned by what presses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Standing<R>(Round<R>);

impl<R: Real> Inertia<R> for Standing<R> {
    const CENTRAL: bool = true;

    #[inline(always)]
    fn answer(self, turning: Vec3<R>) -> Vec3<R> {
        self.0.answer(turning)
    }
}

impl<R: Real> Turns<R> for Standing<R> {
    #[inline(always)]
    fn attitude(bodies: &Bodies, rows: &[u32]) -> Quat<R> {
        attitude(bodies, rows)
    }

    #[inline(always)]
    fn inertia(bodies: &Bodies, rows: &[u32], attitude: Quat<R>, shares: R) -> Self {
        Self(Round::inertia(bodies, rows, attitude, shares))
    }
}

#[inline(always)]
fn attitude<R: Real>(bodies: &Bodies, rows: &[u32]) -> Quat<R> {
    let [i, j, k, w] = gather::<R>(bytemuck::cast_slice(&bodies.attitude), rows);
    Quat {
        v: Vec3::new(i, j, k),
        w,
    }
}

// ANCHOR: side_of
impl<R: Real, I: Turns<R>> Side<R, I> {
    /// Gathers it from the bodies' columns, for as many rows as there are lanes.
    #[inline(always)]
    #[must_use]
    pub fn of(bodies: &Bodies, rows: &[u32]) -> Self {
        let motion = gather::<R>(bytemuck::cast_slice(&bodies.motion), rows);
        let spin = gather::<R>(bytemuck::cast_slice(&bodies.spin), rows);
        Self::moving(bodies, rows, motion, spin)
    }

    /// The same of bodies that move as is said: a velocity and n, an angular velocity and 1/m.
    #[inline(always)]
    #[must_use]
    pub fn moving(
        bodies: &Bodies,
        rows: &[u32],
        [vx, vy, vz, shares]: [R; 4],
        [wx, wy, wz, inverse_mass]: [R; 4],
    ) -> Self {
        let [x, y, z, _] = gather::<R>(bytemuck::cast_slice(&bodies.place), rows);
        let attitude = I::attitude(bodies, rows);
        let shared_inertia = I::inertia(bodies, rows, attitude, shares);
        Self {
            position: Vec3::new(x, y, z),
            attitude,
            velocity: Vec3::new(vx, vy, vz),
            angular_velocity: Vec3::new(wx, wy, wz),
            inverse_mass,
            shared_mass: shares * inverse_mass,
            shared_inertia,
        }
    }
}
// ANCHOR_END: side_of

impl<R: Real, I: Inertia<R>> Side<R, I> {
    /// The same body, moved by an impulse through its origin and an angular impulse: what the row alone
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
