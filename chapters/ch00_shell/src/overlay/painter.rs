//! Puts the overlay's triangles onto the picture.

use egui::ClippedPrimitive;

use super::Layout;
use super::sheet::Sheet;
use crate::gpu::Gpu;

/// So far panels may reach over their edge, points.
const OVER_EDGE: f32 = 4.0;

/// egui's own renderer, and the panels as painted last where that saves time.
pub struct Painter {
    renderer: egui_wgpu::Renderer,
    sheet: Option<Sheet>,
}

/// A picture to paint on.
pub struct Canvas<'a> {
    /// Its pixels.
    pub texture: &'a wgpu::Texture,
    /// The same to draw into.
    pub view: &'a wgpu::TextureView,
}

impl Painter {
    /// For pictures of this format.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let options = egui_wgpu::RendererOptions {
            dithering: !gpu.is_software,
            ..Default::default()
        };
        Self {
            renderer: egui_wgpu::Renderer::new(&gpu.device, format, options),
            sheet: None,
        }
    }

    /// Paints what was laid out over what is in the picture.
    pub fn paint(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        canvas: &Canvas,
        context: &egui::Context,
        mut layout: Layout,
    ) {
        let scale = layout.scale();
        let screen = egui_wgpu::ScreenDescriptor {
            size_in_pixels: [canvas.texture.width(), canvas.texture.height()],
            pixels_per_point: scale,
        };
        let shapes = std::mem::take(&mut layout.output.shapes);
        let mut triangles = context.tessellate(shapes, scale);
        let mut textures = std::mem::take(&mut layout.output.textures_delta);
        for (id, changes) in textures.set.drain() {
            for change in changes {
                self.renderer
                    .update_texture(&gpu.device, &gpu.queue, id, &change);
            }
        }
        if Sheet::suits(gpu, canvas.texture) {
            let panels = take_panels(&mut triangles, &layout);
            self.paint_panels(gpu, &panels, &screen, canvas.texture, &layout);
            if let Some(sheet) = &self.sheet {
                sheet.copy(encoder, canvas.texture);
            }
        }
        let over = wgpu::LoadOp::Load;
        self.paint_triangles(gpu, encoder, canvas.view, over, &triangles, &screen);
        for id in textures.free.drain() {
            self.renderer.free_texture(&id);
        }
    }

    /// Paints the panels onto their sheet, if that is due.
    fn paint_panels(
        &mut self,
        gpu: &Gpu,
        panels: &[ClippedPrimitive],
        screen: &egui_wgpu::ScreenDescriptor,
        picture: &wgpu::Texture,
        layout: &Layout,
    ) {
        let (room, now) = (layout.viewport, layout.time);
        let fitting = self.sheet.take().filter(|sheet| sheet.fits(picture, room));
        let is_new = fitting.is_none();
        let mut sheet = fitting.unwrap_or_else(|| Sheet::new(gpu, picture, room, now));
        if is_new || sheet.is_due(now, layout.is_touched) {
            // Apart from the picture's commands: egui's renderer has room for one list of triangles at a time.
            let mut encoder = gpu
                .device
                .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            let empty = wgpu::LoadOp::Clear(layout.background());
            self.paint_triangles(gpu, &mut encoder, &sheet.view, empty, panels, screen);
            gpu.queue.submit([encoder.finish()]);
        }
        self.sheet = Some(sheet);
    }

    fn paint_triangles(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        view: &wgpu::TextureView,
        load: wgpu::LoadOp<wgpu::Color>,
        triangles: &[ClippedPrimitive],
        screen: &egui_wgpu::ScreenDescriptor,
    ) {
        let is_nothing = triangles.is_empty() && load == wgpu::LoadOp::Load;
        // On a lost device egui's renderer would panic.
        if is_nothing || gpu.failure().is_some() {
            return;
        }
        // Only paint callbacks give commands here, and the overlay has none.
        self.renderer
            .update_buffers(&gpu.device, &gpu.queue, encoder, triangles, screen);
        let mut pass = encoder
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("overlay"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load,
                        store: wgpu::StoreOp::Store,
                    },
                })],
                depth_stencil_attachment: None,
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            })
            .forget_lifetime();
        self.renderer.render(&mut pass, triangles, screen);
    }
}

/// Takes away what lies beside the scene; what is left reaches over it.
fn take_panels(triangles: &mut Vec<ClippedPrimitive>, layout: &Layout) -> Vec<ClippedPrimitive> {
    let scene = layout.free.shrink(OVER_EDGE);
    let (over, panels) = std::mem::take(triangles)
        .into_iter()
        .partition(|primitive| primitive.clip_rect.intersects(scene));
    *triangles = over;
    panels
}
