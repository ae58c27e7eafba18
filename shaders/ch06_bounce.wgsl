// Restitution, once at the end of a step: where an impact came with speed u, the two shall part with e u.
// A ball's mass is shared among those of its contacts that bounce.
// Needs common/index, common/rotation, rows, common/ball.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<storage, read> walls: array<Wall>;
@group(0) @binding(3) var<storage, read> places: array<Place>;
@group(0) @binding(4) var<storage, read> movers: array<Mover>;
@group(0) @binding(5) var<storage, read> balls: array<Ball>;
@group(0) @binding(6) var<storage, read> neighbour_counts: array<u32>;
@group(0) @binding(7) var<storage, read> neighbours: array<u32>;
@group(0) @binding(8) var<storage, read> approaches: array<f32>;
@group(0) @binding(9) var<storage, read_write> movers_next: array<Mover>;
@group(0) @binding(10) var<storage, read_write> status: array<atomic<u32>>;

// ANCHOR: bounce
@compute @workgroup_size(WORKGROUP)
fn bounce(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || atomicLoad(&status[HALTED]) != 0u {
        return;
    }
    var mover = movers[row];
    var velocity = mover.velocity;
    let count = neighbour_counts[row];
    for (var k = 0u; k < count; k++) {
        let slot = k * grid.capacity + row;
        let approach = approaches[slot];
        if approach < -step.restitution_threshold {
            velocity -= added(row, neighbours[slot], approach) * mover.inverse_mass;
        }
    }
    mover.velocity = velocity;
    movers_next[row] = mover;
}

// What restitution adds along the normal of a contact, N s.
fn added(row: u32, neighbour: u32, approach: f32) -> vec3f {
    let own = places[row];
    let mover = movers[row];
    var other: Other;
    if (neighbour & WALL) != 0u {
        other = other_wall(own, walls[neighbour & ~WALL]);
    } else {
        other = other_ball(own, places[neighbour], movers[neighbour], balls[neighbour]);
    }
    let e = 0.5 * (balls[row].restitution + other.restitution);
    let speed = dot(other.velocity - mover.velocity, other.normal);
    let reply = mover.shares * mover.inverse_mass + other.shared_mass;
    return other.normal * max((-e * approach - speed) / reply, 0.0);
}
// ANCHOR_END: bounce
