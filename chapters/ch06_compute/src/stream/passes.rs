//! Passes: kernels that run one after the other, recorded first and submitted together.

use std::ops::Range;

use super::{Columns, Kernel, Readback, StreamError, Timer};

/// How many workgroups stand in a line where they need more than one. `common/index.wgsl` has it too.
pub const GROUPS_ACROSS: u32 = 32768;

/// What is recorded and not yet submitted.
#[derive(Debug)]
pub struct Passes<'a> {
    columns: &'a Columns,
    encoder: wgpu::CommandEncoder,
    open: Option<wgpu::ComputePass<'static>>,
    timer: Option<&'a mut Timer>,
    section: Option<&'static str>,
}

impl<'a> Passes<'a> {
    /// None yet, over these columns.
    #[must_use]
    pub fn new(columns: &'a Columns) -> Self {
        Self::start(columns, None)
    }

    /// The same, with the time that each section takes.
    #[must_use]
    pub fn timed(columns: &'a Columns, timer: &'a mut Timer) -> Self {
        Self::start(columns, Some(timer))
    }

    fn start(columns: &'a Columns, timer: Option<&'a mut Timer>) -> Self {
        let device = &columns.gpu().device;
        let encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut timer = timer.filter(|_| columns.gpu().has_timestamps);
        if let Some(timer) = &mut timer {
            timer.restart();
        }
        Self {
            columns,
            encoder,
            open: None,
            timer,
            section: None,
        }
    }

    /// The following passes belong to this section, for the timer. A name may come again: its times are
    /// added. What comes before the first section is named after its first kernel.
    pub fn section(&mut self, name: &'static str) {
        if self.timer.is_some() && self.section != Some(name) {
            self.open = None;
            self.section = Some(name);
        }
    }

    // ANCHOR: run
    /// Runs a kernel over so many rows, an invocation a row. A pass sees all that those before it wrote.
    ///
    /// # Errors
    /// What [`Kernel`] can't be bound to: [`StreamError::UnknownColumn`], [`StreamError::Layout`].
    pub fn run(&mut self, kernel: &Kernel, rows: usize) -> Result<(), StreamError> {
        self.run_workgroups(kernel, rows.div_ceil(kernel.workgroup() as usize))
    }
    // ANCHOR_END: run

    /// Runs a kernel in so many workgroups.
    ///
    /// # Errors
    /// As for [`Self::run`]; [`StreamError::Kernel`] beyond what a device can count.
    pub fn run_workgroups(&mut self, kernel: &Kernel, count: usize) -> Result<(), StreamError> {
        let group = kernel.group(self.columns)?;
        if count == 0 {
            return Ok(());
        }
        let most = self
            .columns
            .gpu()
            .limits
            .max_compute_workgroups_per_dimension;
        let [x, y] = grid(count, most).ok_or_else(|| StreamError::Kernel {
            kernel: kernel.name().to_owned(),
            why: format!("{count} workgroups are more than a pass can have"),
        })?;
        let pass = self.pass(kernel, &group);
        pass.dispatch_workgroups(x, y, 1);
        Ok(())
    }

    /// Runs a kernel in as many workgroups as a column says: three numbers a row, x, y and z.
    ///
    /// # Errors
    /// As for [`Self::run`]; [`StreamError::NoRow`].
    pub fn run_indirect(
        &mut self,
        kernel: &Kernel,
        counts: &str,
        row: usize,
    ) -> Result<(), StreamError> {
        let group = kernel.group(self.columns)?;
        self.columns.check_row::<[u32; 3]>(counts)?;
        let counts = self.columns.part(counts, row..row + 1)?;
        let pass = self.pass(kernel, &group);
        pass.dispatch_workgroups_indirect(counts.buffer, counts.offset);
        Ok(())
    }

