//! What can go wrong between here and the GPU. None of it is a panic.

use ch00_scenes::TableError;
use thiserror::Error;

/// Why the GPU can't do what it was asked.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StreamError {
    /// There is no GPU, and nothing that imitates one.
    #[error(
        "no graphics device was found ({0}). Install a Vulkan driver for your card, or the software \
         device: package `mesa-vulkan-drivers` on Debian and Ubuntu, `vulkan-swrast` on Arch"
    )]
    NoAdapter(String),
    /// There is one, and it can't be opened.
    #[error("the graphics device {device} can't be opened: {why}")]
    NoDevice {
        /// The adapter's name.
        device: String,
        /// What its driver says.
        why: String,
    },
    /// The device reported an error, or is gone. Nothing that it holds can be trusted any more.
    #[error("the graphics device {device} failed: {why}")]
    Failed {
        /// The adapter's name.
        device: String,
        /// The first error.
        why: String,
    },
    /// A buffer would be larger than the device allows. Nothing was allocated.
    #[error(
        "column `{column}`: {asked} rows of {row_bytes} bytes are asked for, at most {most} fit on {device}"
    )]
    TooLarge {
        /// The column's name.
        column: String,
        /// Rows that were asked for.
        asked: u64,
        /// Bytes of a row.
        row_bytes: u64,
        /// Rows that this device allows.
        most: u64,
        /// The adapter's name.
        device: String,
    },
    /// The device allows a buffer of this size, but has no memory left for it.
    #[error("column `{column}`: {device} has no memory left for its {bytes} bytes")]
    OutOfMemory {
        /// The column's name.
        column: String,
        /// Bytes that were asked for.
        bytes: u64,
        /// The adapter's name.
        device: String,
    },
    /// There is no such column on the GPU.
    #[error("there is no column `{column}` on the GPU; there are: {known}")]
    UnknownColumn {
        /// What was asked for.
        column: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// There is such a column already.
    #[error("there is a column `{0}` on the GPU already")]
    Duplicate(String),
    /// A column's rows aren't what is written to it, read from it, or bound to it.
    #[error("column `{column}` holds {holds}, not {wanted}")]
    Layout {
        /// The column's name.
        column: String,
        /// What its rows are.
        holds: String,
        /// What they were taken for, and by whom.
        wanted: String,
    },
    /// Rows that the column doesn't have.
    #[error("column `{column}` has {rows} rows; row {row} was asked for")]
    NoRow {
        /// The column's name.
        column: String,
        /// How many it has.
        rows: usize,
        /// What was asked for.
        row: usize,
    },
    /// There is no such shader.
    #[error("there is no shader `{shader}`; there are: {known}")]
    UnknownShader {
        /// What was asked for.
        shader: String,
        /// What there is, separated by commas.
        known: String,
    },
    /// A kernel isn't valid.
    #[error("kernel `{kernel}`: {why}")]
    Kernel {
        /// The kernel's name.
        kernel: String,
        /// Why, with the line where it is known.
        why: String,
    },
    /// A column of chapter 5's tables can't be taken.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// Names as they stand in a message.
pub(super) fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<_> = names.into_iter().collect();
    if names.is_empty() {
        "none".to_owned()
    } else {
        names.join(", ")
    }
}
