//! The shaders, each put together from its file and the shared files that it needs. They are
//! part of the program, so that it runs wherever it is copied to.

const ROTATION: &str = include_str!("../../../../shaders/common/rotation.wgsl");
const FRAME: &str = include_str!("../../../../shaders/ch00_frame.wgsl");
const DRAWN: &str = include_str!("../../../../shaders/ch00_drawn.wgsl");
const LIGHT: &str = include_str!("../../../../shaders/ch00_light.wgsl");

/// A shader: a name and the files that make it, in order.
#[derive(Clone, Copy, Debug)]
pub struct Shader {
    /// Its file in `shaders/`.
    pub file: &'static str,
    parts: &'static [&'static str],
}

impl Shader {
    /// The whole source.
    #[must_use]
    pub fn source(&self) -> String {
        self.parts.join("\n")
    }

    pub(super) fn module(&self, device: &wgpu::Device) -> wgpu::ShaderModule {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(self.file),
            source: wgpu::ShaderSource::Wgsl(self.source().into()),
        })
    }
}

macro_rules! shader {
    ($file:literal, needs $($part:ident),*) => {
        Shader {
            file: $file,
            parts: &[$($part,)* include_str!(concat!("../../../../shaders/", $file))],
        }
    };
}

/// Balls.
pub const BALLS: Shader = shader!("ch00_balls.wgsl", needs ROTATION, FRAME, DRAWN, LIGHT);
/// Boxes, capsules and cylinders.
pub const BODIES: Shader = shader!("ch00_bodies.wgsl", needs ROTATION, FRAME, DRAWN, LIGHT);
/// Depths as the sun sees them.
pub const SHADOW: Shader = shader!("ch00_shadow.wgsl", needs ROTATION, FRAME, DRAWN);
/// Background.
pub const SKY: Shader = shader!("ch00_sky.wgsl", needs FRAME);
/// Ground with its grid.
pub const GROUND: Shader = shader!("ch00_ground.wgsl", needs FRAME, LIGHT);
/// Walls.
pub const WALLS: Shader = shader!("ch00_walls.wgsl", needs FRAME);
/// Faces of drawings.
pub const FACES: Shader = shader!("ch00_faces.wgsl", needs FRAME);
/// Lines.
pub const LINES: Shader = shader!("ch00_lines.wgsl", needs ROTATION, FRAME, DRAWN);
