//! Passes over the bodies, in blocks of as many as a number has lanes.

#![expect(
    clippy::inline_always,
    reason = "a formula that isn't expanded in place passes its lanes through memory"
)]

use std::ops::Range;

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use super::joints::Joints;
use super::sums::Sums;
use crate::bodies::Bodies;
use crate::own_row::body::{Gathered, Holding, Moving, Pull, Pulling, holding};
use crate::rows::{Held, Motion, Place, Push, Seen, Solid, Spin, Step};
use crate::simd::{Quat, Real, Vec3, load, store};

/// The columns that a pass over the bodies reads and writes.
pub struct Movers<'b> {
    bodies: &'b mut Bodies,
    least: usize,
}

/// Some bodies that lie together, a body a lane.
pub struct Block<'b> {
    first: usize,
    place: &'b mut [Place],
    attitude: &'b mut [glam::Quat],
    motion: &'b mut [Motion],
    spin: &'b mut [Spin],
    momentum: &'b mut [glam::Vec3],
    held: &'b mut [Held],
    push: &'b mut [Push],
    before: &'b mut [Seen],
    solid: &'b [Solid],
}

impl<'b> Movers<'b> {
    /// All bodies; at least so many blocks go together.
    pub fn of(bodies: &'b mut Bodies, least: usize) -> Self {
        Self { bodies, least }
    }

    /// Does something with every block that is awake, on as many threads as there are.
    pub fn each<R: Real>(&mut self, work: impl Fn(&mut Block<'_>) + Sync) {
        for run in 0..self.bodies.runs().len() {
            let rows = self.bodies.runs()[run].clone();
            self.each_in::<R>(rows, &work);
        }
    }

    /// Does it with the blocks of some rows.
    fn each_in<R: Real>(&mut self, rows: Range<usize>, work: &(impl Fn(&mut Block<'_>) + Sync)) {
        let bodies = &mut *self.bodies;
        let columns = (
            bodies.place[rows.clone()].par_chunks_mut(R::LANES),
            bodies.attitude[rows.clone()].par_chunks_mut(R::LANES),
            bodies.motion[rows.clone()].par_chunks_mut(R::LANES),
            bodies.spin[rows.clone()].par_chunks_mut(R::LANES),
            bodies.momentum[rows.clone()].par_chunks_mut(R::LANES),
            bodies.held[rows.clone()].par_chunks_mut(R::LANES),
            bodies.push[rows.clone()].par_chunks_mut(R::LANES),
            bodies.before[rows.clone()].par_chunks_mut(R::LANES),
            bodies.solid[rows.clone()].par_chunks(R::LANES),
        );
        let blocks = columns.into_par_iter().enumerate().with_min_len(self.least);
        blocks.for_each(|(block, columns)| {
            let (place, attitude, motion, spin, momentum, held, push, before, solid) = columns;
            work(&mut Block {
                first: rows.start + block * R::LANES,
                place,
                attitude,
                motion,
                spin,
                momentum,
                held,
                push,
                before,
                solid,
            });
        });
    }
}

/// Notes among how many pairs each body's mass is shared; `motion` begins with the row `first`.
pub fn share(motion: &mut [Motion], first: usize, sums: &Sums<'_>) {
    for (row, motion) in (first..).zip(motion) {
        motion.shares = sums.row(row).counts.max(1.0);
    }
}

impl Block<'_> {
    /// Takes over what the pairs of a new step give.
    pub fn start(&mut self, sums: &Sums<'_>) {
        for (row, held) in (self.first..).zip(&mut *self.held) {
            *held = sums.row(row).stays;
        }
        share(self.motion, self.first, sums);
    }

    /// What the body of a lane has gathered; lanes that are left over have the last one's.
    #[inline(always)]
    fn gathered<'s>(&self, sums: &Sums<'s>, lane: usize) -> &'s Gathered {
        sums.row(self.first + lane.min(self.place.len() - 1))
    }

    /// Starts a substep: what pulls and holds each body.
    pub fn kick<R: Real>(&mut self, pulls: &[Pull], joints: &Joints<R>, step: &Step) {
        let mut moving = self.load::<R>();
        self.note_before(&moving);
        let (first, last) = (self.first, self.place.len() - 1);
        let held = holding(|lane| {
            let lane = lane.min(last);
            joints.with(first + lane, self.held[lane])
        });
        let pull = |lane: usize| {
            pulls
                .get(first + lane.min(last))
                .copied()
                .unwrap_or_default()
        };
        let pulling = if pulls.is_empty() {
            Pulling::default()
        } else {
            Pulling {
                acceleration: Vec3::of(|lane| pull(lane).acceleration),
                torque: Vec3::of(|lane| pull(lane).torque),
            }
        };
        moving.kick(&held, &pulling, step);
        self.store(&moving);
    }

    // ANCHOR: substep
    /// All that bodies do in a substep which no joints hold and nothing but gravity pulls: they exchange what
    /// holds them, move, and are kicked into the next one.
    pub fn substep<R: Real>(&mut self, sums: &Sums<'_>, kicks: bool, step: &Step) {
        let mut moving = self.load::<R>();
        let push = self.exchange_with(&mut moving, sums);
        let alone = R::of(|lane| self.gathered(sums, lane).touches);
        moving.advance(push, alone.same(R::splat(0.0)), step);
        share(self.motion, self.first, sums);
        if kicks {
            self.note_before(&moving);
            let held = holding(|lane| self.gathered(sums, lane).stays);
            moving.kick(&held, &Pulling::default(), step);
        }
        self.store(&moving);
    }
    // ANCHOR_END: substep

