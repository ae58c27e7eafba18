//! What all shaders know about a frame, in the layout of `shaders/ch00_frame.wgsl`, and the
//! sun's view for the shadow map.

use glam::{Mat4, Vec3, Vec4, camera::rh};

use super::Picture;
use super::surroundings::Surroundings;
use crate::camera::Camera;

/// Unit vector to the sun.
#[must_use]
pub fn sun_direction() -> Vec3 {
    Vec3::new(0.45, 0.95, 0.30).normalize()
}

/// The uniform buffer. Every `Vec3` is followed by a number, as WGSL's alignment wants it.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FrameUniform {
    view_projection: [[f32; 4]; 4],
    light_view_projection: [[f32; 4]; 4],
    camera_position: [f32; 3],
    shadow_texel: f32,
    sun_direction: [f32; 3],
    grid_cell: f32,
    focus: [f32; 3],
    fade_radius: f32,
    viewport: [f32; 2],
    line_scale: f32,
    ground_height: f32,
    sun_light: [f32; 3],
    viewport_top: f32,
    camera_forward: [f32; 3],
    near: f32,
    sky_light: [f32; 3],
    pixel_angle: f32,
    ground_light: [f32; 4],
    sky_top_display: [f32; 4],
    sky_low_display: [f32; 4],
    ground_color: [f32; 4],
    grid_color: [f32; 4],
    alpha: f32,
    picked: u32,
    ball_shadow_corners: u32,
    spare: u32,
}

impl FrameUniform {
    /// For a picture of a scene among these surroundings.
    #[must_use]
    pub fn new(picture: &Picture, surroundings: &Surroundings, shadow_size: u32) -> Self {
        let (camera, viewport) = (picture.camera, picture.viewport);
        let colors = picture.theme.colors();
        let balls = picture.session.scene().bodies.len();
        let reach = shadow_reach(camera, surroundings);
        let opaque = |color: Vec3| color.extend(1.0).to_array();
        Self {
            view_projection: camera.view_projection(viewport).to_cols_array_2d(),
            light_view_projection: sun_view(camera.target, reach).to_cols_array_2d(),
            camera_position: camera.position().to_array(),
            shadow_texel: 2.0 * reach / shadow_size as f32,
            sun_direction: sun_direction().to_array(),
            grid_cell: grid_cell(camera.distance),
            focus: camera.target.to_array(),
            fade_radius: 2.2 * camera.distance,
            viewport: viewport.size.to_array(),
            line_scale: picture.scale,
            ground_height: surroundings.ground_height,
            sun_light: colors.sun_light.to_array(),
            viewport_top: viewport.origin.y,
            camera_forward: camera.forward().to_array(),
            near: camera.near(),
            sky_light: colors.sky_light.to_array(),
            pixel_angle: viewport.pixel_angle(),
            ground_light: opaque(colors.ground_light),
            sky_top_display: opaque(colors.sky_top_display),
            sky_low_display: opaque(colors.sky_low_display),
            ground_color: opaque(colors.ground),
            grid_color: Vec4::from((colors.grid, colors.grid_strength)).to_array(),
            alpha: picture.alpha as f32,
            picked: picture.picked.map_or(NONE, |body| body as u32),
            ball_shadow_corners: ball_shadow_corners(balls),
            spare: 0,
        }
    }
}

/// No body has this index.
const NONE: u32 = u32::MAX;

/// Corners of the disc that casts a ball's shadow, in a scene of so many bodies: many are small.
pub fn ball_shadow_corners(bodies: usize) -> u32 {
    if bodies < 300 { 20 } else { 8 }
}

/// Distance between two lines of the grid when the camera is so far away, m: a power of ten
/// of which a few tens fit in the picture.
#[must_use]
pub fn grid_cell(distance: f32) -> f32 {
    10.0_f32.powf((distance / 4.0).log10().floor())
}

/// Radius of the sphere in which shadows fall, m: what is in the picture, if that is not
/// much more than the scene.
fn shadow_reach(camera: &Camera, surroundings: &Surroundings) -> f32 {
    (0.6 * camera.distance).min(3.0 * surroundings.radius())
}

/// World to the sun's clip coordinates, depth 0 near. What stands nearer to the sun than the
/// sphere casts shadows, too, so depth reaches far.
fn sun_view(centre: Vec3, reach: f32) -> Mat4 {
    let view = rh::view::look_to_mat4(centre, -sun_direction(), Vec3::Z);
    let depth = 20.0 * reach;
    rh::proj::directx::orthographic(-reach, reach, -reach, reach, -depth, depth) * view
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_layout_is_the_shaders() {
        assert_eq!(size_of::<FrameUniform>(), 336);
    }

    #[test]
    fn the_grid_has_one_line_a_metre_a_few_metres_away() {
        assert!((grid_cell(10.0) - 1.0).abs() < 1e-6);
        assert!((grid_cell(50.0) - 10.0).abs() < 1e-5);
    }

    #[test]
    fn the_sun_sees_the_sphere_between_depths_0_and_1() {
        let view = sun_view(Vec3::new(3.0, 1.0, -2.0), 4.0);
        for offset in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_Y] {
            let clip = view.project_point3(Vec3::new(3.0, 1.0, -2.0) + 3.9 * offset);
            assert!(clip.abs().max_element() <= 1.0 && clip.z >= 0.0, "{clip}");
        }
    }
}
