//! Where bodies touch: pairs by the grid of chapter 3, points by the narrow phase of chapter 6, kept from
//! step to step by their features.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::Scene;
use ch03_collision::aabb::Aabb;
use ch03_collision::grid::Grid;
use ch06_compute::own_row::narrow::{Posed, manifold};
use ch06_compute::rows::{FIXED, Manifold, WITH_A, WITH_B};

use super::bodies::Bodies;
use super::real::{Real, Vec3, float, of_float, of_single, single, single_turn};
use super::row::Row;
use super::world::Pivot;

/// One point at which two bodies touch or soon may.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Row of the body a in its table.
    pub a: usize,
    /// Row of the body b.
    pub b: usize,
    /// Which point of the two it is, from step to step.
    pub feature: u32,
    /// From a to b: in the world, or in the axes of the body that it turns with.
    normal: Vec3,
    turns: u32,
    round: [Real; 2],
    core: [Vec3; 2],
    /// What it has pressed along the normal, N s.
    pub impulse: Real,
    /// What it has rubbed: b received it, N s.
    pub friction: Vec3,
    /// How fast it came at the start of the step, m/s; negative.
    pub approach: Real,
    /// The largest impulse of the step, N s: 0 where the bodies never met.
    pub most: Real,
    /// Of the pair.
    pub restitution: Real,
    /// Kinetic, of the pair.
    pub kinetic: Real,
    /// Static, of the pair.
    pub holds: Real,
}

/// Where a contact is now.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// From a to b.
    pub normal: Vec3,
    /// How far apart the surfaces are, m; negative inside.
    pub gap: Real,
    /// From a's centre to the point, m.
    pub arm_a: Vec3,
    /// From b's centre.
    pub arm_b: Vec3,
}

/// What is kept about contacts.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    /// The points of this step, in order of the pairs.
    pub points: Vec<Contact>,
    /// How many pairs were near enough to be looked at.
    pub pairs: usize,
    /// Pairs that a joint connects, in order.
    ignored: Vec<(usize, usize)>,
    /// Bodies that touch nothing.
    aside: Vec<usize>,
    grid: Grid,
    boxes: Vec<Aabb>,
}

impl Contacts {
    /// None yet.
    #[must_use]
    pub fn of(scene: &Scene, pivots: &[Pivot]) -> Self {
        let pair = |joint: &ch00_scenes::Joint| {
            let (a, b) = joint.bodies();
            (a.min(b), a.max(b))
        };
        let mut ignored: Vec<_> = scene.joints.iter().map(pair).collect();
        ignored.sort_unstable();
        Self {
            ignored,
            aside: pivots.iter().map(|pivot| pivot.body).collect(),
            ..Self::default()
        }
    }

    // ANCHOR: find
    /// Finds where bodies touch or may within `dt`; points that were there in the last step keep what they
    /// pressed.
    pub fn find(&mut self, bodies: &Bodies, gravity: Vec3, dt: Real) {
        let last = std::mem::take(&mut self.points);
        for (a, b) in self.pairs(bodies, gravity, dt) {
            let found = manifold(
                &posed(bodies, a, a),
                &posed(bodies, b, a),
                float(margin(bodies, a, b, gravity, dt)),
            );
            for k in 0..found.points as usize {
                let mut point = Contact::of(bodies, (a, b), &found, k);
                if let Ok(at) = last.binary_search_by_key(&point.key(), Contact::key) {
                    point.impulse = last[at].impulse;
                    point.friction = last[at].friction;
                }
                self.points.push(point);
            }
        }
        self.points.sort_by_key(Contact::key);
    }
    // ANCHOR_END: find

    fn pairs(&mut self, bodies: &Bodies, gravity: Vec3, dt: Real) -> Vec<(usize, usize)> {
        let rows = 0..bodies.count();
        let boxed = |row: usize| {
            let at = single(bodies.position[row]);
            let tight = Aabb::of_shape(&bodies.shape[row], at, single_turn(bodies.attitude[row]));
            tight.grown(float(margin(bodies, row, row, gravity, dt)))
        };
        self.boxes.clear();
        self.boxes.extend(rows.clone().map(boxed));
        self.grid.build(&self.boxes);
        let mut pairs = Vec::new();
        for a in rows.filter(|&row| bodies.moves(row) && !self.aside.contains(&row)) {
            self.grid.overlapping(&self.boxes, &self.boxes[a], |b| {
                let once = b != a && (a < b || !bodies.moves(b));
                if once && !self.aside.contains(&b) {
                    pairs.push((a.min(b), a.max(b)));
                }
            });
        }
        pairs.retain(|pair| self.ignored.binary_search(pair).is_err());
        pairs.sort_unstable();
        self.pairs = pairs.len();
        pairs
    }
}

/// How far apart two bodies may be to be looked at, m: as far as they may come together in the step, and a
/// little.
fn margin(bodies: &Bodies, a: usize, b: usize, gravity: Vec3, dt: Real) -> Real {
    let way = |row: usize| {
        let turning =
            bodies.angular_velocity[row].length() * of_float(bodies.shape[row].bounding_radius());
        let falls = if bodies.moves(row) {
            gravity.length() * dt
        } else {
            0.0
        };
        (bodies.velocity[row].length() + turning + falls) * dt
    };
    0.002 + way(a) + way(b)
}

