//! Joints, in the order in which a step visits them: each is a pin, with or without an angle limit, or a
//! rod. Chapter 4's order and formulas, over the columns of six tables.

mod angle;
mod pin;
mod poses;
mod rod;

pub use poses::Poses;

use std::ops::Range;

use ch03_collision::Span;
use ch04_ragdolls::{Anchors, Arms};
use glam::{Quat, Vec3};

use super::movers::Turning;
use super::velocities;
use super::visits::Visits;
use crate::columns::AnyTable;
use crate::data::{Bodies, Joints, Limits, NONE, Pins, Rods, Trees, Turns};

// ANCHOR: held
/// What is resolved together with the contacts, in the same sweeps.
pub trait Held<M> {
    /// The visits that last looked at the joints.
    fn seen(&mut self) -> &mut [u32];

    /// Nudges bodies to where they belong; gives how far the furthest was off, m.
    fn part(&mut self, movers: &mut M, visits: &mut Visits) -> f32;

    /// Begins with the impulses of the last step.
    fn resume(&mut self, movers: &mut M);

    /// Mends the impulses once; says whether a relative velocity was off by more than `still`, m/s.
    fn hold(&mut self, movers: &mut M, visits: &mut Visits, still: f32) -> bool;
}
// ANCHOR_END: held

/// No joints.
pub struct NoJoints;

impl<M> Held<M> for NoJoints {
    fn seen(&mut self) -> &mut [u32] {
        &mut []
    }

    fn part(&mut self, _movers: &mut M, _visits: &mut Visits) -> f32 {
        0.0
    }

    fn resume(&mut self, _movers: &mut M) {}

    fn hold(&mut self, _movers: &mut M, _visits: &mut Visits, _still: f32) -> bool {
        false
    }
}

// ANCHOR: assembly
/// The tables of joints.
pub struct Assembly<'a> {
    /// Who.
    pub joints: &'a mut Joints,
    /// Points.
    pub pins: &'a mut Pins,
    /// Distances.
    pub rods: &'a mut Rods,
    /// Angle limits.
    pub limits: &'a Limits,
    /// Their turns.
    pub turns: &'a mut Turns,
}
// ANCHOR_END: assembly

/// A joint's row, with those of its bodies and its parts.
#[derive(Clone, Copy)]
struct Ends {
    joint: usize,
    parent: usize,
    child: usize,
    part: usize,
    limit: Option<usize>,
}

/// What a joint is.
#[derive(Clone, Copy)]
enum Kind {
    Pin,
    Rod,
}

