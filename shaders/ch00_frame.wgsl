// What every drawing shader knows about a frame: the camera, the sun, the theme's colours.
// Colours are linear unless their name says `display`. The layout is that of `render/frame.rs`.

struct Frame {
    view_projection: mat4x4f,
    light_view_projection: mat4x4f,
    camera_position: vec3f,
    // World size of a texel of the shadow map, m.
    shadow_texel: f32,
    // Unit vector to the sun.
    sun_direction: vec3f,
    // Distance between two lines of the grid, m.
    grid_cell: f32,
    // What the camera looks at, m.
    focus: vec3f,
    // Distance from the focus at which ground and walls have faded away, m.
    fade_radius: f32,
    // Width and height, pixels.
    viewport: vec2f,
    // Pixels of a line of width 1.
    line_scale: f32,
    // Height of the ground, m.
    ground_height: f32,
    sun_light: vec3f,
    // Upper edge of the viewport, pixels.
    viewport_top: f32,
    // Unit vector of the line of sight.
    camera_forward: vec3f,
    // Distance of the near plane, m: a point's depth is this by its distance along the line of
    // sight.
    near: f32,
    sky_light: vec3f,
    // Width of a pixel, m, for each metre of distance.
    pixel_angle: f32,
    ground_light: vec4f,
    sky_top_display: vec4f,
    sky_low_display: vec4f,
    ground_color: vec4f,
    // Colour of the grid on floor and ground; its alpha is the strength.
    grid_color: vec4f,
    // How far bodies are drawn between their places before the last step (0) and after it (1).
    alpha: f32,
    // Index of the body that is picked, or one that no body has.
    picked: u32,
    // Corners of the disc that casts a ball's shadow.
    ball_shadow_corners: u32,
    spare: u32,
}

@group(0) @binding(0) var<uniform> frame: Frame;

// Linear light to the display's sRGB, by a fit of three square roots instead of a power.
fn to_display(linear: vec3f) -> vec3f {
    let c = clamp(linear, vec3f(0.0), vec3f(1.0));
    let s1 = sqrt(c);
    let s2 = sqrt(s1);
    let s3 = sqrt(s2);
    return clamp(0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c,
        vec3f(0.0), vec3f(1.0));
}

// The sky's display colour in this row of pixels.
fn sky_display(row: f32) -> vec3f {
    let down = (row - frame.viewport_top) / frame.viewport.y;
    return mix(frame.sky_top_display.rgb, frame.sky_low_display.rgb, down);
}

// How much a line of a grid with one line a unit covers at q: lines are one pixel wide, where
// a pixel is `width`, and gone where the cells get too small to see.
fn grid_line(q: vec2f, width: vec2f) -> f32 {
    let lines = clamp(1.0 - abs(fract(q - 0.5) - 0.5) / width, vec2f(0.0), vec2f(1.0));
    let seen = clamp(1.4 - 3.0 * width, vec2f(0.0), vec2f(1.0));
    let strength = lines * seen;
    return max(strength.x, strength.y);
}

// The grid of floor and ground: every cell, and every fifth one stronger.
fn grid(p: vec2f) -> f32 {
    let q = p / frame.grid_cell;
    let width = max(fwidth(q), vec2f(1e-6));
    return max(0.45 * grid_line(q, width), grid_line(0.2 * q, 0.2 * width));
}
