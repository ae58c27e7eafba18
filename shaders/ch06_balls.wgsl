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
@group(0) @binding(13) var<storage, read> helds: array<Held>;
@group(0) @binding(14) var<storage, read_write> helds_next: array<Held>;
@group(0) @binding(15) var<storage, read_write> status: array<atomic<u32>>;

// The plan: whether all surfaces are alike, whether any bounces, and whether it is the last substep.
override ALIKE: bool = false;
override BOUNCES: bool = true;
override LAST: bool = false;

// Invocations of a workgroup, and how many of them have a ball together.
const GROUP: u32 = 64u;
override TEAM: u32 = 1u;
// As many as GROUP where there are teams, and 1 where there are none and nothing is to be added up.
override SUMS: u32 = 1u;

// What the contacts of a ball do to it.
struct Gathered {
    linear: vec3f,
    angular: vec3f,
    // Those of the impulses with which the next substep begins: all but impacts.
    stays_linear: vec3f,
    stays_angular: vec3f,
    push: vec3f,
    // How many touch or soon may, and how many share the mass in the next pass.
    touches: f32,
    counts: f32,
}

var<workgroup> sums: array<Gathered, SUMS>;

// The other body of a contact.
fn other_of(own: Place, neighbour: u32) -> Other {
    if (neighbour & WALL) != 0u {
        return other_wall(own, walls[neighbour & ~WALL]);
    }
    return other_ball(own, places[neighbour], movers[neighbour], surface_of(neighbour));
}

// Its surface: where all are alike, that of the first.
fn surface_of(row: u32) -> Ball {
    if ALIKE {
        return balls[0];
    }
    return balls[row];
}

// ANCHOR: note_impact
// How a ball moved before the substep's kick. Just after it what holds the ball may be out of balance,
// and a light ball between heavy ones seems fast.
fn velocity_before(velocity: vec3f, inverse_mass: f32, held: vec3f) -> vec3f {
    let pulled = select(vec3f(0.0), step.h * step.gravity, inverse_mass > 0.0);
    return velocity / step.drag - pulled - held * inverse_mass;
}

// The speed at the surface of what will touch in this substep, m/s, negative: u² = c² + 2 a s.
fn impact(other: Other, neighbour: u32, mover: Mover, held: vec3f) -> f32 {
    let own = velocity_before(mover.velocity, mover.inverse_mass, held);
    var others = other.velocity;
    if (neighbour & WALL) == 0u {
        others = velocity_before(other.velocity, other.inverse_mass, helds[neighbour].linear);
    }
    let closing = closing_pull(other, mover.inverse_mass, step.gravity);
    let before = max(-dot(others - own, other.normal), 0.0);
    return -sqrt(max(before * before + 2.0 * closing * max(other.distance, 0.0), 0.0));
}
// ANCHOR_END: note_impact

// Whether a new contact is an impact rather than the beginning of rest: then its impulse is over with the
// substep. Begun with again, it would be taken back only in part, and make energy.
fn is_impact(given: vec3f, inverse_masses: f32) -> bool {
    return length(given) * inverse_masses > step.impact_speed;
}

// ANCHOR: solve
// A team of invocations has a ball: the first of them its 1st, 5th, 9th contact, the second its 2nd, 6th
// … Where there are few balls, a team is done sooner than one alone; where there are many, teams of one
// do. What they gathered is summed in the order of the team.
@compute @workgroup_size(GROUP)
fn solve(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) own: u32) {
    let row = (group_index(group) * GROUP + own) / TEAM;
    let member = own % TEAM;
    // ANCHOR: solve_one
    // All that doesn't depend on anything is asked for at once: what waits for memory waits once.
    let needed = atomicLoad(&status[NEEDED]);
    let place = places[row];
    let mover = movers[row];
    let held = helds[row];
    let surface = surface_of(row);
    let count = neighbour_counts[row];
    var next = neighbours[member * grid.capacity + row];
    let goes = row < grid.rows && needed <= grid.room;
    var sum: Gathered;
    for (var k = member; goes && k < count; k += TEAM) {
        let slot = k * grid.capacity + row;
        let neighbour = next;
        next = neighbours[min(k + TEAM, grid.room - 1u) * grid.capacity + row];
        solve_contact(slot, neighbour, place, mover, held, surface, &sum);
    }
    // ANCHOR_END: solve_one
    if TEAM > 1u {
        sums[own] = sum;
        workgroupBarrier();
        if member == 0u {
            for (var other = 1u; other < TEAM; other++) {
                sum = total(sum, sums[own + other]);
            }
        }
    }
    if goes && member == 0u {
        finish(row, place, mover, held, sum);
        if LAST && row == 0u {
            atomicAdd(&status[STEPS], 1u);
        }
    }
}

