//! The device of this program: with a window it is the window's, so that the window can draw from the
//! engine's columns.

use crate::stream::{Gpu, StreamError};

/// The device, and whether the window draws from it.
#[derive(Clone)]
pub struct Device {
    /// What computes.
    pub gpu: Gpu,
    /// Whether it is the window's device.
    pub is_windows: bool,
    #[cfg(feature = "window")]
    window: std::rc::Rc<ch00_shell::Gpu>,
}

/// The device that this program has open, or a new one.
///
/// # Errors
/// [`StreamError::NoAdapter`], [`StreamError::NoDevice`].
#[cfg(feature = "window")]
pub fn open() -> Result<Device, StreamError> {
    let window =
        ch00_shell::Gpu::shared().map_err(|error| StreamError::NoAdapter(error.to_string()))?;
    let gpu = Gpu::from_parts(
        window.adapter.clone(),
        window.device.clone(),
        window.queue.clone(),
        window.failure_place(),
    );
    Ok(Device {
        gpu,
        is_windows: true,
        window,
    })
}

/// The device of this program.
///
/// # Errors
/// [`StreamError::NoAdapter`], [`StreamError::NoDevice`].
#[cfg(not(feature = "window"))]
pub fn open() -> Result<Device, StreamError> {
    Ok(Device {
        gpu: Gpu::open()?,
        is_windows: false,
    })
}

#[cfg(feature = "window")]
impl Device {
    /// What the window draws from.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn resident(
        &self,
        columns: &crate::stream::Columns,
    ) -> Result<ch00_shell::Resident, StreamError> {
        Ok(ch00_shell::Resident {
            gpu: std::rc::Rc::clone(&self.window),
            bodies: columns.buffer("drawn")?.clone(),
        })
    }
}
