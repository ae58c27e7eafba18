//! Joints between the same two bodies that hold together what one joint could: two pins are a hinge.
//!
//! A pin holds three numbers, a body has six. Two pins hold five of them, since the distance of their
//! points is none of the bodies' business: six rows for five numbers make a singular system. So joints
//! between the same bodies become one row of a tree where they can; what is left over closes a loop.

use ch00_scenes::{Joint, Scene};
use glam::DVec3;

use crate::rows::{HINGE, PIN, ROD, TWO_RODS};

/// Points this near are one, m.
const NEAR: f64 = 1e-4;

/// Axes this near are one, rad.
const ALIGNED: f64 = 1e-3;

// ANCHOR: bond
/// What joins two bodies, as a row of a tree can hold it.
#[derive(Clone, Debug, PartialEq)]
pub struct Bond {
    /// One body, which is the static one if one is.
    pub a: usize,
    /// The other.
    pub b: usize,
    /// Pin, hinge, rod or two rods.
    pub kind: u32,
    /// Points in a and in b, m.
    pub anchors: [DVec3; 2],
    /// Axes in a and in b; or first the point that the second rod hangs on.
    pub axes: [DVec3; 2],
    /// Lengths of the rods, m.
    pub lengths: [f64; 2],
    /// What the second rod hangs on.
    pub second: Option<usize>,
    /// The joints of the scene that it stands for.
    pub joints: Vec<usize>,
}
// ANCHOR_END: bond

impl Bond {
    /// A joint by itself.
    #[must_use]
    pub fn of(scene: &Scene, index: usize) -> Self {
        let joint = &scene.joints[index];
        let (a, b) = joint.bodies();
        let (anchor_a, anchor_b) = joint.anchors();
        let pin = Self {
            a,
            b,
            kind: PIN,
            anchors: [anchor_a, anchor_b],
            axes: [DVec3::ZERO; 2],
            lengths: [0.0; 2],
            second: None,
            joints: vec![index],
        };
        let bond = match *joint {
            Joint::Hinge { axis_a, axis_b, .. } => Self {
                kind: HINGE,
                axes: [axis_a.normalize(), axis_b.normalize()],
                ..pin
            },
            // Points at the distance 0 are one point, and that has no direction to act along.
            Joint::Distance { length, .. } if length > 0.0 => Self {
                kind: ROD,
                lengths: [length, 0.0],
                ..pin
            },
            Joint::Ball { .. } | Joint::Distance { .. } => pin,
        };
        let is_turned = scene.bodies[b].is_static();
        if is_turned { bond.flipped() } else { bond }
    }

    /// The same between b and a.
    #[must_use]
    pub fn flipped(mut self) -> Self {
        std::mem::swap(&mut self.a, &mut self.b);
        self.anchors.swap(0, 1);
        self.axes.swap(0, 1);
        self
    }

    // ANCHOR: absorb
    /// Takes another bond of the same b up into this one, if one row can hold both. Says whether it did.
    #[must_use]
    pub fn absorb(&mut self, other: &Self, a_is_static: bool) -> bool {
        let fits = match (self.kind, other.kind) {
            (PIN, PIN) if self.a == other.a => self.absorb_pin(other),
            (HINGE, PIN) if self.a == other.a => self.is_on_line(other),
            (HINGE, HINGE) if self.a == other.a => self.is_on_line(other) && self.is_along(other),
            (ROD, ROD) if a_is_static => self.absorb_rod(other),
            _ => false,
        };
        if fits {
            self.joints.extend(&other.joints);
        }
        fits
    }
    // ANCHOR_END: absorb

    /// Two pins are a hinge through both, if they are as far apart in one body as in the other.
    fn absorb_pin(&mut self, other: &Self) -> bool {
        let across = [0, 1].map(|end| other.anchors[end] - self.anchors[end]);
        let lengths = across.map(DVec3::length);
        if (lengths[0] - lengths[1]).abs() > NEAR {
            return false;
        }
        if lengths[0].min(lengths[1]) > NEAR {
            self.kind = HINGE;
            for (end, across) in across.into_iter().enumerate() {
                self.axes[end] = across.normalize();
                self.anchors[end] += 0.5 * across;
            }
        }
        true
    }

    /// Whether the other's points lie on the hinge's line, at the same place in both bodies.
    fn is_on_line(&self, other: &Self) -> bool {
        let places = [0, 1].map(|end| {
            let across = other.anchors[end] - self.anchors[end];
            let along = across.dot(self.axes[end]);
            (along, (across - along * self.axes[end]).length())
        });
        let [(along_a, off_a), (along_b, off_b)] = places;
        off_a < NEAR && off_b < NEAR && (along_a - along_b).abs() < NEAR
    }

    /// Whether the other hinge's axes are this one's, or both the opposite.
    fn is_along(&self, other: &Self) -> bool {
        let turned = [0, 1].map(|end| self.axes[end].cross(other.axes[end]).length() < ALIGNED);
        let signs = [0, 1].map(|end| self.axes[end].dot(other.axes[end]) > 0.0);
        turned[0] && turned[1] && signs[0] == signs[1]
    }

    /// Two rods hold a point by two rows.
    fn absorb_rod(&mut self, other: &Self) -> bool {
        if self.anchors[1].distance(other.anchors[1]) > NEAR {
            return false;
        }
        self.kind = TWO_RODS;
        self.second = Some(other.a);
        self.axes[0] = other.anchors[0];
        self.lengths[1] = other.lengths[0];
        true
    }
}

// ANCHOR: merged
/// One bond for joints between the same two bodies, or between one body and static ones; and the joints
/// that it has no room for.
#[must_use]
pub fn merged(scene: &Scene, joints: &[usize]) -> (Bond, Vec<usize>) {
    let mut bonds: Vec<_> = joints.iter().map(|&j| Bond::of(scene, j)).collect();
    let b = bonds[0].b;
    for bond in &mut bonds {
        if bond.b != b {
            *bond = bond.clone().flipped();
        }
    }
    // What holds more goes first, else in the order of the scene.
    bonds.sort_by_key(|bond| [HINGE, PIN, ROD].iter().position(|&kind| kind == bond.kind));
    let mut first = bonds.remove(0);
    let is_static = scene.bodies[first.a].is_static();
    bonds.retain(|other| !first.absorb(other, is_static));
    (
        first,
        bonds.into_iter().flat_map(|bond| bond.joints).collect(),
    )
}
// ANCHOR_END: merged
