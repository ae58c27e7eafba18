//! What a pair of bodies does in a substep: the contact of the own-row method. Chapter 6 derives it.
//!
//! A pair reads both bodies and writes its own impulses. All pairs do so at once, from the same
//! velocities (Jacobi's way). Were each to stop its bodies alone, a body between n others would be
//! stopped n times over; so each pair is given an n-th of the body's mass to work with: n/m and n I⁻¹
//! instead of 1/m and I⁻¹. The body then gathers the impulses with its whole mass. [Tonge, Benevolenski
//! and Voroshilov 2012: mass splitting]

use glam::{Mat3, Quat, Vec3, Vec4};

use crate::rows::{FIXED, Impulse, Manifold, Material, Motion, Place, Press, Solid, Spin, Step};
use crate::rows::{ROUND, WITH_A, WITH_B};

/// Below this an effective inverse mass or a length is none.
const SMALL: f32 = 1e-12;

/// Sweeps over the points and the friction of a pair of more than one point.
pub const INNER_SWEEPS: u32 = 2;

/// Sweeps over the points of a pair that bounces.
pub const BOUNCE_SWEEPS: u32 = 16;

// ANCHOR: side
/// One of the two bodies, as the pair sees it.
#[derive(Clone, Copy, Debug)]
pub struct Side {
    /// World position, m.
    pub position: Vec3,
    /// Body to world.
    pub attitude: Quat,
    /// m/s.
    pub velocity: Vec3,
    /// rad/s.
    pub angular_velocity: Vec3,
    /// 1/m: with the whole mass.
    pub inverse_mass: f32,
    /// n/m: with the share of the mass that the pair has.
    pub shared_mass: f32,
    /// n I⁻¹ in world axes.
    pub shared_inertia: Mat3,
    /// What the two velocities were before the substep's kick.
    pub before: Before,
}

/// How a body moved before a substep's kick: what counts as the speed of an impact. Just after the kick
/// what holds it may be out of balance, and a light body between heavy ones seems fast.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Before {
    /// m/s.
    pub velocity: Vec3,
    /// rad/s.
    pub angular_velocity: Vec3,
}
// ANCHOR_END: side

impl Side {
    /// Gathers it from a body's rows.
    #[must_use]
    pub fn of(
        place: &Place,
        attitude: Quat,
        motion: &Motion,
        spin: &Spin,
        solid: &Solid,
        before: Before,
    ) -> Self {
        Self {
            before,
            position: place.position,
            attitude,
            velocity: motion.velocity,
            angular_velocity: spin.angular_velocity,
            inverse_mass: spin.inverse_mass,
            shared_mass: motion.shares * spin.inverse_mass,
            shared_inertia: world_inertia(attitude, motion.shares * solid.inverse_inertia),
        }
    }

    /// The same body, moved by an impulse at `arm`: what the pair alone makes of it.
    fn take(&mut self, impulse: Vec3, turning: Vec3) {
        self.velocity += impulse * self.shared_mass;
        self.angular_velocity += self.shared_inertia * turning;
    }

    /// World velocity of the body's point at `arm`, m/s.
    fn velocity_at(&self, arm: Vec3) -> Vec3 {
        self.velocity + self.angular_velocity.cross(arm)
    }
}

/// R D Rᵀ: a diagonal tensor in body axes as a matrix in world axes.
#[must_use]
pub fn world_inertia(q: Quat, diagonal: Vec3) -> Mat3 {
    let r = Mat3::from_quat(q);
    let scaled = Mat3::from_cols(
        r.x_axis * diagonal.x,
        r.y_axis * diagonal.y,
        r.z_axis * diagonal.z,
    );
    scaled * r.transpose()
}

