//! Bodies: one mesh a shape, one buffer of instances, one draw call for each group of bodies
//! with the same mesh.

use super::buffer::GrowingBuffer;
use super::instances::{Group, Instance, Instances};
use super::meshes::{self, Mesh, Vertex};
use super::pipeline::{PipelineMaker, Recipe};
use super::quality::Quality;
use super::shaders;

const VERTEX: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32, 2 => Float32x3];
const INSTANCE: [wgpu::VertexAttribute; 5] = wgpu::vertex_attr_array![
    3 => Float32x3, 4 => Uint32, 5 => Float32x4, 6 => Float32x4, 7 => Float32x4];

/// How meshes and instances lie in their buffers.
pub fn vertex_layouts() -> [Option<wgpu::VertexBufferLayout<'static>>; 2] {
    let layout = |stride: usize, step_mode, attributes| {
        Some(wgpu::VertexBufferLayout {
            array_stride: stride as u64,
            step_mode,
            attributes,
        })
    };
    [
        layout(size_of::<Vertex>(), wgpu::VertexStepMode::Vertex, &VERTEX),
        layout(
            size_of::<Instance>(),
            wgpu::VertexStepMode::Instance,
            &INSTANCE,
        ),
    ]
}

/// A mesh on the device.
struct MeshBuffers {
    vertices: GrowingBuffer,
    indices: GrowingBuffer,
    index_count: u32,
}

impl MeshBuffers {
    fn new(device: &wgpu::Device, queue: &wgpu::Queue, mesh: &Mesh) -> Self {
        let mut vertices = GrowingBuffer::new(device, "vertices", wgpu::BufferUsages::VERTEX);
        let mut indices = GrowingBuffer::new(device, "indices", wgpu::BufferUsages::INDEX);
        vertices.write(device, queue, &mesh.vertices);
        indices.write(device, queue, &mesh.indices);
        Self {
            vertices,
            indices,
            // A mesh has thousands of indices; a count that did not fit would draw nothing.
            index_count: u32::try_from(mesh.indices.len()).unwrap_or(0),
        }
    }
}

/// Meshes, instances and the two pipelines that draw them.
pub struct Bodies {
    meshes: [MeshBuffers; 4],
    ball_subdivisions: u32,
    instances: GrowingBuffer,
    groups: Vec<Group>,
    moving: wgpu::RenderPipeline,
    resting: wgpu::RenderPipeline,
}

impl Bodies {
    /// Without bodies.
    pub fn new(maker: &PipelineMaker, queue: &wgpu::Queue) -> Self {
        let device = maker.device;
        let subdivisions = maker.quality.subdivisions(0);
        let all_meshes = [
            meshes::sphere(subdivisions),
            meshes::cube(),
            meshes::capsule(32, 8),
            meshes::cylinder(40),
        ];
        let pipeline = |fragment| {
            maker.make(&Recipe {
                shader: shaders::BODIES,
                entries: ["vs_body", fragment],
                buffers: &vertex_layouts(),
                topology: wgpu::PrimitiveTopology::TriangleList,
                cull: Some(wgpu::Face::Back),
                depth_compare: wgpu::CompareFunction::Greater,
                hides: true,
                is_translucent: false,
                constants: &[("shadow_reach", f64::from(maker.quality.shadow_reach))],
            })
        };
        Self {
            meshes: all_meshes.map(|mesh| MeshBuffers::new(device, queue, &mesh)),
            ball_subdivisions: subdivisions,
            instances: GrowingBuffer::new(device, "instances", wgpu::BufferUsages::VERTEX),
            groups: Vec::new(),
            moving: pipeline("fs_body"),
            resting: pipeline("fs_static"),
        }
    }

    /// Takes the bodies of a frame.
    pub fn write(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        quality: &Quality,
        instances: &Instances,
    ) {
        let subdivisions = quality.subdivisions(instances.all.len());
        if subdivisions != self.ball_subdivisions {
            self.ball_subdivisions = subdivisions;
            self.meshes[0] = MeshBuffers::new(device, queue, &meshes::sphere(subdivisions));
        }
        self.instances.write(device, queue, &instances.all);
        self.groups.clone_from(&instances.groups);
    }

    /// Draws all groups with the pipeline that is set: the shadow's.
    pub fn draw_depths(&self, pass: &mut wgpu::RenderPass) {
        for group in &self.groups {
            self.draw_group(pass, group);
        }
    }

    /// Draws all groups, each with its pipeline.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        for group in &self.groups {
            pass.set_pipeline(if group.is_static {
                &self.resting
            } else {
                &self.moving
            });
            self.draw_group(pass, group);
        }
    }

    fn draw_group(&self, pass: &mut wgpu::RenderPass, group: &Group) {
        let mesh = &self.meshes[group.mesh];
        pass.set_vertex_buffer(0, mesh.vertices.slice());
        pass.set_vertex_buffer(1, self.instances.slice());
        pass.set_index_buffer(mesh.indices.slice(), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..mesh.index_count, 0, group.range.clone());
    }
}
