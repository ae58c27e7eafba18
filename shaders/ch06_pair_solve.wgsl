// A substep of the pairs and the angle limits, an invocation each: from what both bodies are now it mends its
// own impulses. Limits come first; where their workgroups end, those of the pairs begin.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector, common/swing_twist,
// rows, common/narrow_core, common/narrow_spots, common/side, common/touching, common/contact,
// common/symmetric, common/point_reply, common/limit.

@group(0) @binding(0) var<uniform> step: Step;
@group(0) @binding(1) var<storage, read> live: array<vec4u>;
@group(0) @binding(2) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(3) var<storage, read> touches: array<Contact>;
@group(0) @binding(4) var<storage, read_write> memories: array<Memory>;
@group(0) @binding(5) var<storage, read_write> presses: array<Pressed>;
@group(0) @binding(6) var<storage, read> status: array<u32>;
@group(0) @binding(7) var<storage, read> befores: array<Before>;
@group(0) @binding(8) var<uniform> pairs_of: PairsOf;

@group(0) @binding(9) var<storage, read_write> limits: array<Limit>;
@group(0) @binding(10) var<storage, read_write> turned: array<Turned>;

// The plan: whether any pair bounces, whether there are angle limits, and whether it is the last substep.
override BOUNCES: bool = true;
override LIMITS: bool = true;
override LAST: bool = false;

// The contact of a pair with so many points.
fn manifold_of(pair: u32, points: u32) -> Manifold {
    var m: Manifold;
    m.normal = touches[pair].normal;
    m.turns = touches[pair].turns;
    m.round_a = touches[pair].round_a;
    m.round_b = touches[pair].round_b;
    m.points = points;
    for (var k = 0u; k < POINTS; k++) {
        if k < points {
            m.core_a[k] = touches[pair].cores[2u * k];
            m.core_b[k] = touches[pair].cores[2u * k + 1u];
        }
    }
    return m;
}

fn material_of(pair: u32) -> Material {
    return Material(
        touches[pair].restitution,
        touches[pair].friction,
        touches[pair].static_friction,
        0.0,
    );
}

@compute @workgroup_size(WORKGROUP)
fn pair_solve(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if LIMITS && row < pairs_of.limits {
        solve_limit_row(row);
    }
    let before = invocations_of_limits();
    if row >= before && row - before < status[LIVE] {
        solve_live(live[row - before]);
    }
}

// What the workgroups of limits have, in whole workgroups.
fn invocations_of_limits() -> u32 {
    if !LIMITS {
        return 0u;
    }
    return (pairs_of.limits + WORKGROUP - 1u) / WORKGROUP * WORKGROUP;
}

fn solve_limit_row(row: u32) {
    let limit = limits[row];
    var sides = Sides(side_of(rigids[limit.a]), side_of(rigids[limit.b]));
    let solved = solve_limit(limit, turned[row], &sides, step.h);
    limits[row].impulses = solved.impulses;
    turned[row] = solved.gives;
}

// ANCHOR: solve
// A pair whose points press or may touch: its row and its bodies' rows were noted when the step began.
fn solve_live(noted: vec4u) {
    let pair = noted.x;
    var m = manifold_of(pair, noted.w);
    let material = material_of(pair);
    var impulse = Impulse(memories[pair].normal, memories[pair].friction, memories[pair].twist);
    var approach = vec4f(0.0);
    if BOUNCES {
        approach = memories[pair].approach;
    }
    var sides = Sides(side_of(rigids[noted.y]), side_of(rigids[noted.z]));
    if BOUNCES {
        sides.a.before = befores[noted.y];
        sides.b.before = befores[noted.z];
    }
    let pressed = solve_pair(&m, material, &impulse, &approach, &sides, step);
    memories[pair].normal = impulse.normal;
    memories[pair].friction = impulse.friction;
    memories[pair].twist = impulse.twist;
    if BOUNCES {
        memories[pair].approach = approach;
    }
    let hits = BOUNCES && LAST && bounces(approach, material, step);
    presses[pairs_of.before + pair] = pressed_of(pressed, select(0.0, 1.0, hits));
}
// ANCHOR_END: solve

// ANCHOR: restore
// Restitution, once at the end of a step: a body's mass is now shared among the pairs that bounce.
@compute @workgroup_size(WORKGROUP)
fn pair_restore(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= status[LIVE] {
        return;
    }
    let noted = live[row];
    let pair = noted.x;
    let material = material_of(pair);
    let approach = memories[pair].approach;
    var pressed: Press;
    if bounces(approach, material, step) {
        var m = manifold_of(pair, noted.w);
        var sides = Sides(side_of(rigids[noted.y]), side_of(rigids[noted.z]));
        pressed = restore_pair(&m, material, approach, &sides, step);
    }
    presses[pairs_of.before + pair] = pressed_of(pressed, 0.0);
}
// ANCHOR_END: restore
