// GJK: the direction in which two cores that are apart are the nearest to each other.
// Needs common/rotation, common/narrow_core, common/narrow_simplex.

// Iterations before GJK gives its best so far. Boxes take a handful, cylinders up to 20.
const MOST_ITERATIONS: u32 = 24u;

// The distance is known where its bounds differ by this share of it.
const TOLERANCE: f32 = 1e-6;

// The unit vector from a to b, where b is moved by `shift`, along which their cores are the furthest
// apart; `start` is a guess.
fn gjk(a: Core, b: Core, shift: vec3f, start: vec3f) -> vec3f {
    let rounding = rounding(a, b);
    var simplex = simplex_of(difference(a, b, shift, -start));
    var highest = 0.0;
    var normal = start;
    for (var i = 0u; i < MOST_ITERATIONS; i++) {
        let v = simplex.nearest;
        let distance = length(v);
        if distance <= rounding {
            break;
        }
        let w = difference(a, b, shift, -v);
        let at_least = dot(v, w) / distance;
        let is_higher = at_least > highest;
        if is_higher {
            highest = at_least;
            normal = v / distance;
        }
        if distance - at_least <= TOLERANCE * distance + rounding {
            break;
        }
        take_in(&simplex, w);
        if length(simplex.nearest) >= distance && !is_higher {
            break;
        }
    }
    return normal;
}

// The support point of b − a: b goes as far as it can along `direction`, a against it.
fn difference(a: Core, b: Core, shift: vec3f, direction: vec3f) -> vec3f {
    return support(b, direction) + shift - support(a, -direction);
}