    /// Puts what holds each body now in the place of what it started the substep with, and says how it is
    /// pushed.
    pub fn exchange<R: Real>(&mut self, sums: &Sums<'_>) {
        let mut moving = self.load::<R>();
        self.exchange_with(&mut moving, sums);
        self.store(&moving);
    }

    /// Each body takes up what its pairs gave it, without giving back.
    pub fn take_up<R: Real>(&mut self, sums: &Sums<'_>) {
        let mut moving = self.load::<R>();
        let new = holding(|lane| self.gathered(sums, lane).held);
        moving.exchange(&Holding::default(), &new);
        self.store(&moving);
    }

    /// Each body moves.
    pub fn advance<R: Real>(&mut self, sums: &Sums<'_>, joints: &Joints<R>, step: &Step) {
        let mut moving = self.load::<R>();
        let last = self.place.len() - 1;
        let first = self.first;
        let alone = |lane: usize| joints.floats(first + lane.min(last), sums);
        let alone = R::of(|lane| f32::from(u8::from(alone(lane))));
        let table: &[[[f32; 4]; 2]] = bytemuck::cast_slice(self.push);
        let [x, y, z, _] = R::of_rows(|lane| table[lane.min(last)][0]);
        let [i, j, k, _] = R::of_rows(|lane| table[lane.min(last)][1]);
        let push = [Vec3::new(x, y, z), Vec3::new(i, j, k)];
        moving.advance(push, alone.gt(R::splat(0.5)), step);
        self.store(&moving);
        share(self.motion, first, sums);
    }

    /// Exchanges what holds the bodies; gives the velocities of their pushes.
    #[inline(always)]
    fn exchange_with<R: Real>(&mut self, moving: &mut Moving<R>, sums: &Sums<'_>) -> [Vec3<R>; 2] {
        let last = self.place.len() - 1;
        let old: Holding<R> = holding(|lane| self.held[lane.min(last)]);
        let new = holding(|lane| self.gathered(sums, lane).held);
        moving.exchange(&old, &new);
        let pushed = holding(|lane| self.gathered(sums, lane).pushed);
        let [mut v, mut w] = moving.push_of(&pushed);
        if let Some(live) = sums.pushed() {
            let row = |lane: usize| live.push(self.first + lane.min(last));
            let [x, y, z, _] = R::of_rows(|lane| row(lane)[0]);
            let [i, j, k, _] = R::of_rows(|lane| row(lane)[1]);
            v += Vec3::new(x, y, z);
            w += Vec3::new(i, j, k);
        }
        let zero = R::splat(0.0);
        let linear = R::to_rows([v.x, v.y, v.z, zero]);
        let angular = R::to_rows([w.x, w.y, w.z, zero]);
        for (lane, push) in self.push.iter_mut().enumerate() {
            *push = bytemuck::cast([linear[lane], angular[lane]]);
            self.held[lane] = sums.row(self.first + lane).stays;
        }
        [v, w]
    }

    /// Notes how bodies moved before a kick.
    #[inline(always)]
    fn note_before<R: Real>(&mut self, moving: &Moving<R>) {
        let (v, w, zero) = (moving.velocity, moving.angular_velocity, R::splat(0.0));
        let linear = R::to_rows([v.x, v.y, v.z, zero]);
        let angular = R::to_rows([w.x, w.y, w.z, zero]);
        for (lane, before) in self.before.iter_mut().enumerate() {
            *before = bytemuck::cast([linear[lane], angular[lane]]);
        }
    }

    /// The rows as lanes.
    #[inline(always)]
    fn load<R: Real>(&self) -> Moving<R> {
        let last = self.place.len() - 1;
        let [x, y, z, _] = load::<R>(bytemuck::cast_slice(self.place));
        let [i, j, k, w] = load::<R>(bytemuck::cast_slice(self.attitude));
        let [vx, vy, vz, _] = load::<R>(bytemuck::cast_slice(self.motion));
        let [wx, wy, wz, inverse_mass] = load::<R>(bytemuck::cast_slice(self.spin));
        Moving {
            position: Vec3::new(x, y, z),
            attitude: Quat {
                v: Vec3::new(i, j, k),
                w,
            },
            velocity: Vec3::new(vx, vy, vz),
            angular_velocity: Vec3::new(wx, wy, wz),
            momentum: Vec3::of(|lane| self.momentum[lane.min(last)]),
            inverse_mass,
            inverse_inertia: Vec3::of(|lane| self.solid[lane.min(last)].inverse_inertia),
        }
    }

    /// Lanes as rows again.
    #[inline(always)]
    fn store<R: Real>(&mut self, moving: &Moving<R>) {
        let Moving {
            position: p,
            attitude: q,
            velocity: v,
            angular_velocity: w,
            ..
        } = *moving;
        let last = self.place.len() - 1;
        let reach = R::of(|lane| self.place[lane.min(last)].reach);
        let shares = R::of(|lane| self.motion[lane.min(last)].shares);
        store([p.x, p.y, p.z, reach], bytemuck::cast_slice_mut(self.place));
        store(
            [q.v.x, q.v.y, q.v.z, q.w],
            bytemuck::cast_slice_mut(self.attitude),
        );
        store(
            [v.x, v.y, v.z, shares],
            bytemuck::cast_slice_mut(self.motion),
        );
        store(
            [w.x, w.y, w.z, moving.inverse_mass],
            bytemuck::cast_slice_mut(self.spin),
        );
        for (lane, momentum) in self.momentum.iter_mut().enumerate() {
            *momentum = moving.momentum.lane(lane);
        }
    }
}