impl Assembly<'_> {
    /// Gathers what a joint names.
    #[inline]
    fn ends(&self, joint: usize) -> (Kind, Ends) {
        let limit = self.joints.limit[joint];
        let ends = Ends {
            joint,
            parent: self.joints.parent[joint] as usize,
            child: self.joints.child[joint] as usize,
            part: self.joints.part[joint] as usize,
            limit: (limit != NONE).then_some(limit as usize),
        };
        let kind = if self.joints.kind[joint] == 0 {
            Kind::Pin
        } else {
            Kind::Rod
        };
        (kind, ends)
    }

    /// The arms and the gap of a joint whose bodies have these poses.
    #[inline]
    fn arms_at(&self, joint: usize, parent: (Vec3, Quat), child: (Vec3, Quat)) -> Arms {
        let anchors = Anchors {
            parent: self.joints.anchor_parent[joint],
            child: self.joints.anchor_child[joint],
        };
        anchors.arms_at(parent, child)
    }

    /// Notes them.
    #[inline]
    fn set_arms(&mut self, joint: usize, arms: Arms) {
        self.joints.arm_parent[joint] = arms.t1;
        self.joints.arm_child[joint] = arms.t2;
    }

    /// As noted: t₁ and t₂.
    #[inline]
    fn arms(&self, joint: usize) -> (Vec3, Vec3) {
        (self.joints.arm_parent[joint], self.joints.arm_child[joint])
    }

    // ANCHOR: correct
    /// Puts all bodies back where their joints want them: each tree by itself, then, if joints close
    /// loops, all together. The report's constraint update.
    pub fn correct(&mut self, trees: &Trees, poses: &mut Poses<'_>, sweeps: u32, every: bool) {
        let mut visits = self.first_visits(poses, every);
        let mut in_trees = 0;
        for tree in 0..trees.rows() {
            let (first, end) = (trees.first[tree] as usize, trees.end[tree] as usize);
            self.sweep(first..end, poses, &mut visits, sweeps);
            in_trees = end;
        }
        let all = self.joints.rows();
        if in_trees < all {
            self.sweep(0..all, poses, &mut visits, sweeps);
        }
    }

    /// Goes through joints again and again until none was off.
    fn sweep(
        &mut self,
        joints: Range<usize>,
        poses: &mut Poses<'_>,
        visits: &mut Visits,
        sweeps: u32,
    ) {
        for _ in 0..sweeps {
            let mut moved = false;
            for joint in joints.clone() {
                let (kind, at) = self.ends(joint);
                if visits.is_due(self.joints.seen[joint], at.parent, at.child, poses) {
                    let has_moved = self.correct_one(kind, at, poses);
                    let seen = visits.note(at.parent, at.child, has_moved, poses);
                    self.joints.seen[joint] = seen;
                    moved |= has_moved;
                }
            }
            if !moved {
                break;
            }
        }
    }
    // ANCHOR_END: correct

    /// Before the first visit: all bodies have just moved, no joint has been looked at.
    fn first_visits(&mut self, poses: &mut Poses<'_>, every: bool) -> Visits {
        let joints = &mut *self.joints;
        Visits::begin(every, &joints.parent, [&mut joints.seen, &mut []], poses);
        Visits::begin(every, &joints.child, [&mut [], &mut []], poses)
    }

    fn correct_one(&mut self, kind: Kind, at: Ends, poses: &mut Poses<'_>) -> bool {
        match kind {
            Kind::Pin => {
                let moved = pin::correct(self, at, poses);
                moved | angle::correct(self, at, poses)
            }
            Kind::Rod => rod::correct(self, at, poses),
        }
    }

    /// The same as printed: one walk, the angle before the pin.
    pub fn correct_printed(&mut self, poses: &mut Poses<'_>) {
        for joint in 0..self.joints.rows() {
            let (kind, at) = self.ends(joint);
            poses.weigh(at.parent);
            poses.weigh(at.child);
            match kind {
                Kind::Pin => {
                    angle::correct_printed(self, at, poses);
                    pin::correct_printed(self, at, poses);
                }
                Kind::Rod => rod::correct_printed(self, at, poses),
            }
        }
    }

    // ANCHOR: prepare
    /// Works out what stays the same while contacts are resolved.
    pub fn prepare(&mut self, bodies: &Bodies, movers: &Turning<'_>, dt_last: f32, span: Span) {
        for joint in 0..self.joints.rows() {
            let (kind, at) = self.ends(joint);
            let arms = self.arms_now(joint, bodies);
            self.set_arms(joint, arms);
            let moved = [at.parent, at.child].map(|row| velocities::moved(bodies, row, dt_last));
            match kind {
                Kind::Pin => {
                    pin::prepare(self, at, movers, moved, span);
                    angle::prepare(self, at, bodies, movers, span);
                }
                Kind::Rod => rod::prepare(self, at, arms, movers, moved, span),
            }
        }
    }
    // ANCHOR_END: prepare

    /// Notes how far the bodies, now in their places, are from where they belong.
    pub fn finish(&mut self, bodies: &Bodies) {
        for joint in 0..self.joints.rows() {
            let (kind, at) = self.ends(joint);
            let arms = self.arms_now(joint, bodies);
            self.set_arms(joint, arms);
            match kind {
                Kind::Pin => {
                    self.pins.left[at.part] = arms.d;
                    angle::finish(self, at, bodies);
                }
                Kind::Rod => self.rods.left[at.part] = arms.d.length() - self.rods.length[at.part],
            }
        }
    }

    /// Forgets the impulses of the last step.
    pub fn forget(&mut self) {
        self.pins.impulse.fill(Vec3::ZERO);
        self.rods.impulse.fill(0.0);
        self.turns.impulse.fill(0.0);
    }

    /// Where a joint's bodies are.
    fn arms_now(&self, joint: usize, bodies: &Bodies) -> Arms {
        let (_, at) = self.ends(joint);
        let pose = |row: usize| (bodies.position[row], bodies.orientation[row]);
        self.arms_at(joint, pose(at.parent), pose(at.child))
    }
}

