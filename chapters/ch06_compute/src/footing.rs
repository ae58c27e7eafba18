//! Walls reach into the floor on which they stand, and into the walls that they abut.
//!
//! Who is inside a box leaves it by the shortest way. Where a wall stands on a floor that may be by the foot
//! of the wall, into the floor: a limb that a hard landing has driven under the wall would be held there, the
//! floor pushing it up and the wall down. So a static box, a whole face of which lies against another static
//! box, is made longer through that face, to the far side of the other. Together the two fill the same space
//! as before, and no way out leads from the one into the other.

use glam::{Quat, Vec3};

/// How far apart two faces may be that lie against each other, m.
const NEAR: f32 = 1e-3;

/// With more static boxes than these none is made longer: each is compared with each.
const MOST: usize = 256;

/// A static box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// World position of its middle.
    pub position: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// Half extents, m.
    pub half: Vec3,
}

// ANCHOR: founded
/// Each of the blocks with what it gains where whole faces of it lie against others.
#[must_use]
pub fn founded(blocks: &[Block]) -> Vec<Block> {
    if blocks.len() > MOST {
        return blocks.to_vec();
    }
    blocks.iter().map(|block| block.among(blocks)).collect()
}

impl Block {
    fn among(&self, blocks: &[Self]) -> Self {
        let mut grown = *self;
        for axis in Vec3::AXES {
            for out in [axis, -axis] {
                let gains = blocks.iter().filter(|other| *other != self);
                let gain = gains.map(|other| self.gain(out, other)).fold(0.0, f32::max);
                grown.half += 0.5 * gain * axis;
                grown.position += self.attitude * (0.5 * gain * out);
            }
        }
        grown
    }

    /// How far the face on this side may go on in another block, m: as far as all of its corners may; 0 if
    /// the other doesn't hold them all.
    fn gain(&self, out: Vec3, other: &Self) -> f32 {
        let to_other = other.attitude.conjugate() * self.attitude;
        let between = other.attitude.conjugate() * (self.position - other.position);
        let way = to_other * out;
        let mut gain = f32::INFINITY;
        let (one, two) = (
            Vec3::new(out.z, out.x, out.y),
            Vec3::new(out.y, out.z, out.x),
        );
        for across in [one + two, one - two, two - one, -one - two] {
            let corner = (out + across) * self.half;
            gain = gain.min(other.way_out(between + to_other * corner, way));
        }
        gain.max(0.0)
    }

    /// How far it is from a point to where a ray leaves the block, both in its own axes, m; 0 if the point
    /// isn't in it.
    fn way_out(&self, point: Vec3, way: Vec3) -> f32 {
        if (point.abs() - self.half).max_element() > NEAR {
            return 0.0;
        }
        let mut out = f32::INFINITY;
        for axis in 0..3 {
            if way[axis].abs() > NEAR {
                let room = self.half[axis] - point[axis] * way[axis].signum();
                out = out.min(room / way[axis].abs());
            }
        }
        out
    }
}
// ANCHOR_END: founded

#[cfg(test)]
mod tests {
    use super::*;

    fn block(position: Vec3, half: Vec3) -> Block {
        Block {
            position,
            attitude: Quat::IDENTITY,
            half,
        }
    }

    fn floor() -> Block {
        block(Vec3::new(0.0, -0.5, 0.0), Vec3::new(3.0, 0.5, 3.0))
    }

    #[test]
    fn a_wall_reaches_through_the_floor_that_it_stands_on() {
        let wall = block(Vec3::new(2.0, 1.0, 0.0), Vec3::new(0.5, 1.0, 3.0));
        let [grown, same] = founded(&[wall, floor()])[..] else {
            panic!("two blocks");
        };
        assert_eq!(
            grown,
            block(Vec3::new(2.0, 0.5, 0.0), Vec3::new(0.5, 1.5, 3.0))
        );
        assert_eq!(same, floor());
    }

    #[test]
    fn what_stands_turned_on_the_floor_reaches_down_in_its_own_axes() {
        let mut post = block(Vec3::new(0.5, 1.0, 0.3), Vec3::new(1.0, 0.2, 0.2));
        post.attitude = Quat::from_rotation_z(std::f32::consts::FRAC_PI_2);
        let grown = founded(&[post, floor()])[0];
        assert!((grown.position - Vec3::new(0.5, 0.5, 0.3)).length() < 1e-6);
        assert!((grown.half - Vec3::new(1.5, 0.2, 0.2)).length() < 1e-6);
    }

    #[test]
    fn what_hangs_over_the_edge_or_in_the_air_stays_as_it_is() {
        let over = block(Vec3::new(2.9, 1.0, 0.0), Vec3::new(0.5, 1.0, 1.0));
        let above = block(Vec3::new(0.0, 1.1, 0.0), Vec3::ONE);
        assert_eq!(founded(&[over, floor()])[0], over);
        assert_eq!(founded(&[above, floor()])[0], above);
    }
}
