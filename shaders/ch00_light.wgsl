// Light: a sun with a shadow map, and the light of sky and ground from above and below. Needs ch00_frame.
// Needs ch00_frame.

@group(0) @binding(1) var shadow_map: texture_depth_2d;
@group(0) @binding(2) var shadow_sampler: sampler_comparison;

// Samples of the shadow map are taken from -reach to +reach in both directions.
override shadow_reach: i32 = 1;

// Where a point of a surface with normal n lies in the shadow map: x and y of a texel, 0 … 1
// across the map, and its depth. The point is moved off the surface by a texel or two so that
// it doesn't shade itself.
fn shadow_place(point: vec3f, n: vec3f) -> vec3f {
    let lifted = point + n * (1.8 * frame.shadow_texel);
    let clip = frame.light_view_projection * vec4f(lifted, 1.0);
    return vec3f(clip.xy * vec2f(0.5, -0.5) + 0.5, min(clip.z, 1.0));
}

// The part of the sun's light that reaches this place, 0 … 1. Beyond the map's edge, where
// nothing casts a shadow, the sampler finds the texels of the edge, which no body reaches.
fn sunlit(place: vec3f) -> f32 {
    let texel = 1.0 / vec2f(textureDimensions(shadow_map));
    var sum = 0.0;
    for (var y = -shadow_reach; y <= shadow_reach; y++) {
        for (var x = -shadow_reach; x <= shadow_reach; x++) {
            let at = place.xy + vec2f(f32(x), f32(y)) * texel;
            sum += textureSampleCompareLevel(shadow_map, shadow_sampler, at, place.z);
        }
    }
    return sum / f32((2 * shadow_reach + 1) * (2 * shadow_reach + 1));
}

// Light of sky and ground on a surface with normal n.
fn ambient(n: vec3f) -> vec3f {
    return mix(frame.ground_light.rgb, frame.sky_light, 0.5 + 0.5 * n.y);
}

// A surface of this colour with normal n, seen from direction v, that receives this share of
// the sun's light: matt, with a highlight of the sun and a rim of the sky.
fn lit(color: vec3f, n: vec3f, v: vec3f, sun_share: f32) -> vec3f {
    let s = frame.sun_direction;
    let facing = max(dot(n, s), 0.0);
    let sun = frame.sun_light * sun_share;
    let half_way = max(dot(n, normalize(s + v)), 0.0);
    let h4 = half_way * half_way * half_way * half_way;
    let h16 = h4 * h4 * h4 * h4;
    let away = 1.0 - max(dot(n, v), 0.0);
    let rim = 0.22 * away * away * away * away;
    return color * (sun * facing + ambient(n))
        + sun * (0.10 * h16 * h16 * h4 * facing)
        + frame.sky_light * rim;
}

// A moving body of this colour: two tones, and a glow where it is picked.
fn painted(color: vec4f, tone: f32, n: vec3f, v: vec3f, sun_share: f32) -> vec3f {
    let second = mix(color.rgb, vec3f(1.0), 0.5);
    let away = 1.0 - max(dot(n, v), 0.0);
    let glow = color.a * (0.06 + 0.9 * away * away) * vec3f(1.0, 0.85, 0.4);
    return to_display(lit(mix(color.rgb, second, tone), n, v, sun_share) + glow);
}

// Whether glass at this point, from the viewer, is so close before the eyes that it would hide
// all that it shall show.
fn is_too_close(sight: vec3f) -> bool {
    return length(sight) < 0.4 * distance(frame.focus, frame.camera_position);
}

// A body of glass: faint where one looks straight through it, stronger where its surface turns
// away.
fn glassy(color: vec4f, n: vec3f, v: vec3f) -> vec4f {
    let away = 1.0 - abs(dot(n, v));
    let rim = away * away;
    let sun = frame.sun_light * max(dot(n, frame.sun_direction), 0.0);
    let light = color.rgb * (0.7 * sun + ambient(n)) + frame.sky_light * (0.25 * rim * rim);
    return vec4f(to_display(light), 0.14 + 0.46 * rim);
}