// ANCHOR: touching
/// Where the points of a pair are now.
#[derive(Clone, Copy, Debug, Default)]
pub struct Touching {
    /// From a to b.
    pub normal: Vec3,
    /// s: how far apart the surfaces are at each point, m; negative inside.
    pub distance: [f32; 4],
    /// From a's centre to each point, m.
    pub arm_a: [Vec3; 4],
    /// From b's centre, m.
    pub arm_b: [Vec3; 4],
    /// From a's centre to the mean of the points, m.
    pub mean_a: Vec3,
    /// From b's centre, m.
    pub mean_b: Vec3,
    /// Mean distance of the points from their mean, m.
    pub spread: f32,
}

/// Where the points are for bodies where they are now: both arms of a point end at the same place, so
/// that what one body gains in angular momentum the other loses.
#[must_use]
pub fn touching(m: &Manifold, a: &Side, b: &Side) -> Touching {
    let apart = b.position - a.position;
    let normal = normal_now(m, a, b);
    let mut t = Touching {
        normal,
        ..Touching::default()
    };
    let points = m.points as usize;
    for k in 0..points {
        let core_a = a.attitude * m.core_a[k].truncate();
        let core_b = apart + b.attitude * m.core_b[k].truncate();
        t.distance[k] = (core_b - core_a).dot(normal) - m.round_a - m.round_b;
        let middle = middle(m, [core_a, core_b], normal, t.distance[k]);
        t.arm_a[k] = middle;
        t.arm_b[k] = middle - apart;
        t.mean_a += middle / points as f32;
    }
    t.mean_b = t.mean_a - apart;
    for k in 0..points {
        t.spread += (t.arm_a[k] - t.mean_a).length() / points as f32;
    }
    t
}

/// Where two surfaces meet: in the middle of the gap. On a round body that is along the normal from its
/// core point; a point fixed in a face would lag behind a body that rolls on.
fn middle(m: &Manifold, [core_a, core_b]: [Vec3; 2], normal: Vec3, distance: f32) -> Vec3 {
    if m.round_a > 0.0 {
        return core_a + (m.round_a + 0.5 * distance) * normal;
    }
    if m.round_b > 0.0 {
        return core_b - (m.round_b + 0.5 * distance) * normal;
    }
    0.5 * (core_a + core_b)
}

/// The normal for bodies where they are now.
fn normal_now(m: &Manifold, a: &Side, b: &Side) -> Vec3 {
    if m.turns == WITH_A {
        return a.attitude * m.normal;
    }
    if m.turns == WITH_B {
        return b.attitude * m.normal;
    }
    if m.turns == FIXED {
        return m.normal;
    }
    let mut line = Vec3::ZERO;
    for k in 0..m.points as usize {
        let core_a = a.attitude * m.core_a[k].truncate();
        let core_b = b.attitude * m.core_b[k].truncate();
        line += b.position - a.position + core_b - core_a;
    }
    let length = line.length();
    if length > SMALL {
        line / length
    } else {
        m.normal
    }
}
// ANCHOR_END: touching

/// Speed of b away from a along the normal at point k, m/s.
fn parting(t: &Touching, k: usize, a: &Side, b: &Side) -> f32 {
    t.normal
        .dot(b.velocity_at(t.arm_b[k]) - a.velocity_at(t.arm_a[k]))
}

/// The same before the kick.
fn parting_before(t: &Touching, k: usize, a: &Side, b: &Side) -> f32 {
    let of_a = a.before.velocity + a.before.angular_velocity.cross(t.arm_a[k]);
    let of_b = b.before.velocity + b.before.angular_velocity.cross(t.arm_b[k]);
    t.normal.dot(of_b - of_a)
}

// ANCHOR: press
/// The impulses of a pair as its bodies receive them.
#[must_use]
pub fn press(t: &Touching, points: u32, impulse: &Impulse) -> Press {
    let mut press = Press {
        stays: 1.0,
        ..Press::default()
    };
    for k in 0..points as usize {
        let p = impulse.normal[k] * t.normal;
        press.linear += p;
        press.angular_a -= t.arm_a[k].cross(p);
        press.angular_b += t.arm_b[k].cross(p);
    }
    let twist = impulse.twist * t.normal;
    press.linear += impulse.friction;
    press.angular_a -= t.mean_a.cross(impulse.friction) + twist;
    press.angular_b += t.mean_b.cross(impulse.friction) + twist;
    press
}
// ANCHOR_END: press

