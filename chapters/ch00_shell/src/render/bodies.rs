//! Bodies: one buffer of instances, and one draw call for each group of bodies of the same
//! shape. Boxes, capsules and cylinders are meshes; balls are squares that their shader
//! makes round. Where a body is, the shaders read from its row.

use super::buffer::GrowingBuffer;
use super::looks::{Group, Kind, LOOK, Look, Looks};
use super::meshes::{self, Mesh, Vertex};
use super::pipeline::{PipelineMaker, Recipe};
use super::shaders;
use super::shadow::ShadowMap;

const VERTEX: [wgpu::VertexAttribute; 3] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32, 2 => Float32x3];

/// The group of balls.
const BALL: usize = 0;

/// Corners of the square that shows a ball.
const BALL_CORNERS: u32 = 4;

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
        layout(size_of::<Look>(), wgpu::VertexStepMode::Instance, &LOOK),
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

/// Meshes, instances and the pipelines that draw them.
pub struct Bodies {
    /// Of box, capsule and cylinder.
    meshes: [MeshBuffers; 3],
    looks: GrowingBuffer,
    groups: Vec<Group>,
    moving: wgpu::RenderPipeline,
    resting: wgpu::RenderPipeline,
    ball_depths: wgpu::RenderPipeline,
    ball_surfaces: wgpu::RenderPipeline,
    balls: wgpu::RenderPipeline,
    glass: Glass,
}

/// The pipelines for bodies of glass: first only how deep each pixel's nearest glass lies, then
/// its colour, so that nobody sees glass through glass.
struct Glass {
    depths: wgpu::RenderPipeline,
    ball_depths: wgpu::RenderPipeline,
    meshes: wgpu::RenderPipeline,
    balls: wgpu::RenderPipeline,
}

impl Glass {
    /// From the recipes for meshes and balls that aren't of glass.
    fn new(maker: &PipelineMaker, meshes: &Recipe, balls: &Recipe) -> Self {
        let meshes = Recipe {
            entries: ["vs_body", "fs_glass"],
            ..*meshes
        };
        let balls = Recipe {
            entries: ["vs_ball", "fs_glass_ball"],
            ..*balls
        };
        Self {
            depths: maker.make(&Recipe {
                is_seen: false,
                ..meshes
            }),
            ball_depths: maker.make(&Recipe {
                depth_compare: wgpu::CompareFunction::Greater,
                hides: true,
                is_seen: false,
                ..balls
            }),
            meshes: maker.make(&Recipe {
                depth_compare: wgpu::CompareFunction::Equal,
                hides: false,
                is_translucent: true,
                ..meshes
            }),
            balls: maker.make(&Recipe {
                depth_compare: wgpu::CompareFunction::Equal,
                ..balls
            }),
        }
    }
}

/// How meshes that move are drawn.
fn of_meshes<'a>(
    buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    constants: &'a [(&'a str, f64)],
) -> Recipe<'a> {
    Recipe {
        shader: shaders::BODIES,
        entries: ["vs_body", "fs_body"],
        buffers,
        topology: wgpu::PrimitiveTopology::TriangleList,
        cull: Some(wgpu::Face::Back),
        depth_compare: wgpu::CompareFunction::Greater,
        hides: true,
        is_translucent: false,
        is_seen: true,
        constants,
    }
}

/// How balls are, where meshes are drawn like this.
fn of_balls<'a>(meshes: &Recipe<'a>) -> Recipe<'a> {
    Recipe {
        shader: shaders::BALLS,
        entries: ["vs_ball", "fs_ball"],
        topology: wgpu::PrimitiveTopology::TriangleStrip,
        cull: None,
        depth_compare: wgpu::CompareFunction::GreaterEqual,
        hides: false,
        is_translucent: true,
        buffers: &meshes.buffers[1..],
        ..*meshes
    }
}

