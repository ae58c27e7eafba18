// The kick of a substep where what pulls a body depends on where others are: magnetic poles. So all have
// moved before any takes up what pulls it.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/mouse, common/body, common/moving.

@group(0) @binding(9) var<uniform> pairs_of: PairsOf;
@group(0) @binding(10) var<storage, read> poles: array<Pole>;
@group(0) @binding(11) var<storage, read> status: array<u32>;
@group(0) @binding(12) var<storage, read> joined: array<Held>;

// ANCHOR: pole
// The force, N, of one magnetic pole on another that is `between` away, m: s₁ s₂/(d² + ε²).
fn pole_force(between: vec3f, strength: f32, softening: f32) -> vec3f {
    let squared = dot(between, between);
    if squared == 0.0 {
        return vec3f(0.0);
    }
    return between * (strength / ((squared + softening * softening) * sqrt(squared)));
}
// ANCHOR_END: pole

// From the origin of its body to a pole, in the world, m.
fn arm_of(pole: Pole) -> vec3f {
    return quat_rotate(rigids[pole.body].attitude, pole.place);
}

// ANCHOR: feel
// What a pole feels of all others of its force that sit in other bodies.
fn feel(own: u32, rigid: Rigid) -> Pull {
    let pole = poles[own];
    let arm = quat_rotate(rigid.attitude, pole.place);
    let here = rigid.position + arm;
    var sum: Pull;
    for (var k = 0u; k < pairs_of.poles; k++) {
        let other = poles[k];
        if other.force != pole.force || other.body == pole.body {
            continue;
        }
        let there = rigids[other.body].position + arm_of(other);
        let force = pole_force(here - there, pole.strength * other.strength, pole.softening);
        sum.acceleration += force * rigid.inverse_mass;
        sum.torque += cross(arm, force);
    }
    return sum;
}
// ANCHOR_END: feel

// What its poles feel, and the mouse.
fn pull_of(row: u32, rigid: Rigid) -> Pull {
    var pull: Pull;
    for (var own = 0u; own < pairs_of.poles; own++) {
        if poles[own].body == row {
            let felt = feel(own, rigid);
            pull.acceleration += felt.acceleration;
            pull.torque += felt.torque;
        }
    }
    let dragged = pull_of_mouse(row, rigid);
    pull.acceleration += dragged.acceleration;
    pull.torque += dragged.torque;
    return pull;
}

@compute @workgroup_size(WORKGROUP)
fn pair_kick(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    var rigid = rigids[row];
    if is_static(rigid) {
        return;
    }
    let pull = pull_of(row, rigid);
    var holding = holdings[row];
    var of_tree: Held;
    if JOINTS && in_tree(rigid) {
        of_tree = joined[rigid.seat];
    }
    kick_row(row, &rigid, &holding, of_tree, pull);
    rigids[row].velocity = rigid.velocity;
    rigids[row].angular_velocity = rigid.angular_velocity;
    holdings[row].momentum = holding.momentum;
}
