//! The window's surface: pictures are taken from it, drawn into and shown. It comes back
//! from whatever happens to a window: another size, minimised, covered, lost.

use std::sync::Arc;

use winit::window::Window;

use crate::ShellError;
use crate::gpu::Gpu;

/// A surface with its settings.
pub struct WindowSurface {
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    is_configured: bool,
}

impl WindowSurface {
    /// Takes a surface for this device. Colours are written as the display's values, not as
    /// linear light, so its format is not sRGB.
    ///
    /// # Errors
    /// [`ShellError::Graphics`] if the device can't show pictures there.
    pub fn new(
        gpu: &Gpu,
        surface: wgpu::Surface<'static>,
        window: &Window,
    ) -> Result<Self, ShellError> {
        let size = window.inner_size();
        let mut config = surface
            .get_default_config(&gpu.adapter, size.width.max(1), size.height.max(1))
            .ok_or_else(|| {
                ShellError::Graphics(format!("{} can't show pictures in a window", gpu.name))
            })?;
        let can = surface.get_capabilities(&gpu.adapter);
        let formats = can.formats;
        let plain = |format: &&wgpu::TextureFormat| {
            matches!(
                format,
                wgpu::TextureFormat::Bgra8Unorm | wgpu::TextureFormat::Rgba8Unorm
            )
        };
        let fallback = config.format.remove_srgb_suffix();
        config.format = formats.iter().find(plain).copied().unwrap_or(fallback);
        config.present_mode = wgpu::PresentMode::AutoVsync;
        config.usage |= can.usages & wgpu::TextureUsages::COPY_DST;
        let mut surface = Self {
            surface,
            config,
            is_configured: false,
        };
        surface.resize(gpu, size.width, size.height);
        Ok(surface)
    }

    /// Format of its pictures.
    pub fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// Width and height of its pictures, pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.config.width, self.config.height]
    }

    /// Whether it can show pictures now; not while the window is minimised.
    pub fn is_shown(&self) -> bool {
        self.is_configured
    }

    /// Follows the window; a minimised one, of size 0, shows nothing until it is back.
    pub fn resize(&mut self, gpu: &Gpu, width: u32, height: u32) {
        let most = gpu.device.limits().max_texture_dimension_2d;
        self.is_configured = width > 0 && height > 0;
        if self.is_configured {
            self.config.width = width.min(most);
            self.config.height = height.min(most);
            self.surface.configure(&gpu.device, &self.config);
        }
    }

    /// The picture to draw the next frame into; none if there is nothing to show it on now.
    pub fn next_picture(&self, gpu: &Gpu) -> Option<wgpu::SurfaceTexture> {
        use wgpu::CurrentSurfaceTexture as Current;
        if !self.is_configured {
            return None;
        }
        match self.surface.get_current_texture() {
            // A picture of the wrong size will do until the window's resize event is there.
            Current::Success(picture) | Current::Suboptimal(picture) => Some(picture),
            Current::Outdated | Current::Lost => {
                self.surface.configure(&gpu.device, &self.config);
                None
            }
            Current::Timeout | Current::Occluded | Current::Validation => None,
        }
    }
}

/// The surface of a window.
///
/// # Errors
/// [`ShellError::NoAdapter`] if no graphics system can show pictures in this window.
pub fn create(
    instance: &wgpu::Instance,
    window: &Arc<Window>,
) -> Result<wgpu::Surface<'static>, ShellError> {
    let target = wgpu::SurfaceTarget::DisplayAndWindow(Box::new(Arc::clone(window)));
    instance
        .create_surface(target)
        .map_err(|error| ShellError::NoAdapter(error.to_string()))
}
