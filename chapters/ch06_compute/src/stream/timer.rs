//! How long sections of passes take on the GPU itself. The times come some frames late, like all that
//! nobody waits for.

use std::time::Duration;

use super::fetch::Part;
use super::{Gpu, Readback};

/// What is timed by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grain {
    Sections,
    Kernels,
}

/// Measures passes. On a device that can't tell, it stays silent.
#[derive(Debug)]
pub struct Timer {
    queries: Option<Queries>,
    grain: Grain,
    /// Of what is recorded now.
    names: Vec<&'static str>,
    /// Of what was submitted and hasn't come down yet, by number.
    asked: Vec<(u64, Vec<&'static str>)>,
    readback: Readback,
    number: u64,
}

#[derive(Debug)]
struct Queries {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    passes: u32,
}

impl Timer {
    /// Measures sections of [`super::Passes`], up to so many at once; what comes after them isn't timed.
    #[must_use]
    pub fn new(gpu: &Gpu, passes: u32) -> Self {
        Self::with(gpu, passes, Grain::Sections)
    }

    /// Measures each kernel by itself. A pass must then end before the next one starts, which takes time
    /// of its own: the parts are more than the whole.
    #[must_use]
    pub fn of_kernels(gpu: &Gpu, passes: u32) -> Self {
        Self::with(gpu, passes, Grain::Kernels)
    }

    fn with(gpu: &Gpu, passes: u32, grain: Grain) -> Self {
        let passes = passes.clamp(1, wgpu::QUERY_SET_MAX_QUERIES / 2);
        Self {
            queries: gpu.has_timestamps.then(|| queries(gpu, passes)),
            grain,
            names: Vec::new(),
            asked: Vec::new(),
            readback: Readback::default(),
            number: 0,
        }
    }

    /// The times of the latest submission that has come down since the last call, in the order of their
    /// first passes; the times of a name that came again are added. [`Gpu::poll`] looks for them.
    pub fn latest(&mut self, gpu: &Gpu) -> Option<Vec<(&'static str, Duration)>> {
        let late = self.readback.latest::<u64>()?;
        let place = self
            .asked
            .iter()
            .position(|(number, _)| *number == late.frame)?;
        let (_, names) = self.asked.drain(..=place).next_back()?;
        let nanoseconds = f64::from(gpu.queue.get_timestamp_period());
        let mut times: Vec<(&'static str, Duration)> = Vec::new();
        for (name, pair) in names.into_iter().zip(late.rows.chunks_exact(2)) {
            let ticks = pair[1].saturating_sub(pair[0]);
            let time = Duration::from_nanos((ticks as f64 * nanoseconds) as u64);
            match times.iter_mut().find(|(known, _)| *known == name) {
                Some((_, sum)) => *sum += time,
                None => times.push((name, time)),
            }
        }
        Some(times)
    }

    pub(super) fn is_each(&self) -> bool {
        self.grain == Grain::Kernels
    }

    /// Forgets what was recorded and not finished.
    pub(super) fn restart(&mut self) {
        self.names.clear();
    }

    /// Where a pass of this name writes its times.
    pub(super) fn next(
        &mut self,
        name: &'static str,
    ) -> Option<wgpu::ComputePassTimestampWrites<'_>> {
        let queries = self.queries.as_ref()?;
        let place = self.names.len() as u32;
        if place == queries.passes {
            return None;
        }
        self.names.push(name);
        Some(wgpu::ComputePassTimestampWrites {
            query_set: &queries.set,
            beginning_of_pass_write_index: Some(2 * place),
            end_of_pass_write_index: Some(2 * place + 1),
        })
    }

    /// Asks for the times of what was recorded.
    pub(super) fn finish(&mut self, gpu: &Gpu, encoder: &mut wgpu::CommandEncoder) {
        let names = std::mem::take(&mut self.names);
        let Some(queries) = self.queries.as_ref().filter(|_| !names.is_empty()) else {
            return;
        };
        let count = 2 * names.len() as u32;
        encoder.resolve_query_set(&queries.set, 0..count, &queries.resolved, 0);
        let part = Part {
            buffer: &queries.resolved,
            offset: 0,
            bytes: 8 * u64::from(count),
        };
        self.number += 1;
        if self.readback.request(gpu, encoder, part, 0, self.number) {
            self.asked.push((self.number, names));
        }
    }
}

fn queries(gpu: &Gpu, passes: u32) -> Queries {
    let count = 2 * passes;
    Queries {
        set: gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
            label: Some("times"),
            ty: wgpu::QueryType::Timestamp,
            count,
        }),
        resolved: gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("times"),
            size: 8 * u64::from(count),
            usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        }),
        passes,
    }
}
