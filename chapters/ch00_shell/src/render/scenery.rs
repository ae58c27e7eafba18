//! What is around the bodies: background, ground and walls.

use glam::Vec3;

use super::buffer::GrowingBuffer;
use super::pipeline::{PipelineMaker, Recipe};
use super::shaders;
use super::surroundings::{Face, Surroundings};

/// A corner of a wall's face.
#[repr(C)]
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
struct WallVertex {
    position: [f32; 3],
    normal: [f32; 3],
    /// Horizontal and vertical position along the face, m.
    across: [f32; 2],
}

const WALL: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x2];

/// Background, ground and walls.
pub struct Scenery {
    sky: wgpu::RenderPipeline,
    ground: wgpu::RenderPipeline,
    /// The ground of a scene without a floor.
    grid_only: wgpu::RenderPipeline,
    has_ground: bool,
    walls: wgpu::RenderPipeline,
    wall_vertices: GrowingBuffer,
    wall_vertex_count: u32,
}

impl Scenery {
    /// Without walls.
    pub fn new(maker: &PipelineMaker) -> Self {
        let shadow_reach = ("shadow_reach", f64::from(maker.quality.shadow_reach));
        let plain = Recipe {
            shader: shaders::SKY,
            entries: ["vs_sky", "fs_sky"],
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            cull: None,
            depth_compare: wgpu::CompareFunction::GreaterEqual,
            hides: false,
            is_translucent: false,
            is_seen: true,
            constants: &[],
        };
        let ground = |is_opaque: bool| {
            maker.make(&Recipe {
                shader: shaders::GROUND,
                entries: ["vs_ground", "fs_ground"],
                hides: is_opaque,
                is_translucent: !is_opaque,
                constants: &[shadow_reach, ("is_opaque", f64::from(u8::from(is_opaque)))],
                ..plain
            })
        };
        let wall_layout = wgpu::VertexBufferLayout {
            array_stride: size_of::<WallVertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &WALL,
        };
        let walls = Recipe {
            shader: shaders::WALLS,
            entries: ["vs_wall", "fs_wall"],
            buffers: &[Some(wall_layout)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            cull: Some(wgpu::Face::Back),
            is_translucent: true,
            ..plain
        };
        Self {
            sky: maker.make(&plain),
            ground: ground(true),
            grid_only: ground(false),
            has_ground: false,
            walls: maker.make(&walls),
            wall_vertices: GrowingBuffer::new(maker.device, "walls", wgpu::BufferUsages::VERTEX),
            wall_vertex_count: 0,
        }
    }

    /// Takes the walls of a scene.
    pub fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, around: &Surroundings) {
        let vertices: Vec<WallVertex> = around.wall_faces.iter().flat_map(triangles).collect();
        self.wall_vertices.write(device, queue, &vertices);
        // More than 2³² corners of walls would draw none.
        self.wall_vertex_count = u32::try_from(vertices.len()).unwrap_or(0);
        self.has_ground = around.has_floor;
    }

    /// Draws ground, background and walls where the bodies drawn before leave room. What
    /// hides comes first, so that no pixel is drawn in vain.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        let corners_of = |pipeline| if pipeline == &self.sky { 3 } else { 4 };
        let order = if self.has_ground {
            [&self.ground, &self.sky]
        } else {
            [&self.sky, &self.grid_only]
        };
        for pipeline in order {
            pass.set_pipeline(pipeline);
            pass.draw(0..corners_of(pipeline), 0..1);
        }
        if self.wall_vertex_count > 0 {
            pass.set_pipeline(&self.walls);
            pass.set_vertex_buffer(0, self.wall_vertices.slice());
            pass.draw(0..self.wall_vertex_count, 0..1);
        }
    }
}

/// Two triangles, anticlockwise from the side to look at.
fn triangles(face: &Face) -> [WallVertex; 6] {
    let faces_viewer = face.across.cross(face.up).dot(face.normal) > 0.0;
    let across = if faces_viewer {
        face.across
    } else {
        -face.across
    };
    let horizontal = face.across.normalize_or(Vec3::X);
    [(-1, -1), (1, -1), (1, 1), (-1, -1), (1, 1), (-1, 1)].map(|(x, y): (i8, i8)| {
        let position = face.centre + f32::from(x) * across + f32::from(y) * face.up;
        WallVertex {
            position: position.to_array(),
            normal: face.normal.to_array(),
            across: [position.dot(horizontal), position.y],
        }
    })
}
