// What the kernels that move bodies have in common: their columns, what a body gathers, and the kick of a
// substep.
// Needs common/trigonometry, common/rotation, common/rotation_vector, common/free_rotation, rows,
// common/pairing, common/mouse, common/body.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<uniform> mouse: Mouse;
@group(0) @binding(3) var<storage, read_write> rigids: array<Rigid>;
@group(0) @binding(4) var<storage, read_write> holdings: array<Holding>;
@group(0) @binding(5) var<storage, read_write> befores: array<Before>;
@group(0) @binding(6) var<storage, read> presses: array<Pressed>;
@group(0) @binding(7) var<storage, read> turned: array<Turned>;
@group(0) @binding(8) var<storage, read> totals: array<Total>;

// The plan: whether any pair bounces, there are joints, and any large body moves.
override BOUNCES: bool = true;
override JOINTS: bool = true;
override MOVING_LARGE: bool = true;

// The sum that a body begins with: nothing, or what a pass of its own has summed for a large one.
fn sum_before(large: u32) -> Total {
    var sum: Total;
    if MOVING_LARGE && large != NONE {
        sum = totals[large];
    }
    return sum;
}

// ANCHOR: given_by
// What a row did to the body on one side.
fn given_by(row: u32, side: u32) -> Given {
    return Given(
        vec4f(presses[row].linear, presses[row].counts),
        vec4f(presses[row].push, presses[row].bounces),
        presses[row].turning[2u * side],
        presses[row].turning[2u * side + 1u].xyz,
        select(-1.0, 1.0, side == 1u),
    );
}

// Adds what a limit or a loop did, by its entry in the body's list.
fn add_joint(sum: ptr<function, Total>, entry: u32) {
    if (entry & OF_LIMIT) != 0u {
        let sign = select(-1.0, 1.0, (entry & 1u) == 1u);
        add_turned(sum, turned[(entry & ~OF_LIMIT) >> 1u], sign);
        return;
    }
    var given = given_by(entry >> 1u, entry & 1u);
    given.linear.w = 1.0;
    given.angular.w = 1.0;
    add(sum, given);
}
// ANCHOR_END: given_by

// What the mouse pulls a body with: most with nothing.
fn pull_of_mouse(row: u32, rigid: Rigid) -> Pull {
    var pull: Pull;
    if mouse.body == row {
        pull = drag(rigid, mouse);
    }
    return pull;
}

// Notes how a body moves before the kick, and kicks it.
fn kick_row(
    row: u32,
    rigid: ptr<function, Rigid>,
    holding: ptr<function, Holding>,
    of_tree: Held,
    pull: Pull,
) {
    if BOUNCES {
        befores[row] = Before((*rigid).velocity, 0.0, (*rigid).angular_velocity, 0.0);
    }
    kick(rigid, holding, of_tree, pull, step);
}