impl Bodies {
    /// Without bodies.
    pub fn new(maker: &PipelineMaker, queue: &wgpu::Queue) -> Self {
        let device = maker.device;
        let meshes = [meshes::cube(), meshes::capsule(32, 8), meshes::cylinder(40)];
        let constants = [("shadow_reach", f64::from(maker.quality.shadow_reach))];
        let layouts = vertex_layouts();
        let moving = of_meshes(&layouts, &constants);
        let resting = Recipe {
            entries: ["vs_body", "fs_static"],
            ..moving
        };
        let balls = of_balls(&moving);
        let ball_depths = Recipe {
            entries: ["vs_ball", "fs_ball_depth"],
            hides: true,
            is_translucent: false,
            is_seen: false,
            ..balls
        };
        let ball_surfaces = Recipe {
            entries: ["vs_ball", "fs_ball_surface"],
            ..ball_depths
        };
        Self {
            meshes: meshes.map(|mesh| MeshBuffers::new(device, queue, &mesh)),
            looks: GrowingBuffer::new(device, "looks", wgpu::BufferUsages::VERTEX),
            groups: Vec::new(),
            moving: maker.make(&moving),
            resting: maker.make(&resting),
            ball_depths: maker.make(&ball_depths),
            ball_surfaces: maker.make(&ball_surfaces),
            balls: maker.make(&balls),
            glass: Glass::new(maker, &moving, &balls),
        }
    }

    /// Takes other bodies, or others' looks.
    pub fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, looks: &Looks) {
        self.looks.write(device, queue, &looks.all);
        self.groups.clone_from(&looks.groups);
    }

    /// Draws all groups that aren't of glass into the shadow map; a ball's shadow has so many
    /// corners.
    pub fn draw_shadows(&self, pass: &mut wgpu::RenderPass, shadow: &ShadowMap, corners: u32) {
        for group in self.groups.iter().filter(|group| group.kind != Kind::Glass) {
            if group.shape == BALL {
                pass.set_pipeline(&shadow.balls);
                self.draw_balls(pass, group, corners);
            } else {
                pass.set_pipeline(&shadow.bodies);
                self.draw_meshes(pass, group);
            }
        }
    }

    /// Draws all groups but the balls and what is of glass.
    pub fn draw_all_but_balls(&self, pass: &mut wgpu::RenderPass) {
        for group in self.groups.iter().filter(|group| group.shape != BALL) {
            pass.set_pipeline(match group.kind {
                Kind::Moving => &self.moving,
                Kind::Static => &self.resting,
                Kind::Glass => continue,
            });
            self.draw_meshes(pass, group);
        }
    }

    /// Draws how deep the balls lie, so that nothing is coloured that they hide.
    pub fn draw_ball_depths(&self, pass: &mut wgpu::RenderPass) {
        self.draw_balls_with(pass, &self.ball_depths);
    }

    /// Draws the balls over what is behind them.
    pub fn draw_balls_only(&self, pass: &mut wgpu::RenderPass) {
        self.draw_balls_with(pass, &self.balls);
    }

    /// Draws the depths of the balls' surfaces, for what may be inside balls.
    pub fn draw_ball_surfaces(&self, pass: &mut wgpu::RenderPass) {
        self.draw_balls_with(pass, &self.ball_surfaces);
    }

    fn draw_balls_with(&self, pass: &mut wgpu::RenderPass, pipeline: &wgpu::RenderPipeline) {
        let is_solid_ball = |group: &&Group| group.shape == BALL && group.kind != Kind::Glass;
        for group in self.groups.iter().filter(is_solid_ball) {
            pass.set_pipeline(pipeline);
            self.draw_balls(pass, group, BALL_CORNERS);
        }
    }

    /// Draws what is of glass over everything else; whether anything is.
    pub fn draw_glass(&self, pass: &mut wgpu::RenderPass) -> bool {
        let glass = |group: &&Group| group.kind == Kind::Glass;
        for [balls, meshes] in [
            [&self.glass.ball_depths, &self.glass.depths],
            [&self.glass.balls, &self.glass.meshes],
        ] {
            for group in self.groups.iter().filter(glass) {
                if group.shape == BALL {
                    pass.set_pipeline(balls);
                    self.draw_balls(pass, group, BALL_CORNERS);
                } else {
                    pass.set_pipeline(meshes);
                    self.draw_meshes(pass, group);
                }
            }
        }
        self.groups.iter().any(|group| group.kind == Kind::Glass)
    }

    fn draw_balls(&self, pass: &mut wgpu::RenderPass, group: &Group, corners: u32) {
        pass.set_vertex_buffer(0, self.looks.slice());
        pass.draw(0..corners, group.range.clone());
    }

    fn draw_meshes(&self, pass: &mut wgpu::RenderPass, group: &Group) {
        let mesh = &self.meshes[group.shape - 1];
        pass.set_vertex_buffer(0, mesh.vertices.slice());
        pass.set_vertex_buffer(1, self.looks.slice());
        pass.set_index_buffer(mesh.indices.slice(), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..mesh.index_count, 0, group.range.clone());
    }
}