fn total(one: Gathered, other: Gathered) -> Gathered {
    return Gathered(
        one.linear + other.linear,
        one.angular + other.angular,
        one.stays_linear + other.stays_linear,
        one.stays_angular + other.stays_angular,
        one.push + other.push,
        one.touches + other.touches,
        one.counts + other.counts,
    );
}
// ANCHOR_END: solve

// ANCHOR: solve_contact
// Mends the impulse that the ball receives in a contact: friction in x, y, z, the normal impulse in w.
fn solve_contact(
    slot: u32,
    neighbour: u32,
    place: Place,
    mover: Mover,
    held: Held,
    surface: Ball,
    sum: ptr<function, Gathered>,
) {
    let other = other_of(place, neighbour);
    let arm = place.reach + 0.5 * other.distance;
    let shared_mass = mover.shares * mover.inverse_mass;
    let u = relative_velocity(other, mover.velocity, mover.angular_velocity, arm);
    let speed = dot(u, other.normal);
    let last = impulses[slot];
    let meets = comes(other, u, place.reach, step.h);
    var touches = other.distance <= 0.0 || comes(other, u, place.reach, 2.0 * step.h);
    // What holds it for a moment only adds speed: what is slow even with it is no impact.
    if BOUNCES && meets && speed < -0.5 * step.restitution_threshold {
        let hit = impact(other, neighbour, mover, held.linear);
        approaches[slot] = min(approaches[slot], hit);
    }
    var impulse = vec4f(0.0);
    if last.w > 0.0 || other.distance <= 0.0 || meets {
        let reply = shared_mass + other.shared_mass;
        let room = max(other.distance, 0.0) / step.h;
        impulse.w = max(last.w - (speed + room) / reply, 0.0);
        let sliding = u - speed * other.normal;
        let spun = mover.shares * arm * arm * inverse_moment(mover.inverse_mass, place.reach);
        let across = last.xyz - dot(last.xyz, other.normal) * other.normal;
        let held = across + sliding / (reply + spun + other.turning);
        let friction = coulomb(held, impulse.w, surface, other);
        impulse = vec4f(friction, impulse.w);
        let depth = -other.distance - step.slop;
        let push = min(step.push_share * max(depth, 0.0) / step.h, step.fastest_push) / reply;
        let given = friction - other.normal * impulse.w;
        let turning = arm * cross(other.normal, friction);
        (*sum).linear += given;
        (*sum).angular += turning;
        (*sum).push -= other.normal * push;
        touches = touches || impulse.w > 0.0;
        if last.w == 0.0 && is_impact(given, mover.inverse_mass + other.inverse_mass) {
            impulse = vec4f(0.0);
        } else {
            (*sum).stays_linear += given;
            (*sum).stays_angular += turning;
        }
    }
    impulses[slot] = impulse;
    var counts = touches;
    if LAST {
        let e = 0.5 * (surface.restitution + other.restitution);
        counts = BOUNCES && e > 0.0 && approaches[slot] < -step.restitution_threshold;
    }
    (*sum).touches += select(0.0, 1.0, touches);
    (*sum).counts += select(0.0, 1.0, counts);
}
// ANCHOR_END: solve_contact

// ANCHOR: finish
// Puts what holds the ball now in the place of what it started with, and moves it. A ball that nothing
// touches falls as far as it should: by the mean of its speeds before and after gravity's kick.
fn finish(row: u32, place: Place, mover: Mover, held: Held, sum: Gathered) {
    let inverse_mass = mover.inverse_mass;
    let moment = inverse_moment(inverse_mass, place.reach);
    var velocity = mover.velocity + (sum.linear - held.linear) * inverse_mass;
    var angular_velocity = mover.angular_velocity + (sum.angular - held.angular) * moment;
    let alone = sum.touches == 0.0 && inverse_mass > 0.0;
    let early = select(vec3f(0.0), 0.5 * step.h * step.gravity, alone);
    let moves = velocity + sum.push * inverse_mass - early;
    attitudes[row] = rotation_turned(attitudes[row], step.h * angular_velocity);
    if !LAST {
        velocity = kicked_velocity(velocity, inverse_mass, sum.stays_linear, step);
        angular_velocity = (angular_velocity + sum.stays_angular * moment) * step.drag;
    }
    places_next[row] = Place(place.position + step.h * moves, place.reach);
    let shares = max(sum.counts, 1.0);
    movers_next[row] = Mover(velocity, shares, angular_velocity, inverse_mass);
    helds_next[row] = Held(sum.stays_linear, 0.0, sum.stays_angular, 0.0);
}
// ANCHOR_END: finish
