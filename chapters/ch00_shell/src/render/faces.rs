//! Faces: the triangles of drawings, such as heads of arrows and cones of limits. Solid ones
//! hide what is behind them; translucent ones are mixed with it, the farthest first.

use ch00_scenes::Face;
use glam::Vec3;

use super::buffer::GrowingBuffer;
use super::pipeline::{PipelineMaker, Recipe};
use super::shaders;

/// A corner of a face, as the shader wants it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct Corner {
    position: [f32; 3],
    /// sRGB and opacity.
    color: [u8; 4],
}

const CORNER: [wgpu::VertexAttribute; 2] = wgpu::vertex_attr_array![0 => Float32x3, 1 => Unorm8x4];

/// How much of a face or a line shows through what hides it.
pub const THROUGH: f64 = 0.4;

/// Corners and the pipelines that draw them.
pub struct Faces {
    corners: GrowingBuffer,
    /// How many corners are of solid faces, which come first, and how many there are.
    solid: u32,
    all: u32,
    hidden: wgpu::RenderPipeline,
    solid_ones: wgpu::RenderPipeline,
    translucent_ones: wgpu::RenderPipeline,
}

impl Faces {
    /// Without faces.
    pub fn new(maker: &PipelineMaker) -> Self {
        let layout = wgpu::VertexBufferLayout {
            array_stride: size_of::<Corner>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &CORNER,
        };
        let pipeline = |depth_compare, hides, opacity| {
            maker.make(&Recipe {
                shader: shaders::FACES,
                entries: ["vs_face", "fs_face"],
                buffers: &[Some(layout.clone())],
                topology: wgpu::PrimitiveTopology::TriangleList,
                cull: None,
                depth_compare,
                hides,
                is_translucent: true,
                is_seen: true,
                constants: &[("opacity", opacity)],
            })
        };
        Self {
            corners: GrowingBuffer::new(maker.device, "faces", wgpu::BufferUsages::VERTEX),
            solid: 0,
            all: 0,
            hidden: pipeline(wgpu::CompareFunction::Less, false, THROUGH),
            solid_ones: pipeline(wgpu::CompareFunction::GreaterEqual, true, 1.0),
            translucent_ones: pipeline(wgpu::CompareFunction::GreaterEqual, false, 1.0),
        }
    }

    /// Takes the faces of a frame that is seen from `eye`.
    pub fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, faces: &[Face], eye: Vec3) {
        let (corners, solid) = in_order(faces, eye);
        self.corners.write(device, queue, &corners);
        // More than 2³² corners would draw none.
        self.solid = u32::try_from(solid).unwrap_or(0);
        self.all = u32::try_from(corners.len()).unwrap_or(0);
    }

    /// Draws them faintly where something hides them.
    pub fn draw_hidden(&self, pass: &mut wgpu::RenderPass) {
        self.draw_range(pass, &self.hidden, 0..self.all);
    }

    /// Draws the solid ones where nothing hides them.
    pub fn draw_solid(&self, pass: &mut wgpu::RenderPass) {
        self.draw_range(pass, &self.solid_ones, 0..self.solid);
    }

    /// Draws the translucent ones where nothing hides them.
    pub fn draw_translucent(&self, pass: &mut wgpu::RenderPass) {
        self.draw_range(pass, &self.translucent_ones, self.solid..self.all);
    }

    fn draw_range(
        &self,
        pass: &mut wgpu::RenderPass,
        pipeline: &wgpu::RenderPipeline,
        range: std::ops::Range<u32>,
    ) {
        if !range.is_empty() {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, self.corners.slice());
            pass.draw(range, 0..1);
        }
    }
}

/// The corners of all faces, solid faces first, then the others from the farthest to the
/// nearest; and how many corners are of solid ones.
fn in_order(faces: &[Face], eye: Vec3) -> (Vec<Corner>, usize) {
    let (solid, mut others): (Vec<&Face>, Vec<&Face>) =
        faces.iter().partition(|face| face.color[3] >= 1.0);
    let distance = |face: &Face| {
        let sum: Vec3 = face.corners.iter().map(|&corner| Vec3::from(corner)).sum();
        (sum / 3.0).distance_squared(eye)
    };
    others.sort_by(|a, b| distance(b).total_cmp(&distance(a)));
    let corners = solid.iter().chain(&others).flat_map(|face| {
        let color = face.color.map(byte);
        face.corners.map(|position| Corner { position, color })
    });
    (corners.collect(), 3 * solid.len())
}

/// A part of a colour, 0 … 1, as a byte.
pub fn byte(part: f32) -> u8 {
    (part.clamp(0.0, 1.0) * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face_at(z: f32, opacity: f32) -> Face {
        Face {
            corners: [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]],
            color: [1.0, 0.5, 0.0, opacity],
        }
    }

    #[test]
    fn solid_faces_come_first_then_the_farthest() {
        let faces = [face_at(1.0, 0.2), face_at(2.0, 1.0), face_at(-3.0, 0.2)];
        let (corners, solid) = in_order(&faces, Vec3::new(0.0, 0.0, 5.0));
        let depths: Vec<f32> = corners.iter().step_by(3).map(|c| c.position[2]).collect();
        assert_eq!((depths, solid), (vec![2.0, -3.0, 1.0], 3));
        assert_eq!(corners[0].color, [255, 128, 0, 255]);
    }
}
