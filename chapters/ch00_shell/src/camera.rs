//! A camera that circles a point: dragging turns it, the wheel moves it closer, and at the
//! start it stands so that everything that moves is in the picture.

use glam::{Mat4, Vec2, Vec3, camera::rh};

use crate::render::Surroundings;

/// Vertical angle of view, rad.
const FIELD_OF_VIEW: f32 = 0.65;

/// What is worth seeing is framed with this factor more distance than it needs.
const MARGIN: f32 = 1.08;

/// The part of a window that the scene is drawn in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Its upper left corner, pixels.
    pub origin: Vec2,
    /// Width and height, pixels; neither is 0.
    pub size: Vec2,
}

impl Viewport {
    /// All of a picture.
    #[must_use]
    pub fn whole(size: [u32; 2]) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "a few thousand pixels")]
        let size = Vec2::from(size.map(|side| side as f32));
        Self {
            origin: Vec2::ZERO,
            size,
        }
    }

    /// Whether a pixel of the window is in it.
    #[must_use]
    pub fn contains(self, pixel: Vec2) -> bool {
        let place = pixel - self.origin;
        place.cmpge(Vec2::ZERO).all() && place.cmplt(self.size).all()
    }

    /// Width of a pixel, m, for each metre of distance.
    #[must_use]
    pub fn pixel_angle(self) -> f32 {
        2.0 * (0.5 * FIELD_OF_VIEW).tan() / self.size.y
    }

    fn aspect(self) -> f32 {
        self.size.x / self.size.y
    }
}

/// A half line in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it begins, m.
    pub origin: Vec3,
    /// Unit vector.
    pub direction: Vec3,
}

impl Ray {
    /// The point at this distance, m.
    #[must_use]
    pub fn at(&self, distance: f32) -> Vec3 {
        self.origin + self.direction * distance
    }
}

/// Where the viewer is and looks.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The point in the middle of the picture, m.
    pub target: Vec3,
    /// From the target to the camera, m.
    pub distance: f32,
    /// Angle about the vertical, rad; 0 looks along −z.
    pub yaw: f32,
    /// Angle above the horizontal, rad.
    pub pitch: f32,
    /// Radius of what was framed at the start, m.
    pub scene_radius: f32,
}

impl Camera {
    /// Stands as near as lets everything worth seeing be in the picture.
    #[must_use]
    pub fn framing(surroundings: &Surroundings, viewport: Viewport) -> Self {
        let mut camera = Self {
            target: surroundings.centre(),
            distance: surroundings.radius(),
            yaw: 0.6,
            pitch: 0.38,
            scene_radius: surroundings.radius(),
        };
        camera.frame(surroundings.low, surroundings.high, viewport);
        camera
    }

    /// Moves so that a box fills the picture, without turning.
    pub fn frame(&mut self, low: Vec3, high: Vec3, viewport: Viewport) {
        self.target = 0.5 * (low + high);
        self.distance = MARGIN * self.fitting_distance(0.5 * (high - low), viewport);
    }

    /// The least distance from which all corners of a box of this half size are between the
    /// planes through the eye and the picture's edges: |x| ≤ (d + z) tan(angle / 2), likewise y.
    fn fitting_distance(&self, half: Vec3, viewport: Viewport) -> f32 {
        let forward = self.forward();
        let (right, up) = self.right_and_up();
        let tangent_y = (0.5 * FIELD_OF_VIEW).tan();
        let tangent_x = tangent_y * viewport.aspect();
        let mut distance = 0.1 * half.length().max(0.05);
        for corner in 0..8_u8 {
            let sign = |bit: u8| if corner & bit == 0 { -1.0 } else { 1.0 };
            let point = half * Vec3::new(sign(1), sign(2), sign(4));
            let across = (point.dot(right).abs() / tangent_x).max(point.dot(up).abs() / tangent_y);
            distance = distance.max(across - point.dot(forward));
        }
        distance
    }

    /// Moves away so far that a ball of this radius about the target fits in the picture.
    pub fn fit_ball(&mut self, radius: f32, viewport: Viewport) {
        let narrower = viewport.aspect().min(1.0);
        let half_angle = ((0.5 * FIELD_OF_VIEW).tan() * narrower).atan();
        self.distance = MARGIN * radius / half_angle.sin();
    }

