//! The renderer: draws a session's bodies, lit and with shadows, onto any texture. The window
//! and the screenshot use the same one. A frame is: write what has changed, draw depths as
//! the sun sees them, draw bodies, scenery and drawings as the camera sees them.
//!
//! Where bodies are stands in rows on the device ([`crate::Drawn`]), and shaders interpolate between their
//! last two places: for an engine that computes there, nothing is written but the frame's uniform.

mod bindings;
mod bodies;
mod buffer;
mod faces;
mod frame;
pub mod lines;
mod looks;
mod meshes;
mod pipeline;
mod quality;
mod rods;
mod rows;
mod scenery;
mod several;
pub mod shaders;
mod shadow;
mod surroundings;
mod targets;
mod theme;

pub use faces::byte;
pub use frame::grid_cell;
pub use quality::Quality;
pub use several::Several;
pub use surroundings::Surroundings;
pub use theme::Theme;

use std::cell::RefCell;

use ch00_scenes::Face;

use crate::Session;
use crate::camera::{Camera, Viewport};
use crate::gpu::Gpu;
use bindings::{Bindings, Layouts};
use bodies::Bodies;
use faces::Faces;
use frame::{FrameUniform, ball_shadow_corners};
use lines::{Lines, Stroke};
use looks::Looks;
use pipeline::PipelineMaker;
use rods::Rods;
use rows::Rows;
use scenery::Scenery;
use shadow::ShadowMap;
use targets::{Targets, Turn};

/// What to draw.
pub struct Picture<'a> {
    /// The bodies.
    pub session: &'a Session,
    /// How far from the last state but one (0) to the last (1).
    pub alpha: f64,
    /// From where.
    pub camera: &'a Camera,
    /// Into what part of the window.
    pub viewport: Viewport,
    /// Pixels per point of the screen.
    pub scale: f32,
    /// In which colours.
    pub theme: Theme,
    /// The colour around the viewport, as displayed.
    pub margin: wgpu::Color,
    /// The body that glows.
    pub picked: Option<usize>,
    /// Two bodies that are orange and blue and never of glass.
    pub pair: Option<[usize; 2]>,
    /// Whether bodies that can move are of glass, so that drawings inside and behind them show.
    pub is_glass: bool,
    /// Lines besides the walls' edges.
    pub strokes: &'a [Stroke],
    /// Faces of drawings.
    pub faces: &'a [Face],
    /// Whether bodies are drawn where they were when their state came back last, as what is drawn with
    /// them is.
    pub is_as_read: bool,
}

/// Everything on the device that a picture needs.
pub struct Renderer {
    quality: Quality,
    format: wgpu::TextureFormat,
    layouts: Layouts,
    bindings: Bindings,
    shadow: ShadowMap,
    bodies: Bodies,
    scenery: Scenery,
    faces: Faces,
    lines: Lines,
    rods: Rods,
    targets: Option<Targets>,
    surroundings: Surroundings,
    looks: Looks,
    rows: Rows,
    strokes: Vec<Stroke>,
}

impl Renderer {
    /// For pictures in a format that is not sRGB: shaders write the display's values.
    #[must_use]
    pub fn new(
        gpu: &Gpu,
        format: wgpu::TextureFormat,
        quality: Quality,
        surroundings: Surroundings,
    ) -> Self {
        let device = &gpu.device;
        let layouts = Layouts::new(device);
        let shadow = ShadowMap::new(device, &layouts.shadow, &quality);
        let maker = PipelineMaker {
            device,
            layout: &layouts.scene,
            format,
            quality: &quality,
            modules: RefCell::default(),
        };
        let bodies = Bodies::new(&maker, &gpu.queue);
        let scenery = Scenery::new(&maker);
        let faces = Faces::new(&maker);
        let lines = Lines::new(&maker);
        let rods = Rods::new(&maker);
        let mut renderer = Self {
            bindings: Bindings::new(device, &layouts, &shadow),
            layouts,
            quality,
            format,
            shadow,
            bodies,
            scenery,
            faces,
            lines,
            rods,
            targets: None,
            surroundings: surroundings.clone(),
            looks: Looks::default(),
            rows: Rows::new(device),
            strokes: Vec::new(),
        };
        renderer.set_surroundings(gpu, surroundings);
        renderer
    }

