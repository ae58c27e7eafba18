//! The scan: counts become starts, each the sum of the counts before it.

use crate::rows::Scan;
use crate::stream::{Gpu, Kernel, Passes, StreamError, source};

/// Counts in a block: `ch06_scan.wgsl` has it too.
const PER_BLOCK: usize = 4096;

/// How many blocks so many counts have.
#[must_use]
pub fn blocks(counts: usize) -> usize {
    counts.div_ceil(PER_BLOCK)
}

/// The uniform of a scan over so many counts, which writes always.
#[must_use]
pub fn scan_of(counts: usize) -> Scan {
    Scan {
        counts: counts as u32,
        room: u32::MAX,
        ..Scan::default()
    }
}

/// A scan over one column of counts.
#[derive(Debug)]
pub struct Scanning([Kernel; 3]);

impl Scanning {
    /// Over the columns that stand in the place of `scan`, `counts` and `starts`.
    ///
    /// # Errors
    /// [`StreamError::Kernel`].
    pub fn of(gpu: &Gpu, [scan, counts, starts]: [&str; 3]) -> Result<Self, StreamError> {
        let text = source("ch06_scan")?;
        let kernel = |entry, bound: &[(&str, &str)]| {
            Kernel::new(gpu, "scan", &text, entry, &[])?.renamed(bound)
        };
        let (scan, counts, starts) = (("scan", scan), ("counts", counts), ("starts", starts));
        Ok(Self([
            kernel("scan_blocks", &[scan, counts, starts])?,
            kernel("scan_sums", &[scan])?,
            kernel("scan_add", &[scan, starts])?,
        ]))
    }

    /// Its passes over so many counts.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn run(&self, passes: &mut Passes<'_>, counts: usize) -> Result<(), StreamError> {
        let blocks = blocks(counts);
        passes.run_workgroups(&self.0[0], blocks)?;
        if blocks > 1 {
            passes.run_workgroups(&self.0[1], 1)?;
            passes.run(&self.0[2], counts)?;
        }
        Ok(())
    }
}
