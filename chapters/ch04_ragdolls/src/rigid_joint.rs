//! A joint: what keeps a child at its parent, and within the angles that the joint allows. Report 9.1.

use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use ch03_collision::Span;
use glam::{Quat, Vec3};

use crate::{Anchors, AngleConstraint, AngleLimits, DistanceConstraint, PinConstraint};

/// What a joint is made from: plain data, lengths in metres, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSpec {
    /// o₁ and o₂: where it takes hold of them.
    pub anchors: Anchors,
    /// The distance to keep between the points; `None` pins them together.
    pub distance: Option<f32>,
    /// How far the child may turn; `None` for any way.
    pub limits: Option<AngleLimits>,
    /// j: the child's orientation in the parent at rest; as the bodies are if absent.
    pub rest: Option<Quat>,
}

// ANCHOR: joint
/// A joint between two bodies.
pub struct RigidJoint {
    parent: Shared<RigidBody>,
    child: Shared<RigidBody>,
    /// Their indices in the scene.
    indices: (usize, usize),
    link: Link,
}

/// What keeps the two together.
#[expect(clippy::large_enum_variant, reason = "nearly all joints are pins")]
enum Link {
    /// A point, and the angles about it.
    Pin(PinConstraint, Option<AngleConstraint>),
    /// A rod.
    Distance(DistanceConstraint),
}
// ANCHOR_END: joint

impl RigidJoint {
    /// Joins two different bodies, given with their indices in the scene.
    #[must_use]
    pub fn new(
        parent: (usize, Shared<RigidBody>),
        child: (usize, Shared<RigidBody>),
        spec: JointSpec,
    ) -> Self {
        let rest = spec.rest.unwrap_or_else(|| {
            let (one, two) = (parent.1.borrow(), child.1.borrow());
            (one.orientation().conjugate() * two.orientation()).normalize()
        });
        let angle = spec.limits.map(|limits| AngleConstraint::new(rest, limits));
        let mut joint = Self {
            parent: parent.1,
            child: child.1,
            indices: (parent.0, child.0),
            link: match spec.distance {
                None => Link::Pin(PinConstraint::new(spec.anchors), angle),
                Some(length) => Link::Distance(DistanceConstraint::new(spec.anchors, length)),
            },
        };
        joint.finish();
        joint
    }

    /// The indices of parent and child in the scene.
    #[must_use]
    pub fn indices(&self) -> (usize, usize) {
        self.indices
    }

    /// Its parent and its child.
    #[must_use]
    pub fn bodies(&self) -> (&Shared<RigidBody>, &Shared<RigidBody>) {
        (&self.parent, &self.child)
    }

    /// Its angle constraint, if it has limits.
    #[must_use]
    pub fn angle(&self) -> Option<&AngleConstraint> {
        match &self.link {
            Link::Pin(_, angle) => angle.as_ref(),
            Link::Distance(_) => None,
        }
    }

    /// The points that it holds, in the world, m.
    #[must_use]
    pub fn points(&self) -> (Vec3, Vec3) {
        let (parent, child) = (self.parent.borrow(), self.child.borrow());
        let anchors = match &self.link {
            Link::Pin(pin, _) => pin.anchors(),
            Link::Distance(rod) => rod.anchors(),
        };
        anchors.points(&parent, &child)
    }

    // ANCHOR: correct
    /// The report's constraint update. Says whether anything was off.
    ///
    /// The report solves the angle first, each body turning about its own centre, and the pin's
    /// correction then spoils the angle. Here the pin comes first and the angle turns both about it.
    pub fn correct(&mut self) -> bool {
        let (mut parent, mut child) = (self.parent.borrow_mut(), self.child.borrow_mut());
        match &mut self.link {
            Link::Pin(pin, angle) => {
                let moved = pin.correct(&mut parent, &mut child);
                let angle = angle.as_ref();
                moved | angle.is_some_and(|angle| angle.correct(pin, &mut parent, &mut child))
            }
            Link::Distance(rod) => rod.correct(&mut parent, &mut child),
        }
    }
    // ANCHOR_END: correct

    // ANCHOR: printed
    /// The same with the formulas as printed.
    pub fn correct_printed(&mut self) {
        let (mut parent, mut child) = (self.parent.borrow_mut(), self.child.borrow_mut());
        parent.weigh();
        child.weigh();
        match &mut self.link {
            Link::Pin(pin, angle) => {
                if let Some(angle) = angle {
                    angle.correct_printed(&mut parent, &mut child);
                }
                pin.correct_printed(&mut parent, &mut child);
            }
            Link::Distance(rod) => rod.correct_printed(&mut parent, &mut child),
        }
    }
    // ANCHOR_END: printed

    /// Before contacts are resolved for a step of this length.
    pub fn prepare(&mut self, span: Span) {
        let (parent, child) = (self.parent.borrow(), self.child.borrow());
        match &mut self.link {
            Link::Pin(pin, angle) => {
                pin.prepare(&parent, &child, span);
                if let Some(angle) = angle {
                    angle.prepare(pin, &parent, &child, span);
                }
            }
            Link::Distance(rod) => rod.prepare(&parent, &child, span),
        }
    }

    /// Nudges its bodies to where they belong; gives how far they were off, m.
    pub fn part(&mut self) -> f32 {
        let (mut parent, mut child) = (self.parent.borrow_mut(), self.child.borrow_mut());
        match &mut self.link {
            Link::Pin(pin, angle) => {
                let gap = pin.part(&mut parent, &mut child);
                let angle = angle.as_mut();
                gap.max(angle.map_or(0.0, |angle| angle.part(pin, &mut parent, &mut child)))
            }
            Link::Distance(rod) => rod.part(&mut parent, &mut child),
        }
    }

    /// Begins with the impulses of the last step.
    pub fn resume(&mut self) {
        let (mut parent, mut child) = (self.parent.borrow_mut(), self.child.borrow_mut());
        match &self.link {
            Link::Pin(pin, angle) => {
                pin.resume(&mut parent, &mut child);
                if let Some(angle) = angle {
                    angle.resume(&mut parent, &mut child);
                }
            }
            Link::Distance(rod) => rod.resume(&mut parent, &mut child),
        }
    }

    // ANCHOR: hold
    /// Mends its impulses once; says whether a velocity was off by more than `still`, m/s.
    pub fn hold(&mut self, still: f32) -> bool {
        let (mut parent, mut child) = (self.parent.borrow_mut(), self.child.borrow_mut());
        match &mut self.link {
            Link::Pin(pin, angle) => {
                let off = pin.hold(&mut parent, &mut child) > still;
                let angle = angle.as_mut();
                off | angle.is_some_and(|angle| angle.hold(pin, &mut parent, &mut child, still))
            }
            Link::Distance(rod) => rod.hold(&mut parent, &mut child) > still,
        }
    }
    // ANCHOR_END: hold

    /// Notes how far its bodies are from where they belong.
    pub fn finish(&mut self) {
        let (parent, child) = (self.parent.borrow(), self.child.borrow());
        match &mut self.link {
            Link::Pin(pin, angle) => {
                pin.finish(&parent, &child);
                if let Some(angle) = angle {
                    angle.finish(&parent, &child);
                }
            }
            Link::Distance(rod) => rod.finish(&parent, &child),
        }
    }

    /// Forgets the impulses of the last step; the gap and the angles are as they are now.
    pub fn forget(&mut self) {
        match &mut self.link {
            Link::Pin(pin, angle) => {
                pin.forget();
                if let Some(angle) = angle {
                    angle.forget();
                }
            }
            Link::Distance(rod) => rod.forget(),
        }
        self.finish();
    }
}