// ANCHOR: press_again
/// What a pair starts a step with: the impulses that it ended the last one with, where its points are
/// now; and whether it counts.
#[must_use]
pub fn press_again(m: &Manifold, impulse: &Impulse, a: &Side, b: &Side, h: f32) -> Press {
    let t = touching(m, a, b);
    let mut pressed = press(&t, m.points, impulse);
    for k in 0..m.points as usize {
        if impulse.normal[k] > 0.0 || meets(m, &t, k, a, b, h) {
            pressed.counts = 1.0;
        }
    }
    pressed
}
// ANCHOR_END: press_again

// ANCHOR: solve_pair
/// A substep of a pair: it mends its impulses so that the bodies, with the share of their masses that
/// it has, no longer approach where they touch, and don't slide where friction holds them.
///
/// `approach` keeps the fastest impact of the step at each point, m/s, negative, for [`restore_pair`].
#[must_use]
pub fn solve_pair(
    m: &Manifold,
    material: &Material,
    impulse: &mut Impulse,
    approach: &mut Vec4,
    sides: [Side; 2],
    step: &Step,
) -> Press {
    let [mut a, mut b] = sides;
    let t = touching(m, &a, &b);
    let soon = note_impacts(m, &t, approach, &a, &b, step);
    let active = activate(m, &t, impulse, &a, &b, step);
    let pressed_before = impulse.normal.max_element() > 0.0;
    let mut pressed = Press::default();
    if active {
        let reply = replies(&t, m.points, &a, &b);
        let sweeps = if m.points > 1 { INNER_SWEEPS } else { 1 };
        for _ in 0..sweeps {
            mend_normals(&t, m.points, impulse, reply, &mut a, &mut b, step);
            mend_friction(&t, m.points, impulse, material, &mut a, &mut b);
        }
        pressed = press(&t, m.points, impulse);
        push_out(&t, m.points, reply, sides, step, &mut pressed);
    }
    if soon || impulse.normal.max_element() > 0.0 {
        pressed.counts = 1.0;
    }
    if !pressed_before && is_impact(&pressed, &a, &b, step) {
        pressed.stays = 0.0;
        *impulse = Impulse::default();
    }
    pressed
}
// ANCHOR_END: solve_pair

// ANCHOR: is_impact
/// Whether what a pair newly pressed is an impact rather than the beginning of rest.
///
/// A substep begins with the impulses of the last one, and each pair takes back what was too much; but
/// with its share of the mass it takes back only a share. For a weight that is right. For an impact it
/// would leave speed that nobody paid for.
fn is_impact(pressed: &Press, a: &Side, b: &Side, step: &Step) -> bool {
    pressed.linear.length() * (a.inverse_mass + b.inverse_mass) > step.impact_speed
}
// ANCHOR_END: is_impact

// ANCHOR: note_impacts
// ANCHOR: impact_speed
/// Notes how fast the points come that will touch in this substep; says whether one touches or may
/// touch in the next.
///
/// The speed is that at the surface: u² = c² + 2 a s, where c is the speed of approach before the substep's
/// kick, a the acceleration of approach, and s the gap that is left.
fn note_impacts(
    m: &Manifold,
    t: &Touching,
    approach: &mut Vec4,
    a: &Side,
    b: &Side,
    step: &Step,
) -> bool {
    let mut soon = false;
    let closing = closing_pull(t.normal, a, b, step.gravity);
    for k in 0..m.points as usize {
        if comes(m, t, k, a, b, step.h) {
            let before = (-parting_before(t, k, a, b)).max(0.0);
            let squared = before * before + 2.0 * closing * t.distance[k].max(0.0);
            approach[k] = approach[k].min(-squared.max(0.0).sqrt());
        }
        soon = soon || meets(m, t, k, a, b, 2.0 * step.h);
    }
    soon
}
// ANCHOR_END: impact_speed