fn posed(bodies: &Bodies, row: usize, origin: usize) -> Posed {
    let (kind, size) = match bodies.shape[row] {
        Shape::Sphere { radius } => (0, [radius, 0.0, 0.0]),
        Shape::Box { half_extents } => (1, half_extents.to_array()),
        Shape::Capsule {
            radius,
            half_height,
        } => (2, [radius, half_height, 0.0]),
        Shape::Cylinder {
            radius,
            half_height,
        } => (3, [radius, half_height, 0.0]),
    };
    Posed {
        position: single(bodies.position[row] - bodies.position[origin]),
        attitude: single_turn(bodies.attitude[row]),
        kind,
        size: size.into(),
    }
}

impl Contact {
    fn of(bodies: &Bodies, (a, b): (usize, usize), found: &Manifold, k: usize) -> Self {
        let mixed = |of: &[Real]| (of[a] * of[b]).sqrt();
        Self {
            a,
            b,
            feature: found.core_a[k].w.to_bits(),
            normal: of_single(found.normal),
            turns: found.turns,
            round: [of_float(found.round_a), of_float(found.round_b)],
            core: [
                of_single(found.core_a[k].truncate()),
                of_single(found.core_b[k].truncate()),
            ],
            impulse: 0.0,
            friction: Vec3::ZERO,
            approach: 0.0,
            most: 0.0,
            restitution: 0.5 * (bodies.restitution[a] + bodies.restitution[b]),
            kinetic: mixed(&bodies.friction),
            holds: mixed(&bodies.static_friction),
        }
    }

    fn key(&self) -> (usize, usize, u32) {
        (self.a, self.b, self.feature)
    }

    /// Where it is now, by what turns with the bodies.
    #[must_use]
    pub fn touch(&self, bodies: &Bodies) -> Touch {
        let (q_a, q_b) = (bodies.attitude[self.a], bodies.attitude[self.b]);
        let apart = bodies.position[self.b] - bodies.position[self.a];
        let (on_a, on_b) = (q_a * self.core[0], apart + q_b * self.core[1]);
        let normal = match self.turns {
            WITH_A => q_a * self.normal,
            WITH_B => q_b * self.normal,
            FIXED => self.normal,
            _ => (on_b - on_a).normalize_or(self.normal),
        };
        let gap = (on_b - on_a).dot(normal) - self.round[0] - self.round[1];
        let arm_a = if self.round[0] > 0.0 {
            on_a + normal * (self.round[0] + 0.5 * gap)
        } else if self.round[1] > 0.0 {
            on_b - normal * (self.round[1] + 0.5 * gap)
        } else {
            0.5 * (on_a + on_b)
        };
        Touch {
            normal,
            gap,
            arm_a,
            arm_b: arm_a - apart,
        }
    }

    /// The row along the normal.
    #[must_use]
    pub fn row(&self, touch: &Touch) -> Row {
        let (a, b) = ((self.a, touch.arm_a), (self.b, touch.arm_b));
        Row::along(a, b, touch.normal, touch.gap).at_least_zero()
    }

    /// How b's surface slides over a's, m/s.
    #[must_use]
    pub fn sliding(&self, touch: &Touch, bodies: &Bodies) -> Vec3 {
        let speed =
            bodies.velocity_at(self.b, touch.arm_b) - bodies.velocity_at(self.a, touch.arm_a);
        speed - touch.normal * speed.dot(touch.normal)
    }

    // ANCHOR: rub
    /// Friction: takes away what slides, as far as what the contact presses allows. Both directions at once,
    /// so that no direction is favoured.
    pub fn rub(&mut self, touch: &Touch, bodies: &mut Bodies) {
        let sliding = self.sliding(touch, bodies);
        let speed = sliding.length();
        let before = self.friction - touch.normal * self.friction.dot(touch.normal);
        let mut wanted = before;
        if speed > 0.0 {
            let (a, b) = ((self.a, touch.arm_a), (self.b, touch.arm_b));
            let row = Row::along(a, b, sliding / speed, 0.0);
            wanted -= row.linear * (speed / row.inverse_mass(bodies));
        }
        let size = wanted.length();
        let pressed = self.impulse.max(0.0);
        if size > self.holds * pressed {
            wanted *= self.kinetic * pressed / size;
        }
        self.friction = wanted;
        self.give(touch, bodies, wanted - before);
    }
    // ANCHOR_END: rub

    /// Gives b an impulse at the point, and takes it from a, N s.
    pub fn give(&self, touch: &Touch, bodies: &mut Bodies, impulse: Vec3) {
        for (row, arm, sign) in [(self.a, touch.arm_a, -1.0), (self.b, touch.arm_b, 1.0)] {
            let turned = bodies.turned_by(row, arm.cross(impulse));
            bodies.velocity[row] += impulse * (sign * bodies.inverse_mass[row]);
            bodies.angular_velocity[row] += turned * sign;
        }
    }
}
