//! Several scenes in one picture, each in its own part of it. Each has a renderer of its own, as its rows
//! and its looks differ; all draw into the same samples, which are averaged after the last.

use super::targets::{Targets, Turn};
use super::{Picture, Quality, Renderer, Surroundings};
use crate::camera::Viewport;
use crate::gpu::Gpu;
use crate::side_by_side::View;

impl Picture<'_> {
    /// The same of each view that has bodies, in their places; without what belongs to one scene alone.
    pub fn of_each<'a>(&'a self, views: &[View<'a>], places: &[Viewport]) -> Vec<Picture<'a>> {
        let sessions = views.iter().filter_map(|view| view.session);
        let picture = |(session, place): (_, &Viewport)| Picture {
            session,
            viewport: *place,
            picked: None,
            pair: None,
            is_glass: false,
            strokes: &[],
            faces: &[],
            is_as_read: false,
            ..*self
        };
        sessions.zip(places).map(picture).collect()
    }
}

/// Renderers for scenes that are drawn together.
pub struct Several {
    format: wgpu::TextureFormat,
    quality: Quality,
    renderers: Vec<Renderer>,
    targets: Option<Targets>,
}

impl Several {
    /// For pictures in a format that is not sRGB.
    pub fn new(format: wgpu::TextureFormat, quality: Quality) -> Self {
        Self {
            format,
            quality,
            renderers: Vec::new(),
            targets: None,
        }
    }

    /// Draws these pictures of a scene with these surroundings, each into its viewport; there is at
    /// least one. `size` is that of `view`.
    pub fn draw(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        (view, size): (&wgpu::TextureView, [u32; 2]),
        surroundings: &Surroundings,
        pictures: &[Picture],
    ) {
        let (format, quality) = (self.format, self.quality);
        self.renderers.truncate(pictures.len());
        while self.renderers.len() < pictures.len() {
            let renderer = Renderer::new(gpu, format, quality, surroundings.clone());
            self.renderers.push(renderer);
        }
        let fitting = self.targets.take().filter(|targets| targets.fits(size));
        let targets = fitting.unwrap_or_else(|| Targets::new(&gpu.device, format, &quality, size));
        let last = pictures.len().saturating_sub(1);
        for (i, (renderer, picture)) in self.renderers.iter_mut().zip(pictures).enumerate() {
            let turn = Turn {
                is_first: i == 0,
                is_last: i == last,
            };
            renderer.draw_part(gpu, encoder, view, (&targets, turn), picture);
        }
        self.targets = Some(targets);
    }
}
