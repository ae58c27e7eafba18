//! Where the points of a pair are now.

use super::SMALL;
use crate::own_row::side::Side;
use crate::rows::{FIXED, Manifold, ROUND, WITH_A, WITH_B};
use crate::simd::{Inertia, Mask, Real, Vec3, array_of};

// ANCHOR: contact
/// Where bodies touch, a pair a lane: what stays so for a step. [`Manifold`] tells what the numbers are.
#[derive(Clone, Copy, Debug)]
pub struct Contact<R, const P: usize> {
    /// How the normals of all lanes turn: by the core points, with a, with b, or not at all.
    pub turns: u32,
    /// From a to b: in the world, or in the axes of the body that it turns with.
    pub normal: Vec3<R>,
    /// What a's surface is away from its core points, m.
    pub round_a: R,
    /// What b's surface is away from its core points, m.
    pub round_b: R,
    /// Core points in a's axes, m.
    pub core_a: [Vec3<R>; P],
    /// Core points in b's axes, m.
    pub core_b: [Vec3<R>; P],
}
// ANCHOR_END: contact

impl<R: Real, const P: usize> Contact<R, P> {
    /// What `manifold` gives for each lane; all have P points and turn alike.
    #[inline(always)]
    pub fn of<'m>(manifold: impl Fn(usize) -> &'m Manifold) -> Self {
        let row = |k: usize| {
            R::of_rows(|lane| {
                let rows: &[[f32; 4]; 10] = bytemuck::cast_ref(manifold(lane));
                rows[k]
            })
        };
        let vector = |k: usize| {
            let [x, y, z, _] = row(k);
            Vec3::new(x, y, z)
        };
        let [round_a, round_b, ..] = row(1);
        Self {
            turns: manifold(0).turns,
            normal: vector(0),
            round_a,
            round_b,
            core_a: array_of(|k| vector(2 + k)),
            core_b: array_of(|k| vector(6 + k)),
        }
    }
}

// ANCHOR: touching
/// Where the points of a pair are now.
#[derive(Clone, Copy, Debug)]
pub struct Touching<R, const P: usize> {
    /// From a to b.
    pub normal: Vec3<R>,
    /// s: how far apart the surfaces are at each point, m; negative inside.
    pub distance: [R; P],
    /// From a's centre to each point, m.
    pub arm_a: [Vec3<R>; P],
    /// From b's centre, m.
    pub arm_b: [Vec3<R>; P],
    /// From a's centre to the mean of the points, m.
    pub mean_a: Vec3<R>,
    /// From b's centre, m.
    pub mean_b: Vec3<R>,
    /// Mean distance of the points from their mean, m.
    pub spread: R,
    /// What the surfaces of round bodies are away from their core points together, m; negative where they
    /// aren't round.
    pub reach: R,
}

