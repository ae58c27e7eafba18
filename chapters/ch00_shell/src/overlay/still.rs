//! The overlay of a still picture: what the window shows besides its left panel, laid out without
//! a window.

use super::painter::{Canvas, Painter};
use super::{Layout, narrow, notes, style, viewport};
use crate::Session;
use crate::camera::{Camera, Viewport};
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::render::Theme;
use crate::show::Show;

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
        #[expect(clippy::cast_precision_loss, reason = "a few thousand pixels")]
        let size = egui::Vec2::from(self.size.map(|side| side as f32));
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, size)),
            ..egui::RawInput::default()
        };
        let mut free = egui::Rect::ZERO;
        let output = self.context.run_ui(input, |ui| {
            if let Some(mut pair) = show.pair {
                let dissection = guides.dissection.as_ref();
                narrow::show(ui, session, &mut pair, dissection, camera, true);
            }
            free = ui.available_rect_before_wrap();
            let painter = ui.painter_at(free);
            notes::paint(&painter, ui.visuals(), free, camera, guides);
        });
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
