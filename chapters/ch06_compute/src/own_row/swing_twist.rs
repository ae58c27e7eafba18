//! How a child has turned away from its rest: a twist about its own y axis, and a swing that tilts this
//! axis. Names as in `ch00_maths::f32::swing_twist`, which tells of them, and in
//! `shaders/common/swing_twist.wgsl`; here they are for a limit a lane.

use crate::simd::{Quat, Real, Vec3, arc_tangent_of, sine_cosine};

/// Below this a sine or an axis is none.
pub const SMALL_SINE: f32 = 1e-6;

// ANCHOR: twist_of
/// τ: the twist of a rotation, the child's orientation seen from its rest, rad. Where the axis has been
/// swung by π it is 0.
#[inline(always)]
#[must_use]
pub fn twist_of<R: Real>(turn: Quat<R>) -> R {
    let rel = turn.upper();
    let twist = arc_tangent_of(rel.v.y, rel.w) * R::splat(2.0);
    R::select(keeps(rel).lt(R::splat(SMALL_SINE)), R::splat(0.0), twist)
}

/// The rotation vector of its swing, rad: pitch in x, roll in z, 0 in y.
#[inline(always)]
#[must_use]
pub fn swing_of<R: Real>(turn: Quat<R>) -> Vec3<R> {
    let rel = turn.upper();
    let size = keeps(rel);
    let is_none = size.lt(R::splat(SMALL_SINE));
    let scale = R::select(is_none, R::splat(1.0), size).recip();
    let back = Quat {
        v: Vec3::new(R::splat(0.0), -rel.v.y * scale, R::splat(0.0)),
        w: rel.w * scale,
    };
    Quat::select(is_none, rel, rel.product(back)).log()
}

/// What a rotation keeps of y.
#[inline(always)]
fn keeps<R: Real>(rel: Quat<R>) -> R {
    (rel.v.y * rel.v.y + rel.w * rel.w).sqrt()
}
// ANCHOR_END: twist_of

/// What the relative angular velocity is multiplied by to give the rate of the twist.
#[inline(always)]
#[must_use]
pub fn twist_axis<R: Real>(y_rest: Vec3<R>, y: Vec3<R>) -> Vec3<R> {
    let sum = (R::splat(1.0) + y_rest.dot(y)).max(R::splat(SMALL_SINE));
    (y_rest + y) * sum.recip()
}

/// The angle between the axis at rest and now, rad, and the unit axis of the swing; no axis at 0.
#[inline(always)]
#[must_use]
pub fn cone<R: Real>(y_rest: Vec3<R>, y: Vec3<R>) -> (R, Vec3<R>) {
    let (zero, small) = (R::splat(0.0), R::splat(SMALL_SINE));
    let crossed = y_rest.cross(y);
    let (sine, cosine) = (crossed.length(), y_rest.dot(y));
    let across = Vec3::select(cosine.lt(zero), any_across(y_rest), Vec3::zero());
    let axis = Vec3::select(sine.gt(small), crossed * sine.max(small).recip(), across);
    (arc_tangent_of(sine, cosine), axis)
}

/// Some unit vector across a unit vector.
#[inline(always)]
fn any_across<R: Real>(n: Vec3<R>) -> Vec3<R> {
    let zero = R::splat(0.0);
    let is_x = n.x.abs().gt(n.y.abs());
    let across = Vec3::new(
        R::select(is_x, -n.z, zero),
        R::select(is_x, zero, n.z),
        R::select(is_x, n.x, -n.y),
    );
    across * across.length().recip()
}

// ANCHOR: swing_axes
/// What the relative angular velocity is multiplied by to give the rates of pitch and of roll.
#[inline(always)]
#[must_use]
pub fn swing_axes<R: Real>(rest: Quat<R>, swing: Vec3<R>, y: Vec3<R>) -> (Vec3<R>, Vec3<R>) {
    let small = R::splat(SMALL_SINE);
    let theta = swing.length();
    let is_none = theta.lt(small);
    let scale = theta.max(small).recip();
    let (cosine, sine) = (swing.x * scale, swing.z * scale);
    let u = rest.rotate(swing * scale);
    let across = y.cross(u) * (theta / sine_cosine(theta).0.max(small));
    let axes = rest.matrix();
    (
        Vec3::select(is_none, axes.x, u * cosine + across * sine),
        Vec3::select(is_none, axes.z, u * sine - across * cosine),
    )
}
// ANCHOR_END: swing_axes

#[cfg(test)]
mod tests {
    use ch00_maths::f32::swing_twist as by_definition;
    use ch00_scenes::random::SplitMix64;
    use glam::Vec3 as Row;

    use super::*;
    use crate::simd::Eight;

    #[test]
    fn a_turn_splits_as_by_the_definition_in_each_lane() {
        let mut random = SplitMix64::new(5);
        for _ in 0..200 {
            let turns: [_; 8] = std::array::from_fn(|_| random.rotation().as_quat());
            let turn: Quat<Eight> = Quat::of(|lane| turns[lane]);
            let (twist, swing) = (twist_of(turn), swing_of(turn));
            for (lane, turn) in turns.into_iter().enumerate() {
                let parts = by_definition::decompose(turn);
                assert!((twist.lane(lane) - parts.twist).abs() < 2e-6, "{turn}");
                assert!(
                    (swing.lane(lane) - parts.swing).length() < 1e-5,
                    "{turn}: {} {}",
                    swing.lane(lane),
                    parts.swing
                );
            }
        }
    }

    #[test]
    fn axes_are_those_of_the_definition_in_each_lane_and_at_the_ends() {
        let mut random = SplitMix64::new(6);
        for round in 0..200 {
            let rests: [_; 8] = std::array::from_fn(|_| random.rotation().as_quat());
            let swings: [_; 8] = std::array::from_fn(|lane| match (round, lane) {
                (0, 0) => Row::ZERO,
                (0, 1) => Row::X * std::f32::consts::PI,
                _ => (random.vector(2.0).as_vec3()) * Row::new(1.0, 0.0, 1.0),
            });
            let now =
                |lane: usize| rests[lane] * ch00_maths::f32::rotation::exp(swings[lane]) * Row::Y;
            let rest: Quat<Eight> = Quat::of(|lane| rests[lane]);
            let (y_rest, y) = (Vec3::of(|lane| rests[lane] * Row::Y), Vec3::of(now));
            let (angle, axis) = cone(y_rest, y);
            let twist = twist_axis(y_rest, y);
            let (pitch, roll) = swing_axes(rest, Vec3::of(|lane| swings[lane]), y);
            for lane in 0..8 {
                let (y_rest, y) = (rests[lane] * Row::Y, now(lane));
                let (exact_angle, exact_axis) = by_definition::cone(y_rest, y);
                let exact = by_definition::swing_axes(rests[lane], swings[lane], y);
                assert!((angle.lane(lane) - exact_angle).abs() < 1e-6);
                if round == 0 && lane < 2 {
                    continue;
                }
                let near = |one: Vec3<Eight>, other: Row| {
                    let off = (one.lane(lane) - other).length() / other.length();
                    assert!(off < 1e-5, "{off} {}", swings[lane]);
                };
                near(axis, exact_axis.expect("an axis"));
                near(twist, by_definition::twist_axis(y_rest, y));
                near(pitch, exact.0);
                near(roll, exact.1);
            }
        }
    }
}