/// Where the points are for bodies where they are now: both arms of a point end at the same place, so
/// that what one body gains in angular momentum the other loses.
#[inline(always)]
#[must_use]
pub fn touching<R: Real, I: Inertia<R>, const P: usize>(
    c: &Contact<R, P>,
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> Touching<R, P> {
    let apart = b.position - a.position;
    let cores: [_; P] = array_of(|k| {
        [
            a.attitude.rotate(c.core_a[k]),
            apart + b.attitude.rotate(c.core_b[k]),
        ]
    });
    let normal = normal_now(c, &cores, a, b);
    let distance: [_; P] = array_of(|k| {
        let [on_a, on_b] = cores[k];
        (on_b - on_a).dot(normal) - c.round_a - c.round_b
    });
    let arm_a: [_; P] = array_of(|k| middle(c, cores[k], normal, distance[k]));
    let part = R::splat(1.0 / P as f32);
    let mean_a = arm_a.iter().fold(Vec3::zero(), |sum, arm| sum + *arm) * part;
    let far = |sum: R, arm: &Vec3<R>| sum + (*arm - mean_a).length();
    let is_round = c.turns == ROUND;
    Touching {
        normal,
        distance,
        arm_a,
        arm_b: array_of(|k| arm_a[k] - apart),
        mean_a,
        mean_b: mean_a - apart,
        spread: arm_a.iter().fold(R::splat(0.0), far) * part,
        reach: if is_round {
            c.round_a + c.round_b
        } else {
            R::splat(-1.0)
        },
    }
}

/// Where two surfaces meet: in the middle of the gap. On a round body that is along the normal from its
/// core point; a point fixed in a face would lag behind a body that rolls on.
#[inline(always)]
fn middle<R: Real, const P: usize>(
    c: &Contact<R, P>,
    [core_a, core_b]: [Vec3<R>; 2],
    normal: Vec3<R>,
    distance: R,
) -> Vec3<R> {
    let (zero, half) = (R::splat(0.0), R::splat(0.5));
    let from_a = core_a + normal * (c.round_a + distance * half);
    let from_b = core_b - normal * (c.round_b + distance * half);
    let between = (core_a + core_b) * half;
    let flat = Vec3::select(c.round_b.gt(zero), from_b, between);
    Vec3::select(c.round_a.gt(zero), from_a, flat)
}

/// The normal for bodies where they are now.
#[inline(always)]
fn normal_now<R: Real, I: Inertia<R>, const P: usize>(
    c: &Contact<R, P>,
    cores: &[[Vec3<R>; 2]; P],
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> Vec3<R> {
    match c.turns {
        WITH_A => a.attitude.rotate(c.normal),
        WITH_B => b.attitude.rotate(c.normal),
        FIXED => c.normal,
        _ => {
            let between = |sum: Vec3<R>, [on_a, on_b]: &[Vec3<R>; 2]| sum + (*on_b - *on_a);
            let line = cores.iter().fold(Vec3::zero(), between);
            let length = line.length();
            let is_line = length.gt(R::splat(SMALL));
            let length = R::select(is_line, length, R::splat(1.0));
            Vec3::select(is_line, line * length.recip(), c.normal)
        }
    }
}
// ANCHOR_END: touching

// ANCHOR: touching_balls
/// [`touching`] for two balls: the point lies on the line between their centres.
#[inline(always)]
#[must_use]
pub fn touching_balls<R: Real, I: Inertia<R>>(
    c: &Contact<R, 1>,
    a: &Side<R, I>,
    b: &Side<R, I>,
) -> Touching<R, 1> {
    let apart = b.position - a.position;
    let length = apart.length();
    let is_line = length.gt(R::splat(SMALL));
    let along = apart * R::select(is_line, length, R::splat(1.0)).recip();
    let normal = Vec3::select(is_line, along, c.normal);
    let reach = c.round_a + c.round_b;
    let distance = length - reach;
    let arm_a = normal * (c.round_a + distance * R::splat(0.5));
    let arm_b = arm_a - apart;
    Touching {
        normal,
        distance: [distance],
        arm_a: [arm_a],
        arm_b: [arm_b],
        mean_a: arm_a,
        mean_b: arm_b,
        spread: R::splat(0.0),
        reach,
    }
}
// ANCHOR_END: touching_balls

impl<R: Real, const P: usize> Touching<R, P> {
    /// Whether the bodies touch at point k, or come to within `h` seconds.
    #[inline(always)]
    #[must_use]
    pub fn meets<I: Inertia<R>>(
        &self,
        k: usize,
        a: &Side<R, I>,
        b: &Side<R, I>,
        h: f32,
    ) -> R::Mask {
        self.distance[k].le(R::splat(0.0)) | self.comes(k, a, b, h)
    }

    /// Whether the bodies come so near within `h` seconds that they touch at point k.
    #[inline(always)]
    #[must_use]
    pub fn comes<I: Inertia<R>>(
        &self,
        k: usize,
        a: &Side<R, I>,
        b: &Side<R, I>,
        h: f32,
    ) -> R::Mask {
        let speed = super::parting(self, k, a, b);
        let near = (self.distance[k] + speed * R::splat(h)).le(R::splat(0.0));
        let apart = near & self.distance[k].gt(R::splat(0.0)) & self.reach.gt(R::splat(0.0));
        if apart.any() {
            return near & !(apart & self.passes(k, a, b, h));
        }
        near
    }

    // ANCHOR: passes
    /// Whether two round bodies that come nearer pass each other within `h` seconds: the nearest that their
    /// core points come is farther than both radii. Without it a fast ball would be stopped by what it flies
    /// past, or share its mass with it, and be stopped too little by what it hits.
    #[inline(always)]
    fn passes<I: Inertia<R>>(&self, k: usize, a: &Side<R, I>, b: &Side<R, I>, h: f32) -> R::Mask {
        let apart = self.normal * (self.distance[k] + self.reach);
        let moves = (b.velocity_at(self.arm_b[k]) - a.velocity_at(self.arm_a[k])) * R::splat(h);
        let part = -apart.dot(moves) / moves.length_squared().max(R::splat(SMALL));
        let part = part.clamp(R::splat(0.0), R::splat(1.0));
        let nearest = apart + moves * part;
        nearest.length_squared().gt(self.reach * self.reach)
    }
    // ANCHOR_END: passes
}