    /// Where the viewer is, m.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        self.target - self.forward() * self.distance
    }

    /// Unit vector of the line of sight.
    #[must_use]
    pub fn forward(&self) -> Vec3 {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        -Vec3::new(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch)
    }

    /// World to clip coordinates, depth reversed: 1 near, 0 infinitely far.
    #[must_use]
    pub fn view_projection(&self, viewport: Viewport) -> Mat4 {
        let projection = rh::proj::directx::perspective_infinite_reverse(
            FIELD_OF_VIEW,
            viewport.aspect(),
            self.near(),
        );
        projection * rh::view::look_to_mat4(self.position(), self.forward(), Vec3::Y)
    }

    /// Distance of the near plane, m.
    #[must_use]
    pub fn near(&self) -> f32 {
        (0.01 * self.distance).max(1e-3)
    }

    /// The line of sight through a pixel.
    #[must_use]
    pub fn ray(&self, viewport: Viewport, pixel: Vec2) -> Ray {
        let place = (pixel - viewport.origin) / viewport.size;
        let (x, y) = (2.0 * place.x - 1.0, 1.0 - 2.0 * place.y);
        let tangent = (0.5 * FIELD_OF_VIEW).tan();
        let (right, up) = self.right_and_up();
        let direction = self.forward() + tangent * (x * viewport.aspect() * right + y * up);
        Ray {
            origin: self.position(),
            direction: direction.normalize(),
        }
    }

    /// Turns about the target by a drag of so many points of the screen.
    pub fn orbit(&mut self, drag: Vec2) {
        const RADIANS_PER_POINT: f32 = 0.006;
        self.yaw = (self.yaw - drag.x * RADIANS_PER_POINT) % std::f32::consts::TAU;
        self.pitch = (self.pitch + drag.y * RADIANS_PER_POINT).clamp(-0.2, 1.55);
    }

    /// Moves closer by so many notches of the wheel; away if negative.
    pub fn zoom(&mut self, notches: f32) {
        let distance = self.distance * (-0.12 * notches).exp();
        self.distance = distance.clamp(0.05 * self.scene_radius, 40.0 * self.scene_radius);
    }

    /// Moves the target with a drag of so many pixels, so that it stays under the pointer.
    pub fn pan(&mut self, drag: Vec2, viewport: Viewport) {
        let metres_per_pixel = self.distance * viewport.pixel_angle();
        let (right, up) = self.right_and_up();
        self.target += (drag.y * up - drag.x * right) * metres_per_pixel;
    }

    fn right_and_up(&self) -> (Vec3, Vec3) {
        let forward = self.forward();
        let right = forward.cross(Vec3::Y).normalize();
        (right, right.cross(forward))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ch00_scenes::Scene;

    const VIEWPORT: Viewport = Viewport {
        origin: Vec2::new(320.0, 0.0),
        size: Vec2::new(960.0, 720.0),
    };

    fn camera() -> Camera {
        Camera::framing(&Surroundings::of(&Scene::new("empty")), VIEWPORT)
    }

    fn pixel_of(camera: &Camera, point: Vec3) -> Vec2 {
        let clip = camera.view_projection(VIEWPORT).project_point3(point);
        VIEWPORT.origin + (Vec2::new(clip.x, -clip.y) * 0.5 + 0.5) * VIEWPORT.size
    }

    #[test]
    fn the_target_is_in_the_middle_of_the_viewport() {
        let camera = camera();
        let pixel = pixel_of(&camera, camera.target);
        assert!(pixel.distance(Vec2::new(800.0, 360.0)) < 0.01, "{pixel}");
    }

    #[test]
    fn a_ray_passes_through_the_point_that_is_drawn_at_its_pixel() {
        let camera = camera();
        let point = camera.target + Vec3::new(0.3, -0.2, 0.4);
        let ray = camera.ray(VIEWPORT, pixel_of(&camera, point));
        let along = (point - ray.origin).dot(ray.direction);
        assert!(ray.at(along).distance(point) < 1e-4);
    }

    #[test]
    fn panning_keeps_the_target_under_the_pointer() {
        let mut camera = camera();
        let before = camera.target;
        camera.pan(Vec2::new(40.0, -25.0), VIEWPORT);
        let pixel = pixel_of(&camera, before);
        assert!(pixel.distance(Vec2::new(840.0, 335.0)) < 0.5, "{pixel}");
    }

    #[test]
    fn what_is_worth_seeing_fills_the_picture() {
        let camera = camera();
        let mut least_room = f32::INFINITY;
        for corner in 0..8_u8 {
            let sign = |bit: u8| if corner & bit == 0 { -1.0 } else { 1.0 };
            let place = pixel_of(&camera, Vec3::new(sign(1), sign(2), sign(4))) - VIEWPORT.origin;
            let room = place.min(VIEWPORT.size - place).min_element();
            assert!(room >= 0.0, "{place}");
            least_room = least_room.min(room);
        }
        assert!(least_room < 0.1 * VIEWPORT.size.y, "{least_room}");
    }
}
