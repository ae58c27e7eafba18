//! The graphics device: found asynchronously, as a browser demands, and with no more than
//! every device has. Nothing here or in the renderer panics when the device fails; the first
//! error is kept, and whoever runs the loop asks for it once a frame.

use std::sync::{Arc, Mutex, PoisonError};

use crate::ShellError;

/// An adapter with a device on it, ready to draw.
pub struct Gpu {
    /// What surfaces are configured with.
    pub adapter: wgpu::Adapter,
    /// Makes buffers, textures and pipelines.
    pub device: wgpu::Device,
    /// Takes commands.
    pub queue: wgpu::Queue,
    /// The adapter's name, as its driver says it.
    pub name: String,
    /// Whether the adapter is a processor that imitates a graphics card.
    pub is_software: bool,
    failure: Failure,
}

/// The first error that the device reported.
type Failure = Arc<Mutex<Option<String>>>;

impl Gpu {
    /// Finds an adapter that can draw to `surface`, or any if there is none, and opens a
    /// device on it.
    ///
    /// # Errors
    /// [`ShellError::NoAdapter`] if there is none, [`ShellError::Graphics`] if it can't be opened.
    pub async fn request(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'static>>,
    ) -> Result<Self, ShellError> {
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                compatible_surface: surface,
                ..Default::default()
            })
            .await
            .map_err(|error| ShellError::NoAdapter(error.to_string()))?;
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("shell"),
                required_limits: limits(&adapter),
                ..Default::default()
            })
            .await
            .map_err(|error| ShellError::Graphics(error.to_string()))?;
        let info = adapter.get_info();
        Ok(Self {
            failure: watch(&device),
            adapter,
            device,
            queue,
            name: info.name,
            is_software: info.device_type == wgpu::DeviceType::Cpu,
        })
    }

    /// The first error that the device reported, if it did.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        lock(&self.failure).clone()
    }
}

/// What even modest devices have, with the picture sizes and buffers that this one has.
fn limits(adapter: &wgpu::Adapter) -> wgpu::Limits {
    let have = adapter.limits();
    wgpu::Limits {
        max_buffer_size: have.max_buffer_size,
        ..wgpu::Limits::downlevel_defaults().using_resolution(have)
    }
}

/// Keeps the device's first error instead of the default, which is to panic.
fn watch(device: &wgpu::Device) -> Failure {
    let failure = Failure::default();
    let on_error = Arc::clone(&failure);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        lock(&on_error).get_or_insert(error.to_string());
    }));
    let on_loss = Arc::clone(&failure);
    device.set_device_lost_callback(move |reason, message| {
        // Dropping the device at the program's end is reported here, too.
        if reason != wgpu::DeviceLostReason::Destroyed {
            lock(&on_loss).get_or_insert(format!("the device was lost: {message}"));
        }
    });
    failure
}

/// A text is whole even if a thread panicked while it held the lock.
fn lock(failure: &Failure) -> std::sync::MutexGuard<'_, Option<String>> {
    failure.lock().unwrap_or_else(PoisonError::into_inner)
}
