// Sine, cosine and arc tangent to the last digits of f32. WGSL's own may err by 0.0005 (sin, cos) and by
// 4096 units in the last place (atan2); a body that is turned sixteen times a step would drift.
// The polynomials are those of Cephes' single precision; angles up to some thousand rad.

const HALF_PI: f32 = 1.57079632679;

// ANCHOR: sine
// x less whole quarter turns, in x, and their number, in y: ½π in three parts, so that nothing is lost.
fn less_quarters(x: f32) -> vec2f {
    let quarters = round(x / HALF_PI);
    let r = ((x - quarters * 1.5703125) - quarters * 4.837512969970703125e-4)
        - quarters * 7.54978995489188216e-8;
    return vec2f(r, quarters);
}

// Sine and cosine within ±¼π, in x and y.
fn sine_cosine_near(r: f32) -> vec2f {
    let r2 = r * r;
    let s = ((-1.9515295891e-4 * r2 + 8.3321608736e-3) * r2 - 1.6666654611e-1) * r2 * r + r;
    let c = ((2.443315711809948e-5 * r2 - 1.388731625493765e-3) * r2 + 4.166664568298827e-2)
        * r2 * r2 - 0.5 * r2 + 1.0;
    return vec2f(s, c);
}
// ANCHOR_END: sine

// Sine and cosine of x, rad, in x and y.
fn sine_cosine(x: f32) -> vec2f {
    let reduced = less_quarters(x);
    let near = sine_cosine_near(reduced.x);
    switch i32(reduced.y) & 3 {
        case 0: { return near; }
        case 1: { return vec2f(near.y, -near.x); }
        case 2: { return -near; }
        default: { return vec2f(-near.y, near.x); }
    }
}

fn sine(x: f32) -> f32 {
    return sine_cosine(x).x;
}

fn cosine(x: f32) -> f32 {
    return sine_cosine(x).y;
}

// The arc tangent of t ≥ 0, rad.
fn arc_tangent(t: f32) -> f32 {
    var start = 0.0;
    var x = t;
    if t > 2.414213562373095 {
        start = HALF_PI;
        x = -1.0 / t;
    } else if t > 0.4142135623730950 {
        start = 0.5 * HALF_PI;
        x = (t - 1.0) / (t + 1.0);
    }
    let z = x * x;
    let p = ((8.05374449538e-2 * z - 1.38776856032e-1) * z + 1.99777106478e-1) * z - 3.33329491539e-1;
    return start + (p * z * x + x);
}

// The angle of the point (x, y), rad; 0 for the origin.
fn arc_tangent_of(y: f32, x: f32) -> f32 {
    let high = max(abs(x), abs(y));
    if high == 0.0 {
        return 0.0;
    }
    var angle = arc_tangent(min(abs(x), abs(y)) / high);
    if abs(y) > abs(x) {
        angle = HALF_PI - angle;
    }
    if x < 0.0 {
        angle = 2.0 * HALF_PI - angle;
    }
    return select(angle, -angle, y < 0.0);
}
