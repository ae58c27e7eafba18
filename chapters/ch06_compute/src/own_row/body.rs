//! What a body does in a substep: it takes up what pulls and holds it, gathers what its pairs did to
//! it, and moves. The formulas are written for as many bodies as a [`Real`] has lanes.

use bytemuck::{Pod, Zeroable};

use super::free_rotation;
use crate::rows::{Held, Press, Step, Turned};
use crate::simd::{Four, Mask, Quat, Real, Vec3};

// ANCHOR: moving
/// Where bodies are and how they move, a body a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moving<R> {
    /// World position, m.
    pub position: Vec3<R>,
    /// Body to world.
    pub attitude: Quat<R>,
    /// m/s.
    pub velocity: Vec3<R>,
    /// rad/s.
    pub angular_velocity: Vec3<R>,
    /// World angular momentum, kg m²/s. A ball has none here: it doesn't need it to turn.
    pub momentum: Vec3<R>,
    /// 0 for a static body.
    pub inverse_mass: R,
    /// Inverse principal moments, in its own axes; 0 for a static body.
    pub inverse_inertia: Vec3<R>,
}

/// Impulses that hold bodies, or push them, a body a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Holding<R> {
    /// Through its origin, N s.
    pub linear: Vec3<R>,
    /// About its origin, N m s.
    pub angular: Vec3<R>,
}

/// What pulls bodies beyond gravity, a body a lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pulling<R> {
    /// m/s².
    pub acceleration: Vec3<R>,
    /// About its origin, world axes, N m.
    pub torque: Vec3<R>,
}
// ANCHOR_END: moving

/// What pulls a body beyond gravity.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pull {
    /// m/s².
    pub acceleration: glam::Vec3,
    /// About its origin, world axes, N m.
    pub torque: glam::Vec3,
}

impl<R: Real> Moving<R> {
    // ANCHOR: kick
    /// Starts a substep: gravity, drag, other pulls, and what held the body in the last substep.
    #[inline(always)]
    pub fn kick(&mut self, held: &Holding<R>, pull: &Pulling<R>, step: &Step) {
        let (h, drag) = (R::splat(step.h), R::splat(step.drag));
        let falls = self.inverse_mass.gt(R::splat(0.0));
        let gravity = Vec3::all(step.h * step.gravity);
        self.velocity += Vec3::select(falls, gravity, Vec3::zero());
        self.velocity += pull.acceleration * h + held.linear * self.inverse_mass;
        self.velocity = self.velocity * drag;
        let turning = held.angular + pull.torque * h;
        self.angular_velocity += self.turned_by(turning);
        self.angular_velocity = self.angular_velocity * drag;
        self.momentum = (self.momentum + turning) * drag;
    }
    // ANCHOR_END: kick

    // ANCHOR: exchange
    /// Puts what holds the body now in the place of what it started the substep with.
    #[inline(always)]
    pub fn exchange(&mut self, old: &Holding<R>, new: &Holding<R>) {
        self.velocity += (new.linear - old.linear) * self.inverse_mass;
        let turning = new.angular - old.angular;
        self.angular_velocity += self.turned_by(turning);
        self.momentum += turning;
    }
    // ANCHOR_END: exchange

    /// The velocities that pushes are, for this body.
    #[inline(always)]
    #[must_use]
    pub fn push_of(&self, pushed: &Holding<R>) -> [Vec3<R>; 2] {
        [
            pushed.linear * self.inverse_mass,
            self.turned_by(pushed.angular),
        ]
    }

    /// I⁻¹ T in world axes.
    #[inline(always)]
    #[must_use]
    pub fn turned_by(&self, turning: Vec3<R>) -> Vec3<R> {
        let round = turning * self.inverse_inertia.x;
        if !(!self.is_round()).any() {
            return round;
        }
        let other = self.attitude.moment(self.inverse_inertia, turning);
        Vec3::select(self.is_round(), round, other)
    }

    /// Whether the three moments are equal, as a ball's are.
    #[inline(always)]
    #[must_use]
    pub fn is_round(&self) -> R::Mask {
        let Vec3 { x, y, z } = self.inverse_inertia;
        x.same(y) & y.same(z)
    }

    // ANCHOR: advance
    /// Moves the body for a substep. One that nothing touches falls as it should: h v̄, not h v, is how far
    /// it comes, where v̄ is the mean of its speeds before and after gravity's kick.
    #[inline(always)]
    pub fn advance(&mut self, [push, push_spin]: [Vec3<R>; 2], alone: R::Mask, step: &Step) {
        let early = Vec3::all(0.5 * step.h * step.gravity);
        let early = Vec3::select(alone, early, Vec3::zero());
        let moves = self.inverse_mass.gt(R::splat(0.0));
        let way = (self.velocity + push - early) * R::splat(step.h);
        self.position += Vec3::select(moves, way, Vec3::zero());
        let mut after = *self;
        after.turn(push_spin, step.h);
        self.attitude = Quat::select(moves, after.attitude, self.attitude);
        self.angular_velocity = Vec3::select(moves, after.angular_velocity, self.angular_velocity);
    }
    // ANCHOR_END: advance

