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
@group(0) @binding(17) var<storage, read_write> helds: array<Held>;
@group(0) @binding(18) var<storage, read_write> status: array<atomic<u32>>;

// What an invocation gathers while it looks.
struct Finding {
    row: u32,
    place: Place,
    mover: Mover,
    // Where its last neighbours are listed, how many there are, and where to look first.
    last_row: u32,
    last_count: u32,
    cursor: u32,
    // How many neighbours it has by now, and how many of them count.
    count: u32,
    counting: f32,
    held: Held,
}

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

// ANCHOR: add
// Adds a neighbour, if there is room; what it pressed goes on.
fn add(finding: ptr<function, Finding>, neighbour: u32, other: Other) {
    let k = (*finding).count;
    (*finding).count = k + 1u;
    if k >= grid.room {
        return;
    }
    let impulse = last_impulse(finding, neighbour);
    let slot = k * grid.capacity + (*finding).row;
    neighbours[slot] = neighbour;
    impulses[slot] = impulse;
    approaches[slot] = 0.0;
    let own = (*finding).place;
    let arm = own.reach + 0.5 * other.distance;
    let pressed = impulse.xyz - other.normal * impulse.w;
    (*finding).held.linear += pressed;
    (*finding).held.angular += arm * cross(other.normal, impulse.xyz);
    let mover = (*finding).mover;
    let u = relative_velocity(other, mover.velocity, mover.angular_velocity, arm);
    let comes = other.distance + step.h * dot(u, other.normal) <= 0.0;
    if impulse.w > 0.0 || other.distance <= 0.0 || comes {
        (*finding).counting += 1.0;
    }
}
// ANCHOR_END: add

// ANCHOR: look
// Looks through rows of the grid.
fn look(finding: ptr<function, Finding>, first: u32, end: u32) {
    let own = (*finding).place;
    for (var row = first; row < end; row++) {
        let place = places[row];
        let apart = place.position - own.position;
        let near = own.reach + place.reach + grid.most_margin;
        if dot(apart, apart) > near * near || row == (*finding).row {
            continue;
        }
        let mover = movers[row];
        let other = other_ball(own, place, mover, balls[row]);
        let speed = length(mover.velocity - (*finding).mover.velocity);
        if other.distance <= min(grid.margin + speed * grid.dt, grid.most_margin) {
            add(finding, row, other);
        }
    }
}
// ANCHOR_END: look

// ANCHOR: look_around
// Looks through the 27 cells about the ball's own, nine lines of three. Three neighbours along x are
// three slots in a row, unless the line wraps round.
fn look_around(finding: ptr<function, Finding>) {
    let cell = cell_of(grid, (*finding).place.position);
    let x = u32(cell.x - 1) & (grid.slots_x - 1u);
    let pieces = select(1u, 3u, x + 2u >= grid.slots_x);
    for (var line = 0; line < 9; line++) {
        for (var piece = 0u; piece < pieces; piece++) {
            let offset = vec3i(i32(piece) - 1, line % 3 - 1, line / 3 - 1);
            let slot = slot_of(grid, cell + offset);
            let last = slot + select(3u, 1u, pieces == 3u);
            look(finding, starts[slot], starts[last]);
        }
    }
}
// ANCHOR_END: look_around

fn look_at_walls(finding: ptr<function, Finding>) {
    let own = (*finding).place;
    for (var k = 0u; k < grid.walls; k++) {
        let other = other_wall(own, walls[k]);
        if other.distance <= grid.margin + length((*finding).mover.velocity) * grid.dt {
            add(finding, WALL | k, other);
        }
    }
}

// ANCHOR: meet
@compute @workgroup_size(WORKGROUP)
fn meet(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || atomicLoad(&status[HALTED]) != 0u {
        return;
    }
    var finding: Finding;
    finding.row = row;
    finding.place = places[row];
    finding.mover = movers[row];
    finding.last_row = old_rows[row];
    finding.last_count = last_counts[finding.last_row];
    let is_lost = row >= starts[slot_of_lost(grid)];
    if !is_lost {
        look_at_walls(&finding);
        look_around(&finding);
    }
    neighbour_counts[row] = min(finding.count, grid.room);
    helds[row] = finding.held;
    if finding.count > grid.room {
        atomicMax(&status[NEEDED], finding.count);
    }
    if length(finding.mover.velocity) * grid.dt > 0.5 * grid.most_margin {
        atomicAdd(&status[FAST], 1u);
    }
    start(finding);
}

// The first kick of the step.
fn start(finding: Finding) {
    let row = finding.row;
    var mover = finding.mover;
    let moment = inverse_moment(mover.inverse_mass, finding.place.reach);
    mover.velocity = kicked_velocity(mover.velocity, mover.inverse_mass, finding.held.linear, step);
    mover.angular_velocity = (mover.angular_velocity + finding.held.angular * moment) * step.drag;
    mover.shares = max(finding.counting, 1.0);
    places_next[row] = finding.place;
    movers_next[row] = mover;
}
// ANCHOR_END: meet

// ANCHOR: halt
// A step whose neighbours have no room isn't made: nothing is written until there is more.
@compute @workgroup_size(1)
fn halt() {
    if atomicLoad(&status[NEEDED]) > grid.room {
        atomicStore(&status[HALTED], 1u);
    }
}
// ANCHOR_END: halt
