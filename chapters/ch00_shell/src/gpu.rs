//! The graphics device: found asynchronously, as a browser demands, and with what drawing and computing
//! need of it. Nothing here or in the renderer panics when the device fails; the first
//! error is kept, and whoever runs the loop asks for it once a frame.
//!
//! A program has one device open at a time: an engine that computes on it and the window that
//! draws from the engine's buffers share it. Who needs it first opens it.

use std::cell::RefCell;
use std::rc::{Rc, Weak};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crate::ShellError;

/// An adapter with a device on it, ready to draw and to compute.
pub struct Gpu {
    /// What the adapter was found with; a window's surface has to come from it, too.
    pub instance: wgpu::Instance,
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
    is_lost: Arc<AtomicBool>,
}

/// The first error that the device reported.
pub type Failure = Arc<Mutex<Option<String>>>;

thread_local! {
    /// The device that this program has open. Who uses it holds it.
    static OPEN: RefCell<Weak<Gpu>> = const { RefCell::new(Weak::new()) };
}

impl Gpu {
    /// The device that this program has open; opens one if there is none, or if it has failed.
    ///
    /// # Errors
    /// [`ShellError::NoAdapter`] if there is none, [`ShellError::Graphics`] if it can't be opened.
    pub fn shared() -> Result<Rc<Self>, ShellError> {
        match open_one() {
            Some(open) => Ok(open),
            None => pollster::block_on(Self::request(&new_instance(), None)),
        }
    }

    /// What to make a window's surface with, so that the open device can draw to it.
    pub(crate) fn instance() -> wgpu::Instance {
        open_one().map_or_else(new_instance, |open| open.instance.clone())
    }

    /// The open device if it can draw to this surface, or else one that can. The surface was made with
    /// [`Self::instance`].
    ///
    /// # Errors
    /// [`ShellError::NoAdapter`] if there is none, [`ShellError::Graphics`] if it can't be opened.
    pub(crate) async fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'static>,
    ) -> Result<Rc<Self>, ShellError> {
        match open_one().filter(|open| open.adapter.is_surface_supported(surface)) {
            Some(open) => Ok(open),
            None => Self::request(instance, Some(surface)).await,
        }
    }

    /// Finds an adapter that can draw to `surface`, or any if there is none, and opens a
    /// device on it. It is the one to be shared from then on.
    ///
    /// # Errors
    /// [`ShellError::NoAdapter`] if there is none, [`ShellError::Graphics`] if it can't be opened.
    async fn request(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'static>>,
    ) -> Result<Rc<Self>, ShellError> {
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
                required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
                required_limits: limits(&adapter),
                ..Default::default()
            })
            .await
            .map_err(|error| ShellError::Graphics(error.to_string()))?;
        let info = adapter.get_info();
        let (failure, is_lost) = watch(&device);
        let gpu = Rc::new(Self {
            instance: instance.clone(),
            adapter,
            device,
            queue,
            name: info.name,
            is_software: info.device_type == wgpu::DeviceType::Cpu,
            failure,
            is_lost,
        });
        OPEN.set(Rc::downgrade(&gpu));
        Ok(gpu)
    }

    /// Takes over what the device has to say, without waiting: errors, and numbers that came back. To be
    /// called once a frame.
    pub fn look(&self) {
        // What goes wrong here is the device's failure, or its loss.
        let _ = self.device.poll(wgpu::PollType::Poll);
    }

    /// The first error that the device reported, if it did.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        lock(&self.failure).clone()
    }

    /// Where that error will stand, for an engine that watches the same device.
    #[must_use]
    pub fn failure_place(&self) -> Failure {
        Arc::clone(&self.failure)
    }

    /// Whether the device is gone: driver updates, suspended machines and shaders that never end do
    /// that. Another one can be opened then.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.is_lost.load(Ordering::Acquire)
    }
}

/// The device that is open and hasn't failed.
fn open_one() -> Option<Rc<Gpu>> {
    let open = OPEN.with_borrow(Weak::upgrade)?;
    open.failure().is_none().then_some(open)
}

/// A way to adapters. It leaves the arguments of indirect runs to whoever makes them on the device:
/// checking them would cost a pass before each.
fn new_instance() -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor {
        flags: wgpu::InstanceFlags::from_env_or_default()
            - wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL,
        ..wgpu::InstanceDescriptor::new_without_display_handle_from_env()
    })
}

/// What devices commonly have, as far as this one has it, with the picture sizes, buffers and
/// workgroups that this one has.
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
        ..wgpu::Limits::default()
            .or_worse_values_from(&have)
            .using_resolution(have)
    }
}

/// Keeps the device's first error instead of the default, which is to panic. A loss is what counts
/// when there is one: errors before it were its signs.
fn watch(device: &wgpu::Device) -> (Failure, Arc<AtomicBool>) {
    let (failure, is_lost) = (Failure::default(), Arc::new(AtomicBool::new(false)));
    let on_error = Arc::clone(&failure);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        lock(&on_error).get_or_insert(error.to_string());
    }));
    let (on_loss, flag) = (Arc::clone(&failure), Arc::clone(&is_lost));
    device.set_device_lost_callback(move |reason, message| {
        let message = format!("the device was lost ({reason:?}) {message}");
        *lock(&on_loss) = Some(message.trim_end().to_owned());
        flag.store(true, Ordering::Release);
    });
    (failure, is_lost)
}

/// A text is whole even if a thread panicked while it held the lock.
fn lock(failure: &Failure) -> std::sync::MutexGuard<'_, Option<String>> {
    failure.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEEDED: &str = "a Vulkan device, such as that of the package mesa-vulkan-drivers";

    #[test]
    fn all_who_ask_share_one_device_and_the_last_closes_it() {
        let one = Gpu::shared().expect(NEEDED);
        let two = Gpu::shared().expect(NEEDED);
        assert!(Rc::ptr_eq(&one, &two));
        drop((one, two));
        assert!(open_one().is_none());
    }

    #[test]
    fn after_a_loss_another_device_is_opened() {
        let lost = Gpu::shared().expect(NEEDED);
        lost.device.destroy();
        lost.device
            .poll(wgpu::PollType::wait_indefinitely())
            .expect("nothing is left to do");
        assert!(lost.is_lost() && lost.failure().is_some());
        let next = Gpu::shared().expect(NEEDED);
        assert!(!Rc::ptr_eq(&lost, &next) && next.failure().is_none());
    }

    #[test]
    fn the_device_can_do_what_kernels_need() {
        let gpu = Gpu::shared().expect(NEEDED);
        let (limits, have) = (gpu.device.limits(), gpu.adapter.limits());
        assert_eq!(limits.max_buffer_size, have.max_buffer_size);
        assert!(limits.max_storage_buffers_per_shader_stage >= 8);
        assert!(limits.max_compute_invocations_per_workgroup >= 256);
        let wanted = gpu.adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
        assert!(gpu.device.features().contains(wanted));
    }
}
