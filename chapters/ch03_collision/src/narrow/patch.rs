//! Four points of many. A face on a face can give sixteen points, and four hold it as well: the
//! ones that span the widest area, and the deepest.
//!
//! Which four they are must not change with every tremor, since a point that stays hands on what it
//! carried in the last step. So the choice begins with the first point and not with the deepest,
//! and of points that are about as good the first one wins.

use glam::Vec3;

use super::clip::MOST_POINTS;
use super::features::MOST_CORNERS;
use super::list::List;
use super::{MOST_SPOTS, Spot, Touch};

/// A point is taken instead of an earlier one if it adds more by this factor.
const CLEARLY: f32 = 1.001;

/// The points where two solids touch, before four of them are chosen.
pub struct Patch {
    /// Where the two are nearest to each other, or deepest in each other.
    nearest: Spot,
    spots: List<Spot, { MOST_POINTS + 1 }>,
}

impl Patch {
    /// With no more than the point where the two are nearest to each other.
    pub fn new(nearest: Spot) -> Self {
        Self {
            nearest,
            spots: List::default(),
        }
    }

    /// Names the point where the two are nearest to each other.
    pub fn name_nearest(&mut self, feature: u32) {
        self.nearest.feature = feature;
    }

    /// Adds a point.
    pub fn push(&mut self, spot: Spot) {
        self.spots.push(spot);
    }

    // ANCHOR: patch
    /// The touch: the points whose gap is at most `margin`, with the nearest point if none of them
    /// is as deep but for `slack`, m; of more than four the widest four, with the deepest.
    pub fn touch(mut self, normal: Vec3, margin: f32, slack: f32) -> Touch {
        self.spots.retain(|spot| spot.depth >= -margin);
        if deepest(&self.spots) < self.nearest.depth - slack {
            self.spots.push(self.nearest);
        }
        let mut spots = self.spots_to_keep(normal, slack);
        tell_apart(&mut spots);
        Touch::new(normal, &spots)
    }
    // ANCHOR_END: patch

    // ANCHOR: keep
    /// All of them if there are four at most, else the widest four, with the deepest in the place
    /// of its neighbour.
    fn spots_to_keep(&self, normal: Vec3, slack: f32) -> List<Spot, MOST_SPOTS> {
        if self.spots.len() <= MOST_SPOTS {
            return List::of(&self.spots);
        }
        let mut four = self.widest(normal);
        let depth = deepest(&self.spots);
        if deepest(&four) < depth - slack
            && let Some(&missing) = self.spots.iter().find(|spot| spot.depth == depth)
        {
            let away = |spot: &Spot| spot.point.distance_squared(missing.point);
            four.sort_unstable_by(|one, other| away(one).total_cmp(&away(other)));
            four[0] = missing;
        }
        four
    }
    // ANCHOR_END: keep

    // ANCHOR: widest
    /// The first point, the one furthest from it, the one that makes the largest triangle with
    /// these, and the one that adds most to the triangle.
    fn widest(&self, normal: Vec3) -> List<Spot, MOST_SPOTS> {
        let mut chosen = List::of(&self.spots[..1]);
        while !chosen.is_full() {
            let (mut best, mut most) = (None, 0.0);
            for spot in self.spots.iter() {
                let gain = gain(&chosen, spot.point, normal);
                if gain > CLEARLY * most {
                    (best, most) = (Some(spot), gain);
                }
            }
            match best {
                Some(spot) => chosen.push(*spot),
                None => break,
            }
        }
        chosen
    }
    // ANCHOR_END: widest
}

// ANCHOR: gain
/// What p adds to the extent of the chosen points: a length squared, then twice an area.
fn gain(chosen: &[Spot], p: Vec3, normal: Vec3) -> f32 {
    let at = |i: usize| chosen[i].point;
    let area = |q: Vec3, r: Vec3, s: Vec3| (r - q).cross(s - q).dot(normal);
    match chosen.len() {
        1 => p.distance_squared(at(0)),
        2 => area(at(0), at(1), p).abs(),
        _ => {
            let turn = area(at(0), at(1), at(2)).signum();
            let sides = [(0, 1), (1, 2), (2, 0)];
            let beyond = sides.map(|(i, j)| -turn * area(at(i), at(j), p));
            beyond.into_iter().fold(0.0, f32::max)
        }
    }
}
// ANCHOR_END: gain

fn deepest(spots: &[Spot]) -> f32 {
    let depths = spots.iter().map(|spot| spot.depth);
    depths.fold(f32::NEG_INFINITY, f32::max)
}

/// Gives points of the same corner names of their own: 8 more for each that came before.
fn tell_apart(spots: &mut [Spot]) {
    for i in 1..spots.len() {
        let (before, rest) = spots.split_at_mut(i);
        while before.iter().any(|spot| spot.feature == rest[0].feature) {
            rest[0].feature += MOST_CORNERS as u32;
        }
    }
}
