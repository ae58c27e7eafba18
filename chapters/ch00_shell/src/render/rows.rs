//! Where bodies are: the rows that shaders read, of an engine that keeps them on the device, or
//! written from the states of one that doesn't.

use glam::{DQuat, DVec3};

use super::Picture;
use super::bindings::Layouts;
use super::buffer::GrowingBuffer;
use crate::Session;
use crate::gpu::Gpu;
use crate::resident::Drawn;

/// The rows of a frame.
pub struct Rows {
    /// For engines that keep their bodies elsewhere.
    own: GrowingBuffer,
    /// Which revision of the session was written.
    written: Option<u64>,
    staged: Vec<Drawn>,
    bound: Option<Bound>,
}

/// Rows to be read by shaders.
struct Bound {
    buffer: wgpu::Buffer,
    bytes: u64,
    group: wgpu::BindGroup,
}

impl Rows {
    /// Without bodies.
    pub fn new(device: &wgpu::Device) -> Self {
        Self {
            own: GrowingBuffer::new(device, "rows", wgpu::BufferUsages::STORAGE),
            written: None,
            staged: Vec::new(),
            bound: None,
        }
    }

    /// Another scene has begun.
    pub fn forget(&mut self) {
        self.written = None;
    }

    /// Takes the bodies of a picture. Those of an engine on the same device stay where they are, unless
    /// something is shown with them that is as late as the last state that came back.
    pub fn follow(&mut self, gpu: &Gpu, layouts: &Layouts, picture: &Picture) {
        let session = picture.session;
        let resident = session
            .resident()
            .filter(|resident| !picture.is_as_read && resident.gpu.device == gpu.device);
        let buffer = if let Some(resident) = resident {
            resident.bodies.clone()
        } else {
            self.write(gpu, session);
            self.own.buffer().clone()
        };
        let rows = session.scene().bodies.len().max(1);
        let bytes = (rows * size_of::<Drawn>()) as u64;
        let fits = |bound: &Bound| bound.buffer == buffer && bound.bytes == bytes;
        if !self.bound.as_ref().is_some_and(fits) {
            let group = layouts.bind_rows(&gpu.device, &buffer, bytes);
            self.bound = Some(Bound {
                buffer,
                bytes,
                group,
            });
        }
    }

    /// Lets shaders of this pass read them.
    pub fn bind(&self, pass: &mut wgpu::RenderPass) {
        if let Some(bound) = &self.bound {
            pass.set_bind_group(1, &bound.group, &[]);
        }
    }

    /// Writes the last two states, if they are new.
    fn write(&mut self, gpu: &Gpu, session: &Session) {
        if self.written == Some(session.revision()) {
            return;
        }
        self.written = Some(session.revision());
        let now = session.state_now();
        let last = session.state_before();
        self.staged.clear();
        self.staged.extend((0..now.len()).map(|i| {
            let (position, orientation) = place(now.position[i], now.orientation[i]);
            let (position_last, orientation_last) = place(last.position[i], last.orientation[i]);
            Drawn {
                position,
                orientation,
                position_last,
                orientation_last,
                ..Drawn::default()
            }
        }));
        self.own.write(&gpu.device, &gpu.queue, &self.staged);
    }
}

fn place(position: DVec3, orientation: DQuat) -> ([f32; 3], [f32; 4]) {
    (
        position.as_vec3().to_array(),
        orientation.as_quat().to_array(),
    )
}
