//! What a pair gives its bodies.

use crate::rows::Press;
use crate::simd::{Real, Vec3};

/// What a pair does to its two bodies in a substep, a pair a lane; the row that bodies gather from is [`Press`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Given<R> {
    /// Impulse that b receives; a the opposite, N s.
    pub linear: Vec3<R>,
    /// Turning impulse that a receives, N m s.
    pub angular_a: Vec3<R>,
    /// Turning impulse that b receives, N m s.
    pub angular_b: Vec3<R>,
    /// Push that b receives; a the opposite, N s.
    pub push: Vec3<R>,
    /// Turning push that a receives, N m s.
    pub push_a: Vec3<R>,
    /// Turning push that b receives, N m s.
    pub push_b: Vec3<R>,
    /// 1 where the pair counts among those that share the bodies' masses in the next substep.
    pub counts: R,
    /// 1 where the next substep begins with these impulses, 0 where they were an impact.
    pub stays: R,
}

impl<R: Real> Given<R> {
    /// All of it where yes, nothing where no.
    #[inline(always)]
    pub(super) fn kept(self, mask: R::Mask) -> Self {
        let kept = |v: Vec3<R>| Vec3::select(mask, v, Vec3::zero());
        Self {
            linear: kept(self.linear),
            angular_a: kept(self.angular_a),
            angular_b: kept(self.angular_b),
            push: kept(self.push),
            push_a: kept(self.push_a),
            push_b: kept(self.push_b),
            ..self
        }
    }

    /// Writes a row a lane.
    #[inline(always)]
    pub fn write(&self, rows: &mut [Press]) {
        let of = |v: Vec3<R>, last: R| R::to_rows([v.x, v.y, v.z, last]);
        let zero = R::splat(0.0);
        let linear = of(self.linear, self.counts);
        let angular_a = of(self.angular_a, self.stays);
        let angular_b = of(self.angular_b, zero);
        let push = of(self.push, zero);
        let push_a = of(self.push_a, zero);
        let push_b = of(self.push_b, zero);
        let rows: &mut [[[f32; 4]; 6]] = bytemuck::cast_slice_mut(rows);
        for (lane, row) in rows.iter_mut().enumerate().take(R::LANES) {
            row[0] = linear[lane];
            row[1] = angular_a[lane];
            row[2] = angular_b[lane];
            row[3] = push[lane];
            row[4] = push_a[lane];
            row[5] = push_b[lane];
        }
    }
}
