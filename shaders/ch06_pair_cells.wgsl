// Where each body may be in the step, which slot of the grid it is in, and how many are in each. Behind
// all slots are those that the grid doesn't hold: large bodies, fast ones, which all others look at
// wherever they are, those that touch nothing, and those that are not finite.
// Needs common/index, common/rotation, rows, common/grid, common/pairing.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(2) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(3) var<storage, read_write> bounds: array<Bound>;
@group(0) @binding(4) var<storage, read_write> slots: array<u32>;
@group(0) @binding(5) var<storage, read_write> counts: array<atomic<u32>>;
@group(0) @binding(6) var<storage, read_write> status: array<atomic<u32>>;

// The half width of a body along each axis, m: chapter 3's `Aabb::of_shape`.
fn half_widths(rigid: Rigid) -> vec3f {
    let axes = quat_matrix(rigid.attitude);
    let size = rigid.size;
    let up = abs(axes[1]);
    switch rigid.kind {
        case 0u: {
            return vec3f(size.x);
        }
        case 1u: {
            return abs(axes[0]) * size.x + up * size.y + abs(axes[2]) * size.z;
        }
        case 2u: {
            return up * size.y + vec3f(size.x);
        }
        default: {
            // A disc with the normal y reaches r √(1 − y_i²) along axis i.
            return up * size.y + sqrt(max(vec3f(1.0) - up * up, vec3f(0.0))) * size.x;
        }
    }
}

// How far a body looks beyond itself, m: half the margin, and what it may move.
fn ahead(rigid: Rigid, is_static: bool) -> f32 {
    if is_static {
        return 0.5 * grid.margin;
    }
    let turning = select(length(rigid.angular_velocity) * rigid.reach, 0.0, rigid.kind == 0u);
    return 0.5 * grid.margin + (length(rigid.velocity) + turning) * grid.dt;
}

fn is_whole(rigid: Rigid) -> bool {
    return all_finite(rigid.position) && all_finite(rigid.velocity)
        && all_finite(rigid.angular_velocity) && all_finite(rigid.attitude.xyz)
        && is_finite(rigid.attitude.w);
}

// The farthest that a body of the workgroup looks ahead, and how many look farther than half a cell, a cell
// and two: so that not every row asks for the same number in memory.
var<workgroup> ahead_here: atomic<u32>;
var<workgroup> beyond_here: array<atomic<u32>, 3>;

fn note_far(far: f32) {
    for (var k = 0u; k < 3u; k++) {
        if far > 0.5 * f32(1u << k) * grid.edge {
            atomicAdd(&beyond_here[k], 1u);
        }
    }
}

// ANCHOR: cells
@compute @workgroup_size(WORKGROUP)
fn pair_cells(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let row = row_index(id);
    if lane == 0u {
        atomicStore(&ahead_here, 0u);
    }
    if lane < 3u {
        atomicStore(&beyond_here[lane], 0u);
    }
    workgroupBarrier();
    if row < grid.rows && atomicLoad(&status[HALTED]) == 0u {
        bound_row(row);
    }
    workgroupBarrier();
    if lane == 0u {
        atomicMax(&status[AHEAD], atomicLoad(&ahead_here));
    }
    if lane < 3u {
        atomicAdd(&status[HALF_CELL + lane], atomicLoad(&beyond_here[lane]));
    }
}

fn bound_row(row: u32) {
    let rigid = rigids[row];
    let is_static = rigid.inverse_mass == 0.0 && all(rigid.inverse_inertia == vec3f(0.0));
    let kind = row | (rigid.kind << KIND_SHIFT) | select(0u, STATIC, is_static);
    var slot = slot_of_lost(grid);
    // A box that holds nothing.
    var bound = Bound(vec3f(1.0), kind, vec3f(-1.0), 0u);
    if !is_whole(rigid) {
        atomicAdd(&status[NOT_FINITE], 1u);
        atomicMin(&status[FIRST_NOT_FINITE], row);
    } else if rigid.role != ON_POINT {
        let far = ahead(rigid, is_static);
        let reach = half_widths(rigid) + far;
        bound.low = rigid.position - reach;
        bound.high = rigid.position + reach;
        if rigid.role == LARGE {
            bound.flags = OVERSIZED;
        } else if far > bitcast<f32>(atomicLoad(&status[LOOK])) {
            bound.flags = RUSHING;
            atomicAdd(&status[FAST], 1u);
        } else {
            slot = slot_of(grid, cell_of(grid, rigid.position));
            // Numbers that aren't negative are in the order of their bits.
            atomicMax(&ahead_here, bitcast<u32>(far));
        }
        note_far(far);
    }
    bounds[row] = bound;
    slots[row] = slot;
    atomicAdd(&counts[slot], 1u);
}
// ANCHOR_END: cells
