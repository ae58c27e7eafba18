//! Bringing rows down and waiting for them.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::buffers::readable;
use super::{Gpu, StreamError};

/// Some rows of a column.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<'a> {
    pub(super) buffer: &'a wgpu::Buffer,
    pub(super) offset: u64,
    pub(super) bytes: u64,
}

/// Memory that both sides can reach; kept from one time to the next.
#[derive(Debug, Default)]
pub(super) struct Fetch {
    shared: Mutex<Option<wgpu::Buffer>>,
}

impl Fetch {
    // ANCHOR: fetch
    /// Copies all parts where this side can read them, waits, and hands each to `take`.
    pub(super) fn parts(
        &self,
        gpu: &Gpu,
        parts: &[Part<'_>],
        mut take: impl FnMut(usize, &[u8]),
    ) -> Result<(), StreamError> {
        let total: u64 = parts.iter().map(|part| part.bytes).sum();
        if total == 0 {
            (0..parts.len()).for_each(|index| take(index, &[]));
            return gpu.check();
        }
        let shared = self.shared(gpu, total);
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut at = 0;
        for part in parts {
            encoder.copy_buffer_to_buffer(part.buffer, part.offset, &shared, at, part.bytes);
            at += part.bytes;
        }
        let arrived = Arc::new(OnceLock::new());
        let note = Arc::clone(&arrived);
        encoder.map_buffer_on_submit(&shared, wgpu::MapMode::Read, 0..total, move |result| {
            note.get_or_init(|| result.is_ok());
        });
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()?;
        if arrived.get() != Some(&true) {
            gpu.fail("it didn't bring rows down");
        }
        gpu.check()?;
        hand_out(gpu, &shared, total, parts, &mut take)?;
        shared.unmap();
        Ok(())
    }
    // ANCHOR_END: fetch

    /// The memory, made larger if it is too small.
    fn shared(&self, gpu: &Gpu, bytes: u64) -> wgpu::Buffer {
        let mut shared = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = shared.as_ref().filter(|found| found.size() >= bytes) {
            return found.clone();
        }
        let larger = readable(gpu, bytes);
        shared.insert(larger).clone()
    }
}

fn hand_out(
    gpu: &Gpu,
    shared: &wgpu::Buffer,
    total: u64,
    parts: &[Part<'_>],
    take: &mut impl FnMut(usize, &[u8]),
) -> Result<(), StreamError> {
    let Ok(view) = shared.get_mapped_range(0..total) else {
        gpu.fail("what it brought down can't be read");
        return gpu.check();
    };
    let mut rest = &view[..];
    for (index, part) in parts.iter().enumerate() {
        let (bytes, after) = rest.split_at(part.bytes as usize);
        take(index, bytes);
        rest = after;
    }
    Ok(())
}
