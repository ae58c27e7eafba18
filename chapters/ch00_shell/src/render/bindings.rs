//! What shaders see besides vertices. In group 0 the frame's uniform, and in the
//! scene's pass the shadow map; the shadow's own pass can't see the map that it draws, so
//! there are two layouts. In group 1 the rows of the bodies.

use super::frame::FrameUniform;
use super::shadow::ShadowMap;

/// The layouts of the two passes.
pub struct Layouts {
    shadow_bindings: wgpu::BindGroupLayout,
    scene_bindings: wgpu::BindGroupLayout,
    row_bindings: wgpu::BindGroupLayout,
    /// For the pipeline of the shadow's pass.
    pub shadow: wgpu::PipelineLayout,
    /// For the pipelines of the scene's pass.
    pub scene: wgpu::PipelineLayout,
}

impl Layouts {
    /// Makes them.
    pub fn new(device: &wgpu::Device) -> Self {
        let [uniform, texture, sampler, rows] = entries();
        let bindings = |label, entries: &[_]| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some(label),
                entries,
            })
        };
        let shadow_bindings = bindings("shadow", &[uniform]);
        let scene_bindings = bindings("scene", &[uniform, texture, sampler]);
        let row_bindings = bindings("rows", &[rows]);
        let pipeline = |label, layout| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(label),
                bind_group_layouts: &[Some(layout), Some(&row_bindings)],
                immediate_size: 0,
            })
        };
        Self {
            shadow: pipeline("shadow", &shadow_bindings),
            scene: pipeline("scene", &scene_bindings),
            shadow_bindings,
            scene_bindings,
            row_bindings,
        }
    }

    /// Binds the first bytes of a buffer of rows.
    pub fn bind_rows(
        &self,
        device: &wgpu::Device,
        buffer: &wgpu::Buffer,
        bytes: u64,
    ) -> wgpu::BindGroup {
        let rows = wgpu::BufferBinding {
            buffer,
            offset: 0,
            size: wgpu::BufferSize::new(bytes),
        };
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("rows"),
            layout: &self.row_bindings,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::Buffer(rows),
            }],
        })
    }
}

/// Uniform, shadow map, the sampler that compares with it; and in their own group the rows.
fn entries() -> [wgpu::BindGroupLayoutEntry; 4] {
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty,
        count: None,
    };
    let buffer = |ty| wgpu::BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let uniform = buffer(wgpu::BufferBindingType::Uniform);
    let rows = buffer(wgpu::BufferBindingType::Storage { read_only: true });
    let depths = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Depth,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let compare = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison);
    [
        entry(0, wgpu::ShaderStages::VERTEX_FRAGMENT, uniform),
        entry(1, wgpu::ShaderStages::FRAGMENT, depths),
        entry(2, wgpu::ShaderStages::FRAGMENT, compare),
        entry(0, wgpu::ShaderStages::VERTEX, rows),
    ]
}

/// The uniform buffer and the groups that bind it.
pub struct Bindings {
    uniform: wgpu::Buffer,
    /// For the shadow's pass.
    pub shadow: wgpu::BindGroup,
    /// For the scene's pass.
    pub scene: wgpu::BindGroup,
}

impl Bindings {
    /// Makes them around a shadow map.
    pub fn new(device: &wgpu::Device, layouts: &Layouts, shadow_map: &ShadowMap) -> Self {
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: size_of::<FrameUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let group = |label, layout, entries: &[_]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(label),
                layout,
                entries,
            })
        };
        let whole = entry(0, uniform.as_entire_binding());
        let map = wgpu::BindingResource::TextureView(&shadow_map.view);
        let sampler = wgpu::BindingResource::Sampler(&shadow_map.sampler);
        let shadow = group(
            "shadow",
            &layouts.shadow_bindings,
            std::slice::from_ref(&whole),
        );
        let scene_entries = [whole, entry(1, map), entry(2, sampler)];
        let scene = group("scene", &layouts.scene_bindings, &scene_entries);
        Self {
            uniform,
            shadow,
            scene,
        }
    }

    /// Takes the numbers of a frame.
    pub fn write(&self, queue: &wgpu::Queue, uniform: &FrameUniform) {
        queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(uniform));
    }
}