    // ANCHOR: turned
    /// The attitude and the angular velocity after a substep: the push turns it, and then it turns freely
    /// with its angular momentum (chapter 2's splitting, so that errata 3 and 5 stay mended).
    ///
    /// The momentum is kept. Read from the angular velocity in each substep, it would grow by a rounding
    /// each time: 2e-7 of it, which after 10 s is 1e-3.
    #[inline(always)]
    pub fn turn(&mut self, push: Vec3<R>, h: f32) {
        let round = self
            .attitude
            .turned((self.angular_velocity + push) * R::splat(h));
        if !(!self.is_round()).any() {
            self.attitude = round;
            return;
        }
        let is_round = self.is_round();
        let inertia = self.inverse_inertia.recip();
        let pushed = self.attitude.turned(push * R::splat(h));
        let other = free_rotation::attitude_after(pushed, inertia, self.momentum, h);
        let spin = other.moment(self.inverse_inertia, self.momentum);
        self.attitude = Quat::select(is_round, round, other);
        self.angular_velocity = Vec3::select(is_round, self.angular_velocity, spin);
    }
    // ANCHOR_END: turned
}

/// What a body's pairs did to it, summed in the order of their IDs.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Gathered {
    /// The impulses of this substep.
    pub held: Held,
    /// Those of them with which the next one begins.
    pub stays: Held,
    /// The pushes of this substep.
    pub pushed: Held,
    /// How many pairs, limits and loops count.
    pub counts: f32,
    /// How many pairs count.
    pub touches: f32,
    spare: [f32; 2],
}

impl Gathered {
    /// What others have summed, without pushes: impulses, what of them was impacts, and how many pairs count.
    #[inline(always)]
    #[must_use]
    pub fn of(held: Held, impacts: Held, counts: f32) -> Self {
        let mut stays = held;
        stays.linear -= impacts.linear;
        stays.angular -= impacts.angular;
        Self {
            held,
            stays,
            counts,
            touches: counts,
            ..Self::default()
        }
    }
}

// ANCHOR: gather
impl Gathered {
    /// Adds a pair in which the body is b, or a: four numbers at a time, of which the last is unused.
    #[inline(always)]
    pub fn add(&mut self, press: &Press, is_b: bool) {
        let sign = if is_b { 1.0 } else { -1.0 };
        let given: &[[f32; 4]; 6] = bytemuck::cast_ref(press);
        let (linear, push) = (Four::new(given[0]), Four::new(given[3]));
        let turning = Four::new(given[1 + usize::from(is_b)]);
        let push_turning = Four::new(given[4 + usize::from(is_b)]);
        let forth = Four::new([sign, sign, sign, 0.0]);
        let three = Four::new([1.0, 1.0, 1.0, 0.0]);
        let stays = Four::splat(press.stays);
        let sums: &mut [[f32; 4]; 7] = bytemuck::cast_mut(self);
        let mut sum = |row: usize, more: Four| {
            sums[row] = (Four::new(sums[row]) + more).to_array();
        };
        sum(0, linear * forth);
        sum(1, turning * three);
        sum(2, linear * forth * stays);
        sum(3, turning * three * stays);
        sum(4, push * forth);
        sum(5, push_turning * three);
        self.counts += press.counts;
        self.touches += press.counts;
    }

    /// Shares the mass among limits and loops alone: pairs that come one after another have it whole.
    pub fn share_among_limits(&mut self) {
        self.counts -= self.touches;
    }

    /// Adds a limit in which the body is b, or a.
    pub fn add_turned(&mut self, turned: &Turned, is_b: bool) {
        let sign = if is_b { 1.0 } else { -1.0 };
        self.held.angular += sign * turned.turning;
        self.stays.angular += sign * turned.turning;
        self.pushed.angular += sign * turned.push;
        self.counts += turned.counts;
    }
}
// ANCHOR_END: gather

/// Rows of two vectors, a row a lane.
#[inline(always)]
#[must_use]
pub fn holding<R: Real>(rows: impl Fn(usize) -> Held) -> Holding<R> {
    let row = |lane: usize| bytemuck::cast::<Held, [[f32; 4]; 2]>(rows(lane));
    let [x, y, z, _] = R::of_rows(|lane| row(lane)[0]);
    let [tx, ty, tz, _] = R::of_rows(|lane| row(lane)[1]);
    Holding {
        linear: Vec3::new(x, y, z),
        angular: Vec3::new(tx, ty, tz),
    }
}
