//! The pairs of a step: where they touch, and what they pressed in the last step.

use rayon::iter::{
    IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelIterator,
};

use super::batches::{BALL_AND_BOX, Batches, Pair, Sorts};
use super::coloured::Colours;
use super::plan::{Part, Plan};
use super::sleep::KeptPair;
use super::threads;
use crate::bodies::Bodies;
use crate::own_row::narrow::{Posed, put_manifold};
use crate::rows::{Impulse, Manifold, Material};
use crate::rules::{MARGIN, Method};
use crate::simd::Real;

/// All pairs that touch or may touch in the step, in the order of their bodies.
#[derive(Clone, Debug)]
pub struct Pairs<R: Real> {
    /// Rows of the two bodies, the smaller first.
    pub bodies: Vec<(usize, usize)>,
    /// Where they touch.
    pub manifold: Vec<Manifold>,
    /// What becomes of them there.
    pub material: Vec<Material>,
    /// What they pressed and rubbed in the last step.
    pub impulse: Vec<Impulse>,
    /// What they press and rub now, in lanes.
    pub batches: Batches<R>,
    /// Their colours; none where the method needs none.
    pub colours: Colours,
    /// By body: where its pairs begin in `of_body`; one more at the end.
    pub starts: Vec<u32>,
    /// The pairs of each body, in the order of the other body's ID: twice the row of what it gathers, and 1
    /// where the body is b.
    pub of_body: Vec<u32>,
    /// What came of the pairs that were found, some by some.
    met: Vec<Met>,
}

impl<R: Real> Default for Pairs<R> {
    fn default() -> Self {
        Self {
            bodies: Vec::new(),
            manifold: Vec::new(),
            material: Vec::new(),
            impulse: Vec::new(),
            batches: Batches::default(),
            colours: Colours::default(),
            starts: Vec::new(),
            of_body: Vec::new(),
            met: Vec::new(),
        }
    }
}

impl<R: Real> Pairs<R> {
    /// The pairs of a body.
    #[must_use]
    pub fn of(&self, row: usize) -> &[u32] {
        let (first, end) = (self.starts[row], self.starts[row + 1]);
        &self.of_body[first as usize..end as usize]
    }

    /// A body is gone, its pairs with it, and those after it have moved up.
    pub fn remove_body(&mut self, row: usize) {
        let moved = |other: usize| if other > row { other - 1 } else { other };
        let kept = |&pair: &usize| self.bodies[pair].0 != row && self.bodies[pair].1 != row;
        let kept: Vec<usize> = (0..self.bodies.len()).filter(kept).collect();
        self.manifold = kept.iter().map(|&pair| self.manifold[pair]).collect();
        self.material = kept.iter().map(|&pair| self.material[pair]).collect();
        self.impulse = kept.iter().map(|&pair| self.impulse[pair]).collect();
        let bodies = kept.iter().map(|&pair| self.bodies[pair]);
        self.bodies = bodies.map(|(a, b)| (moved(a), moved(b))).collect();
        let rows = self.starts.len().saturating_sub(2);
        self.colours.clear();
        self.fill(rows, usize::MAX, Plan::default(), |_| false);
    }

    /// Pairs that have woken are known as they were when they fell asleep. Of the pairs of a step that is past:
    /// nothing more is read of them than what they pressed, and where.
    pub fn recall(&mut self, woken: &mut Vec<KeptPair>) {
        if woken.is_empty() {
            return;
        }
        let mut known: Vec<_> = (0..self.bodies.len())
            .map(|pair| KeptPair::of(self, pair))
            .chain(woken.drain(..))
            .collect();
        known.sort_by_key(|pair| pair.bodies);
        self.bodies = known.iter().map(|pair| pair.bodies).collect();
        self.manifold = known.iter().map(|pair| pair.manifold).collect();
        self.impulse = known.iter().map(|pair| pair.impulse).collect();
    }

    /// Brings what was pressed from the lanes into a row a pair. At least `least` pairs go together.
    pub fn write_back(&mut self, least: usize) {
        let batches = &self.batches;
        threads::each(&mut self.impulse, least, |pair, impulse| {
            *impulse = batches.impulse(pair);
        });
    }

