// Where each body is and how it moves, as it is drawn and brought down. What can't move stays as it was drawn
// first. Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> rigids: array<Rigid>;
@group(0) @binding(2) var<storage, read_write> drawn: array<Drawn>;
@group(0) @binding(3) var<storage, read_write> seen: array<Seen>;
@group(0) @binding(4) var<storage, read> status: array<u32>;

@compute @workgroup_size(WORKGROUP)
fn pair_state(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || status[HALTED] != 0u {
        return;
    }
    if rigids[row].inverse_mass == 0.0 && all(rigids[row].inverse_inertia == vec3f(0.0)) {
        return;
    }
    let position = rigids[row].position;
    let attitude = rigids[row].attitude;
    let last = drawn[row];
    drawn[row] = Drawn(position, 0.0, attitude, last.position, 0.0, last.orientation);
    seen[row] = Seen(rigids[row].velocity, 0.0, rigids[row].angular_velocity, 0.0);
}