// ANCHOR: passes
/// Whether two round bodies that come nearer pass each other within `h` seconds: the nearest that their core
/// points come is farther than both radii. Without it a fast ball would be stopped by what it flies past, or
/// share its mass with it, and be stopped too little by what it hits.
fn passes(m: &Manifold, t: &Touching, k: usize, a: &Side, b: &Side, h: f32) -> bool {
    if m.turns != ROUND || t.distance[k] <= 0.0 {
        return false;
    }
    let reach = m.round_a + m.round_b;
    let apart = (t.distance[k] + reach) * t.normal;
    let moves = h * (b.velocity_at(t.arm_b[k]) - a.velocity_at(t.arm_a[k]));
    let part = (-apart.dot(moves) / moves.length_squared().max(SMALL)).clamp(0.0, 1.0);
    (apart + part * moves).length_squared() > reach * reach
}
// ANCHOR_END: passes

/// Whether the bodies come so near within `h` seconds that they touch at point k.
fn comes(m: &Manifold, t: &Touching, k: usize, a: &Side, b: &Side, h: f32) -> bool {
    t.distance[k] + h * parting(t, k, a, b) <= 0.0 && !passes(m, t, k, a, b, h)
}

/// Whether they touch at point k, or come to within `h` seconds.
fn meets(m: &Manifold, t: &Touching, k: usize, a: &Side, b: &Side, h: f32) -> bool {
    t.distance[k] <= 0.0 || comes(m, t, k, a, b, h)
}

/// The acceleration with which gravity brings a and b together along the normal, m/s².
fn closing_pull(normal: Vec3, a: &Side, b: &Side, gravity: Vec3) -> f32 {
    let mut closing = 0.0;
    if a.inverse_mass > 0.0 {
        closing += gravity.dot(normal);
    }
    if b.inverse_mass > 0.0 {
        closing -= gravity.dot(normal);
    }
    closing
}
// ANCHOR_END: note_impacts

/// Whether a point is active. Points that aren't press no more.
fn activate(
    m: &Manifold,
    t: &Touching,
    impulse: &mut Impulse,
    a: &Side,
    b: &Side,
    step: &Step,
) -> bool {
    let mut active = false;
    for k in 0..m.points as usize {
        active = active || impulse.normal[k] > 0.0 || meets(m, t, k, a, b, step.h);
    }
    if !active {
        *impulse = Impulse::default();
    }
    active
}

// ANCHOR: replies
/// Dₖ = Σⱼ |Aₖⱼ|, 1/kg, where Aₖⱼ is what a unit impulse at point j makes of the speed at point k.
///
/// All points of a pair move at once, so each must reckon with what the others will do: divided by the
/// row's sum of sizes rather than by its diagonal, no set of points overshoots, and the same four
/// corners of a box get the same impulses whatever their order.
fn replies(t: &Touching, points: u32, a: &Side, b: &Side) -> Vec4 {
    let mut sums = Vec4::ZERO;
    for k in 0..points as usize {
        let turned_a = a.shared_inertia * t.arm_a[k].cross(t.normal);
        let turned_b = b.shared_inertia * t.arm_b[k].cross(t.normal);
        for j in 0..points as usize {
            let turns =
                t.arm_a[j].cross(t.normal).dot(turned_a) + t.arm_b[j].cross(t.normal).dot(turned_b);
            sums[k] += (a.shared_mass + b.shared_mass + turns).abs();
        }
    }
    sums
}
// ANCHOR_END: replies

