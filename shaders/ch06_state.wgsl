// Where each ball is and how it moves, in the order of the scene: what is drawn, and what is brought
// down when somebody asks. A ball writes the row of its ID, which no other does.
// Needs common/index, rows.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<storage, read> places: array<Place>;
@group(0) @binding(2) var<storage, read> movers: array<Mover>;
@group(0) @binding(3) var<storage, read> attitudes: array<vec4f>;
@group(0) @binding(4) var<storage, read> balls: array<Ball>;
@group(0) @binding(5) var<storage, read_write> drawn: array<Drawn>;
@group(0) @binding(6) var<storage, read_write> seen: array<Seen>;
@group(0) @binding(7) var<storage, read_write> status: array<atomic<u32>>;

// ANCHOR: state
@compute @workgroup_size(WORKGROUP)
fn state(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || atomicLoad(&status[NEEDED]) > grid.room {
        return;
    }
    let body = balls[row].id;
    let last = drawn[body];
    let mover = movers[row];
    let position = places[row].position;
    drawn[body] = Drawn(position, 0.0, attitudes[row], last.position, 0.0, last.orientation);
    seen[body] = Seen(mover.velocity, 0.0, mover.angular_velocity, 0.0);
}
// ANCHOR_END: state
