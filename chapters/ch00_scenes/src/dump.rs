//! State dumps: the format RBD1, little endian, for exchange with other engines.
//!
//! A header of 16 bytes: `RBD1`, u32 number of bodies n, u32 size of a real (4 or 8),
//! u32 0. Then frames: u32 step, u32 0, and n × 13 reals: position 3, orientation
//! x y z w, linear velocity 3, angular velocity 3 (world), in the scene's order, static
//! bodies too. Step 0 is the start; whoever writes also writes the last step.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use glam::{DQuat, DVec3};

use crate::{SceneError, State};

/// The first four bytes of a dump.
pub const MAGIC: [u8; 4] = *b"RBD1";

/// Reals that a frame has for each body.
pub const REALS_PER_BODY: usize = 13;

/// Writes states to a file, one after the other.
#[derive(Debug)]
pub struct DumpWriter {
    path: PathBuf,
    file: BufWriter<File>,
    n: usize,
    real_size: u32,
}

impl DumpWriter {
    /// Creates the file, or empties it, and writes the header: `n` bodies, reals of
    /// `real_size` bytes, 4 or 8.
    ///
    /// # Errors
    /// [`SceneError::Write`] with the path.
    pub fn create(path: &Path, n: usize, real_size: u32) -> Result<Self, SceneError> {
        let create = || {
            let header = header(n, real_size)?;
            let mut file = BufWriter::new(File::create(path)?);
            file.write_all(&header)?;
            Ok(file)
        };
        let file = create().map_err(|source| write_error(path, source))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            n,
            real_size,
        })
    }

    /// Appends the state after `step` steps.
    ///
    /// # Errors
    /// [`SceneError::Write`] with the path, also when the state has another number of
    /// bodies than the header says.
    pub fn frame(&mut self, step: u32, state: &State) -> Result<(), SceneError> {
        self.write_frame(step, state)
            .map_err(|source| write_error(&self.path, source))
    }

    /// Writes what is still in memory. Without this call an error at the end of the file
    /// would go unseen.
    ///
    /// # Errors
    /// [`SceneError::Write`] with the path.
    pub fn finish(mut self) -> Result<(), SceneError> {
        self.file
            .flush()
            .map_err(|source| write_error(&self.path, source))
    }

    fn write_frame(&mut self, step: u32, state: &State) -> io::Result<()> {
        if state.len() != self.n {
            let (has, wants) = (state.len(), self.n);
            return Err(io::Error::new(
                ErrorKind::InvalidInput,
                format!("the state has {has} bodies, the header says {wants}"),
            ));
        }
        self.file.write_all(&step.to_le_bytes())?;
        self.file.write_all(&0_u32.to_le_bytes())?;
        for body in 0..self.n {
            for real in row(state, body) {
                self.write_real(real)?;
            }
        }
        Ok(())
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "reals of 4 bytes come from engines that run in f32"
    )]
    fn write_real(&mut self, real: f64) -> io::Result<()> {
        if self.real_size == 8 {
            self.file.write_all(&real.to_le_bytes())
        } else {
            self.file.write_all(&(real as f32).to_le_bytes())
        }
    }
}

/// A state at a step, as read from a dump.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// How many steps led to it; 0 is the start.
    pub step: u32,
    /// Where every body was.
    pub state: State,
}

/// Reads a dump frame by frame.
#[derive(Debug)]
pub struct DumpReader {
    path: PathBuf,
    file: BufReader<File>,
    n: usize,
    real_size: u32,
}