// ANCHOR: mend_normals
/// Mends the normal impulses of all points at once. A point that is still apart may come as near as it
/// touches; impulses may be taken back but never pull.
fn mend_normals(
    t: &Touching,
    points: u32,
    impulse: &mut Impulse,
    reply: Vec4,
    a: &mut Side,
    b: &mut Side,
    step: &Step,
) {
    let mut linear = Vec3::ZERO;
    let mut turning_a = Vec3::ZERO;
    let mut turning_b = Vec3::ZERO;
    for k in 0..points as usize {
        let room = t.distance[k].max(0.0) / step.h;
        let wanted = impulse.normal[k] - (parting(t, k, a, b) + room) / reply[k].max(SMALL);
        let change = wanted.max(0.0) - impulse.normal[k];
        impulse.normal[k] += change;
        linear += change * t.normal;
        turning_a -= t.arm_a[k].cross(change * t.normal);
        turning_b += t.arm_b[k].cross(change * t.normal);
    }
    a.take(-linear, turning_a);
    b.take(linear, turning_b);
}
// ANCHOR_END: mend_normals

// ANCHOR: mend_friction
/// Mends friction at the mean of the points: against sliding, and against turning about the normal.
/// Static friction holds as long as μ_s allows; beyond it the pair slips and kinetic friction is left.
fn mend_friction(
    t: &Touching,
    points: u32,
    impulse: &mut Impulse,
    material: &Material,
    a: &mut Side,
    b: &mut Side,
) {
    let pressed = impulse.normal.x + impulse.normal.y + impulse.normal.z + impulse.normal.w;
    if points > 1 {
        mend_twist(t, impulse, material, pressed, a, b);
    }
    let sliding = b.velocity_at(t.mean_b) - a.velocity_at(t.mean_a);
    let sliding = sliding - sliding.dot(t.normal) * t.normal;
    let reply = sliding_reply(t, a, b).max(SMALL);
    let last = impulse.friction;
    let held = last - last.dot(t.normal) * t.normal - sliding / reply;
    impulse.friction = coulomb(held, pressed, material);
    let change = impulse.friction - last;
    a.take(-change, -t.mean_a.cross(change));
    b.take(change, t.mean_b.cross(change));
}

// ANCHOR: coulomb
/// What friction gives of what it would take to hold.
fn coulomb(held: Vec3, pressed: f32, material: &Material) -> Vec3 {
    let size = held.length();
    if size <= material.static_friction * pressed {
        return held;
    }
    held * (material.friction * pressed / size.max(SMALL))
}
// ANCHOR_END: coulomb

/// Friction against turning about the normal, with the points' spread as its arm.
fn mend_twist(
    t: &Touching,
    impulse: &mut Impulse,
    material: &Material,
    pressed: f32,
    a: &mut Side,
    b: &mut Side,
) {
    let reply = t
        .normal
        .dot(a.shared_inertia * t.normal + b.shared_inertia * t.normal);
    let rate = t.normal.dot(b.angular_velocity - a.angular_velocity);
    let most = material.friction * pressed * t.spread;
    let last = impulse.twist;
    impulse.twist = (last - rate / reply.max(SMALL)).clamp(-most, most);
    let change = (impulse.twist - last) * t.normal;
    a.take(Vec3::ZERO, -change);
    b.take(Vec3::ZERO, change);
}

/// The larger of what a unit impulse makes of the sliding speed in two directions across the normal,
/// 1/kg.
fn sliding_reply(t: &Touching, a: &Side, b: &Side) -> f32 {
    let [one, two] = across(t.normal);
    let along = |direction: Vec3| {
        let on_a = t.mean_a.cross(direction);
        let on_b = t.mean_b.cross(direction);
        on_a.dot(a.shared_inertia * on_a) + on_b.dot(b.shared_inertia * on_b)
    };
    a.shared_mass + b.shared_mass + along(one).max(along(two))
}

