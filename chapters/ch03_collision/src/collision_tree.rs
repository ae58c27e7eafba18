//! The report's `CollisionTree`: knows all colliders of a level, finds the pairs that may touch
//! (broad phase) and where they do (narrow phase).

use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;
use glam::Vec3;

use crate::Contact;
use crate::aabb::Aabb;
use crate::kd_tree::KdTree;
use crate::narrow::{Placed, touch};

/// The colliders of a level. Keeps its memory from step to step.
#[derive(Default)]
pub struct CollisionTree {
    boxes: Vec<Aabb>,
    tree: KdTree,
    pairs: Vec<(usize, usize)>,
    /// Pairs that pass through each other, in order.
    ignored: Vec<(usize, usize)>,
    last: Vec<Contact>,
    /// Touches whose depth the iterations did not get to the end of, since loading.
    unsure: usize,
}

impl CollisionTree {
    /// From now on these pairs, in either order, touch each other no more.
    pub fn ignore_pairs(&mut self, pairs: impl IntoIterator<Item = (usize, usize)>) {
        let ordered = pairs.into_iter().map(|(a, b)| (a.min(b), a.max(b)));
        self.ignored.extend(ordered);
        self.ignored.sort_unstable();
        self.ignored.dedup();
    }

    // ANCHOR: broad
    /// Broad phase: the pairs that may be within the margin of each other, in order of index. Two
    /// bodies that can't move are no pair, and a held body touches nothing.
    pub fn find_pairs(
        &mut self,
        bodies: &[Shared<RigidBody>],
        margins: Margins,
    ) -> &[(usize, usize)] {
        self.boxes.clear();
        self.boxes.extend(
            bodies
                .iter()
                .map(|body| bounding_box(&body.borrow(), margins)),
        );
        self.tree.build(&self.boxes);
        self.pairs.clear();
        for (i, body) in bodies.iter().enumerate() {
            if body.borrow().is_static() {
                continue;
            }
            self.tree.overlapping(&self.boxes, &self.boxes[i], |j| {
                if j > i || (j < i && bodies[j].borrow().is_static()) {
                    self.pairs.push((i.min(j), i.max(j)));
                }
            });
        }
        self.pairs.sort_unstable();
        if !self.ignored.is_empty() {
            self.pairs
                .retain(|pair| self.ignored.binary_search(pair).is_err());
        }
        &self.pairs
    }
    // ANCHOR_END: broad

    // ANCHOR: narrow
    /// Narrow phase: the contacts of the pairs that [`Self::find_pairs`] found.
    /// A pair that touched in the last step too hands on what it held.
    pub fn find_contacts(
        &mut self,
        bodies: &[Shared<RigidBody>],
        margins: Margins,
        contacts: &mut Vec<Contact>,
    ) {
        std::mem::swap(&mut self.last, contacts);
        contacts.clear();
        for &(a, b) in &self.pairs {
            let (body_1, body_2) = (bodies[a].borrow(), bodies[b].borrow());
            let margin = margins.between(&body_1, &body_2);
            let Some(touch) = touch(&placed(&body_1), &placed(&body_2), margin) else {
                continue;
            };
            self.unsure += usize::from(!touch.converged);
            let from = contacts.len();
            contacts.extend(touch.spots().iter().map(|spot| Contact {
                a,
                b,
                feature: spot.feature,
                normal: touch.normal,
                depth: spot.depth,
                point: spot.point,
                impulse: Vec3::ZERO,
                support: 0.0,
                rub: Vec3::ZERO,
            }));
            contacts[from..].sort_unstable_by_key(|contact| contact.feature);
        }
        Contact::remember(contacts, &self.last);
    }
    // ANCHOR_END: narrow

    /// Touches whose depth the narrow phase's iterations did not get to the end of, since loading.
    #[must_use]
    pub fn unsure_touches(&self) -> usize {
        self.unsure
    }

    /// How many pairs the last broad phase found.
    #[must_use]
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    /// The pairs that the last broad phase found, in order of index.
    #[must_use]
    pub fn pairs(&self) -> &[(usize, usize)] {
        &self.pairs
    }

    /// The bounding boxes of the last broad phase, by body.
    #[must_use]
    pub fn boxes(&self) -> &[Aabb] {
        &self.boxes
    }

    /// The cells of the last broad phase's tree, with how deep each lies.
    #[must_use]
    pub fn cells(&self) -> Vec<(Aabb, u32)> {
        self.tree.cells()
    }
}

// ANCHOR: margins
/// How far from touching two bodies may be and still make a contact, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Margins {
    /// Two bodies that move.
    pub moving: f32,
    /// A body that moves and one that can't.
    pub obstacle: f32,
    /// What is added for a body that doesn't bounce and moves on as it did in the last step, at most.
    pub ahead: f32,
}

impl Margins {
    /// Of a pair.
    fn between(self, one: &RigidBody, two: &RigidBody) -> f32 {
        if one.is_static() || two.is_static() {
            self.obstacle
        } else {
            self.moving + self.ahead_of(one) + self.ahead_of(two)
        }
    }

    /// How far ahead of a body to look. Who bounces must arrive first.
    fn ahead_of(self, body: &RigidBody) -> f32 {
        self.ahead(body.material().restitution, || body.last_reach())
    }

    /// The same of a body with this restitution that moved `reach`, m, in the last step.
    #[must_use]
    pub fn ahead(self, restitution: f32, reach: impl FnOnce() -> f32) -> f32 {
        if restitution > 0.0 {
            0.0
        } else {
            reach().min(self.ahead)
        }
    }
}
// ANCHOR_END: margins

/// Where a body could come near something; nowhere if it is held.
fn bounding_box(body: &RigidBody, margins: Margins) -> Aabb {
    if body.is_held() {
        return Aabb::EMPTY;
    }
    let margin = if body.is_static() {
        margins.obstacle
    } else {
        0.5 * margins.moving + margins.ahead_of(body)
    };
    Aabb::of_shape(body.collider(), body.position(), body.orientation()).grown(margin)
}

/// A body as the narrow phase sees it.
#[must_use]
pub fn placed(body: &RigidBody) -> Placed<'_> {
    Placed {
        shape: body.collider(),
        p: body.position(),
        q: body.orientation(),
        p_before: body.last_position(),
    }
}
