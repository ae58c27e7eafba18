// Where the points of a pair are now, and what the pair presses there. Names as in
// `ch06_compute::own_row::contact`.
// Needs common/rotation, rows, common/narrow_core, common/narrow_spots, common/side.

// The plan: the most points that a pair of the scene's kinds can have.
override POINTS: u32 = 4u;

// ANCHOR: touching
struct Touching {
    // From a to b.
    normal: vec3f,
    // Mean distance of the points from their mean, m.
    spread: f32,
    // s: how far apart the surfaces are at each point, m; negative inside.
    distance: vec4f,
    // r: from a's centre to each point, m.
    arm_a: array<vec3f, 4>,
    // r × n of each point, r from a's centre, m. An impulse λ n there turns a by −λ r × n.
    lever_a: array<vec3f, 4>,
    // The same, from b's centre.
    lever_b: array<vec3f, 4>,
    // From a's centre to the mean of the points, m.
    mean_a: vec3f,
    // From b's centre, m.
    mean_b: vec3f,
    // From a's centre to b's, m.
    apart: vec3f,
    // What the surfaces of round bodies are away from their core points together, m; negative where they
    // aren't round.
    reach: f32,
    // How many points there are.
    points: u32,
}

// Where the points are for bodies where they are now: both arms of a point end at the same place, so
// that what one body gains in angular momentum the other loses.
fn touching(m: ptr<function, Manifold>, sides: ptr<function, Sides>) -> Touching {
    let apart = (*sides).b.position - (*sides).a.position;
    let turn_a = quat_matrix((*sides).a.attitude);
    let turn_b = quat_matrix((*sides).b.attitude);
    let points = (*m).points;
    var core_a: array<vec3f, 4>;
    var core_b: array<vec3f, 4>;
    var line = vec3f(0.0);
    for (var k = 0u; k < POINTS; k++) {
        if k < points {
            core_a[k] = turn_a * (*m).core_a[k].xyz;
            core_b[k] = apart + turn_b * (*m).core_b[k].xyz;
            line += core_b[k] - core_a[k];
        }
    }
    var t: Touching;
    t.normal = normal_now((*m).normal, (*m).turns, turn_a, turn_b, line);
    let share = 1.0 / f32(max(points, 1u));
    for (var k = 0u; k < POINTS; k++) {
        if k < points {
            let gap = core_b[k] - core_a[k];
            t.distance[k] = dot(gap, t.normal) - (*m).round_a - (*m).round_b;
            let arm = middle(m, core_a[k], core_b[k], t.normal, t.distance[k]);
            t.lever_a[k] = cross(arm, t.normal);
            t.lever_b[k] = cross(arm - apart, t.normal);
            t.mean_a += arm * share;
            t.arm_a[k] = arm;
        }
    }
    t.mean_b = t.mean_a - apart;
    t.apart = apart;
    t.reach = select(-1.0, (*m).round_a + (*m).round_b, (*m).turns == ROUND);
    t.points = points;
    for (var k = 0u; k < POINTS; k++) {
        if k < points && points > 1u {
            t.spread += length(t.arm_a[k] - t.mean_a) * share;
        }
    }
    return t;
}

// Where two surfaces meet: in the middle of the gap. On a round body that is along the normal from its
// core point; a point fixed in a face would lag behind a body that rolls on.
fn middle(m: ptr<function, Manifold>, core_a: vec3f, core_b: vec3f, normal: vec3f, distance: f32) -> vec3f {
    if (*m).round_a > 0.0 {
        return core_a + ((*m).round_a + 0.5 * distance) * normal;
    }
    if (*m).round_b > 0.0 {
        return core_b - ((*m).round_b + 0.5 * distance) * normal;
    }
    return 0.5 * (core_a + core_b);
}

// The normal for bodies where they are now.
fn normal_now(normal: vec3f, turns: u32, turn_a: mat3x3f, turn_b: mat3x3f, line: vec3f) -> vec3f {
    switch turns {
        case WITH_A: {
            return turn_a * normal;
        }
        case WITH_B: {
            return turn_b * normal;
        }
        case FIXED: {
            return normal;
        }
        default: {
            let size = length(line);
            return select(normal, line / max(size, SMALL), size > SMALL);
        }
    }
}
// ANCHOR_END: touching

