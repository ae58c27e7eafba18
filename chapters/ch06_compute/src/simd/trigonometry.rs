//! Sine, cosine and arc tangent, to the last digits of f32. Names and polynomials as in
//! `shaders/common/trigonometry.wgsl`: those of Cephes' single precision.

use super::Real;

const HALF_PI: f32 = std::f32::consts::FRAC_PI_2;

// ANCHOR: sine
/// Sine and cosine of x, rad, up to some thousand. [Cephes: sinf, cosf]
///
/// Errors: below 1e-7 where |x| < 100.
#[inline(always)]
#[must_use]
pub fn sine_cosine<R: Real>(x: R) -> (R, R) {
    // x less whole quarter turns: ½π in three parts, so that nothing is lost.
    let quarters = (x * R::splat(1.0 / HALF_PI)).round();
    let r = ((x - quarters * R::splat(1.570_312_5)) - quarters * R::splat(4.837_513e-4))
        - quarters * R::splat(7.549_79e-8);
    let (s, c) = sine_cosine_near(r);
    // 0, 1, 2 or 3 quarters, as −1, 0, 1, 2.
    let rest = quarters - (quarters * R::splat(0.25)).round() * R::splat(4.0);
    let is_odd = rest.abs().same(R::splat(1.0));
    let minus_sine = rest.abs().same(R::splat(2.0)) | rest.same(R::splat(-1.0));
    let minus_cosine = rest.abs().same(R::splat(2.0)) | rest.same(R::splat(1.0));
    let sine = R::select(is_odd, c, s);
    let cosine = R::select(is_odd, s, c);
    (
        R::select(minus_sine, -sine, sine),
        R::select(minus_cosine, -cosine, cosine),
    )
}
// ANCHOR_END: sine

/// Sine and cosine within ±¼π.
#[inline(always)]
fn sine_cosine_near<R: Real>(r: R) -> (R, R) {
    let r2 = r * r;
    let s = ((r2 * R::splat(-1.951_529_6e-4) + R::splat(8.332_161e-3)) * r2
        - R::splat(1.666_665_5e-1))
        * r2
        * r
        + r;
    let c = ((r2 * R::splat(2.443_315_7e-5) - R::splat(1.388_731_6e-3)) * r2
        + R::splat(4.166_664_6e-2))
        * r2
        * r2
        - r2 * R::splat(0.5)
        + R::splat(1.0);
    (s, c)
}

/// The arc tangent of t, which is 0 to 1, rad. [Cephes: atanf]
#[inline(always)]
fn arc_tangent<R: Real>(t: R) -> R {
    let one = R::splat(1.0);
    let is_far = t.gt(R::splat(0.414_213_57));
    let start = R::select(is_far, R::splat(0.5 * HALF_PI), R::splat(0.0));
    let x = R::select(is_far, (t - one) / (t + one), t);
    let z = x * x;
    let p = ((z * R::splat(8.053_744e-2) - R::splat(1.387_768_6e-1)) * z
        + R::splat(1.997_771_1e-1))
        * z
        - R::splat(3.333_295e-1);
    start + (p * z * x + x)
}

// ANCHOR: arc_tangent_of
/// The angle of the point (x, y), rad; 0 for the origin.
///
/// Errors: below 3e-7.
#[inline(always)]
#[must_use]
pub fn arc_tangent_of<R: Real>(y: R, x: R) -> R {
    let zero = R::splat(0.0);
    let (width, height) = (x.abs(), y.abs());
    let high = width.max(height);
    let is_origin = high.same(zero);
    let t = width.min(height) / R::select(is_origin, R::splat(1.0), high);
    let angle = arc_tangent(t);
    let angle = R::select(height.gt(width), R::splat(HALF_PI) - angle, angle);
    let angle = R::select(x.lt(zero), R::splat(2.0 * HALF_PI) - angle, angle);
    let angle = R::select(y.lt(zero), -angle, angle);
    R::select(is_origin, zero, angle)
}
// ANCHOR_END: arc_tangent_of

#[cfg(test)]
mod tests {
    use super::super::Eight;
    use super::*;

    #[test]
    fn sine_and_cosine_are_those_of_the_library_to_a_last_digit() {
        for k in -40_000..40_000 {
            let x = k as f32 * 2.5e-3;
            let (s, c) = sine_cosine(x);
            assert!((f64::from(s) - f64::from(x).sin()).abs() < 1e-7, "{x}: {s}");
            assert!((f64::from(c) - f64::from(x).cos()).abs() < 1e-7, "{x}: {c}");
        }
    }

    #[test]
    fn the_angle_of_a_point_is_that_of_the_library_all_the_way_round() {
        for k in -3142..3142 {
            let angle = f64::from(k) * 1e-3;
            let (y, x) = (3.0 * angle.sin() as f32, 3.0 * angle.cos() as f32);
            let exact = f64::from(y).atan2(f64::from(x));
            assert!(
                (f64::from(arc_tangent_of(y, x)) - exact).abs() < 3e-7,
                "{angle}"
            );
        }
        assert_eq!(arc_tangent_of(0.0_f32, 0.0), 0.0);
        assert_eq!(arc_tangent_of(0.0_f32, -1.0), 2.0 * HALF_PI);
    }

    #[test]
    fn eight_lanes_have_the_bits_of_one() {
        for k in 0..2000 {
            let number = |lane: usize| ((8 * k + lane) as f32 * 0.37).sin() * 9.0;
            let other = |lane: usize| ((8 * k + lane) as f32 * 0.11).cos() * 7.0;
            let (x, y) = (Eight::of(number), Eight::of(other));
            let ((s, c), angle) = (sine_cosine(x), arc_tangent_of(y, x));
            for lane in 0..8 {
                let (one_s, one_c) = sine_cosine(number(lane));
                assert_eq!(s.lane(lane).to_bits(), one_s.to_bits());
                assert_eq!(c.lane(lane).to_bits(), one_c.to_bits());
                let one = arc_tangent_of(other(lane), number(lane));
                assert_eq!(angle.lane(lane).to_bits(), one.to_bits());
            }
        }
    }
}
