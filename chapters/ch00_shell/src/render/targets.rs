//! What is drawn into: a texture with several samples a pixel and its depth, both of the
//! picture's size.

use super::quality::Quality;

/// Format of depths. Depth is reversed, 1 near and 0 infinitely far, which keeps its
/// precision even over the whole distance.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Where a drawing stands among those that go into one picture.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Whether it begins with an empty picture.
    pub is_first: bool,
    /// Whether the picture is done after it.
    pub is_last: bool,
}

impl Turn {
    /// The only drawing of a picture.
    pub const ALONE: Self = Self {
        is_first: true,
        is_last: true,
    };
}

/// Colour and depth for pictures of one size.
pub struct Targets {
    size: [u32; 2],
    /// None where a pixel has one sample: that is drawn into the picture itself.
    color: Option<wgpu::TextureView>,
    depth: wgpu::TextureView,
}

impl Targets {
    /// For pictures of so many pixels, neither of them 0.
    pub fn new(
        device: &wgpu::Device,
        format: wgpu::TextureFormat,
        quality: &Quality,
        size: [u32; 2],
    ) -> Self {
        let view = |label, format| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d {
                    width: size[0],
                    height: size[1],
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count: quality.samples,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        Self {
            size,
            color: (quality.samples > 1).then(|| view("scene colour", format)),
            depth: view("scene depth", DEPTH_FORMAT),
        }
    }

    /// Whether it fits pictures of this size.
    pub fn fits(&self, size: [u32; 2]) -> bool {
        self.size == size
    }

    /// Begins drawing, the first on a background; at the end of the last the samples of each pixel are
    /// averaged into `picture`.
    pub fn begin<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        picture: &wgpu::TextureView,
        background: wgpu::Color,
        turn: Turn,
    ) -> wgpu::RenderPass<'a> {
        let (view, resolve_target, store) = match &self.color {
            Some(color) if turn.is_last => (color, Some(picture), wgpu::StoreOp::Discard),
            Some(color) => (color, None, wgpu::StoreOp::Store),
            None => (picture, None, wgpu::StoreOp::Store),
        };
        let load = if turn.is_first {
            wgpu::LoadOp::Clear(background)
        } else {
            wgpu::LoadOp::Load
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations { load, store },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}
