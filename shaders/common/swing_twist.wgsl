// How a child has turned away from its rest: a twist about its own y axis and a swing that tilts this axis.
// Names as in `ch00_maths::f32::swing_twist`.
// Needs common/trigonometry, common/rotation, common/rotation_vector.

// Below this a sine or an axis is none.
const SMALL_SINE: f32 = 1e-6;

// A rotation as swing and twist.
struct SwingTwist {
    // Rotation vector of the swing, rad: pitch in x, roll in z, 0 in y.
    swing: vec3f,
    // τ, rad, about y.
    twist: f32,
}

// ANCHOR: decompose
// Splits the child's orientation seen from its rest.
fn decompose(turn: vec4f) -> SwingTwist {
    let rel = select(turn, -turn, turn.w < 0.0);
    let size = sqrt(rel.y * rel.y + rel.w * rel.w);
    if size < SMALL_SINE {
        return SwingTwist(rotation_log(rel), 0.0);
    }
    let back = vec4f(0.0, -rel.y / size, 0.0, rel.w / size);
    let twist = 2.0 * arc_tangent_of(rel.y, rel.w);
    return SwingTwist(rotation_log(quat_product(rel, back)), twist);
}
// ANCHOR_END: decompose

// What the relative angular velocity is multiplied by to give the rate of the twist.
fn twist_axis(y_rest: vec3f, y: vec3f) -> vec3f {
    return (y_rest + y) / max(1.0 + dot(y_rest, y), SMALL_SINE);
}

// The unit axis of the swing, and in w the angle θ between the axis at rest and now; no axis at θ = 0.
fn cone(y_rest: vec3f, y: vec3f) -> vec4f {
    let crossed = cross(y_rest, y);
    let sine = length(crossed);
    let cosine = dot(y_rest, y);
    var axis = vec3f(0.0);
    if sine > SMALL_SINE {
        axis = crossed / sine;
    } else if cosine < 0.0 {
        axis = any_across(y_rest);
    }
    return vec4f(axis, arc_tangent_of(sine, cosine));
}

// Some unit vector across a unit vector.
fn any_across(n: vec3f) -> vec3f {
    if abs(n.x) > abs(n.y) {
        return normalize(vec3f(-n.z, 0.0, n.x));
    }
    return normalize(vec3f(0.0, n.z, -n.y));
}

// What the relative angular velocity is multiplied by to give the rates of pitch and of roll.
struct SwingAxes {
    pitch: vec3f,
    roll: vec3f,
}

// ANCHOR: swing_axes
fn swing_axes(rest: vec4f, swing: vec3f, y: vec3f) -> SwingAxes {
    let theta = length(swing);
    if theta < SMALL_SINE {
        let axes = quat_matrix(rest);
        return SwingAxes(axes[0], axes[2]);
    }
    let u = quat_rotate(rest, swing / theta);
    let across = cross(y, u) * (theta / max(sine(theta), SMALL_SINE));
    let c = swing.x / theta;
    let s = swing.z / theta;
    return SwingAxes(c * u + s * across, s * u - c * across);
}
// ANCHOR_END: swing_axes
