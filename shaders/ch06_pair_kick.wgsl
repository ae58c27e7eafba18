// The kick of a substep where what pulls a body depends on where others are: magnetic poles. So all have
// moved before any takes up what pulls it.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector,
// common/free_rotation, rows, common/pairing, common/body.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<uniform> mouse: Mouse;
@group(0) @binding(3) var<uniform> pairs_of: PairsOf;
@group(0) @binding(4) var<storage, read> poles: array<Pole>;
@group(0) @binding(5) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(6) var<storage, read_write> holdings: array<Holding>;
@group(0) @binding(7) var<storage, read_write> befores: array<Before>;
@group(0) @binding(8) var<storage, read> status: array<u32>;
@group(0) @binding(9) var<storage, read> joined: array<Held>;

// The plan: whether any pair bounces, and whether there are joints.
override BOUNCES: bool = true;
override JOINTS: bool = true;

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
    var pull: Pull;
    for (var own = 0u; own < pairs_of.poles; own++) {
        if poles[own].body == row {
            let felt = feel(own, rigid);
            pull.acceleration += felt.acceleration;
            pull.torque += felt.torque;
        }
    }
    if mouse.body == row {
        let dragged = drag(rigid, mouse);
        pull.acceleration += dragged.acceleration;
        pull.torque += dragged.torque;
    }
    if BOUNCES {
        befores[row] = Before(rigid.velocity, 0.0, rigid.angular_velocity, 0.0);
    }
    var holding = holdings[row];
    var of_tree: Held;
    if JOINTS && in_tree(rigid) {
        of_tree = joined[rigid.seat];
    }
    kick(&rigid, &holding, of_tree, pull, step);
    rigids[row].velocity = rigid.velocity;
    rigids[row].angular_velocity = rigid.angular_velocity;
    holdings[row].momentum = holding.momentum;
}
