//! Rotations as unit quaternions. Names as in `shaders/common/rotation.wgsl` and
//! `shaders/common/rotation_vector.wgsl`, without the `quat_` and `rotation_` before them.

use super::{Mat3, Real, Vec3, arc_tangent_of, sine_cosine};

/// A quaternion in each lane: x, y, z in `v`, then w.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quat<R> {
    /// x, y, z.
    pub v: Vec3<R>,
    /// w.
    pub w: R,
}

impl<R: Real> Quat<R> {
    /// What `quat` gives for each lane.
    #[inline(always)]
    pub fn of(mut quat: impl FnMut(usize) -> glam::Quat) -> Self {
        Self {
            v: Vec3::of(|lane| {
                let q = quat(lane);
                glam::Vec3::new(q.x, q.y, q.z)
            }),
            w: R::of(|lane| quat(lane).w),
        }
    }

    /// The quaternion in a lane.
    #[inline(always)]
    pub fn lane(self, lane: usize) -> glam::Quat {
        let v = self.v.lane(lane);
        glam::Quat::from_xyzw(v.x, v.y, v.z, self.w.lane(lane))
    }

    /// No turn.
    #[inline(always)]
    #[must_use]
    pub fn identity() -> Self {
        Self {
            v: Vec3::zero(),
            w: R::splat(1.0),
        }
    }

    /// u turned by q: u + 2 w (v × u) + 2 v × (v × u), where q = (v, w).
    #[inline(always)]
    #[must_use]
    pub fn rotate(self, u: Vec3<R>) -> Vec3<R> {
        let t = self.v.cross(u) * R::splat(2.0);
        u + t * self.w + self.v.cross(t)
    }

    /// u turned back by q.
    #[inline(always)]
    #[must_use]
    pub fn rotate_back(self, u: Vec3<R>) -> Vec3<R> {
        self.conjugate().rotate(u)
    }

    /// q̄: the turn back.
    #[inline(always)]
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self {
            v: -self.v,
            w: self.w,
        }
    }

    /// The product a b: first b's turn, then a's.
    #[inline(always)]
    #[must_use]
    pub fn product(self, b: Self) -> Self {
        Self {
            v: b.v * self.w + self.v * b.w + self.v.cross(b.v),
            w: self.w * b.w - self.v.dot(b.v),
        }
    }

    /// As long as one.
    #[inline(always)]
    #[must_use]
    pub fn normalize(self) -> Self {
        let length = (self.v.length_squared() + self.w * self.w).sqrt();
        let scale = length.recip();
        Self {
            v: self.v * scale,
            w: self.w * scale,
        }
    }

    /// One where yes, the other where no.
    #[inline(always)]
    #[must_use]
    pub fn select(mask: R::Mask, yes: Self, no: Self) -> Self {
        Self {
            v: Vec3::select(mask, yes.v, no.v),
            w: R::select(mask, yes.w, no.w),
        }
    }

    /// q or −q, which is the same turn: the one with w ≥ 0.
    #[inline(always)]
    #[must_use]
    pub fn upper(self) -> Self {
        let below = self.w.lt(R::splat(0.0));
        Self {
            v: Vec3::select(below, -self.v, self.v),
            w: self.w.abs(),
        }
    }

    /// exp: the unit quaternion that turns by θ, rad.
    #[inline(always)]
    #[must_use]
    pub fn exp(theta: Vec3<R>) -> Self {
        let half2 = theta.length_squared() * R::splat(0.25);
        let half = half2.sqrt();
        let (sine, cosine) = sine_cosine(half);
        let near =
            R::splat(0.5) - half2 * R::splat(1.0 / 12.0) + half2 * half2 * R::splat(1.0 / 240.0);
        let far = sine * R::splat(0.5) / half.max(R::splat(0.01));
        let half_sinc = R::select(half.lt(R::splat(0.01)), near, far);
        Self {
            v: theta * half_sinc,
            w: cosine,
        }
    }

    /// log: the rotation vector of a unit quaternion, rad, the shorter way round.
    #[inline(always)]
    #[must_use]
    pub fn log(self) -> Vec3<R> {
        let upper = self.upper();
        let sine2 = upper.v.length_squared();
        let sine = sine2.sqrt();
        let is_near = sine.lt(upper.w * R::splat(0.01));
        let w = R::select(is_near, upper.w, R::splat(1.0));
        let t2 = sine2 / (w * w);
        let near = (R::splat(2.0)
            - t2 * (R::splat(2.0 / 3.0) - t2 * (R::splat(0.4) - t2 * R::splat(2.0 / 7.0))))
            / w;
        let angle = arc_tangent_of(sine, upper.w) * R::splat(2.0);
        let far = angle / R::select(is_near, R::splat(1.0), sine);
        upper.v * R::select(is_near, near, far)
    }

    /// q turned by the world-frame rotation vector θ, rad.
    #[inline(always)]
    #[must_use]
    pub fn turned(self, theta: Vec3<R>) -> Self {
        Self::exp(theta).product(self).normalize()
    }

    /// The matrix that turns as q does: its columns are the turned axes.
    #[inline(always)]
    #[must_use]
    pub fn matrix(self) -> Mat3<R> {
        let (v, one) = (self.v, R::splat(1.0));
        let twice = v + v;
        let (xx, yy, zz) = (v.x * twice.x, v.y * twice.y, v.z * twice.z);
        let (xy, xz, yz) = (v.x * twice.y, v.x * twice.z, v.y * twice.z);
        let wv = twice * self.w;
        Mat3 {
            x: Vec3::new(one - (yy + zz), xy + wv.z, xz - wv.y),
            y: Vec3::new(xy - wv.z, one - (xx + zz), yz + wv.x),
            z: Vec3::new(xz + wv.y, yz - wv.x, one - (xx + yy)),
        }
    }

    /// M(q, I, a): what the world vector a, an angular momentum or a torque, is as angular velocity or
    /// acceleration, where the body has these inverse moments.
    #[inline(always)]
    #[must_use]
    pub fn moment(self, inverse_inertia: Vec3<R>, a: Vec3<R>) -> Vec3<R> {
        self.rotate(self.rotate_back(a) * inverse_inertia)
    }
}

impl From<glam::Quat> for Quat<f32> {
    #[inline(always)]
    fn from(q: glam::Quat) -> Self {
        Self {
            v: Vec3::new(q.x, q.y, q.z),
            w: q.w,
        }
    }
}