// Speed of b away from a along the normal at point k, m/s.
fn parting(t: ptr<function, Touching>, k: u32, sides: ptr<function, Sides>) -> f32 {
    return dot((*t).normal, (*sides).b.velocity - (*sides).a.velocity)
        + dot((*t).lever_b[k], (*sides).b.angular_velocity)
        - dot((*t).lever_a[k], (*sides).a.angular_velocity);
}

// The same before the kick.
fn parting_before(t: ptr<function, Touching>, k: u32, sides: ptr<function, Sides>) -> f32 {
    return dot((*t).normal, (*sides).b.before.velocity - (*sides).a.before.velocity)
        + dot((*t).lever_b[k], (*sides).b.before.angular_velocity)
        - dot((*t).lever_a[k], (*sides).a.before.angular_velocity);
}

// Velocity of b away from a where both arms end, m/s.
fn sliding_at(arm_a: vec3f, arm_b: vec3f, sides: ptr<function, Sides>) -> vec3f {
    return (*sides).b.velocity + cross((*sides).b.angular_velocity, arm_b)
        - (*sides).a.velocity - cross((*sides).a.angular_velocity, arm_a);
}

// ANCHOR: passes
// Whether two round bodies that come nearer pass each other within `h` seconds: the nearest that their core
// points come is farther than both radii.
fn passes(t: ptr<function, Touching>, k: u32, sides: ptr<function, Sides>, h: f32) -> bool {
    let reach = (*t).reach;
    if reach < 0.0 || (*t).distance[k] <= 0.0 {
        return false;
    }
    let apart = ((*t).distance[k] + reach) * (*t).normal;
    let arm = (*t).arm_a[k];
    let moves = h * sliding_at(arm, arm - (*t).apart, sides);
    let part = clamp(-dot(apart, moves) / max(dot(moves, moves), SMALL), 0.0, 1.0);
    let nearest = apart + part * moves;
    return dot(nearest, nearest) > reach * reach;
}
// ANCHOR_END: passes

// Whether the bodies come so near within `h` seconds that they touch at point k.
fn comes(t: ptr<function, Touching>, k: u32, sides: ptr<function, Sides>, h: f32) -> bool {
    return (*t).distance[k] + h * parting(t, k, sides) <= 0.0 && !passes(t, k, sides, h);
}

// Whether they touch at point k, or come to within `h` seconds.
fn meets(t: ptr<function, Touching>, k: u32, sides: ptr<function, Sides>, h: f32) -> bool {
    return (*t).distance[k] <= 0.0 || comes(t, k, sides, h);
}

// ANCHOR: press
// The impulses of a pair as its bodies receive them.
fn press(t: ptr<function, Touching>, impulse: Impulse) -> Press {
    var pressed: Press;
    pressed.stays = 1.0;
    for (var k = 0u; k < POINTS; k++) {
        if k < (*t).points {
            pressed.linear += impulse.normal[k] * (*t).normal;
            pressed.angular_a -= impulse.normal[k] * (*t).lever_a[k];
            pressed.angular_b += impulse.normal[k] * (*t).lever_b[k];
        }
    }
    let twist = impulse.twist * (*t).normal;
    pressed.linear += impulse.friction;
    pressed.angular_a -= cross((*t).mean_a, impulse.friction) + twist;
    pressed.angular_b += cross((*t).mean_b, impulse.friction) + twist;
    return pressed;
}
// ANCHOR_END: press

// A `Press` as bodies gather it.
fn pressed_of(pressed: Press, bounces: f32) -> Pressed {
    return Pressed(
        pressed.linear,
        pressed.counts,
        pressed.push,
        bounces,
        array<vec4f, 4>(
            vec4f(pressed.angular_a, pressed.stays),
            vec4f(pressed.push_a, 0.0),
            vec4f(pressed.angular_b, pressed.stays),
            vec4f(pressed.push_b, 0.0),
        ),
    );
}

// ANCHOR: press_again
// What a pair starts a step with: the impulses that it ended the last one with, where its points are
// now; and whether it counts.
fn press_again(m: ptr<function, Manifold>, impulse: Impulse, sides: ptr<function, Sides>, h: f32) -> Press {
    var t = touching(m, sides);
    var pressed = press(&t, impulse);
    for (var k = 0u; k < POINTS; k++) {
        if k < t.points {
            if impulse.normal[k] > 0.0 || meets(&t, k, sides, h) {
                pressed.counts = 1.0;
            }
        }
    }
    return pressed;
}
// ANCHOR_END: press_again
