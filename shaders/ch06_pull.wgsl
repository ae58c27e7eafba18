// The mouse's pull on a ball.
// Needs common/index, common/rotation, rows, common/mouse, common/ball.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> mouse: Mouse;
@group(0) @binding(2) var<storage, read> places: array<Place>;
@group(0) @binding(3) var<storage, read> attitudes: array<vec4f>;
@group(0) @binding(4) var<storage, read> balls: array<Ball>;
@group(0) @binding(5) var<storage, read_write> movers: array<Mover>;

@compute @workgroup_size(WORKGROUP)
fn pull(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || balls[row].id != mouse.body {
        return;
    }
    let place = places[row];
    var mover = movers[row];
    let spring = spring_at(mouse, place.position, attitudes[row], mover.velocity, mover.angular_velocity);
    mover.velocity += grid.dt * spring.force * mover.inverse_mass;
    mover.angular_velocity += grid.dt * spring.torque * inverse_moment(mover.inverse_mass, place.reach);
    movers[row] = mover;
}
