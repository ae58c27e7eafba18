// Each ball looks for what it may touch in the step: walls, and balls in the 27 cells about its own.
// It takes over what it pressed on them in the last step, and starts the first substep.
// Needs common/index, common/rotation, rows, common/grid, common/ball.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> step: Step;
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read> walls: array<Wall>;
@group(0) @binding(4) var<storage, read> places: array<Place>;
@group(0) @binding(5) var<storage, read> movers: array<Mover>;
@group(0) @binding(6) var<storage, read> balls: array<Ball>;
@group(0) @binding(7) var<storage, read> old_rows: array<u32>;
@group(0) @binding(8) var<storage, read> last_counts: array<u32>;
@group(0) @binding(9) var<storage, read> last_neighbours: array<u32>;
@group(0) @binding(10) var<storage, read> last_impulses: array<vec4f>;
@group(0) @binding(11) var<storage, read_write> neighbour_counts: array<u32>;
@group(0) @binding(12) var<storage, read_write> neighbours: array<u32>;
@group(0) @binding(13) var<storage, read_write> impulses: array<vec4f>;
@group(0) @binding(14) var<storage, read_write> approaches: array<f32>;
@group(0) @binding(15) var<storage, read_write> places_next: array<Place>;
@group(0) @binding(16) var<storage, read_write> movers_next: array<Mover>;
@group(0) @binding(17) var<storage, read> fastest: array<u32>;
@group(0) @binding(18) var<storage, read_write> helds_next: array<Held>;
@group(0) @binding(19) var<storage, read_write> status: array<atomic<u32>>;

// Invocations of a workgroup, and how many of them have a ball together.
const GROUP: u32 = 64u;
override TEAM: u32 = 1u;
override SUMS: u32 = 1u;

// Most neighbours that a member of a team can note: it keeps them to itself until all have found theirs.
// One alone notes them where they will be listed.
const MOST_FOUND: u32 = 32u;

// What an invocation knows while it looks.
struct Finding {
    row: u32,
    place: Place,
    mover: Mover,
    // How much farther than they reach two balls may be apart, m.
    margin: f32,
    // Where its last neighbours are listed, how many there are, and where to look first.
    last_row: u32,
    last_count: u32,
    cursor: u32,
    // Its neighbours, and how many there are by now.
    found: array<u32, MOST_FOUND>,
    count: u32,
    // How many of them count, and what they press.
    counting: f32,
    held: Held,
}

// What the members of a team add up.
struct Sum {
    held: Held,
    counting: f32,
}

var<workgroup> counts: array<u32, GROUP>;
var<workgroup> sums: array<Sum, SUMS>;

// ANCHOR: look
// ANCHOR: note
// Looks through rows of the grid for balls that are near enough, and notes them. What is to be done with
// them waits: neighbours of a wavefront's balls turn up at different times, and each would hold up all.
fn look(finding: ptr<function, Finding>, first: u32, end: u32) {
    for (var row = first; row < end; row += 4u) {
        // Four are asked for at once: what waits for memory waits once for all.
        let last = end - 1u;
        let one = places[row];
        let two = places[min(row + 1u, last)];
        let three = places[min(row + 2u, last)];
        let four = places[min(row + 3u, last)];
        consider(finding, row, one, end);
        consider(finding, row + 1u, two, end);
        consider(finding, row + 2u, three, end);
        consider(finding, row + 3u, four, end);
    }
}

fn consider(finding: ptr<function, Finding>, row: u32, place: Place, end: u32) {
    let apart = place.position - (*finding).place.position;
    let near = (*finding).place.reach + place.reach + (*finding).margin;
    if dot(apart, apart) <= near * near && row != (*finding).row && row < end {
        note(finding, row);
    }
}

// Notes a neighbour; those beyond the room are only counted.
fn note(finding: ptr<function, Finding>, neighbour: u32) {
    if (*finding).count < room_to_note() {
        set_noted(finding, (*finding).count, neighbour);
    }
    (*finding).count += 1u;
}
// ANCHOR_END: note

