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
    if row >= grid.rows {
        return;
    }
    let needed = atomicLoad(&status[NEEDED]);
    let count = neighbour_counts[row];
    let own = movers[row];
    if needed > grid.room {
        return;
    }
    var mover = own;
    for (var k = 0u; k < count; k++) {
        let slot = k * grid.capacity + row;
        let approach = approaches[slot];
        if approach < -step.restitution_threshold {
            restore(&mover, own, row, neighbours[slot], approach);
        }
    }
    movers_next[row] = mover;
}

// What restitution adds in a contact, and the friction that goes with it.
fn restore(mover: ptr<function, Mover>, own: Mover, row: u32, neighbour: u32, approach: f32) {
    let place = places[row];
    let surface = balls[row];
    var other: Other;
    if (neighbour & WALL) != 0u {
        other = other_wall(place, walls[neighbour & ~WALL]);
    } else {
        other = other_ball(place, places[neighbour], movers[neighbour], balls[neighbour]);
    }
    let e = 0.5 * (surface.restitution + other.restitution);
    let arm = place.reach + 0.5 * other.distance;
    let moment = inverse_moment(own.inverse_mass, place.reach);
    let u = relative_velocity(other, own.velocity, own.angular_velocity, arm);
    let speed = dot(u, other.normal);
    let reply = own.shares * own.inverse_mass + other.shared_mass;
    let pressed = max((-e * approach - speed) / reply, 0.0);
    let spun = own.shares * arm * arm * moment;
    let held = (u - speed * other.normal) / (reply + spun + other.turning);
    let friction = coulomb(held, pressed, surface, other);
    (*mover).velocity += (friction - pressed * other.normal) * own.inverse_mass;
    (*mover).angular_velocity += arm * cross(other.normal, friction) * moment;
}
// ANCHOR_END: bounce
