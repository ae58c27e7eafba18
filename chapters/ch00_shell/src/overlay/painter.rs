//! Puts the overlay's triangles onto the picture.

use crate::gpu::Gpu;

/// egui's own renderer.
pub struct Painter {
    renderer: egui_wgpu::Renderer,
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
        }
    }

    /// Paints over what is in the picture.
    pub fn paint(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        picture: &wgpu::TextureView,
        triangles: &[egui::ClippedPrimitive],
        mut textures: egui::TexturesDelta,
        screen: &egui_wgpu::ScreenDescriptor,
    ) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        for (id, changes) in textures.set.drain() {
            for change in changes {
                self.renderer.update_texture(device, queue, id, &change);
            }
        }
        // Only paint callbacks give commands here, and the overlay has none.
        self.renderer
            .update_buffers(device, queue, encoder, triangles, screen);
        let mut pass = encoder
            .begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("overlay"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: picture,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Load,
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
        drop(pass);
        for id in textures.free.drain() {
            self.renderer.free_texture(&id);
        }
    }
}