fn room_to_note() -> u32 {
    return select(MOST_FOUND, grid.room, TEAM == 1u);
}

fn noted(finding: ptr<function, Finding>, k: u32) -> u32 {
    if TEAM == 1u {
        return neighbours[k * grid.capacity + (*finding).row];
    }
    return (*finding).found[k];
}

fn set_noted(finding: ptr<function, Finding>, k: u32, neighbour: u32) {
    if TEAM == 1u {
        neighbours[k * grid.capacity + (*finding).row] = neighbour;
    } else {
        (*finding).found[k] = neighbour;
    }
}
// ANCHOR_END: look

// ANCHOR: look_around
// Looks through all cells in which a ball may be that is near enough: lines along x, whose slots follow
// each other, except where a line wraps round. The members of a team take turns.
fn look_around(finding: ptr<function, Finding>, member: u32) {
    let slots = vec3u(grid.slots_x, grid.slots_y, grid.slots_z);
    let reach = (*finding).place.reach + grid.widest + (*finding).margin;
    let low = cell_of(grid, (*finding).place.position - reach);
    let high = cell_of(grid, (*finding).place.position + reach);
    let cells = min(vec3u(high - low) + 1u, slots);
    let first = wrap(low, slots).x;
    let to_end = min(cells.x, slots.x - first);
    for (var line = member; line < cells.y * cells.z; line += TEAM) {
        let cell = low + vec3i(0, i32(line % cells.y), i32(line / cells.y));
        let slot = slot_of(grid, cell);
        look(finding, starts[slot], starts[slot + to_end]);
        if to_end < cells.x {
            let line_start = slot - first;
            look(finding, starts[line_start], starts[line_start + cells.x - to_end]);
        }
    }
}
// ANCHOR_END: look_around

fn look_at_walls(finding: ptr<function, Finding>, member: u32) {
    let margin = grid.margin + length((*finding).mover.velocity) * grid.dt;
    for (var k = member; k < grid.walls; k += TEAM) {
        if other_wall((*finding).place, walls[k]).distance <= margin {
            note(finding, WALL | k);
        }
    }
}

// What a neighbour is to the ball.
fn other_of(finding: ptr<function, Finding>, neighbour: u32) -> Other {
    let own = (*finding).place;
    if (neighbour & WALL) != 0u {
        return other_wall(own, walls[neighbour & ~WALL]);
    }
    return other_ball(own, places[neighbour], movers[neighbour], balls[neighbour]);
}

// ANCHOR: keep
// Keeps those that may touch in the step: both balls of a pair must find the same.
fn keep(finding: ptr<function, Finding>) {
    if (*finding).count > room_to_note() {
        return;
    }
    var kept = 0u;
    for (var k = 0u; k < (*finding).count; k++) {
        let neighbour = noted(finding, k);
        let other = other_of(finding, neighbour);
        let speed = length(other.velocity - (*finding).mover.velocity);
        let margin = grid.margin + min(speed * grid.dt, grid.most_margin);
        if (neighbour & WALL) != 0u || other.distance <= margin {
            set_noted(finding, kept, neighbour);
            kept += 1u;
        }
    }
    (*finding).count = kept;
}
// ANCHOR_END: keep

// ANCHOR: last_impulse
// What the ball pressed on a neighbour in the last step. Lists hardly change from step to step, so the
// one that follows the last one found is nearly always the right one.
fn last_impulse(finding: ptr<function, Finding>, neighbour: u32) -> vec4f {
    var sought = neighbour;
    if (neighbour & WALL) == 0u {
        sought = old_rows[neighbour];
    }
    let count = (*finding).last_count;
    for (var n = 0u; n < count; n++) {
        var k = (*finding).cursor + n;
        k = select(k, k - count, k >= count);
        let slot = k * grid.capacity + (*finding).last_row;
        if last_neighbours[slot] == sought {
            (*finding).cursor = k + 1u;
            return last_impulses[slot];
        }
    }
    return vec4f(0.0);
}
// ANCHOR_END: last_impulse

