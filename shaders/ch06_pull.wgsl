// The mouse's pull on a ball: a critically damped spring, as `ch00_maths::force::spring`.
// Needs common/index, common/rotation, rows, common/ball.

@group(0) @binding(0) var<uniform> grid: GridOf;
@group(0) @binding(1) var<uniform> mouse: Mouse;
@group(0) @binding(2) var<storage, read> places: array<Place>;
@group(0) @binding(3) var<storage, read> attitudes: array<vec4f>;
@group(0) @binding(4) var<storage, read> balls: array<Ball>;
@group(0) @binding(5) var<storage, read_write> movers: array<Mover>;

// Natural frequency of the spring, rad/s.
const FREQUENCY: f32 = 12.0;

@compute @workgroup_size(WORKGROUP)
fn pull(@builtin(global_invocation_id) id: vec3u) {
    let row = row_index(id);
    if row >= grid.rows || balls[row].id != mouse.body {
        return;
    }
    let place = places[row];
    var mover = movers[row];
    let arm = quat_rotate(attitudes[row], mouse.anchor);
    let stretch = mouse.towards - (place.position + arm);
    let speed = mover.velocity + cross(mover.angular_velocity, arm);
    let force = mouse.mass * FREQUENCY * (FREQUENCY * stretch - 2.0 * speed);
    mover.velocity += grid.dt * force * mover.inverse_mass;
    let torque = 0.4 * cross(arm, force);
    mover.angular_velocity += grid.dt * torque * inverse_moment(mover.inverse_mass, place.reach);
    movers[row] = mover;
}
