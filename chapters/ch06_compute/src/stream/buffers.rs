//! Memory on the GPU.

use super::{ColumnInfo, Gpu, StreamError};

// ANCHOR: allocate
/// A buffer for a column, if the device allows it.
pub(super) fn allocate(
    gpu: &Gpu,
    info: &ColumnInfo,
    usage: wgpu::BufferUsages,
) -> Result<wgpu::Buffer, StreamError> {
    let most = gpu.most_rows(info.row_bytes);
    if info.capacity as u64 > most {
        return Err(StreamError::TooLarge {
            column: info.name.clone(),
            asked: info.capacity as u64,
            row_bytes: info.row_bytes as u64,
            most,
            device: gpu.name.clone(),
        });
    }
    let size = (info.capacity * info.row_bytes) as u64;
    let scope = gpu.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(&info.name),
        size: size.next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT),
        usage,
        mapped_at_creation: false,
    });
    match pollster::block_on(scope.pop()) {
        None => Ok(buffer),
        Some(_) => Err(StreamError::OutOfMemory {
            column: info.name.clone(),
            bytes: size,
            device: gpu.name.clone(),
        }),
    }
}
// ANCHOR_END: allocate

/// A buffer that the GPU can copy to and this side can read.
pub(super) fn readable(gpu: &Gpu, bytes: u64) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size: bytes.max(4),
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