// ANCHOR: take_over
// Writes a neighbour into the list; what it pressed goes on.
fn take_over(finding: ptr<function, Finding>, neighbour: u32, k: u32) {
    let other = other_of(finding, neighbour);
    let impulse = last_impulse(finding, neighbour);
    let slot = k * grid.capacity + (*finding).row;
    neighbours[slot] = neighbour;
    impulses[slot] = impulse;
    approaches[slot] = 0.0;
    let arm = (*finding).place.reach + 0.5 * other.distance;
    let mover = (*finding).mover;
    (*finding).held.linear += impulse.xyz - other.normal * impulse.w;
    (*finding).held.angular += arm * cross(other.normal, impulse.xyz);
    let u = relative_velocity(other, mover.velocity, mover.angular_velocity, arm);
    let meets = comes(other, u, (*finding).place.reach, step.h);
    if impulse.w > 0.0 || other.distance <= 0.0 || meets {
        (*finding).counting += 1.0;
    }
}
// ANCHOR_END: take_over

// ANCHOR: meet
@compute @workgroup_size(GROUP)
fn meet(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) own: u32) {
    let row = (group_index(group) * GROUP + own) / TEAM;
    let member = own % TEAM;
    var finding: Finding;
    finding.row = row;
    finding.place = places[row];
    finding.mover = movers[row];
    finding.last_row = old_rows[row];
    finding.last_count = last_counts[finding.last_row];
    let others = bitcast<f32>(fastest[atomicLoad(&status[STEPS]) & 1u]);
    let comes = (length(finding.mover.velocity) + others) * grid.dt;
    finding.margin = grid.margin + min(comes, grid.most_margin);
    let goes = row < grid.rows && atomicLoad(&status[NEEDED]) <= grid.room;
    let is_lost = row >= starts[slot_of_lost(grid)];
    if goes && !is_lost {
        look_at_walls(&finding, member);
        look_around(&finding, member);
        keep(&finding);
    }
    list(&finding, own, member, goes);
    if goes && member == 0u {
        start(finding);
    }
}

// Writes the list of neighbours: the members' finds one after the other. The first of the team has the
// sums then.
fn list(finding: ptr<function, Finding>, own: u32, member: u32, goes: bool) {
    let count = (*finding).count;
    counts[own] = count;
    workgroupBarrier();
    var before = 0u;
    for (var other = 1u; other <= member; other++) {
        before += counts[own - other];
    }
    // ANCHOR: room
    let fits = count <= room_to_note() && before + count <= grid.room;
    for (var k = 0u; goes && fits && k < count; k++) {
        take_over(finding, noted(finding, k), before + k);
    }
    if goes && member == TEAM - 1u {
        neighbour_counts[(*finding).row] = min(before + count, grid.room);
    }
    if goes && !fits {
        atomicMax(&status[NEEDED], max(before + count, grid.room + 1u));
    }
    // ANCHOR_END: room
    if TEAM > 1u {
        sums[own] = Sum((*finding).held, (*finding).counting);
        workgroupBarrier();
        for (var other = 1u; other < TEAM && member == 0u; other++) {
            (*finding).held.linear += sums[own + other].held.linear;
            (*finding).held.angular += sums[own + other].held.angular;
            (*finding).counting += sums[own + other].counting;
        }
    }
}

// The first kick of the step.
fn start(finding: Finding) {
    let row = finding.row;
    var mover = finding.mover;
    let moment = inverse_moment(mover.inverse_mass, finding.place.reach);
    let held = finding.held;
    if length(mover.velocity) * grid.dt > 0.5 * grid.most_margin {
        atomicAdd(&status[FAST], 1u);
    }
    mover.velocity = kicked_velocity(mover.velocity, mover.inverse_mass, held.linear, step);
    mover.angular_velocity = (mover.angular_velocity + held.angular * moment) * step.drag;
    mover.shares = max(finding.counting, 1.0);
    helds_next[row] = held;
    places_next[row] = finding.place;
    movers_next[row] = mover;
}
// ANCHOR_END: meet
