//! The columns on the GPU: a buffer each, by name.

use std::any::type_name;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use bytemuck::Pod;

use super::buffers::allocate;
use super::error::listed;
use super::fetch::{Fetch, Part};
use super::{Gpu, StreamError};

/// Gives every state of every container a number of its own.
static STAMPS: AtomicU64 = AtomicU64::new(0);

/// What is known of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnInfo {
    /// What kernels bind it by.
    pub name: String,
    /// The Rust type of a row: `Place`, `u32`.
    pub row: &'static str,
    /// Bytes of a row.
    pub row_bytes: usize,
    /// How many rows are in use, as far as this side knows.
    pub rows: usize,
    /// For how many there is memory. It is what `arrayLength` says in a kernel.
    pub capacity: usize,
}

/// A column.
#[derive(Debug)]
struct Column {
    info: ColumnInfo,
    buffer: wgpu::Buffer,
}

/// All columns that kernels run over.
#[derive(Debug)]
pub struct Columns {
    gpu: Gpu,
    all: Vec<Column>,
    stamp: u64,
    fetch: Fetch,
}

impl Columns {
    /// None yet.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            gpu: gpu.clone(),
            all: Vec::new(),
            stamp: new_stamp(),
            fetch: Fetch::default(),
        }
    }

    /// The device that they are on.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    // ANCHOR: add
    /// Adds a column with memory for so many rows, all zero. It has no rows in use yet.
    ///
    /// # Errors
    /// [`StreamError::Duplicate`], [`StreamError::TooLarge`] before anything is allocated,
    /// [`StreamError::OutOfMemory`].
    pub fn add<R: Pod>(&mut self, name: &str, capacity: usize) -> Result<(), StreamError> {
        self.add_for::<R>(name, capacity, wgpu::BufferUsages::STORAGE)
    }

    /// Adds one value that a kernel binds as `var<uniform>`.
    ///
    /// # Errors
    /// As for [`Self::add`].
    pub fn add_uniform<R: Pod>(&mut self, name: &str, value: &R) -> Result<(), StreamError> {
        self.add_for::<R>(name, 1, wgpu::BufferUsages::UNIFORM)?;
        self.write(name, std::slice::from_ref(value))
    }
    // ANCHOR_END: add

    /// Adds a column for more than kernels: `INDIRECT` for numbers of workgroups, `VERTEX` for drawing.
    ///
    /// # Errors
    /// As for [`Self::add`].
    pub fn add_for<R: Pod>(
        &mut self,
        name: &str,
        capacity: usize,
        uses: wgpu::BufferUsages,
    ) -> Result<(), StreamError> {
        let row = type_name::<R>().rsplit("::").next().unwrap_or_default();
        self.add_bytes(name, row, size_of::<R>(), capacity, uses)
    }

    pub(super) fn add_bytes(
        &mut self,
        name: &str,
        row: &'static str,
        row_bytes: usize,
        capacity: usize,
        uses: wgpu::BufferUsages,
    ) -> Result<(), StreamError> {
        if self.has(name) {
            return Err(StreamError::Duplicate(name.to_owned()));
        }
        let info = ColumnInfo {
            name: name.to_owned(),
            row,
            row_bytes,
            rows: 0,
            capacity: capacity.max(1),
        };
        let copies = wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        let buffer = allocate(&self.gpu, &info, uses | copies)?;
        self.all.push(Column { info, buffer });
        self.stamp = new_stamp();
        Ok(())
    }

    // ANCHOR: write
    /// Writes all rows of a column, and makes room for them first if there isn't enough.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::Layout`], [`StreamError::TooLarge`],
    /// [`StreamError::OutOfMemory`].
    pub fn write<R: Pod>(&mut self, name: &str, rows: &[R]) -> Result<(), StreamError> {
        self.check_row::<R>(name)?;
        self.write_bytes(name, bytemuck::cast_slice(rows))
    }
    // ANCHOR_END: write

    pub(super) fn write_bytes(&mut self, name: &str, bytes: &[u8]) -> Result<(), StreamError> {
        let rows = bytes.len() / self.find(name)?.info.row_bytes;
        self.reserve(name, rows)?;
        self.set_rows(name, rows)?;
        let buffer = &self.find(name)?.buffer;
        self.gpu.queue.write_buffer(buffer, 0, bytes);
        Ok(())
    }

    /// Writes some rows from `first` on. Makes no room.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::Layout`], [`StreamError::NoRow`].
    pub fn write_at<R: Pod>(
        &self,
        name: &str,
        first: usize,
        rows: &[R],
    ) -> Result<(), StreamError> {
        self.check_row::<R>(name)?;
        let part = self.part(name, first..first + rows.len())?;
        let bytes = bytemuck::cast_slice(rows);
        self.gpu.queue.write_buffer(part.buffer, part.offset, bytes);
        Ok(())
    }

    /// Says how many rows are in use, where a kernel wrote them. Makes room for them if need be.
    ///
    /// # Errors
    /// As for [`Self::reserve`].
    pub fn set_rows(&mut self, name: &str, rows: usize) -> Result<(), StreamError> {
        self.reserve(name, rows)?;
        let place = self.place(name)?;
        self.all[place].info.rows = rows;
        Ok(())
    }

    /// Makes all of a column's memory zero.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn clear(&self, name: &str) -> Result<(), StreamError> {
        let buffer = self.buffer(name)?;
        let mut encoder = self.gpu.device.create_command_encoder(&encoder(name));
        encoder.clear_buffer(buffer, 0, None);
        self.gpu.queue.submit([encoder.finish()]);
        Ok(())
    }

    // ANCHOR: reserve
    /// Makes room for so many rows. What the column holds stays; if it has to move, it gets half as much
    /// again as it had, so that growing row by row moves it seldom.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::TooLarge`], [`StreamError::OutOfMemory`]: then
    /// it is as it was.
    pub fn reserve(&mut self, name: &str, rows: usize) -> Result<(), StreamError> {
        let place = self.place(name)?;
        let Column { info, buffer } = &self.all[place];
        if rows <= info.capacity {
            return Ok(());
        }
        let most = self.gpu.most_rows(info.row_bytes) as usize;
        let grown = ColumnInfo {
            capacity: rows.max((info.capacity * 3 / 2).min(most)),
            ..info.clone()
        };
        let larger = allocate(&self.gpu, &grown, buffer.usage())?;
        let mut encoder = self.gpu.device.create_command_encoder(&encoder(name));
        encoder.copy_buffer_to_buffer(buffer, 0, &larger, 0, buffer.size());
        self.gpu.queue.submit([encoder.finish()]);
        // Kernels may still remember it; its memory is free when the copy is done.
        buffer.destroy();
        self.all[place] = Column {
            info: grown,
            buffer: larger,
        };
        self.stamp = new_stamp();
        Ok(())
    }
    // ANCHOR_END: reserve

    /// Trades what two columns hold, without moving it: what was written last becomes what is read next.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`]; [`StreamError::Layout`] if their rows differ.
    pub fn swap(&mut self, one: &str, other: &str) -> Result<(), StreamError> {
        let (i, j) = (self.place(one)?, self.place(other)?);
        let (first, second) = (&self.all[i].info, &self.all[j].info);
        if (first.row, first.row_bytes) != (second.row, second.row_bytes) {
            return Err(layout(
                first,
                format!("{} like column `{other}`", second.row),
            ));
        }
        self.all.swap(i, j);
        let name = std::mem::take(&mut self.all[i].info.name);
        self.all[i].info.name = std::mem::replace(&mut self.all[j].info.name, name);
        self.stamp = new_stamp();
        Ok(())
    }

    // ANCHOR: read
    /// Brings all rows in use down and waits for them. For tests, tools and (a); a program that draws uses
    /// a [`super::Readback`].
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`], [`StreamError::Layout`], [`StreamError::Failed`].
    pub fn read<R: Pod>(&self, name: &str) -> Result<Vec<R>, StreamError> {
        let rows = self.info(name)?.rows;
        self.read_rows(name, 0..rows)
    }
    // ANCHOR_END: read

    /// Brings some rows down and waits for them: any for which there is memory.
    ///
    /// # Errors
    /// As for [`Self::read`], and [`StreamError::NoRow`].
    pub fn read_rows<R: Pod>(&self, name: &str, rows: Range<usize>) -> Result<Vec<R>, StreamError> {
        self.check_row::<R>(name)?;
        let part = self.part(name, rows)?;
        let mut found = Vec::new();
        self.fetch_parts(&[part], |_, bytes| {
            found = bytemuck::pod_collect_to_vec(bytes);
        })?;
        Ok(found)
    }

    /// Brings parts of columns down together and hands each to `take`.
    pub(super) fn fetch_parts(
        &self,
        parts: &[Part<'_>],
        take: impl FnMut(usize, &[u8]),
    ) -> Result<(), StreamError> {
        self.fetch.parts(&self.gpu, parts, take)
    }

    /// All columns, in the order in which they were added.
    pub fn list(&self) -> impl Iterator<Item = &ColumnInfo> {
        self.all.iter().map(|column| &column.info)
    }

    /// What is known of a column.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn info(&self, name: &str) -> Result<&ColumnInfo, StreamError> {
        Ok(&self.find(name)?.info)
    }

    /// A column's buffer, for whoever draws from it. It is another one after [`Self::reserve`] made room.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn buffer(&self, name: &str) -> Result<&wgpu::Buffer, StreamError> {
        Ok(&self.find(name)?.buffer)
    }

    /// Whether there is a column of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.all.iter().any(|column| column.info.name == name)
    }

    /// Bytes of memory that all columns have on the device.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.all.iter().map(|column| column.buffer.size()).sum()
    }

    /// Another number whenever another buffer stands behind a name.
    pub(super) fn stamp(&self) -> u64 {
        self.stamp
    }

    /// Where some rows of a column are.
    pub(super) fn part(&self, name: &str, rows: Range<usize>) -> Result<Part<'_>, StreamError> {
        let Column { info, buffer } = self.find(name)?;
        if rows.end > info.capacity {
            return Err(StreamError::NoRow {
                column: name.to_owned(),
                rows: info.capacity,
                row: rows.end - 1,
            });
        }
        Ok(Part {
            buffer,
            offset: (rows.start * info.row_bytes) as u64,
            bytes: (rows.len() * info.row_bytes) as u64,
        })
    }

    /// Whether a column's rows are of this type, as far as their size tells.
    pub(super) fn check_row<R: Pod>(&self, name: &str) -> Result<(), StreamError> {
        let info = self.info(name)?;
        if info.row_bytes == size_of::<R>() {
            return Ok(());
        }
        let wanted = format!("{} of {} bytes", type_name::<R>(), size_of::<R>());
        Err(layout(info, wanted))
    }

    fn find(&self, name: &str) -> Result<&Column, StreamError> {
        Ok(&self.all[self.place(name)?])
    }

    fn place(&self, name: &str) -> Result<usize, StreamError> {
        let found = self.list().position(|info| info.name == name);
        found.ok_or_else(|| StreamError::UnknownColumn {
            column: name.to_owned(),
            known: listed(self.list().map(|info| info.name.as_str())),
        })
    }
}

/// The error of a column that isn't what it is taken for.
pub(super) fn layout(info: &ColumnInfo, wanted: String) -> StreamError {
    StreamError::Layout {
        column: info.name.clone(),
        holds: format!("{} of {} bytes", info.row, info.row_bytes),
        wanted,
    }
}

fn encoder(name: &str) -> wgpu::CommandEncoderDescriptor<'_> {
    wgpu::CommandEncoderDescriptor { label: Some(name) }
}

fn new_stamp() -> u64 {
    STAMPS.fetch_add(1, Ordering::Relaxed)
}
