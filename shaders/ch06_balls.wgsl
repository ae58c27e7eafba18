// A substep of a ball, an invocation a ball: it solves all contacts that it has, from what all balls were
// before, gathers what they do to it, moves, and takes up what pulls and holds it for the next substep.
// The ball at the other end of a contact does the same sums, and finds the opposite.
// Needs common/index, common/trigonometry, common/rotation, common/rotation_vector, rows, common/ball.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<storage, read> walls: array<Wall>;
@group(0) @binding(3) var<storage, read> places: array<Place>;
@group(0) @binding(4) var<storage, read> movers: array<Mover>;
@group(0) @binding(5) var<storage, read> balls: array<Ball>;
@group(0) @binding(6) var<storage, read> neighbour_counts: array<u32>;
@group(0) @binding(7) var<storage, read> neighbours: array<u32>;
@group(0) @binding(8) var<storage, read_write> impulses: array<vec4f>;
@group(0) @binding(9) var<storage, read_write> approaches: array<f32>;
@group(0) @binding(10) var<storage, read_write> places_next: array<Place>;
@group(0) @binding(11) var<storage, read_write> movers_next: array<Mover>;
@group(0) @binding(12) var<storage, read_write> attitudes: array<vec4f>;
@group(0) @binding(13) var<storage, read_write> helds: array<Held>;
@group(0) @binding(14) var<storage, read_write> status: array<atomic<u32>>;

// The plan: whether all surfaces are alike, whether any bounces, and whether it is the last substep.
override ALIKE: bool = false;
override BOUNCES: bool = true;
override LAST: bool = false;

// What the contacts of a ball do to it.
struct Gathered {
    linear: vec3f,
    angular: vec3f,
    push: vec3f,
    // How many touch or soon may, and how many share the mass in the next pass.
    touches: f32,
    counts: f32,
}

// The other body of a contact.
fn other_of(own: Place, neighbour: u32) -> Other {
    if (neighbour & WALL) != 0u {
        return other_wall(own, walls[neighbour & ~WALL]);
    }
    var surface = balls[0];
    if !ALIKE {
        surface = balls[neighbour];
    }
    return other_ball(own, places[neighbour], movers[neighbour], surface);
}

// ANCHOR: note_impact
// The speed at the surface of what will touch in this substep, m/s, negative: u² = c² + 2 a s.
fn impact(other: Other, speed: f32, inverse_mass: f32) -> f32 {
    let closing = closing_pull(other, inverse_mass, step.gravity);
    let before = max(-speed - closing * step.h, 0.0);
    return -sqrt(max(before * before + 2.0 * closing * max(other.distance, 0.0), 0.0));
}
// ANCHOR_END: note_impact

// What friction gives of what it would take to hold.
fn coulomb(held: vec3f, pressed: f32, surface: Ball, other: Other) -> vec3f {
    let size = length(held);
    if size <= sqrt(surface.static_friction * other.static_friction) * pressed {
        return held;
    }
    return held * (sqrt(surface.friction * other.friction) * pressed / max(size, SMALL));
}

// ANCHOR: solve
@compute @workgroup_size(WORKGROUP)
fn solve(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows {
        return;
    }
    // All that doesn't depend on anything is asked for at once: what waits for memory waits once.
    let halted = atomicLoad(&status[HALTED]);
    let place = places[row];
    let mover = movers[row];
    let surface = balls[row];
    let count = neighbour_counts[row];
    var next = neighbours[row];
    if halted != 0u {
        return;
    }
    var sum: Gathered;
    for (var k = 0u; k < count; k++) {
        let slot = k * grid.capacity + row;
        let neighbour = next;
        next = neighbours[min(k + 1u, grid.room - 1u) * grid.capacity + row];
        solve_contact(slot, other_of(place, neighbour), place, mover, surface, &sum);
    }
    finish(row, place, mover, sum);
    if LAST && row == 0u {
        atomicAdd(&status[STEPS], 1u);
    }
}
// ANCHOR_END: solve

