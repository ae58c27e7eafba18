//! Principal moments of inertia of homogeneous solids about their centre, kg m².
//!
//! The inertia matrix of these four shapes is diagonal in the body's own axes, so three
//! numbers hold it. Report 8.1; box, sphere and cylinder from [Bourg and Bywalec 2013],
//! the capsule from [Lovrovic 2015], each checked against an integral over the solid.

use super::real::{Real, Vec3};

// ANCHOR: sphere
/// Solid ball: I = ⅖ m r² about every axis.
#[must_use]
pub fn sphere(mass: Real, radius: Real) -> Vec3 {
    Vec3::splat(0.4 * mass * radius * radius)
}
// ANCHOR_END: sphere

// ANCHOR: ori_box
/// Solid box with half-extents h: Iₓ = ⅓ m (h_y² + h_z²), and so on round the axes.
#[must_use]
pub fn ori_box(mass: Real, half_extents: Vec3) -> Vec3 {
    let h2 = half_extents * half_extents;
    mass / 3.0 * Vec3::new(h2.y + h2.z, h2.z + h2.x, h2.x + h2.y)
}
// ANCHOR_END: ori_box

// ANCHOR: cylinder
/// Solid cylinder along y with half-height h: I_y = ½ m r², Iₓ = I_z = m (¼ r² + ⅓ h²).
#[must_use]
pub fn cylinder(mass: Real, radius: Real, half_height: Real) -> Vec3 {
    let r2 = radius * radius;
    let across = mass * (r2 / 4.0 + half_height * half_height / 3.0);
    Vec3::new(across, 0.5 * mass * r2, across)
}
// ANCHOR_END: cylinder

// ANCHOR: about_point
/// Principal moments about a point that is `arm` away from the centre, in the body's axes, m:
/// I + m(|s|² − s sᵀ). `None` where the arm makes the axes mix, that is unless it lies along one of them.
#[must_use]
pub fn about_point(inertia: Vec3, mass: Real, arm: Vec3) -> Option<Vec3> {
    let s = arm;
    let mixed = s.x * s.y != 0.0 || s.y * s.z != 0.0 || s.z * s.x != 0.0;
    let squares = s * s;
    let added = Vec3::splat(squares.element_sum()) - squares;
    (!mixed).then_some(inertia + mass * added)
}
// ANCHOR_END: about_point

// ANCHOR: capsule
/// Solid capsule along y: a cylinder of half-height h and two half-balls of the same stuff.
///
/// A half-ball's centre of mass lies ⅜ r beyond its flat face, which gives the mixed term:
/// about the capsule's centre the two caps have I = m_caps (⅖ r² + h² + ¾ h r) across the axis.
#[must_use]
pub fn capsule(mass: Real, radius: Real, half_height: Real) -> Vec3 {
    let (r, h) = (radius, half_height);
    let caps = mass * (4.0 / 3.0 * r) / (4.0 / 3.0 * r + 2.0 * h);
    let straight = cylinder(mass - caps, r, h);
    let along = 0.4 * caps * r * r;
    let across = along + caps * (h * h + 0.75 * h * r);
    straight + Vec3::new(across, along, across)
}
// ANCHOR_END: capsule
