//! The device that computes: found, opened, watched.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::StreamError;
use super::kernel::Compiled;

/// The first error that a device reported.
pub type Failure = Arc<Mutex<Option<String>>>;

/// A graphics device, opened for computing. Clones are the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// What it was opened on.
    pub adapter: wgpu::Adapter,
    /// Makes buffers and pipelines.
    pub device: wgpu::Device,
    /// Takes commands.
    pub queue: wgpu::Queue,
    /// The adapter's name, as its driver says it.
    pub name: String,
    /// Whether it is a processor that imitates a graphics card.
    pub is_software: bool,
    /// Whether it can tell how long passes take.
    pub has_timestamps: bool,
    /// What it allows.
    pub limits: wgpu::Limits,
    failure: Failure,
    /// Kernels that were compiled, by entry point, constants and text.
    compiled: Arc<Mutex<BTreeMap<String, Compiled>>>,
}

impl Gpu {
    // ANCHOR: open
    /// Opens the fastest device of this machine, without a window.
    ///
    /// # Errors
    /// [`StreamError::NoAdapter`] says what to install; [`StreamError::NoDevice`].
    pub fn open() -> Result<Self, StreamError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            flags: flags(),
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        pollster::block_on(Self::request(&instance, None))
    }
    // ANCHOR_END: open

    /// Opens the fastest device that can draw to `surface`, or of all if there is none.
    ///
    /// # Errors
    /// [`StreamError::NoAdapter`], [`StreamError::NoDevice`].
    pub async fn request(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'static>>,
    ) -> Result<Self, StreamError> {
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                compatible_surface: surface,
                ..Default::default()
            })
            .await
            .map_err(|error| StreamError::NoAdapter(error.to_string()))?;
        let (device, queue) = adapter
            .request_device(&Self::descriptor(&adapter))
            .await
            .map_err(|error| StreamError::NoDevice {
                device: adapter.get_info().name,
                why: error.to_string(),
            })?;
        let failure = watch(&device);
        Ok(Self::from_parts(adapter, device, queue, failure))
    }

    /// How a device is to be asked for, so that the kernels can run on it.
    #[must_use]
    pub fn descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        wgpu::DeviceDescriptor {
            label: Some("stream"),
            required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
            required_limits: limits(adapter),
            ..Default::default()
        }
    }

    /// Takes a device that someone else opened, such as the window's, and watches.
    #[must_use]
    pub fn from_parts(
        adapter: wgpu::Adapter,
        device: wgpu::Device,
        queue: wgpu::Queue,
        failure: Failure,
    ) -> Self {
        let info = adapter.get_info();
        Self {
            name: info.name,
            is_software: info.device_type == wgpu::DeviceType::Cpu,
            has_timestamps: device.features().contains(wgpu::Features::TIMESTAMP_QUERY),
            limits: device.limits(),
            adapter,
            device,
            queue,
            failure,
            compiled: Arc::default(),
        }
    }

    /// A kernel that was compiled before.
    pub(super) fn compiled(&self, key: &str) -> Option<Compiled> {
        lock(&self.compiled).get(key).cloned()
    }

    /// Keeps a kernel for whoever needs it again.
    pub(super) fn keep_compiled(&self, key: String, compiled: Compiled) {
        lock(&self.compiled).insert(key, compiled);
    }

    /// Says whether all went well until now.
    ///
    /// # Errors
    /// [`StreamError::Failed`] with the device's first error, or with its loss.
    pub fn check(&self) -> Result<(), StreamError> {
        if lock(&self.failure).is_none() {
            return Ok(());
        }
        // What a lost device leaves undone may be reported before its loss, which comes when all that it
        // still does is done.
        let _ = self.device.poll(wgpu::PollType::Wait {
            submission_index: None,
            timeout: Some(Duration::from_secs(1)),
        });
        let why = lock(&self.failure).clone();
        Err(StreamError::Failed {
            device: self.name.clone(),
            why: why.unwrap_or_default(),
        })
    }

    /// Looks what has arrived, without waiting. To be called once a frame.
    ///
    /// # Errors
    /// [`StreamError::Failed`].
    pub fn poll(&self) -> Result<(), StreamError> {
        self.look(wgpu::PollType::Poll)
    }

    /// Waits until all that was submitted is done.
    ///
    /// # Errors
    /// [`StreamError::Failed`].
    pub fn wait(&self) -> Result<(), StreamError> {
        self.look(wgpu::PollType::wait_indefinitely())
    }

    fn look(&self, how: wgpu::PollType) -> Result<(), StreamError> {
        if let Err(error) = self.device.poll(how) {
            self.fail(&error.to_string());
        }
        self.check()
    }

    /// Keeps an error that the device reported by other ways.
    pub(super) fn fail(&self, why: &str) {
        lock(&self.failure).get_or_insert_with(|| why.to_owned());
    }

    // ANCHOR: most_rows
    /// How many rows of this size a column can have here.
    #[must_use]
    pub fn most_rows(&self, row_bytes: usize) -> u64 {
        let limits = &self.limits;
        let bytes = limits
            .max_storage_buffer_binding_size
            .min(limits.max_buffer_size);
        let rows = bytes / row_bytes.max(1) as u64;
        // Kernels count rows in 32 bits.
        rows.min(u64::from(u32::MAX))
    }
    // ANCHOR_END: most_rows
}

/// What the instance checks. The arguments of indirect runs are ours: to check them would cost a pass
/// before each.
fn flags() -> wgpu::InstanceFlags {
    wgpu::InstanceFlags::from_env_or_default() - wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL
}

/// What every device has, with the buffers and workgroups that this one has.
fn limits(adapter: &wgpu::Adapter) -> wgpu::Limits {
    let have = adapter.limits();
    wgpu::Limits {
        max_buffer_size: have.max_buffer_size,
        max_storage_buffer_binding_size: have.max_storage_buffer_binding_size,
        max_storage_buffers_per_shader_stage: have.max_storage_buffers_per_shader_stage,
        max_compute_workgroup_storage_size: have.max_compute_workgroup_storage_size,
        max_compute_invocations_per_workgroup: have.max_compute_invocations_per_workgroup,
        max_compute_workgroup_size_x: have.max_compute_workgroup_size_x,
        max_compute_workgroup_size_y: have.max_compute_workgroup_size_y,
        max_compute_workgroup_size_z: have.max_compute_workgroup_size_z,
        max_compute_workgroups_per_dimension: have.max_compute_workgroups_per_dimension,
        ..wgpu::Limits::downlevel_defaults().using_resolution(have)
    }
}

/// Keeps the device's first error, or its loss, instead of the default, which is to panic.
fn watch(device: &wgpu::Device) -> Failure {
    let failure = Failure::default();
    let on_error = Arc::clone(&failure);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        lock(&on_error).get_or_insert(error.to_string());
    }));
    let on_loss = Arc::clone(&failure);
    device.set_device_lost_callback(move |reason, message| {
        *lock(&on_loss) = Some(format!("it was lost ({reason:?}) {message}"));
    });
    failure
}

/// What is kept is whole even if a thread panicked while it held the lock.
fn lock<T>(kept: &Mutex<T>) -> MutexGuard<'_, T> {
    kept.lock().unwrap_or_else(PoisonError::into_inner)
}
