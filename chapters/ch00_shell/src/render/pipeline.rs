//! Making the pipelines of the scene's pass: what they have in common stands here once, and
//! a [`Recipe`] says what differs.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::quality::Quality;
use super::shaders::Shader;
use super::targets::DEPTH_FORMAT;

/// What differs between two pipelines of the scene's pass.
pub struct Recipe<'a> {
    /// The source.
    pub shader: Shader,
    /// Names of the functions for vertices and pixels.
    pub entries: [&'a str; 2],
    /// What vertices are read from.
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// How vertices make triangles.
    pub topology: wgpu::PrimitiveTopology,
    /// Which side of a triangle is not drawn.
    pub cull: Option<wgpu::Face>,
    /// What is drawn where something is already.
    pub depth_compare: wgpu::CompareFunction,
    /// Whether it hides what is drawn later.
    pub hides: bool,
    /// Whether it is mixed with what is behind it, by its alpha.
    pub is_translucent: bool,
    /// Whether it is seen at all, or only hides.
    pub is_seen: bool,
    /// Values of the shader's overrides.
    pub constants: &'a [(&'a str, f64)],
}

/// What all pipelines of the scene's pass share.
pub struct PipelineMaker<'a> {
    /// The device.
    pub device: &'a wgpu::Device,
    /// The bindings.
    pub layout: &'a wgpu::PipelineLayout,
    /// Format of the picture.
    pub format: wgpu::TextureFormat,
    /// How many samples a pixel has.
    pub quality: &'a Quality,
    /// The shaders that were read so far.
    pub modules: RefCell<BTreeMap<&'static str, wgpu::ShaderModule>>,
}

impl PipelineMaker<'_> {
    /// Makes a pipeline.
    pub fn make(&self, recipe: &Recipe) -> wgpu::RenderPipeline {
        let mut modules = self.modules.borrow_mut();
        let read = || recipe.shader.module(self.device);
        let module = modules.entry(recipe.shader.file).or_insert_with(read);
        let options = wgpu::PipelineCompilationOptions {
            constants: recipe.constants,
            ..Default::default()
        };
        let blend = recipe
            .is_translucent
            .then_some(wgpu::BlendState::ALPHA_BLENDING);
        self.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(recipe.entries[1]),
                layout: Some(self.layout),
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some(recipe.entries[0]),
                    compilation_options: options.clone(),
                    buffers: recipe.buffers,
                },
                primitive: wgpu::PrimitiveState {
                    topology: recipe.topology,
                    cull_mode: recipe.cull,
                    ..Default::default()
                },
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH_FORMAT,
                    depth_write_enabled: Some(recipe.hides),
                    depth_compare: Some(recipe.depth_compare),
                    stencil: wgpu::StencilState::default(),
                    bias: wgpu::DepthBiasState::default(),
                }),
                multisample: wgpu::MultisampleState {
                    count: self.quality.samples,
                    ..Default::default()
                },
                fragment: Some(wgpu::FragmentState {
                    module,
                    entry_point: Some(recipe.entries[1]),
                    compilation_options: options,
                    targets: &[Some(wgpu::ColorTargetState {
                        format: self.format,
                        blend,
                        write_mask: if recipe.is_seen {
                            wgpu::ColorWrites::ALL
                        } else {
                            wgpu::ColorWrites::empty()
                        },
                    })],
                }),
                multiview_mask: None,
                cache: None,
            })
    }
}