    /// How much work its pictures are.
    #[must_use]
    pub fn quality(&self) -> Quality {
        self.quality
    }

    /// Takes over another scene's surroundings, or those that are left when a body was taken out.
    pub fn set_surroundings(&mut self, gpu: &Gpu, surroundings: Surroundings) {
        self.scenery.write(&gpu.device, &gpu.queue, &surroundings);
        self.surroundings = surroundings;
        self.looks.forget();
        self.rows.forget();
        self.rods.forget();
    }

    /// Draws a picture of `size` pixels, neither of them 0, into `view`.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        view: &wgpu::TextureView,
        size: [u32; 2],
        picture: &Picture,
    ) {
        let fitting = self.targets.take().filter(|targets| targets.fits(size));
        let targets =
            fitting.unwrap_or_else(|| Targets::new(&gpu.device, self.format, &self.quality, size));
        self.draw_part(gpu, encoder, view, (&targets, Turn::ALONE), picture);
        self.targets = Some(targets);
    }

    /// Draws into the picture's part of `view`, which others may draw into, too.
    fn draw_part(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        view: &wgpu::TextureView,
        (targets, turn): (&Targets, Turn),
        picture: &Picture,
    ) {
        self.write(gpu, picture);
        self.draw_shadow(encoder, picture);
        let mut pass = targets.begin(encoder, view, picture.margin, turn);
        self.draw_scene(&mut pass, picture);
    }

    /// Everything that has changed since the last frame.
    fn write(&mut self, gpu: &Gpu, picture: &Picture) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let colors = picture.theme.colors();
        let uniform = FrameUniform::new(picture, &self.surroundings, self.quality.shadow_size);
        self.bindings.write(queue, &uniform);
        self.rows.follow(gpu, &self.layouts, picture);
        if self.looks.follow(picture, &self.surroundings) {
            self.bodies.write(device, queue, &self.looks);
        }
        self.rods.follow(device, queue, picture.session.scene());
        self.strokes.clear();
        let eye = picture.camera.position();
        self.strokes
            .extend(lines::wall_edges(&self.surroundings, eye, &colors));
        self.strokes.extend_from_slice(picture.strokes);
        self.lines.write(device, queue, &self.strokes);
        self.faces.write(device, queue, picture.faces, eye);
    }

    fn draw_shadow(&self, encoder: &mut wgpu::CommandEncoder, picture: &Picture) {
        let mut pass = self.shadow.begin(encoder);
        pass.set_bind_group(0, &self.bindings.shadow, &[]);
        self.rows.bind(&mut pass);
        let corners = ball_shadow_corners(picture.session.scene().bodies.len());
        self.bodies.draw_shadows(&mut pass, &self.shadow, corners);
    }

    fn draw_scene(&self, pass: &mut wgpu::RenderPass, picture: &Picture) {
        let (origin, extent) = (picture.viewport.origin, picture.viewport.size);
        pass.set_viewport(origin.x, origin.y, extent.x, extent.y, 0.0, 1.0);
        let [x, y, width, height] =
            [origin.x, origin.y, extent.x, extent.y].map(|side| side.round() as u32);
        pass.set_scissor_rect(x, y, width, height);
        pass.set_bind_group(0, &self.bindings.scene, &[]);
        self.rows.bind(pass);
        self.bodies.draw_ball_depths(pass);
        self.bodies.draw_all_but_balls(pass);
        self.scenery.draw(pass);
        self.bodies.draw_balls_only(pass);
        let has_drawings = !picture.strokes.is_empty() || !picture.faces.is_empty();
        if has_drawings || self.rods.is_any() {
            self.bodies.draw_ball_surfaces(pass);
        }
        self.faces.draw_hidden(pass);
        self.lines.draw_hidden(pass);
        self.rods.draw_hidden(pass);
        self.faces.draw_solid(pass);
        self.faces.draw_translucent(pass);
        self.lines.draw(pass);
        self.rods.draw(pass);
        if self.bodies.draw_glass(pass) {
            // Once more, for what is before the glass.
            self.faces.draw_solid(pass);
            self.lines.draw(pass);
            self.rods.draw(pass);
        }
    }
}
