// What an angle limit does in a substep: it reads both bodies and mends its own angular impulses. Names as in
// `ch06_compute::own_row::limits`, where it is told.
// Needs common/trigonometry, common/rotation, common/rotation_vector, common/swing_twist, rows, common/side,
// common/symmetric, common/point_reply.

// The plan: whether any joint has limits of pitch, yaw and roll.
override EULER_LIMITS: bool = true;

// An angle that no turn reaches, rad.
const FREE_ANGLE: f32 = 10.0;
const WHOLE: f32 = 3.14159265;
// A limit this near, rad, counts; one further away than FAR is left alone.
const NEAR: f32 = 0.02;
const FAR: f32 = 0.35;
// The share of what is beyond a bound that a substep turns back, and the fastest push, rad/s.
const TURN_SHARE: f32 = 0.2;
const FASTEST_TURN: f32 = 4.0;
// What is beyond by less than this, rad, is left to the push; the share of the rest that the impulse turns
// back in a substep, and the fastest that it does, rad/s.
const TURN_SLOP: f32 = 0.01;
const RETURN_SHARE: f32 = 0.05;
const GENTLE_TURN: f32 = 0.25;

// ANCHOR: bounded
// A turn that is limited.
struct Bounded {
    // u: a unit vector, along which the angle grows.
    axis: vec3f,
    // C: how much further it may turn towards the nearer bound, rad; of a turn that is locked, how far it
    // is above.
    room: f32,
    // 1 if the nearer bound is below, −1 if it is above, 0 if there is none.
    side: f32,
    is_locked: bool,
}
// ANCHOR_END: bounded

// ANCHOR: within
// The nearer bound of an angle whose rate is `axis`·ω.
fn within(angle: f32, low: f32, high: f32, axis: vec3f) -> Bounded {
    var turn: Bounded;
    let size = length(axis);
    if (low <= -WHOLE && high >= WHOLE) || size < SMALL_SINE {
        return turn;
    }
    let above = angle - low;
    let below = high - angle;
    turn.is_locked = low == high;
    let is_low = above < below || turn.is_locked;
    turn.axis = axis / size;
    turn.room = select(below, above, is_low) / size;
    turn.side = select(-1.0, 1.0, is_low);
    return turn;
}
// ANCHOR_END: within

// ANCHOR: turns
// The turns that are limited, at these attitudes: tilt, twist and none, or pitch, yaw and roll.
fn turns_of(limit: Limit, a: vec4f, b: vec4f) -> array<Bounded, 3> {
    let rest = quat_product(a, limit.frame_a);
    let frame = quat_product(b, limit.frame_b);
    let y_rest = quat_rotate(rest, vec3f(0.0, 1.0, 0.0));
    let y = quat_rotate(frame, vec3f(0.0, 1.0, 0.0));
    let parts = decompose(quat_product(quat_conjugate(rest), frame));
    let low = limit.low;
    let high = limit.high;
    var turns: array<Bounded, 3>;
    turns[1] = within(parts.twist, low.y, high.y, twist_axis(y_rest, y));
    if EULER_LIMITS && limit.kind == EULER {
        let axes = swing_axes(rest, parts.swing, y);
        turns[0] = within(parts.swing.x, low.x, high.x, axes.pitch);
        turns[2] = within(parts.swing.z, low.z, high.z, axes.roll);
        return turns;
    }
    let tilt = cone(y_rest, y);
    turns[0] = within(tilt.w, -FREE_ANGLE, high.x, tilt.xyz);
    return turns;
}
// ANCHOR_END: turns

// ANCHOR: pinned
// The joint's point, about which both turn.
struct Pinned {
    arm_a: vec3f,
    arm_b: vec3f,
    // K⁻¹: the impulse at the point that goes with a parting there, kg.
    holding: Symmetric,
}

fn pinned_of(limit: Limit, sides: ptr<function, Sides>) -> Pinned {
    let arm_a = quat_rotate((*sides).a.attitude, limit.anchor_a);
    let arm_b = quat_rotate((*sides).b.attitude, limit.anchor_b);
    let reply = symmetric_plus(point_reply((*sides).a, arm_a), point_reply((*sides).b, arm_b));
    return Pinned(arm_a, arm_b, symmetric_inverse(reply, (*sides).a.shared_mass + (*sides).b.shared_mass));
}

// How an angular impulse on b, and its opposite on a, changes the spins of both.
struct Spins {
    a: vec3f,
    b: vec3f,
}

fn turned_by(pinned: Pinned, sides: ptr<function, Sides>, turning: vec3f) -> Spins {
    let turn_a = (*sides).a.shared_inertia * turning;
    let turn_b = (*sides).b.shared_inertia * turning;
    let parting = cross(turn_b, pinned.arm_b) + cross(turn_a, pinned.arm_a);
    let held = symmetric_times(pinned.holding, parting);
    return Spins(
        (*sides).a.shared_inertia * cross(pinned.arm_a, held) - turn_a,
        turn_b - (*sides).b.shared_inertia * cross(pinned.arm_b, held),
    );
}

