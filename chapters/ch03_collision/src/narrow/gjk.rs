//! GJK: how far apart two convex solids are, or that they overlap.
//!
//! The distance between a and b is the distance of the origin from the Minkowski difference a − b.
//! GJK walks there: it holds a simplex within a − b, takes the simplex's point v that is nearest to
//! the origin, and asks for the support point w of a − b along −v, the furthest beyond v towards
//! the origin. No point of a − b is nearer to the origin than v·w/|v|; where that is |v|, v is the
//! answer, and where the simplex holds the origin, the solids overlap.
//! [Gilbert, Johnson and Keerthi 1988; van den Bergen 2003, 4.3; Ericson 2005, 9.5]
//!
//! An f32 loses |v| long before the direction of v is right: near the end a step turns v by a
//! thousandth and makes it shorter by a millionth. So GJK goes on while either bound gets better.

use glam::Vec3;

use super::simplex::Simplex;
use super::support_point::{Core, ROUNDING, Vertex, extent};

/// Iterations before GJK gives its best so far. Boxes take a handful, cylinders up to 20.
pub const MOST_ITERATIONS: usize = 48;

/// The distance is known where its bounds differ by this share of it.
const TOLERANCE: f32 = 1e-6;

/// What one iteration looked at, for those who watch. All of it is in the coordinates of
/// [`Core::pair`]: the world's axes, the origin at b's centre.
#[derive(Clone, Copy, Debug)]
pub struct Step<'a> {
    /// Counts from 0.
    pub iteration: usize,
    /// The simplex, one to three vertices, and v, its point nearest to the origin.
    pub simplex: &'a Simplex,
    /// w, the next vertex: the support point along −v.
    pub support: Vertex,
    /// v·w/|v|: the solids' cores are at least so far apart, m.
    pub at_least: f32,
}

/// What GJK found out about two cores. Their radii are not counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gjk {
    /// Further apart than one wanted to know.
    Far,
    /// Apart, by so much.
    Apart(Apart),
    /// They share a point: this simplex of their Minkowski difference holds the origin, or is as
    /// near to it as numbers can tell.
    Overlapping(Simplex),
}

/// Two cores that share no point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// m.
    pub distance: f32,
    /// Unit vector from b to a, along which they are as far apart as along any other that was seen.
    pub normal: Vec3,
    /// The point of a that is nearest to b.
    pub on_a: Vec3,
    /// The point of b that is nearest to a.
    pub on_b: Vec3,
    /// The last simplex.
    pub simplex: Simplex,
    /// False if the iterations ran out: the distance may be smaller then.
    pub converged: bool,
}

/// The distance of two cores, m, in the coordinates of [`Core::pair`]; of no interest above
/// `limit`.
#[must_use]
pub fn gjk(a: &Core, b: &Core, limit: f32) -> Gjk {
    watched(a, b, limit, |_| ())
}

// ANCHOR: gjk
/// [`gjk`], with a look at every iteration.
pub fn watched(a: &Core, b: &Core, limit: f32, mut watch: impl FnMut(&Step)) -> Gjk {
    let first = Vertex::support(a, b, b.centre - a.centre);
    let mut simplex = Simplex::new(&[first]);
    let rounding = ROUNDING * extent(a, b);
    let (mut highest, mut normal) = (f32::NEG_INFINITY, Vec3::Y);
    for iteration in 0..MOST_ITERATIONS {
        let v = simplex.nearest();
        let distance = v.length();
        if simplex.vertices().len() == 4 || distance <= rounding {
            return Gjk::Overlapping(simplex);
        }
        let support = Vertex::support(a, b, -v);
        let at_least = v.dot(support.point) / distance;
        watch(&Step {
            iteration,
            simplex: &simplex,
            support,
            at_least,
        });
        if at_least > limit {
            return Gjk::Far;
        }
        let higher = at_least > highest;
        if higher {
            (highest, normal) = (at_least, v / distance);
        }
        if distance - at_least <= TOLERANCE * distance + rounding {
            return Gjk::Apart(Apart::new(&simplex, normal, true));
        }
        let last = simplex;
        simplex.add(support);
        let nearer = simplex.nearest().length() < distance;
        if !nearer && !higher {
            return Gjk::Apart(Apart::new(&last, normal, true));
        }
    }
    Gjk::Apart(Apart::new(&simplex, normal, false))
}
// ANCHOR_END: gjk

impl Apart {
    fn new(simplex: &Simplex, normal: Vec3, converged: bool) -> Self {
        let (on_a, on_b) = simplex.witnesses();
        Self {
            distance: simplex.nearest().length(),
            normal,
            on_a,
            on_b,
            simplex: *simplex,
            converged,
        }
    }
}
