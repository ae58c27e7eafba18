//! A buffer that grows with what is written into it.

/// A buffer on the device and how much of it is in use.
pub struct GrowingBuffer {
    label: &'static str,
    usage: wgpu::BufferUsages,
    buffer: wgpu::Buffer,
}

impl GrowingBuffer {
    /// An empty buffer.
    pub fn new(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages) -> Self {
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        Self {
            label,
            usage,
            buffer: create(device, label, usage, 1024),
        }
    }

    /// Writes from the start; makes a larger buffer where this one is too small.
    pub fn write<T: bytemuck::NoUninit>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        data: &[T],
    ) {
        let bytes: &[u8] = bytemuck::cast_slice(data);
        let needed = bytes.len() as u64;
        if needed > self.buffer.size() {
            let size = needed.next_power_of_two();
            let size = size.min(device.limits().max_buffer_size).max(needed);
            self.buffer = create(device, self.label, self.usage, size);
        }
        if needed > 0 {
            queue.write_buffer(&self.buffer, 0, bytes);
        }
    }

    /// The buffer, until the next write.
    pub fn buffer(&self) -> &wgpu::Buffer {
        &self.buffer
    }

    /// All of it, to bind.
    pub fn slice(&self) -> wgpu::BufferSlice<'_> {
        self.buffer.slice(..)
    }
}

fn create(
    device: &wgpu::Device,
    label: &str,
    usage: wgpu::BufferUsages,
    size: u64,
) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size,
        usage,
        mapped_at_creation: false,
    })
}
