//! Lines: what an engine shows of its inner state, edges of walls, the pull of the mouse.
//! Each is drawn fully where nothing hides it, and faintly elsewhere.

use ch00_scenes::Line;
use glam::Vec3;

use super::buffer::GrowingBuffer;
use super::faces::{THROUGH, byte};
use super::pipeline::{PipelineMaker, Recipe};
use super::shaders;
use super::surroundings::{Face, Surroundings};
use super::theme::Colors;

/// A line with a width, as the shader wants it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Stroke {
    /// From, m.
    pub from: [f32; 3],
    /// Points of the screen.
    pub width: f32,
    /// To, m.
    pub to: [f32; 3],
    /// sRGB and opacity.
    pub color: [u8; 4],
}

const STROKE: [wgpu::VertexAttribute; 4] =
    wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32, 2 => Float32x3, 3 => Unorm8x4];

/// The two pipelines that draw lines: where nothing hides them, and faintly elsewhere.
pub struct LinePipelines {
    full: wgpu::RenderPipeline,
    hidden: wgpu::RenderPipeline,
}

impl LinePipelines {
    /// For lines that lie so in their buffer and that this function of the shader places.
    pub fn new(
        maker: &PipelineMaker,
        entry: &str,
        layout: wgpu::VertexBufferLayout<'static>,
    ) -> Self {
        let buffers = [Some(layout)];
        let pipeline = |depth_compare, opacity| {
            maker.make(&Recipe {
                shader: shaders::LINES,
                entries: [entry, "fs_line"],
                buffers: &buffers,
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                cull: None,
                depth_compare,
                hides: false,
                is_translucent: true,
                is_seen: true,
                constants: &[("opacity", opacity)],
            })
        };
        Self {
            full: pipeline(wgpu::CompareFunction::GreaterEqual, 1.0),
            hidden: pipeline(wgpu::CompareFunction::Less, THROUGH),
        }
    }

    /// Draws so many lines faintly where something hides them.
    pub fn draw_hidden(&self, pass: &mut wgpu::RenderPass, lines: &GrowingBuffer, count: u32) {
        draw_with(pass, &self.hidden, lines, count);
    }

    /// Draws so many lines where nothing hides them.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, lines: &GrowingBuffer, count: u32) {
        draw_with(pass, &self.full, lines, count);
    }
}

fn draw_with(
    pass: &mut wgpu::RenderPass,
    pipeline: &wgpu::RenderPipeline,
    lines: &GrowingBuffer,
    count: u32,
) {
    if count > 0 {
        pass.set_vertex_buffer(0, lines.slice());
        pass.set_pipeline(pipeline);
        pass.draw(0..4, 0..count);
    }
}

/// Strokes and the pipelines that draw them.
pub struct Lines {
    strokes: GrowingBuffer,
    count: u32,
    pipelines: LinePipelines,
}

impl Lines {
    /// Without lines.
    pub fn new(maker: &PipelineMaker) -> Self {
        let layout = wgpu::VertexBufferLayout {
            array_stride: size_of::<Stroke>() as u64,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &STROKE,
        };
        Self {
            strokes: GrowingBuffer::new(maker.device, "lines", wgpu::BufferUsages::VERTEX),
            count: 0,
            pipelines: LinePipelines::new(maker, "vs_line", layout),
        }
    }

    /// Takes the lines of a frame.
    pub fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, strokes: &[Stroke]) {
        self.strokes.write(device, queue, strokes);
        // More than 2³² lines would draw none.
        self.count = u32::try_from(strokes.len()).unwrap_or(0);
    }

    /// Draws them faintly where something hides them.
    pub fn draw_hidden(&self, pass: &mut wgpu::RenderPass) {
        self.pipelines.draw_hidden(pass, &self.strokes, self.count);
    }

    /// Draws them where nothing hides them.
    pub fn draw(&self, pass: &mut wgpu::RenderPass) {
        self.pipelines.draw(pass, &self.strokes, self.count);
    }
}

/// A line of an engine's layer.
#[must_use]
pub fn stroke_of(line: &Line) -> Stroke {
    let [r, g, b] = line.color.map(byte);
    Stroke {
        from: line.from,
        width: line.width,
        to: line.to,
        color: [r, g, b, 255],
    }
}

/// A line of a width in points of the screen.
#[must_use]
pub fn stroke_between(from: Vec3, to: Vec3, width: f32, color: [u8; 4]) -> Stroke {
    Stroke {
        from: from.to_array(),
        width,
        to: to.to_array(),
        color,
    }
}

/// Edges of the walls' inner faces: all four where `eye` looks at the inside, otherwise the
/// lower one, so that the outline on the floor is whole and nothing crosses the scene.
pub fn wall_edges(
    surroundings: &Surroundings,
    eye: Vec3,
    colors: &Colors,
) -> impl Iterator<Item = Stroke> {
    let color = colors.edge_display;
    let edges_of = move |face: &Face| {
        let corner = |x: f32, y: f32| (face.centre + x * face.across + y * face.up).to_array();
        let down = -face.up.y.signum();
        let corners = [
            corner(-1.0, down),
            corner(1.0, down),
            corner(1.0, -down),
            corner(-1.0, -down),
        ];
        let is_seen = face.normal.dot(eye - face.centre) > 0.0;
        [(0, 1), (1, 2), (2, 3), (3, 0)]
            .into_iter()
            .take(if is_seen { 4 } else { 1 })
            .map(move |(i, j)| Stroke {
                from: corners[i],
                width: 1.2,
                to: corners[j],
                color,
            })
    };
    surroundings.wall_faces.iter().flat_map(edges_of)
}
