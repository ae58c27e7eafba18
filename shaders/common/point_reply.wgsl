// How a body's point answers to an impulse there. Needs common/rotation, rows, common/side,
// common/symmetric.

// What a unit impulse at `arm` makes of the velocity there, along each axis, 1/kg.
fn point_reply(side: Side, arm: vec3f) -> Symmetric {
    let x = along(side, arm, vec3f(1.0, 0.0, 0.0));
    let y = along(side, arm, vec3f(0.0, 1.0, 0.0));
    let z = along(side, arm, vec3f(0.0, 0.0, 1.0));
    return Symmetric(vec3f(x.x, y.y, z.z) + side.shared_mass, vec3f(y.z, z.x, x.y));
}

fn along(side: Side, arm: vec3f, unit: vec3f) -> vec3f {
    return cross(side.shared_inertia * cross(arm, unit), arm);
}