/// Two unit vectors across a unit vector and across each other. [Duff and others 2017]
#[must_use]
pub fn across(n: Vec3) -> [Vec3; 2] {
    let sign = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let p = -1.0 / (sign + n.z);
    let q = n.x * n.y * p;
    [
        Vec3::new(1.0 + sign * n.x * n.x * p, sign * q, -sign * n.x),
        Vec3::new(q, sign + n.y * n.y * p, -n.y),
    ]
}
// ANCHOR_END: mend_friction

// ANCHOR: push_out
/// Pushes bodies that are inside each other apart: a velocity that moves them in this substep and is
/// then forgotten, so that no speed is left of it.
fn push_out(
    t: &Touching,
    points: u32,
    reply: Vec4,
    sides: [Side; 2],
    step: &Step,
    pressed: &mut Press,
) {
    let [mut a, mut b] = sides;
    for side in [&mut a, &mut b] {
        side.velocity = Vec3::ZERO;
        side.angular_velocity = Vec3::ZERO;
    }
    let mut pushes = Vec4::ZERO;
    let share = if points > 1 {
        step.push_share_of_many
    } else {
        step.push_share
    };
    let sweeps = if points > 1 { INNER_SWEEPS } else { 1 };
    for _ in 0..sweeps {
        let mut linear = Vec3::ZERO;
        let mut turning_a = Vec3::ZERO;
        let mut turning_b = Vec3::ZERO;
        for k in 0..points as usize {
            let depth = -t.distance[k] - step.slop;
            let speed = (share * depth / step.h).min(step.fastest_push);
            let lacks = speed - parting(t, k, &a, &b);
            let wanted = if depth > 0.0 {
                pushes[k] + lacks / reply[k].max(SMALL)
            } else {
                0.0
            };
            let change = wanted.max(0.0) - pushes[k];
            pushes[k] += change;
            linear += change * t.normal;
            turning_a -= t.arm_a[k].cross(change * t.normal);
            turning_b += t.arm_b[k].cross(change * t.normal);
        }
        a.take(-linear, turning_a);
        b.take(linear, turning_b);
        pressed.push += linear;
        pressed.push_a += turning_a;
        pressed.push_b += turning_b;
    }
}
// ANCHOR_END: push_out

/// Whether a pair bounces at the end of the step: it had an impact faster than the threshold.
#[must_use]
pub fn bounces(approach: Vec4, material: &Material, step: &Step) -> bool {
    material.restitution > 0.0 && approach.min_element() < -step.restitution_threshold
}

// ANCHOR: restore_pair
/// What restitution adds at the end of a step: where an impact came with speed u, the bodies shall part
/// with e u; and the friction that goes with it. Shares are those among the pairs that bounce.
#[must_use]
pub fn restore_pair(
    m: &Manifold,
    material: &Material,
    approach: Vec4,
    sides: [Side; 2],
    step: &Step,
) -> Press {
    let [mut a, mut b] = sides;
    let mut added = Impulse::default();
    let t = touching(m, &a, &b);
    if !bounces(approach, material, step) {
        return Press::default();
    }
    let reply = replies(&t, m.points, &a, &b);
    for _ in 0..BOUNCE_SWEEPS {
        let mut linear = Vec3::ZERO;
        let mut turning_a = Vec3::ZERO;
        let mut turning_b = Vec3::ZERO;
        for k in 0..m.points as usize {
            let lacks = -material.restitution * approach[k] - parting(&t, k, &a, &b);
            let hits = approach[k] < -step.restitution_threshold;
            let wanted = if hits {
                added.normal[k] + lacks / reply[k].max(SMALL)
            } else {
                0.0
            };
            let change = wanted.max(0.0) - added.normal[k];
            added.normal[k] += change;
            linear += change * t.normal;
            turning_a -= t.arm_a[k].cross(change * t.normal);
            turning_b += t.arm_b[k].cross(change * t.normal);
        }
        a.take(-linear, turning_a);
        b.take(linear, turning_b);
        mend_friction(&t, m.points, &mut added, material, &mut a, &mut b);
    }
    press(&t, m.points, &added)
}
// ANCHOR_END: restore_pair
