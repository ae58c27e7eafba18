//! The shadow map: a depth picture of the bodies as the sun sees them, drawn first in every
//! frame. A point that the sun sees farther away than this picture says is in shadow.

use super::bodies::vertex_layouts;
use super::quality::Quality;
use super::shaders;
use super::targets::DEPTH_FORMAT;

/// The depth picture, how to compare with it, and the pipelines that draw it.
pub struct ShadowMap {
    /// The depth picture.
    pub view: wgpu::TextureView,
    /// Compares a depth with the four texels around a point and mixes the answers.
    pub sampler: wgpu::Sampler,
    /// Draws meshes.
    pub bodies: wgpu::RenderPipeline,
    /// Draws balls.
    pub balls: wgpu::RenderPipeline,
}

impl ShadowMap {
    /// `layout` binds the frame's uniform and the rows of the bodies.
    pub fn new(device: &wgpu::Device, layout: &wgpu::PipelineLayout, quality: &Quality) -> Self {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("shadow map"),
            size: wgpu::Extent3d {
                width: quality.shadow_size,
                height: quality.shadow_size,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: DEPTH_FORMAT,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        });
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("shadow map"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            compare: Some(wgpu::CompareFunction::LessEqual),
            ..Default::default()
        });
        Self {
            view: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            sampler,
            bodies: pipeline(
                device,
                layout,
                "vs_body_shadow",
                &vertex_layouts(),
                wgpu::PrimitiveTopology::TriangleList,
            ),
            balls: pipeline(
                device,
                layout,
                "vs_ball_shadow",
                &vertex_layouts()[1..],
                wgpu::PrimitiveTopology::TriangleStrip,
            ),
        }
    }

    /// Begins drawing it.
    pub fn begin<'a>(&self, encoder: &'a mut wgpu::CommandEncoder) -> wgpu::RenderPass<'a> {
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("shadow"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.view,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
    }
}

fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::PipelineLayout,
    entry: &str,
    buffers: &[Option<wgpu::VertexBufferLayout>],
    topology: wgpu::PrimitiveTopology,
) -> wgpu::RenderPipeline {
    let module = shaders::SHADOW.module(device);
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(entry),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers,
        },
        primitive: wgpu::PrimitiveState {
            topology,
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Less),
            stencil: wgpu::StencilState::default(),
            // Keeps a surface from shading itself where the sun grazes it.
            bias: wgpu::DepthBiasState {
                constant: 1,
                slope_scale: 1.5,
                clamp: 0.0,
            },
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: None,
        multiview_mask: None,
        cache: None,
    })
}
