// What a pair of bodies does in a substep: the contact of the own-row method. Names as in
// `ch06_compute::own_row::contact`, where the method is told.
// Needs common/rotation, rows, common/narrow_core, common/narrow_spots, common/side, common/touching.

// Sweeps over the points and the friction of a pair of more than one point.
const INNER_SWEEPS: u32 = 2u;

// Sweeps over the points of a pair that bounces.
const BOUNCE_SWEEPS: u32 = 16u;

// ANCHOR: note_impacts
// Notes how fast the points come that will touch in this substep; says whether one touches or may touch
// in the next. The speed is that at the surface: u² = c² + 2 a s, with c the speed of approach before the
// substep's kick.
fn note_impacts(
    t: ptr<function, Touching>,
    approach: ptr<function, vec4f>,
    sides: ptr<function, Sides>,
    step: Step,
) -> bool {
    var soon = false;
    let closing = closing_pull((*t).normal, sides, step.gravity);
    for (var k = 0u; k < POINTS; k++) {
        if k < (*t).points {
            if comes(t, k, sides, step.h) {
                let before = max(-parting_before(t, k, sides), 0.0);
                let squared = before * before + 2.0 * closing * max((*t).distance[k], 0.0);
                (*approach)[k] = min((*approach)[k], -sqrt(max(squared, 0.0)));
            }
            soon = soon || meets(t, k, sides, 2.0 * step.h);
        }
    }
    return soon;
}

// The acceleration with which gravity brings a and b together along the normal, m/s².
fn closing_pull(normal: vec3f, sides: ptr<function, Sides>, gravity: vec3f) -> f32 {
    let along = dot(gravity, normal);
    return select(0.0, along, (*sides).a.inverse_mass > 0.0)
        - select(0.0, along, (*sides).b.inverse_mass > 0.0);
}
// ANCHOR_END: note_impacts

// Whether a point is active. If none is, the pair presses no more.
fn activate(t: ptr<function, Touching>, impulse: Impulse, sides: ptr<function, Sides>, h: f32) -> bool {
    var is_active = false;
    for (var k = 0u; k < POINTS; k++) {
        if k < (*t).points {
            is_active = is_active || impulse.normal[k] > 0.0 || meets(t, k, sides, h);
        }
    }
    return is_active;
}

// ANCHOR: replies
// Dₖ = Σⱼ |Aₖⱼ|, 1/kg, where Aₖⱼ is what a unit impulse at point j makes of the speed at point k.
fn replies(t: ptr<function, Touching>, sides: ptr<function, Sides>) -> vec4f {
    var sums = vec4f(0.0);
    let masses = (*sides).a.shared_mass + (*sides).b.shared_mass;
    for (var k = 0u; k < POINTS; k++) {
        if k < (*t).points {
            let turned_a = (*sides).a.shared_inertia * (*t).lever_a[k];
            let turned_b = (*sides).b.shared_inertia * (*t).lever_b[k];
            for (var j = 0u; j < POINTS; j++) {
                if j < (*t).points {
                    let turns = dot((*t).lever_a[j], turned_a) + dot((*t).lever_b[j], turned_b);
                    sums[k] += abs(masses + turns);
                }
            }
        }
    }
    return sums;
}
// ANCHOR_END: replies

// ANCHOR: mend_normals
// Mends the normal impulses of all points at once. A point that is still apart may come as near as it
// touches; impulses may be taken back but never pull.
fn mend_normals(
    t: ptr<function, Touching>,
    impulse: ptr<function, Impulse>,
    reply: vec4f,
    sides: ptr<function, Sides>,
    h: f32,
) {
    var linear = 0.0;
    var turning_a = vec3f(0.0);
    var turning_b = vec3f(0.0);
    for (var k = 0u; k < POINTS; k++) {
        if k < (*t).points {
            let room = max((*t).distance[k], 0.0) / h;
            let last = (*impulse).normal[k];
            let wanted = last - (parting(t, k, sides) + room) / max(reply[k], SMALL);
            let change = max(wanted, 0.0) - last;
            (*impulse).normal[k] = last + change;
            linear += change;
            turning_a -= change * (*t).lever_a[k];
            turning_b += change * (*t).lever_b[k];
        }
    }
    take_both(sides, linear * (*t).normal, turning_a, turning_b);
}
// ANCHOR_END: mend_normals