    /// Makes all of a column's memory zero.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn clear(&mut self, column: &str) -> Result<(), StreamError> {
        let buffer = self.columns.buffer(column)?;
        self.encoder().clear_buffer(buffer, 0, None);
        Ok(())
    }

    /// Copies the first rows of a column to another one.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::NoRow`].
    pub fn copy(&mut self, from: &str, to: &str, rows: usize) -> Result<(), StreamError> {
        let (from, to) = (
            self.columns.part(from, 0..rows)?,
            self.columns.part(to, 0..rows)?,
        );
        let bytes = from.bytes.min(to.bytes);
        self.encoder()
            .copy_buffer_to_buffer(from.buffer, 0, to.buffer, 0, bytes);
        Ok(())
    }

    /// Asks for some rows, as they are at this point; `frame` labels them. False if so many requests are
    /// on their way that this one was left out.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::NoRow`].
    pub fn read_back(
        &mut self,
        readback: &mut Readback,
        column: &str,
        rows: Range<usize>,
        frame: u64,
    ) -> Result<bool, StreamError> {
        let part = self.columns.part(column, rows.clone())?;
        let gpu = self.columns.gpu();
        Ok(readback.request(gpu, self.encoder(), part, rows.start, frame))
    }

    /// The encoder, for what isn't a kernel: drawing, copies.
    pub fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        self.open = None;
        &mut self.encoder
    }

    /// Sends all that was recorded to the device.
    ///
    /// # Errors
    /// [`StreamError::Failed`].
    pub fn submit(self) -> Result<(), StreamError> {
        let gpu = self.columns.gpu();
        gpu.queue.submit([self.finish()]);
        gpu.check()
    }

    /// What was recorded, to be submitted with other commands before any column grows.
    #[must_use]
    pub fn finish(mut self) -> wgpu::CommandBuffer {
        self.open = None;
        if let Some(timer) = self.timer {
            timer.finish(self.columns.gpu(), &mut self.encoder);
        }
        self.encoder.finish()
    }

    /// The open pass, with a kernel ready to run in it.
    fn pass(
        &mut self,
        kernel: &Kernel,
        group: &wgpu::BindGroup,
    ) -> &mut wgpu::ComputePass<'static> {
        if self.timer.as_ref().is_some_and(|timer| timer.is_each()) {
            self.open = None;
        }
        let Self {
            encoder,
            open,
            timer,
            section,
            ..
        } = self;
        let pass = open.get_or_insert_with(|| {
            let name = section.unwrap_or_else(|| kernel.name());
            let writes = timer.as_mut().and_then(|timer| timer.next(name));
            let descriptor = wgpu::ComputePassDescriptor {
                label: Some(name),
                timestamp_writes: writes,
            };
            encoder.begin_compute_pass(&descriptor).forget_lifetime()
        });
        pass.set_pipeline(kernel.pipeline());
        pass.set_bind_group(0, group, &[]);
        pass
    }
}

// ANCHOR: grid
/// Workgroups in x and y: one line of them, or full lines where a device can't count so far in one.
fn grid(count: usize, most: u32) -> Option<[u32; 2]> {
    let count = u32::try_from(count).ok()?;
    if count <= most {
        return Some([count, 1]);
    }
    let lines = count.div_ceil(GROUPS_ACROSS);
    (GROUPS_ACROSS <= most && lines <= most).then_some([GROUPS_ACROSS, lines])
}
// ANCHOR_END: grid

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workgroups_beyond_what_one_line_can_count_stand_in_several() {
        assert_eq!(grid(65535, 65535), Some([65535, 1]));
        assert_eq!(grid(65536, 65535), Some([32768, 2]));
        assert_eq!(grid(65537, 65535), Some([32768, 3]));
        assert_eq!(grid(1 << 33, 65535), None);
    }

    #[test]
    fn the_shaders_and_the_passes_agree_on_the_length_of_a_line() {
        let index = crate::stream::source("common/index").expect("it is there");
        assert!(index.contains(&format!("GROUPS_ACROSS: u32 = {GROUPS_ACROSS}u;")));
    }
}
