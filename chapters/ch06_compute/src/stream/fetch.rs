//! Bringing rows down and waiting for them.

use std::sync::{Mutex, PoisonError, mpsc};
use std::time::Duration;

use super::buffers::readable;
use super::{Gpu, StreamError};

/// How long rows may still be on their way when the device has nothing left to do.
const LONGEST: Duration = Duration::from_secs(10);

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
        let (tell, told) = mpsc::channel();
        encoder.map_buffer_on_submit(&shared, wgpu::MapMode::Read, 0..total, move |result| {
            // Nobody listens any more where the wait below has failed.
            let _ = tell.send(result.is_ok());
        });
        gpu.queue.submit([encoder.finish()]);
        gpu.wait()?;
        // Another thread that waits for the same device may be the one that is told, and tell us late.
        if told.recv_timeout(LONGEST) != Ok(true) {
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
