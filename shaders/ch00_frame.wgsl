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
    // Opacity of the ground: 0 draws its grid only.
    ground_opacity: f32,
    sky_light: vec4f,
    ground_light: vec4f,
    sky_top_display: vec4f,
    sky_low_display: vec4f,
    ground_color: vec4f,
    // Colour of the grid on floor and ground; its alpha is the strength.
    grid_color: vec4f,
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

// How much a line of the grid covers at p: lines every `cell` metres, one pixel wide,
// gone where the cells get too small to see.
fn grid_line(p: vec2f, cell: f32) -> f32 {
    let q = p / cell;
    let width = max(fwidth(q), vec2f(1e-6));
    let distance = abs(fract(q - 0.5) - 0.5) / width;
    let lines = (1.0 - min(distance, vec2f(1.0))) * (1.0 - smoothstep(vec2f(0.15), vec2f(0.5), width));
    return max(lines.x, lines.y);
}

// The grid of floor and ground: every cell, and every fifth one stronger.
fn grid(p: vec2f) -> f32 {
    return max(0.45 * grid_line(p, frame.grid_cell), grid_line(p, 5.0 * frame.grid_cell));
}
