//! How the narrow phase comes to its answer for one pair of bodies, looked at after one of its
//! iterations.

use crate::Drawing;

/// A part of the narrow phase that goes round and round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Phase {
    /// Its name, as in the book.
    pub name: &'static str,
    /// How many iterations it needed.
    pub steps: usize,
}

/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Where, m.
    pub at: [f32; 3],
    /// Unit vector out of the surface.
    pub normal: [f32; 3],
}

/// The narrow phase of one pair after one of its iterations. What it works on is not the pair
/// but the set of all differences, a point of body a minus a point of body b: the two overlap
/// where that set holds the origin, and are as far apart as it is from the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Dissection {
    /// Its parts, in the order in which they run; those that weren't needed are absent.
    pub phases: Vec<Phase>,
    /// The iteration that this is: from 0, over all phases.
    pub step: usize,
    /// Such as `GJK, iteration 3 of 5`.
    pub title: String,
    /// What happens in it, two or three lines with the numbers.
    pub text: String,
    /// After each iteration, between which two numbers the distance is known to lie, m; it is
    /// negative where the bodies overlap.
    pub bounds: Vec<[f32; 2]>,
    /// The surface of the set of differences, as triangles around the origin of differences.
    pub surface: Vec<[SurfacePoint; 3]>,
    /// The surface of what is left of that set when the bodies' radii are taken off, where that
    /// is what the narrow phase works on; a ball is then a point, a capsule a segment.
    pub core: Vec<[SurfacePoint; 3]>,
    /// What the iteration has found, among the differences: the origin is at 0.
    pub difference: Drawing,
    /// The same on the bodies, in the world.
    pub world: Drawing,
}

impl Dissection {
    /// How many iterations there are.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.phases.iter().map(|phase| phase.steps).sum()
    }
}