// The relative spin that an angular impulse makes.
fn spin_of(pinned: Pinned, sides: ptr<function, Sides>, turning: vec3f) -> vec3f {
    let spins = turned_by(pinned, sides, turning);
    return spins.b - spins.a;
}

// What the limit alone makes of its two bodies.
fn turn_both(pinned: Pinned, sides: ptr<function, Sides>, turning: vec3f) {
    let spins = turned_by(pinned, sides, turning);
    (*sides).a.angular_velocity += spins.a;
    (*sides).b.angular_velocity += spins.b;
}
// ANCHOR_END: pinned

// What is left of an impulse: nothing, if the nearer bound is another one than it came from.
fn still_holds(turn: Bounded, impulse: f32) -> f32 {
    if turn.side == 0.0 || turn.room > FAR {
        return 0.0;
    }
    return select(turn.side * max(turn.side * impulse, 0.0), impulse, turn.is_locked);
}

// ANCHOR: solve_turn
// Mends the impulse of one turn, and pushes back what is beyond its bound. Gives the impulse.
fn solve_turn(
    turn: Bounded,
    pinned: Pinned,
    impulse: f32,
    gives: ptr<function, Turned>,
    sides: ptr<function, Sides>,
    h: f32,
) -> f32 {
    if turn.side == 0.0 || turn.room > FAR {
        return impulse;
    }
    let reply = max(dot(turn.axis, spin_of(pinned, sides, turn.axis)), SMALL_SINE);
    let rate = dot(turn.axis, (*sides).b.angular_velocity - (*sides).a.angular_velocity);
    let back = returning(max(-turn.room - TURN_SLOP, 0.0), h);
    let off = turn.side * rate + max(turn.room, 0.0) / h - back;
    let bounded = turn.side * max(turn.side * impulse - off / reply, 0.0);
    let locked = impulse - (rate - returning(-turn.room, h)) / reply;
    let wanted = select(bounded, locked, turn.is_locked);
    let change = (wanted - impulse) * turn.axis;
    (*gives).turning += change;
    turn_both(pinned, sides, change);
    let pushed = dot(turn.axis, spin_of(pinned, sides, (*gives).push));
    (*gives).push += turn.axis * pushed_back(turn, pushed, reply, h);
    return wanted;
}

// How fast the impulse turns back what is beyond, rad/s.
fn returning(beyond: f32, h: f32) -> f32 {
    return clamp(beyond * (RETURN_SHARE / h), -GENTLE_TURN, GENTLE_TURN);
}

// The turning push that turns back what is beyond a bound, N m s, where others push at this rate.
fn pushed_back(turn: Bounded, pushed: f32, reply: f32, h: f32) -> f32 {
    let wanted = clamp(turn.room * (-TURN_SHARE / h), -FASTEST_TURN, FASTEST_TURN);
    if turn.is_locked {
        return (wanted - pushed) / reply;
    }
    if turn.room >= 0.0 {
        return 0.0;
    }
    return turn.side * max((wanted - turn.side * pushed) / reply, 0.0);
}
// ANCHOR_END: solve_turn

// Whether a turn is at its bound or may be in the next substep.
fn is_near(turn: Bounded, sides: ptr<function, Sides>, h: f32) -> bool {
    let rate = turn.side * dot(turn.axis, (*sides).b.angular_velocity - (*sides).a.angular_velocity);
    return turn.side != 0.0 && (turn.is_locked || turn.room + 2.0 * h * rate < NEAR);
}

// What a limit is after a substep, and what it does to its bodies.
struct SolvedLimit {
    impulses: vec3f,
    gives: Turned,
}

// ANCHOR: solve_limit
// Mends the impulses of a limit so that its bodies, with the share of their masses that it has, don't turn
// beyond a bound. `before` is what it gave them in the last substep; it works now only if it counted then.
fn solve_limit(limit: Limit, before: Turned, sides: ptr<function, Sides>, h: f32) -> SolvedLimit {
    let turns = turns_of(limit, (*sides).a.attitude, (*sides).b.attitude);
    var impulses = vec3f(0.0);
    var gives: Turned;
    if before.counts > 0.0 {
        let pinned = pinned_of(limit, sides);
        impulses = vec3f(
            still_holds(turns[0], limit.impulses.x),
            still_holds(turns[1], limit.impulses.y),
            still_holds(turns[2], limit.impulses.z),
        );
        gives.turning = impulses.x * turns[0].axis + impulses.y * turns[1].axis
            + impulses.z * turns[2].axis;
        turn_both(pinned, sides, gives.turning - before.turning);
        // First the swing, then the twist, each from the velocities that the one before left.
        impulses.x = solve_turn(turns[0], pinned, impulses.x, &gives, sides, h);
        if EULER_LIMITS {
            impulses.z = solve_turn(turns[2], pinned, impulses.z, &gives, sides, h);
        }
        impulses.y = solve_turn(turns[1], pinned, impulses.y, &gives, sides, h);
    }
    let near = is_near(turns[0], sides, h) || is_near(turns[1], sides, h)
        || is_near(turns[2], sides, h);
    gives.counts = select(0.0, 1.0, near || any(impulses != vec3f(0.0)));
    return SolvedLimit(impulses, gives);
}
// ANCHOR_END: solve_limit