// ANCHOR: mend_friction
// Mends friction at the mean of the points: against sliding, and against turning about the normal. Static
// friction holds as long as μ_s allows; beyond it the pair slips and kinetic friction is left.
fn mend_friction(
    t: ptr<function, Touching>,
    impulse: ptr<function, Impulse>,
    material: Material,
    reply: f32,
    sides: ptr<function, Sides>,
) {
    let pressed = dot((*impulse).normal, vec4f(1.0));
    let normal = (*t).normal;
    if (*t).points > 1u {
        mend_twist(t, impulse, material, pressed, sides);
    }
    let sliding = sliding_at((*t).mean_a, (*t).mean_b, sides);
    let last = (*impulse).friction;
    let held = last - dot(last, normal) * normal - (sliding - dot(sliding, normal) * normal) / reply;
    (*impulse).friction = coulomb(held, pressed, material);
    let change = (*impulse).friction - last;
    take_both(sides, change, -cross((*t).mean_a, change), cross((*t).mean_b, change));
}

// What friction gives of what it would take to hold.
fn coulomb(held: vec3f, pressed: f32, material: Material) -> vec3f {
    let size = length(held);
    if size <= material.static_friction * pressed {
        return held;
    }
    return held * (material.friction * pressed / max(size, SMALL));
}

// Friction against turning about the normal, with the points' spread as its arm.
fn mend_twist(
    t: ptr<function, Touching>,
    impulse: ptr<function, Impulse>,
    material: Material,
    pressed: f32,
    sides: ptr<function, Sides>,
) {
    let normal = (*t).normal;
    let reply = dot(normal, (*sides).a.shared_inertia * normal + (*sides).b.shared_inertia * normal);
    let rate = dot(normal, (*sides).b.angular_velocity - (*sides).a.angular_velocity);
    let most = material.friction * pressed * (*t).spread;
    let last = (*impulse).twist;
    (*impulse).twist = clamp(last - rate / max(reply, SMALL), -most, most);
    let change = ((*impulse).twist - last) * normal;
    take_both(sides, vec3f(0.0), -change, change);
}

// The larger of what a unit impulse makes of the sliding speed in two directions across the normal, 1/kg.
fn sliding_reply(t: ptr<function, Touching>, sides: ptr<function, Sides>) -> f32 {
    let one = across((*t).normal);
    let two = cross((*t).normal, one);
    let along = max(sliding_along(t, one, sides), sliding_along(t, two, sides));
    return max((*sides).a.shared_mass + (*sides).b.shared_mass + along, SMALL);
}

fn sliding_along(t: ptr<function, Touching>, direction: vec3f, sides: ptr<function, Sides>) -> f32 {
    let on_a = cross((*t).mean_a, direction);
    let on_b = cross((*t).mean_b, direction);
    return dot(on_a, (*sides).a.shared_inertia * on_a) + dot(on_b, (*sides).b.shared_inertia * on_b);
}
// ANCHOR_END: mend_friction

// ANCHOR: push_out
// Pushes bodies that are inside each other apart: a velocity that moves them in this substep and is then
// forgotten, so that no speed is left of it. The bodies must not move.
fn push_out(
    t: ptr<function, Touching>,
    reply: vec4f,
    sides: ptr<function, Sides>,
    step: Step,
    pressed: ptr<function, Press>,
) {
    var pushes = vec4f(0.0);
    let share = select(step.push_share, step.push_share_of_many, (*t).points > 1u);
    let sweeps = select(1u, INNER_SWEEPS, (*t).points > 1u);
    for (var sweep = 0u; sweep < sweeps; sweep++) {
        var linear = 0.0;
        var turning_a = vec3f(0.0);
        var turning_b = vec3f(0.0);
        for (var k = 0u; k < POINTS; k++) {
            if k < (*t).points {
                let depth = -(*t).distance[k] - step.slop;
                let speed = min(share * depth / step.h, step.fastest_push);
                let lacks = speed - parting(t, k, sides);
                let wanted = select(0.0, pushes[k] + lacks / max(reply[k], SMALL), depth > 0.0);
                let change = max(wanted, 0.0) - pushes[k];
                pushes[k] += change;
                linear += change;
                turning_a -= change * (*t).lever_a[k];
                turning_b += change * (*t).lever_b[k];
            }
        }
        take_both(sides, linear * (*t).normal, turning_a, turning_b);
        (*pressed).push += linear * (*t).normal;
        (*pressed).push_a += turning_a;
        (*pressed).push_b += turning_b;
    }
}
// ANCHOR_END: push_out

