// What a ball knows of another ball or of a wall that it touches, and what the two do to each other.
// Names as in `ch06_compute::own_row`. Needs common/rotation, rows.

// A neighbour with this bit is a wall: a static body, by its number.
const WALL: u32 = 0x80000000u;

const SMALL: f32 = 1e-12;

// The other body, seen from a ball.
struct Other {
    // Unit vector from the ball to it.
    normal: vec3f,
    // How far apart the surfaces are, m; negative inside.
    distance: f32,
    velocity: vec3f,
    // n/m of the other.
    shared_mass: f32,
    // Its angular velocity times the arm of the contact: ω R.
    swept: vec3f,
    // n R²/I of the other.
    turning: f32,
    inverse_mass: f32,
    // 0 for a box.
    radius: f32,
    restitution: f32,
    friction: f32,
    static_friction: f32,
}

// The inverse moment of a solid ball, 1/(kg m²): I = 2/5 m r².
fn inverse_moment(inverse_mass: f32, radius: f32) -> f32 {
    return 2.5 * inverse_mass / (radius * radius);
}

// ANCHOR: ball_ball
// Another ball. The sums are the same, bit for bit, from either side.
fn other_ball(own: Place, place: Place, mover: Mover, surface: Ball) -> Other {
    let apart = place.position - own.position;
    let span = length(apart);
    let distance = span - (own.reach + place.reach);
    let arm = place.reach + 0.5 * distance;
    var other: Other;
    other.normal = select(vec3f(0.0, 1.0, 0.0), apart / max(span, SMALL), span > SMALL);
    other.distance = distance;
    other.radius = place.reach;
    other.velocity = mover.velocity;
    other.inverse_mass = mover.inverse_mass;
    other.shared_mass = mover.shares * mover.inverse_mass;
    other.swept = mover.angular_velocity * arm;
    other.turning = mover.shares * arm * arm * inverse_moment(mover.inverse_mass, place.reach);
    other.restitution = surface.restitution;
    other.friction = surface.friction;
    other.static_friction = surface.static_friction;
    return other;
}
// ANCHOR_END: ball_ball

// ANCHOR: ball_wall
// A static box or ball. Where the centre is inside the box, the nearest face pushes it out.
fn other_wall(own: Place, wall: Wall) -> Other {
    var other: Other;
    other.restitution = wall.restitution;
    other.friction = wall.friction;
    other.static_friction = wall.static_friction;
    let away = own.position - wall.position;
    if wall.kind == 0u {
        let span = length(away);
        other.normal = select(vec3f(0.0, -1.0, 0.0), -away / max(span, SMALL), span > SMALL);
        other.distance = span - (own.reach + wall.size.x);
        other.radius = wall.size.x;
        return other;
    }
    let local = quat_rotate(wall.attitude * vec4f(-1.0, -1.0, -1.0, 1.0), away);
    let outside = local - clamp(local, -wall.size, wall.size);
    let span = length(outside);
    if span > SMALL {
        other.normal = -quat_rotate(wall.attitude, outside / span);
        other.distance = span - own.reach;
        return other;
    }
    let gap = wall.size - abs(local);
    var out = vec3f(0.0, 0.0, select(-1.0, 1.0, local.z >= 0.0));
    if gap.x <= gap.y && gap.x <= gap.z {
        out = vec3f(select(-1.0, 1.0, local.x >= 0.0), 0.0, 0.0);
    } else if gap.y <= gap.z {
        out = vec3f(0.0, select(-1.0, 1.0, local.y >= 0.0), 0.0);
    }
    other.normal = -quat_rotate(wall.attitude, out);
    other.distance = -min(gap.x, min(gap.y, gap.z)) - own.reach;
    return other;
}
// ANCHOR_END: ball_wall

// Velocity of the other relative to the ball where they touch, m/s.
fn relative_velocity(other: Other, velocity: vec3f, angular_velocity: vec3f, arm: f32) -> vec3f {
    let turning = other.swept + angular_velocity * arm;
    return other.velocity - velocity - cross(turning, other.normal);
}

// ANCHOR: passes
// Whether a ball that comes nearer passes by within `h` seconds: the nearest that the centres come is
// farther than both radii. Without it a fast ball would be stopped by what it flies past.
fn passes(other: Other, u: vec3f, radius: f32, h: f32) -> bool {
    if other.distance <= 0.0 || other.radius == 0.0 {
        return false;
    }
    let reach = radius + other.radius;
    let apart = (other.distance + reach) * other.normal;
    let moves = h * u;
    let part = clamp(-dot(apart, moves) / max(dot(moves, moves), SMALL), 0.0, 1.0);
    let nearest = apart + part * moves;
    return dot(nearest, nearest) > reach * reach;
}
// ANCHOR_END: passes

// Whether the two come so near within `h` seconds that they touch. `u` is how fast the other comes away.
fn comes(other: Other, u: vec3f, radius: f32, h: f32) -> bool {
    return other.distance + h * dot(u, other.normal) <= 0.0 && !passes(other, u, radius, h);
}

// The acceleration with which gravity brings the two together, m/s².
fn closing_pull(other: Other, inverse_mass: f32, gravity: vec3f) -> f32 {
    var closing = 0.0;
    if inverse_mass > 0.0 {
        closing += dot(gravity, other.normal);
    }
    if other.inverse_mass > 0.0 {
        closing -= dot(gravity, other.normal);
    }
    return closing;
}

// ANCHOR: kick
// Starts a substep: gravity, what held the ball in the last substep, drag.
fn kicked_velocity(velocity: vec3f, inverse_mass: f32, held: vec3f, step: Step) -> vec3f {
    let pulled = select(vec3f(0.0), step.h * step.gravity, inverse_mass > 0.0);
    return (velocity + pulled + held * inverse_mass) * step.drag;
}
// ANCHOR_END: kick

// What friction gives of what it would take to hold.
fn coulomb(held: vec3f, pressed: f32, surface: Ball, other: Other) -> vec3f {
    let size = length(held);
    if size <= sqrt(surface.static_friction * other.static_friction) * pressed {
        return held;
    }
    return held * (sqrt(surface.friction * other.friction) * pressed / max(size, SMALL));
}
