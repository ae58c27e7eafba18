// The narrow phase over the pairs of one kind: where each touches or soon may. What it pressed in the
// last step goes on where the same features still touch.
// Needs common/index, common/rotation, rows, common/narrow_core, common/narrow_features,
// common/narrow_spots, common/narrow_faces, common/narrow_edges, common/narrow_axis,
// common/narrow_simplex, common/narrow_gjk, common/narrow_way, common/narrow_contacts,
// common/narrow_convex, common/narrow_ball, common/narrow_capsule, common/narrow, common/pairing,
// common/side, common/touching.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(3) var<storage, read> last_partners: array<Partner>;
@group(0) @binding(4) var<storage, read> last_memories: array<Memory>;
@group(0) @binding(5) var<storage, read_write> touches: array<Contact>;
@group(0) @binding(6) var<storage, read_write> memories: array<Memory>;
@group(0) @binding(7) var<storage, read_write> presses: array<Pressed>;
@group(0) @binding(8) var<storage, read_write> live: array<vec4u>;
@group(0) @binding(9) var<storage, read_write> status: array<atomic<u32>>;
@group(0) @binding(10) var<uniform> pairs_of: PairsOf;

// The kind of the pairs, and where it is listed.
override PAIR_KIND: u32 = 0u;
override SLOT: u32 = 0u;

// How many pairs of this workgroup touch or soon may, and where they are noted.
var<workgroup> found: atomic<u32>;
var<workgroup> noted: u32;

fn posed(rigid: Rigid) -> Posed {
    return Posed(rigid.position, rigid.kind, rigid.size, rigid.attitude);
}

// How far apart two bodies may be and still be a pair: what they may come nearer in the step, m.
fn margin_of(a: Rigid, b: Rigid) -> f32 {
    let speed = length(b.velocity - a.velocity);
    let tip_a = select(length(a.angular_velocity) * a.reach, 0.0, a.kind == 0u);
    let tip_b = select(length(b.angular_velocity) * b.reach, 0.0, b.kind == 0u);
    return grid.margin + (speed + tip_a + tip_b) * grid.dt;
}

// ANCHOR: last_pair
// The row that the pair had in the last step, from the list of the body that lists it.
fn last_pair(row: u32, other: u32) -> u32 {
    let count = last_partners[row].body;
    for (var k = 1u; k <= count; k++) {
        let entry = last_partners[k * grid.capacity + row];
        if (entry.body & BODY) == other {
            return entry.pair;
        }
    }
    return NONE;
}
// ANCHOR_END: last_pair

// ANCHOR: carry
// The impulses of the last step on the points of this one: those of the same feature.
fn carry(old: u32, m: ptr<function, Manifold>) -> Memory {
    var memory: Memory;
    for (var k = 0u; k < POINTS; k++) {
        if k < (*m).points {
            memory.features[k] = (*m).core_a[k].w;
        }
    }
    if old == NONE {
        return memory;
    }
    let last = last_memories[old];
    let features = bitcast<vec4u>(last.features);
    for (var k = 0u; k < POINTS; k++) {
        if k < (*m).points {
            let same = features == vec4u(bitcast<u32>((*m).core_a[k].w));
            if any(same) {
                memory.normal[k] = dot(select(vec4f(0.0), last.normal, same), vec4f(1.0));
                memory.friction = last.friction;
                // A single point has no arm against turning.
                memory.twist = select(0.0, last.twist, (*m).points > 1u);
            }
        }
    }
    return memory;
}
// ANCHOR_END: carry

fn contact_of(rows: vec2u, m: ptr<function, Manifold>, a: Rigid, b: Rigid) -> Contact {
    var contact: Contact;
    contact.a = rows.x;
    contact.b = rows.y;
    contact.normal = (*m).normal;
    contact.turns = (*m).turns;
    contact.round_a = (*m).round_a;
    contact.round_b = (*m).round_b;
    contact.restitution = 0.5 * (a.restitution + b.restitution);
    contact.friction = sqrt(a.friction * b.friction);
    contact.static_friction = sqrt(a.static_friction * b.static_friction);
    contact.points = (*m).points;
    for (var k = 0u; k < POINTS; k++) {
        contact.cores[2u * k] = (*m).core_a[k];
        contact.cores[2u * k + 1u] = (*m).core_b[k];
    }
    return contact;
}

// ANCHOR: meet
// Finds where a pair touches, and presses again. Says how many points there are.
fn meet_pair(pair: u32, rows: vec2u) -> u32 {
    let a = rigids[rows.x];
    let b = rigids[rows.y];
    var m = manifold_of_kind(PAIR_KIND, posed(a), posed(b), margin_of(a, b));
    if m.points == 0u {
        touches[pair].points = 0u;
        memories[pair].features = vec4f(0.0);
        return 0u;
    }
    let b_lists = a.role == LARGE && b.role != LARGE;
    let listed = select(rows, rows.yx, b_lists);
    let old = last_pair(listed.x, listed.y);
    let memory = carry(old, &m);
    touches[pair] = contact_of(rows, &m, a, b);
    memories[pair] = memory;
    var sides = Sides(side_of(a), side_of(b));
    let impulse = Impulse(memory.normal, memory.friction, memory.twist);
    let pressed = press_again(&m, impulse, &sides, step.h);
    presses[pairs_of.before + pair] = pressed_of(pressed, 0.0);
    return m.points;
}

@compute @workgroup_size(WORKGROUP)
fn pair_meet(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let pair = atomicLoad(&status[KIND_FIRST + SLOT]) + row_index(id);
    let is_one = pair < atomicLoad(&status[KIND_FIRST + SLOT + 1u]);
    if lane == 0u {
        atomicStore(&found, 0u);
    }
    workgroupBarrier();
    var points = 0u;
    var rows = vec2u(0u);
    var place = 0u;
    if is_one {
        rows = vec2u(touches[pair].a, touches[pair].b);
        points = meet_pair(pair, rows);
        if points > 0u {
            place = atomicAdd(&found, 1u);
        }
    }
    workgroupBarrier();
    if lane == 0u {
        noted = atomicAdd(&status[LIVE], atomicLoad(&found));
    }
    workgroupBarrier();
    if points > 0u {
        live[noted + place] = vec4u(pair, rows.x, rows.y, points);
    }
}
// ANCHOR_END: meet