// ANCHOR: solve_pair
// A substep of a pair: it mends its impulses so that the bodies, with the share of their masses that it
// has, no longer approach where they touch, and don't slide where friction holds them.
fn solve_pair(
    m: ptr<function, Manifold>,
    material: Material,
    impulse: ptr<function, Impulse>,
    approach: ptr<function, vec4f>,
    sides: ptr<function, Sides>,
    step: Step,
) -> Press {
    var t = touching(m, sides);
    let soon = note_impacts(&t, approach, sides, step);
    let pressed_before = any((*impulse).normal > vec4f(0.0));
    var pressed: Press;
    if activate(&t, *impulse, sides, step.h) {
        let reply = replies(&t, sides);
        let sliding = sliding_reply(&t, sides);
        let sweeps = select(1u, INNER_SWEEPS, t.points > 1u);
        for (var sweep = 0u; sweep < sweeps; sweep++) {
            mend_normals(&t, impulse, reply, sides, step.h);
            mend_friction(&t, impulse, material, sliding, sides);
        }
        pressed = press(&t, *impulse);
        stop_both(sides);
        push_out(&t, reply, sides, step, &pressed);
    } else {
        *impulse = Impulse();
    }
    let presses = any((*impulse).normal > vec4f(0.0));
    pressed.counts = select(0.0, 1.0, soon || presses);
    if !pressed_before && is_impact(pressed, (*sides).a.inverse_mass + (*sides).b.inverse_mass, step) {
        pressed.stays = 0.0;
        *impulse = Impulse();
    }
    return pressed;
}
// ANCHOR_END: solve_pair

// Whether what a pair newly pressed is an impact rather than the beginning of rest.
fn is_impact(pressed: Press, inverse_masses: f32, step: Step) -> bool {
    return length(pressed.linear) * inverse_masses > step.impact_speed;
}

// Whether a pair bounces at the end of the step: it had an impact faster than the threshold.
fn bounces(approach: vec4f, material: Material, step: Step) -> bool {
    let fastest = min(min(approach.x, approach.y), min(approach.z, approach.w));
    return material.restitution > 0.0 && fastest < -step.restitution_threshold;
}

// ANCHOR: restore_pair
// What restitution adds at the end of a step: where an impact came with speed u, the bodies shall part
// with e u; and the friction that goes with it. Shares are those among the pairs that bounce.
fn restore_pair(
    m: ptr<function, Manifold>,
    material: Material,
    approach: vec4f,
    sides: ptr<function, Sides>,
    step: Step,
) -> Press {
    var t = touching(m, sides);
    let reply = replies(&t, sides);
    let sliding = sliding_reply(&t, sides);
    var added: Impulse;
    for (var sweep = 0u; sweep < BOUNCE_SWEEPS; sweep++) {
        var linear = 0.0;
        var turning_a = vec3f(0.0);
        var turning_b = vec3f(0.0);
        for (var k = 0u; k < POINTS; k++) {
            if k < t.points {
                let lacks = -material.restitution * approach[k] - parting(&t, k, sides);
                let hits = approach[k] < -step.restitution_threshold;
                let wanted = select(0.0, added.normal[k] + lacks / max(reply[k], SMALL), hits);
                let change = max(wanted, 0.0) - added.normal[k];
                added.normal[k] += change;
                linear += change;
                turning_a -= change * t.lever_a[k];
                turning_b += change * t.lever_b[k];
            }
        }
        take_both(sides, linear * t.normal, turning_a, turning_b);
        mend_friction(&t, &added, material, sliding, sides);
    }
    return press(&t, added);
}
// ANCHOR_END: restore_pair
