//! The narrow phase of a step: where pairs touch, and what they begin with.

use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use super::{Label, Pairs};
use crate::bodies::Bodies;
use crate::lanes::batches::Sort;
use crate::lanes::plan::{Part, Plan};
use crate::lanes::regions::Regions;
use crate::norm::Norm;
use crate::own_row::narrow::{Posed, put_manifold};
use crate::rows::{Impulse, Manifold, Material};
use crate::rules::{MARGIN, Method};
use crate::simd::Real;

/// What the narrow phase is given.
#[derive(Clone, Copy, Debug)]
pub struct Found<'f> {
    /// The pairs that may touch, in order.
    pub pairs: &'f [(usize, usize)],
    /// All bodies.
    pub bodies: &'f Bodies,
    /// How long a step takes, s.
    pub dt: f32,
    /// What is done with the pairs.
    pub method: Method,
    /// What is kept although nothing needs it.
    pub plan: Plan,
}

// ANCHOR: meet
/// Narrow phase: where each pair touches or may touch; impulses of the last step go on where the same
/// features still touch. At least `least` pairs that were found go together.
pub fn meet<R: Real>(
    found: &Found<'_>,
    last: &Pairs<R>,
    regions: &mut Regions,
    pairs: &mut Pairs<R>,
    least: usize,
) {
    let mut met = std::mem::take(&mut pairs.met);
    met.resize_with(found.pairs.len().div_ceil(least.max(1)), Met::default);
    let some = found.pairs.chunks(least.min(found.pairs.len()).max(1));
    met.par_iter_mut()
        .zip(some.collect::<Vec<_>>())
        .for_each(|(met, some)| met.meet(some, found, last, regions));
    match &mut met[..] {
        [all] => all.swap_with(pairs),
        some => {
            join(some, |met| &met.bodies, &mut pairs.bodies);
            join(some, |met| &met.manifold, &mut pairs.manifold);
            join(some, |met| &met.material, &mut pairs.material);
            join(some, |met| &met.impulse, &mut pairs.impulse);
            join(some, |met| &met.labels, &mut pairs.labels);
        }
    }
    pairs.met = met;
    pairs.fill(regions, found.method, least);
}
// ANCHOR_END: meet

/// Puts a column of some pairs behind that of those before them.
fn join<T: Copy + Default + Send + Sync>(
    met: &[Met],
    column: impl Fn(&Met) -> &Vec<T> + Sync,
    all: &mut Vec<T>,
) {
    all.resize(
        met.iter().map(|some| column(some).len()).sum(),
        T::default(),
    );
    let mut rest = &mut all[..];
    let places = met.iter().map(|some| {
        let (own, others) = std::mem::take(&mut rest).split_at_mut(column(some).len());
        rest = others;
        own
    });
    let places: Vec<_> = places.collect();
    met.par_iter()
        .zip(places)
        .for_each(|(some, place)| place.copy_from_slice(column(some)));
}

/// What came of some of the pairs that were found.
#[derive(Clone, Debug, Default)]
pub struct Met {
    bodies: Vec<(usize, usize)>,
    manifold: Vec<Manifold>,
    material: Vec<Material>,
    impulse: Vec<Impulse>,
    labels: Vec<Label>,
}

impl Met {
    /// Takes the place of all pairs.
    fn swap_with<R: Real>(&mut self, pairs: &mut Pairs<R>) {
        std::mem::swap(&mut self.bodies, &mut pairs.bodies);
        std::mem::swap(&mut self.manifold, &mut pairs.manifold);
        std::mem::swap(&mut self.material, &mut pairs.material);
        std::mem::swap(&mut self.impulse, &mut pairs.impulse);
        std::mem::swap(&mut self.labels, &mut pairs.labels);
    }

    fn meet<R: Real>(
        &mut self,
        some: &[(usize, usize)],
        &Found {
            bodies, dt, plan, ..
        }: &Found<'_>,
        last: &Pairs<R>,
        regions: &Regions,
    ) {
        self.bodies.clear();
        self.material.clear();
        self.labels.clear();
        let first = some.first().copied().unwrap_or_default();
        let mut old = last.bodies.partition_point(|pair| *pair < first);
        for &(a, b) in some {
            let met = self.bodies.len();
            if self.manifold.len() == met {
                self.manifold.push(Manifold::default());
                self.impulse.push(Impulse::default());
            }
            let (m, impulse) = (&mut self.manifold[met], &mut self.impulse[met]);
            let near = margin(bodies, a, b, dt);
            put_manifold(m, &posed(bodies, a), &posed(bodies, b), near);
            if m.points == 0 {
                continue;
            }
            if plan.keeps(Part::Points) {
                repeat_points(m);
            }
            while old < last.bodies.len() && last.bodies[old] < (a, b) {
                old += 1;
            }
            *impulse = Impulse::default();
            if last.bodies.get(old) == Some(&(a, b)) {
                carry(&last.manifold[old], &last.impulse[old], m, impulse);
            }
            let material = between(&bodies.material[a], &bodies.material[b]);
            let stands = || bodies.is_block(a) || bodies.is_block(b);
            self.labels.push(Label {
                regions: [regions.of(a), regions.of(b)],
                sort: Sort::of(m, &material, plan, stands),
            });
            self.bodies.push((a, b));
            self.material.push(material);
        }
        self.manifold.truncate(self.bodies.len());
        self.impulse.truncate(self.bodies.len());
    }
}

/// Gives a pair four points, the first ones again.
fn repeat_points(m: &mut Manifold) {
    for k in m.points as usize..4 {
        let of = k % m.points as usize;
        (m.core_a[k], m.core_b[k]) = (m.core_a[of], m.core_b[of]);
    }
    m.points = 4;
}

/// A body as the narrow phase sees it.
#[inline]
fn posed(bodies: &Bodies, row: usize) -> Posed {
    Posed {
        position: bodies.place[row].position,
        attitude: bodies.attitude[row],
        kind: bodies.solid[row].kind,
        size: bodies.solid[row].size,
    }
}

/// How far apart two bodies may be and still be a pair: what they may come nearer in the step, m.
#[inline]
fn margin(bodies: &Bodies, a: usize, b: usize, dt: f32) -> f32 {
    let speed = (bodies.motion[b].velocity - bodies.motion[a].velocity).norm();
    let tips = [a, b].map(|row| {
        let turns = bodies.solid[row].kind != 0;
        let rate = if turns {
            bodies.spin[row].angular_velocity.norm()
        } else {
            0.0
        };
        rate * bodies.place[row].reach
    });
    MARGIN + (speed + tips[0] + tips[1]) * dt
}

// ANCHOR: carry
/// The impulses of the last step on the points of this one: those of the same feature. The others stay.
fn carry(old: &Manifold, impulse: &Impulse, new: &Manifold, carried: &mut Impulse) {
    for k in 0..new.points as usize {
        for j in 0..old.points as usize {
            if old.core_a[j].w.to_bits() == new.core_a[k].w.to_bits() {
                carried.normal[k] = impulse.normal[j];
                carried.friction = impulse.friction;
                // A single point has no arm against turning.
                carried.twist = if new.points > 1 { impulse.twist } else { 0.0 };
            }
        }
    }
}
// ANCHOR_END: carry

/// The material of a pair.
#[inline]
#[must_use]
pub fn between(a: &Material, b: &Material) -> Material {
    Material {
        restitution: 0.5 * (a.restitution + b.restitution),
        friction: (a.friction * b.friction).sqrt(),
        static_friction: (a.static_friction * b.static_friction).sqrt(),
        spare: 0.0,
    }
}