impl DumpReader {
    /// Opens a dump and reads its header.
    ///
    /// # Errors
    /// [`SceneError::Read`] with the path, also for a file that is no dump.
    pub fn open(path: &Path) -> Result<Self, SceneError> {
        let open = || {
            let mut file = BufReader::new(File::open(path)?);
            let mut header = [0; 16];
            file.read_exact(&mut header)?;
            let (n, real_size) = read_header(&header)?;
            Ok((file, n, real_size))
        };
        let (file, n, real_size) = open().map_err(|source| read_error(path, source))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            n,
            real_size,
        })
    }

    /// How many bodies each frame has.
    #[must_use]
    pub fn bodies(&self) -> usize {
        self.n
    }

    /// Bytes of a real number in the file: 4 or 8.
    #[must_use]
    pub fn real_size(&self) -> u32 {
        self.real_size
    }

    /// The next frame; `None` after the last.
    ///
    /// # Errors
    /// [`SceneError::Read`] with the path, also for a frame that breaks off.
    pub fn frame(&mut self) -> Result<Option<Frame>, SceneError> {
        self.read_frame()
            .map_err(|source| read_error(&self.path, source))
    }

    /// All frames that are left.
    ///
    /// # Errors
    /// As [`DumpReader::frame`].
    pub fn frames(mut self) -> Result<Vec<Frame>, SceneError> {
        let mut frames = Vec::new();
        while let Some(frame) = self.frame()? {
            frames.push(frame);
        }
        Ok(frames)
    }

    fn read_frame(&mut self) -> io::Result<Option<Frame>> {
        use io::BufRead;
        if self.file.fill_buf()?.is_empty() {
            return Ok(None);
        }
        let step = self.read_u32()?;
        self.read_u32()?;
        let mut state = State::default();
        for _ in 0..self.n {
            let mut reals = [0.0; REALS_PER_BODY];
            for real in &mut reals {
                *real = self.read_real()?;
            }
            push_row(&mut state, reals);
        }
        Ok(Some(Frame { step, state }))
    }

    fn read_u32(&mut self) -> io::Result<u32> {
        let mut bytes = [0; 4];
        self.file.read_exact(&mut bytes)?;
        Ok(u32::from_le_bytes(bytes))
    }

    fn read_real(&mut self) -> io::Result<f64> {
        if self.real_size == 8 {
            let mut bytes = [0; 8];
            self.file.read_exact(&mut bytes)?;
            return Ok(f64::from_le_bytes(bytes));
        }
        let mut bytes = [0; 4];
        self.file.read_exact(&mut bytes)?;
        Ok(f32::from_le_bytes(bytes).into())
    }
}

fn header(n: usize, real_size: u32) -> io::Result<[u8; 16]> {
    let n = u32::try_from(n).map_err(|error| io::Error::new(ErrorKind::InvalidInput, error))?;
    check_real_size(real_size, ErrorKind::InvalidInput)?;
    let mut bytes = [0; 16];
    bytes[..4].copy_from_slice(&MAGIC);
    bytes[4..8].copy_from_slice(&n.to_le_bytes());
    bytes[8..12].copy_from_slice(&real_size.to_le_bytes());
    Ok(bytes)
}

fn read_header(bytes: &[u8; 16]) -> io::Result<(usize, u32)> {
    let [m0, m1, m2, m3, n0, n1, n2, n3, r0, r1, r2, r3, ..] = *bytes;
    if [m0, m1, m2, m3] != MAGIC {
        return Err(io::Error::new(
            ErrorKind::InvalidData,
            "not a state dump: it doesn't begin with RBD1",
        ));
    }
    let n = u32::from_le_bytes([n0, n1, n2, n3]);
    let n = usize::try_from(n).map_err(|error| io::Error::new(ErrorKind::InvalidData, error))?;
    let real_size = u32::from_le_bytes([r0, r1, r2, r3]);
    check_real_size(real_size, ErrorKind::InvalidData)?;
    Ok((n, real_size))
}

fn check_real_size(real_size: u32, kind: ErrorKind) -> io::Result<()> {
    if matches!(real_size, 4 | 8) {
        return Ok(());
    }
    Err(io::Error::new(
        kind,
        format!("a real has 4 or 8 bytes, not {real_size}"),
    ))
}

/// The 13 reals of a body.
fn row(state: &State, body: usize) -> [f64; REALS_PER_BODY] {
    let p = state.position[body];
    let q = state.orientation[body];
    let v = state.linear_velocity[body];
    let w = state.angular_velocity[body];
    [
        p.x, p.y, p.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z,
    ]
}

fn push_row(state: &mut State, reals: [f64; REALS_PER_BODY]) {
    let [px, py, pz, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz] = reals;
    state.push(
        DVec3::new(px, py, pz),
        DQuat::from_xyzw(qx, qy, qz, qw),
        DVec3::new(vx, vy, vz),
        DVec3::new(wx, wy, wz),
    );
}

fn write_error(path: &Path, source: io::Error) -> SceneError {
    SceneError::Write {
        file: path.to_owned(),
        source,
    }
}

fn read_error(path: &Path, source: io::Error) -> SceneError {
    SceneError::Read {
        file: path.to_owned(),
        source,
    }
}

#[cfg(test)]
mod tests;
