//! What holds bodies: rods to fixed points and of distance joints. Their ends are points of bodies, so
//! they are found where the bodies are drawn and change only with the scene.

use ch00_scenes::{Force, Joint, Scene};
use glam::DVec3;

use super::buffer::GrowingBuffer;
use super::lines::LinePipelines;
use super::pipeline::PipelineMaker;

/// A line between points of two bodies, as the shader wants it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
struct Rod {
    /// In the first body's coordinates, m.
    start: [f32; 3],
    first: u32,
    /// In the second body's coordinates, m.
    end: [f32; 3],
    second: u32,
    /// Points of the screen.
    width: f32,
    /// sRGB and opacity.
    color: [u8; 4],
}

const ROD: [wgpu::VertexAttribute; 6] = wgpu::vertex_attr_array![
    0 => Float32x3, 1 => Uint32, 2 => Float32x3, 3 => Uint32, 4 => Float32, 5 => Unorm8x4];

const COLOR: [u8; 4] = [120, 130, 140, 255];

/// The rods of a scene and the pipelines that draw them.
pub struct Rods {
    lines: GrowingBuffer,
    count: u32,
    /// How many bodies the scene had that they are of.
    bodies: Option<usize>,
    pipelines: LinePipelines,
}

impl Rods {
    /// Without rods.
    pub fn new(maker: &PipelineMaker) -> Self {
        let layout = wgpu::VertexBufferLayout {
            array_stride: size_of::<Rod>() as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &ROD,
        };
        Self {
            lines: GrowingBuffer::new(maker.device, "rods", wgpu::BufferUsages::VERTEX),
            count: 0,
            bodies: None,
            pipelines: LinePipelines::new(maker, "vs_rod", layout),
        }
    }

    /// Another scene has begun, or a body was taken out.
    pub fn forget(&mut self) {
        self.bodies = None;
    }

    /// Takes the rods of a scene.
    pub fn follow(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, scene: &Scene) {
        if self.bodies == Some(scene.bodies.len()) {
            return;
        }
        self.bodies = Some(scene.bodies.len());
        let rods = rods_of(scene);
        self.lines.write(device, queue, &rods);
        // More than 2³² rods would draw none.
        self.count = u32::try_from(rods.len()).unwrap_or(0);
    }

    /// Whether the scene has any.
    pub fn is_any(&self) -> bool {
        self.count > 0
    }

    /// Draws them faintly where something hides them.
    pub fn draw_hidden(&self, pass: &mut wgpu::RenderPass) {
        self.pipelines.draw_hidden(pass, &self.lines, self.count);
    }

    /// Draws them where nothing hides them.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        self.pipelines.draw(pass, &self.lines, self.count);
    }
}

fn rods_of(scene: &Scene) -> Vec<Rod> {
    let arms = scene.forces.iter().filter_map(|force| match *force {
        Force::FixedPoint { body, arm } => Some(rod([body, body], [-arm, DVec3::ZERO], 3.0)),
        Force::Magnets { .. } | Force::Constant { .. } => None,
    });
    let strings = scene.joints.iter().filter_map(|joint| match *joint {
        Joint::Distance { a, b, .. } => Some(rod([a, b], joint.anchors().into(), 2.0)),
        _ => None,
    });
    arms.chain(strings).collect()
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "memory ends before 2³² bodies"
)]
fn rod([first, second]: [usize; 2], [start, end]: [DVec3; 2], width: f32) -> Rod {
    Rod {
        start: start.as_vec3().to_array(),
        first: first as u32,
        end: end.as_vec3().to_array(),
        second: second as u32,
        width,
        color: COLOR,
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::builtin;

    use super::*;

    #[test]
    fn a_ball_on_a_string_has_a_rod_from_its_centre_to_where_it_hangs() {
        let scene = builtin::build("cradle", None, None).expect("`cradle` is built in");
        let rods = rods_of(&scene);
        assert_eq!(rods.len(), scene.joints.len());
        let length = |rod: &Rod| {
            let end = |point: [f32; 3], body: u32| {
                let body = &scene.bodies[body as usize];
                body.position + body.orientation * glam::Vec3::from(point).as_dvec3()
            };
            end(rod.start, rod.first).distance(end(rod.end, rod.second))
        };
        assert!(rods.iter().all(|rod| length(rod) > 0.1));
    }
}
