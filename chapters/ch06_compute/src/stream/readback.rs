//! Numbers that come down some frames late, so that nobody waits for them.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use bytemuck::Pod;

use super::Gpu;
use super::buffers::readable;
use super::fetch::Part;

/// How many requests may be on their way.
const MOST: usize = 4;

/// A slot that nobody uses.
const FREE: u8 = 0;
/// Its rows are on their way.
const ASKED: u8 = 1;
/// Its rows are here.
const HERE: u8 = 2;
/// They won't come.
const LOST: u8 = 3;

/// Rows that were asked for some frames ago.
#[derive(Clone, Debug, PartialEq)]
pub struct Late<R> {
    /// The label that they were asked for with.
    pub frame: u64,
    /// The first of the rows.
    pub first: usize,
    /// The rows.
    pub rows: Vec<R>,
}

/// Asks for rows with [`super::Passes::read_back`] and has them later.
#[derive(Debug, Default)]
pub struct Readback {
    slots: Vec<Slot>,
}

#[derive(Debug)]
struct Slot {
    buffer: wgpu::Buffer,
    state: Arc<AtomicU8>,
    frame: u64,
    first: usize,
    bytes: u64,
}

impl Readback {
    // ANCHOR: request
    /// Copies rows to where this side can read them once the commands have run.
    pub(super) fn request(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        part: Part<'_>,
        first: usize,
        frame: u64,
    ) -> bool {
        let bytes = part.bytes;
        let Some(slot) = self.free_slot(gpu, bytes).filter(|_| bytes > 0) else {
            return false;
        };
        (slot.frame, slot.first, slot.bytes) = (frame, first, bytes);
        slot.state.store(ASKED, Ordering::Release);
        encoder.copy_buffer_to_buffer(part.buffer, part.offset, &slot.buffer, 0, bytes);
        let state = Arc::clone(&slot.state);
        encoder.map_buffer_on_submit(&slot.buffer, wgpu::MapMode::Read, 0..bytes, move |result| {
            let arrived = if result.is_ok() { HERE } else { LOST };
            state.store(arrived, Ordering::Release);
        });
        true
    }
    // ANCHOR_END: request

    // ANCHOR: latest
    /// The latest rows that have arrived since the last call; None if none have. [`Gpu::poll`] looks
    /// for them once a frame. Older ones that arrived with them are dropped.
    ///
    /// None, too, if the rows aren't of this type.
    pub fn latest<R: Pod>(&mut self) -> Option<Late<R>> {
        let mut latest: Option<Late<R>> = None;
        for slot in &mut self.slots {
            let state = slot.state.load(Ordering::Acquire);
            if state == HERE && latest.as_ref().is_none_or(|late| late.frame < slot.frame) {
                latest = slot.rows().or(latest);
            }
            if state == HERE {
                slot.buffer.unmap();
            }
            if state == HERE || state == LOST {
                slot.state.store(FREE, Ordering::Release);
            }
        }
        latest
    }
    // ANCHOR_END: latest

    /// Whether rows are on their way.
    #[must_use]
    pub fn is_waiting(&self) -> bool {
        let mut states = self
            .slots
            .iter()
            .map(|slot| slot.state.load(Ordering::Acquire));
        states.any(|state| state == ASKED)
    }

    /// A slot that is free and large enough, or a new one if there may be more.
    fn free_slot(&mut self, gpu: &Gpu, bytes: u64) -> Option<&mut Slot> {
        let is_free = |slot: &Slot| slot.state.load(Ordering::Acquire) == FREE;
        let place = match self.slots.iter().position(is_free) {
            Some(place) => place,
            None if self.slots.len() < MOST => {
                self.slots.push(Slot {
                    buffer: readable(gpu, bytes),
                    state: Arc::default(),
                    frame: 0,
                    first: 0,
                    bytes,
                });
                self.slots.len() - 1
            }
            None => return None,
        };
        let slot = &mut self.slots[place];
        if slot.buffer.size() < bytes {
            slot.buffer = readable(gpu, bytes);
        }
        Some(slot)
    }
}

impl Slot {
    fn rows<R: Pod>(&self) -> Option<Late<R>> {
        if !(self.bytes as usize).is_multiple_of(size_of::<R>()) {
            return None;
        }
        let view = self.buffer.get_mapped_range(0..self.bytes).ok()?;
        Some(Late {
            frame: self.frame,
            first: self.first,
            rows: bytemuck::pod_collect_to_vec(&view[..]),
        })
    }
}
