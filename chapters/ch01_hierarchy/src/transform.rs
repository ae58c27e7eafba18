//! A rigid transform: first turn, then move. Maps the coordinates of a node into those of
//! its parent: x′ = q x q̄ + t.
//!
//! There is no scale. A rigid body has none, and without it an inverse is exact up to
//! rounding and the composition of two transforms is again one.

use std::ops::Mul;

use glam::{Quat, Vec3};

/// Where a frame is, seen from another: translation (m) and rotation (unit quaternion).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Origin of the inner frame in the outer one, m.
    pub translation: Vec3,
    /// Turns inner axes into outer axes; of length 1.
    pub rotation: Quat,
}

impl Transform {
    /// The inner frame is the outer one.
    pub const IDENTITY: Self = Self {
        translation: Vec3::ZERO,
        rotation: Quat::IDENTITY,
    };

    /// From an origin (m) and a unit quaternion.
    #[must_use]
    pub const fn new(translation: Vec3, rotation: Quat) -> Self {
        Self {
            translation,
            rotation,
        }
    }

    /// Moved by `translation` (m), not turned.
    #[must_use]
    pub const fn from_translation(translation: Vec3) -> Self {
        Self::new(translation, Quat::IDENTITY)
    }

    /// Turned by `rotation` (unit quaternion), not moved.
    #[must_use]
    pub const fn from_rotation(rotation: Quat) -> Self {
        Self::new(Vec3::ZERO, rotation)
    }

    // ANCHOR: compose
    /// `inner` seen from outside `self`: t = t₁ + q₁ t₂ q̄₁, q = q₁ q₂.
    #[must_use]
    #[inline]
    pub fn compose(self, inner: Self) -> Self {
        Self {
            translation: self.translation + self.rotation * inner.translation,
            rotation: self.rotation * inner.rotation,
        }
    }

    /// The way back: composed with `self`, on either side, it gives the identity.
    #[must_use]
    pub fn inverse(self) -> Self {
        let back = self.rotation.conjugate();
        Self {
            translation: back * -self.translation,
            rotation: back,
        }
    }
    // ANCHOR_END: compose

    /// A point's outer coordinates from its inner ones, m.
    #[must_use]
    pub fn point(self, inner: Vec3) -> Vec3 {
        self.translation + self.rotation * inner
    }

    /// A direction's outer coordinates from its inner ones: turned, not moved.
    #[must_use]
    pub fn vector(self, inner: Vec3) -> Vec3 {
        self.rotation * inner
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// `outer * inner` is `outer.compose(inner)`: read from the root towards the leaf.
impl Mul for Transform {
    type Output = Self;

    #[inline]
    fn mul(self, inner: Self) -> Self {
        self.compose(inner)
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::FRAC_PI_2;

    use super::*;

    fn quarter_turn_at(x: f32) -> Transform {
        Transform::new(Vec3::X * x, Quat::from_rotation_y(FRAC_PI_2))
    }

    #[test]
    fn a_child_one_metre_ahead_of_a_parent_turned_left_is_one_metre_to_its_left() {
        // A right-handed quarter turn about y takes x to −z.
        let child = quarter_turn_at(5.0) * Transform::from_translation(Vec3::X);
        let expected = Vec3::new(5.0, 0.0, -1.0);
        assert!(child.translation.abs_diff_eq(expected, 1e-6));
    }

    #[test]
    fn composing_maps_points_as_applying_one_after_the_other() {
        let (a, b) = (quarter_turn_at(2.0), quarter_turn_at(-3.0));
        let p = Vec3::new(0.3, 0.5, -0.7);
        assert!((a * b).point(p).abs_diff_eq(a.point(b.point(p)), 1e-6));
    }

    #[test]
    fn composing_in_the_other_order_is_another_transform() {
        let turn = Transform::from_rotation(Quat::from_rotation_y(FRAC_PI_2));
        let step = Transform::from_translation(Vec3::X);
        assert!(
            (turn * step)
                .translation
                .distance((step * turn).translation)
                > 1.0
        );
    }

    #[test]
    fn the_inverse_undoes_on_both_sides() {
        let a = Transform::new(
            Vec3::new(1.0, -2.0, 3.0),
            Quat::from_axis_angle(Vec3::new(0.6, 0.0, 0.8), 1.2),
        );
        for identity in [a * a.inverse(), a.inverse() * a] {
            assert!(identity.translation.abs_diff_eq(Vec3::ZERO, 1e-6));
            assert!(identity.rotation.abs_diff_eq(Quat::IDENTITY, 1e-6));
        }
    }

    #[test]
    fn composing_is_associative_up_to_rounding() {
        let (a, b, c) = (
            quarter_turn_at(1.0),
            Transform::new(Vec3::Y, Quat::from_rotation_x(0.4)),
            Transform::new(Vec3::Z, Quat::from_rotation_z(-1.1)),
        );
        let (left, right) = ((a * b) * c, a * (b * c));
        assert!(left.translation.abs_diff_eq(right.translation, 1e-6));
        assert!(left.rotation.abs_diff_eq(right.rotation, 1e-6));
    }
}