// ANCHOR: solve_contact
// Mends the impulse that the ball receives in a contact: friction in x, y, z, the normal impulse in w.
fn solve_contact(
    slot: u32,
    other: Other,
    place: Place,
    mover: Mover,
    surface: Ball,
    sum: ptr<function, Gathered>,
) {
    let arm = place.reach + 0.5 * other.distance;
    let shared_mass = mover.shares * mover.inverse_mass;
    let u = relative_velocity(other, mover.velocity, mover.angular_velocity, arm);
    let speed = dot(u, other.normal);
    let last = impulses[slot];
    let comes = other.distance + step.h * speed <= 0.0;
    let soon = other.distance <= 0.0 || other.distance + 2.0 * step.h * speed <= 0.0;
    if BOUNCES && comes {
        let hit = impact(other, speed, mover.inverse_mass);
        if hit < -step.restitution_threshold {
            approaches[slot] = min(approaches[slot], hit);
        }
    }
    var impulse = vec4f(0.0);
    if last.w > 0.0 || other.distance <= 0.0 || comes {
        let reply = shared_mass + other.shared_mass;
        let room = max(other.distance, 0.0) / step.h;
        impulse.w = max(last.w - (speed + room) / reply, 0.0);
        let sliding = u - speed * other.normal;
        let turning = mover.shares * arm * arm * inverse_moment(mover.inverse_mass, place.reach);
        let across = last.xyz - dot(last.xyz, other.normal) * other.normal;
        let held = across + sliding / (reply + turning + other.turning);
        let friction = coulomb(held, impulse.w, surface, other);
        impulse = vec4f(friction, impulse.w);
        let depth = -other.distance - step.slop;
        let push = min(step.push_share * max(depth, 0.0) / step.h, step.fastest_push) / reply;
        (*sum).linear += friction - other.normal * impulse.w;
        (*sum).angular += arm * cross(other.normal, friction);
        (*sum).push -= other.normal * push;
    }
    impulses[slot] = impulse;
    var counts = soon || impulse.w > 0.0;
    if LAST {
        let e = 0.5 * (surface.restitution + other.restitution);
        counts = BOUNCES && e > 0.0 && approaches[slot] < -step.restitution_threshold;
    }
    (*sum).touches += select(0.0, 1.0, soon || impulse.w > 0.0);
    (*sum).counts += select(0.0, 1.0, counts);
}
// ANCHOR_END: solve_contact

// ANCHOR: finish
// Puts what holds the ball now in the place of what it started with, and moves it. A ball that nothing
// touches falls as far as it should: by the mean of its speeds before and after gravity's kick.
fn finish(row: u32, place: Place, mover: Mover, sum: Gathered) {
    let held = helds[row];
    let inverse_mass = mover.inverse_mass;
    let moment = inverse_moment(inverse_mass, place.reach);
    var velocity = mover.velocity + (sum.linear - held.linear) * inverse_mass;
    var angular_velocity = mover.angular_velocity + (sum.angular - held.angular) * moment;
    let alone = sum.touches == 0.0 && inverse_mass > 0.0;
    let early = select(vec3f(0.0), 0.5 * step.h * step.gravity, alone);
    let moves = velocity + sum.push * inverse_mass - early;
    attitudes[row] = rotation_turned(attitudes[row], step.h * angular_velocity);
    if !LAST {
        velocity = kicked_velocity(velocity, inverse_mass, sum.linear, step);
        angular_velocity = (angular_velocity + sum.angular * moment) * step.drag;
    }
    places_next[row] = Place(place.position + step.h * moves, place.reach);
    let shares = max(sum.counts, 1.0);
    movers_next[row] = Mover(velocity, shares, angular_velocity, inverse_mass);
    helds[row] = Held(sum.linear, 0.0, sum.angular, 0.0);
}
// ANCHOR_END: finish
