//! The overlay of a still picture: what the window shows besides its left panel, laid out without
//! a window.

use super::beside::show_views;
use super::painter::{Canvas, Painter};
use super::{Layout, narrow, notes, style, viewport};
use crate::Session;
use crate::camera::{Camera, Viewport};
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::render::Theme;
use crate::show::Show;
use crate::side_by_side::{SideBySide, whole};

/// An overlay for one picture.
pub struct Still {
    context: egui::Context,
    painter: Painter,
    size: [u32; 2],
    layout: Option<Layout>,
}

impl Still {
    /// For pictures of this format and size, a pixel a point.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat, size: [u32; 2], theme: Theme) -> Self {
        let context = egui::Context::default();
        style::apply(&context, theme);
        Self {
            context,
            painter: Painter::new(gpu, format),
            size,
            layout: None,
        }
    }

    /// The panels' colour, as displayed.
    pub fn background(&self) -> wgpu::Color {
        super::background(self.context.global_style().visuals.panel_fill)
    }

    /// Lays everything out and gives what is left for the scene.
    pub fn lay_out(
        &mut self,
        session: &Session,
        show: &Show,
        guides: &Guides,
        camera: &Camera,
    ) -> Viewport {
        self.run(|ui| {
            if let Some(mut pair) = show.pair {
                let dissection = guides.dissection.as_ref();
                narrow::show(ui, session, &mut pair, dissection, camera, true);
            }
            let free = ui.available_rect_before_wrap();
            let painter = ui.painter_at(free);
            notes::paint(&painter, ui.visuals(), free, camera, guides);
            free
        })
    }

    /// Lays out several runs side by side and gives what is left for each view that has a picture.
    pub fn lay_out_beside(&mut self, runs: &mut dyn SideBySide) -> Vec<Viewport> {
        let mut views = Vec::new();
        self.run(|ui| {
            let free = show_views(ui, runs);
            views = free.views;
            free.all
        });
        let in_pixels = |room| viewport(room, 1.0, self.size);
        views.into_iter().map(in_pixels).collect()
    }

    fn run(&mut self, mut add: impl FnMut(&mut egui::Ui) -> egui::Rect) -> Viewport {
        let input = egui::RawInput {
            screen_rect: Some(whole(self.size)),
            ..egui::RawInput::default()
        };
        let mut free = egui::Rect::ZERO;
        let output = self.context.run_ui(input, |ui| free = add(ui));
        let viewport = viewport(free, 1.0, self.size);
        let mut all = self
            .layout
            .take()
            .map_or_else(egui::FullOutput::default, |layout| layout.output);
        // Textures of earlier lay-outs are still to be made.
        all.append(output);
        self.layout = Some(Layout {
            output: all,
            viewport,
            views: Vec::new(),
            free,
            background: self.context.global_style().visuals.panel_fill,
            time: 0.0,
            is_touched: true,
        });
        viewport
    }

    /// Paints what was laid out last over the picture.
    pub fn paint(&mut self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder, canvas: &Canvas) {
        if let Some(layout) = self.layout.take() {
            self.painter
                .paint(gpu, encoder, canvas, &self.context, layout);
        }
    }
}

impl Drop for Still {
    /// A picture that nobody wants any more needs no textures; egui would ask why they were never made.
    fn drop(&mut self) {
        if let Some(layout) = &mut self.layout {
            layout.output.textures_delta.clear();
        }
    }
}