/// What a visit with nudges found and did.
#[derive(Clone, Copy)]
struct Parted {
    /// How far the bodies were off, m.
    off: f32,
    /// Whether it nudged them.
    nudged: bool,
}

impl std::ops::Add for Parted {
    type Output = Self;

    /// Both, one after the other.
    fn add(self, after: Self) -> Self {
        Self {
            off: self.off.max(after.off),
            nudged: self.nudged || after.nudged,
        }
    }
}

/// Joints whose bodies have these poses, where a step is resolved that they are part of.
pub struct Jointed<'a> {
    /// The joints.
    pub assembly: Assembly<'a>,
    /// Where the bodies are before nudges.
    pub position: &'a [Vec3],
    /// How they are turned before nudges.
    pub orientation: &'a [Quat],
}

impl Jointed<'_> {
    /// Where their nudges have brought a joint's two bodies.
    #[inline]
    fn nudged_poses(&self, movers: &Turning<'_>, at: Ends) -> [(Vec3, Quat); 2] {
        [
            self.nudged_pose(movers, at.parent),
            self.nudged_pose(movers, at.child),
        ]
    }

    /// Where its nudges have brought a body.
    #[inline]
    fn nudged_pose(&self, movers: &Turning<'_>, row: usize) -> (Vec3, Quat) {
        (
            self.position[row] + movers.shift[row],
            ch00_maths::f32::rotation::turned(self.orientation[row], movers.turn[row]),
        )
    }
}

// ANCHOR: held_joints
impl Held<Turning<'_>> for Jointed<'_> {
    fn seen(&mut self) -> &mut [u32] {
        &mut self.assembly.joints.seen
    }

    fn part(&mut self, movers: &mut Turning<'_>, visits: &mut Visits) -> f32 {
        let mut furthest = 0.0_f32;
        for joint in 0..self.assembly.joints.rows() {
            let (kind, at) = self.assembly.ends(joint);
            let seen = self.assembly.joints.seen[joint];
            if visits.is_due(seen, at.parent, at.child, movers) {
                let parted = match kind {
                    Kind::Pin => {
                        let poses = self.nudged_poses(movers, at);
                        let pin = pin::part(&self.assembly, at, poses, movers);
                        let turned = if pin.nudged {
                            self.nudged_poses(movers, at)
                        } else {
                            poses
                        };
                        pin + angle::part(&mut self.assembly, at, turned, movers)
                    }
                    Kind::Rod => rod::part(self, at, movers),
                };
                let nudged = parted.nudged;
                let seen = visits.note(at.parent, at.child, nudged, movers);
                self.assembly.joints.seen[joint] = seen;
                self.assembly.joints.off[joint] = parted.off;
            }
            furthest = furthest.max(self.assembly.joints.off[joint]);
        }
        furthest
    }

    fn resume(&mut self, movers: &mut Turning<'_>) {
        for joint in 0..self.assembly.joints.rows() {
            match self.assembly.ends(joint) {
                (Kind::Pin, at) => {
                    pin::resume(&self.assembly, at, movers);
                    angle::resume(&self.assembly, at, movers);
                }
                (Kind::Rod, at) => rod::resume(&self.assembly, at, movers),
            }
        }
    }

    fn hold(&mut self, movers: &mut Turning<'_>, visits: &mut Visits, still: f32) -> bool {
        let mut much = false;
        for joint in 0..self.assembly.joints.rows() {
            let (kind, at) = self.assembly.ends(joint);
            much |= match kind {
                Kind::Pin => {
                    let off = pin::hold(&mut self.assembly, at, movers) > still;
                    off | angle::hold(&mut self.assembly, at, movers, still)
                }
                Kind::Rod => rod::hold(&mut self.assembly, at, movers) > still,
            };
            visits.note(at.parent, at.child, true, movers);
        }
        much
    }
}
// ANCHOR_END: held_joints