    /// Puts the pairs into lanes, and lists those of each of so many bodies, of which some are boxes that stand.
    /// At least `least` pairs go together.
    fn fill(
        &mut self,
        rows: usize,
        least: usize,
        plan: Plan,
        stands: impl Fn(usize) -> bool + Sync,
    ) {
        let sorts = Sorts {
            colours: self.colours.count(),
            alone: self.colours.alone(),
            plan,
        };
        self.batches.fill(self.bodies.len(), sorts, least, |pair| {
            let (a, b) = self.bodies[pair];
            let (colour, moves) = self.colours.at(pair);
            let manifold = &self.manifold[pair];
            Pair {
                bodies: (a as u32, b as u32),
                moves,
                stands: manifold.kind == BALL_AND_BOX && (stands(a) || stands(b)),
                colour,
                manifold,
                material: &self.material[pair],
                impulse: &self.impulse[pair],
            }
        });
        list(rows, self);
    }
}

// ANCHOR: meet
/// Narrow phase: where each pair touches or may touch; impulses of the last step go on where the same
/// features still touch. At least `least` pairs that were found go together.
pub fn meet<R: Real>(
    found: &[(usize, usize)],
    bodies: &Bodies,
    dt: f32,
    last: &Pairs<R>,
    (method, plan): (Method, Plan),
    pairs: &mut Pairs<R>,
    least: usize,
) {
    let mut met = std::mem::take(&mut pairs.met);
    met.resize_with(found.len().div_ceil(least.max(1)), Met::default);
    let some = found.chunks(least.min(found.len()).max(1));
    met.par_iter_mut()
        .zip(some.collect::<Vec<_>>())
        .for_each(|(met, found)| met.meet(found, bodies, dt, last, plan));
    match &mut met[..] {
        [all] => all.swap_with(pairs),
        some => {
            join(some, |met| &met.bodies, &mut pairs.bodies);
            join(some, |met| &met.manifold, &mut pairs.manifold);
            join(some, |met| &met.material, &mut pairs.material);
            join(some, |met| &met.impulse, &mut pairs.impulse);
        }
    }
    pairs.met = met;
    if method == Method::Coloured {
        pairs
            .colours
            .paint(&pairs.bodies, bodies.rows(), |row| bodies.moves(row));
    }
    pairs.fill(bodies.rows(), least, plan, |row| bodies.is_block(row));
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
struct Met {
    bodies: Vec<(usize, usize)>,
    manifold: Vec<Manifold>,
    material: Vec<Material>,
    impulse: Vec<Impulse>,
}

impl Met {
    /// Takes the place of all pairs.
    fn swap_with<R: Real>(&mut self, pairs: &mut Pairs<R>) {
        std::mem::swap(&mut self.bodies, &mut pairs.bodies);
        std::mem::swap(&mut self.manifold, &mut pairs.manifold);
        std::mem::swap(&mut self.material, &mut pairs.material);
        std::mem::swap(&mut self.impulse, &mut pairs.impulse);
    }

    fn meet<R: Real>(
        &mut self,
        found: &[(usize, usize)],
        bodies: &Bodies,
        dt: f32,
        last: &Pairs<R>,
        plan: Plan,
    ) {
        self.bodies.clear();
        self.material.clear();
        let first = found.first().copied().unwrap_or_default();
        let mut old = last.bodies.partition_point(|pair| *pair < first);
        for &(a, b) in found {
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
            self.bodies.push((a, b));
            self.material
                .push(between(&bodies.material[a], &bodies.material[b]));
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
    let speed = (bodies.motion[b].velocity - bodies.motion[a].velocity).length();
    let tips = [a, b].map(|row| {
        let turns = bodies.solid[row].kind != 0;
        let rate = if turns {
            bodies.spin[row].angular_velocity.length()
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

/// Lists the pairs of each body. They come in the order of a, then b, so each list is in the order of
/// the partner.
fn list<R: Real>(rows: usize, pairs: &mut Pairs<R>) {
    pairs.starts.clear();
    pairs.starts.resize(rows + 1, 0);
    for &(a, b) in &pairs.bodies {
        pairs.starts[a] += 1;
        pairs.starts[b] += 1;
    }
    let mut sum = 0;
    for start in &mut pairs.starts {
        sum += std::mem::replace(start, sum);
    }
    let mut next = pairs.starts.clone();
    pairs.of_body.clear();
    pairs.of_body.resize(2 * pairs.bodies.len(), 0);
    for (&(a, b), &place) in pairs.bodies.iter().zip(&pairs.batches.place) {
        for (row, is_b) in [(a, 0), (b, 1)] {
            pairs.of_body[next[row] as usize] = 2 * place + is_b;
            next[row] += 1;
        }
    }
}
