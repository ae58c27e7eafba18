//! A frame of the window, and what happens between frames: simulate, lay the overlay out,
//! draw the scene, paint the overlay, show.

use std::rc::Rc;
use std::sync::Arc;

use web_time::{Duration, Instant};
use winit::event::WindowEvent;
use winit::window::Window;

use crate::ShellError;
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::input::Input;
use crate::overlay::{Canvas, Layout, Overlay, Panels};
use crate::render::{Picture, Quality, Renderer, Several};
use crate::stage::Stage;
use crate::surface::WindowSurface;

/// A window with everything that is drawn in it.
pub struct WindowLoop {
    window: Arc<Window>,
    surface: WindowSurface,
    renderer: Renderer,
    several: Several,
    overlay: Overlay,
    input: Input,
    stage: Stage,
    generation: u32,
    guides: Guides,
    start: Instant,
    last_frame: Option<Instant>,
    is_occluded: bool,
    // Dropped last: everything above lives on it.
    gpu: Rc<Gpu>,
}

impl WindowLoop {
    /// Ready for the first frame, or for the next one after a device was lost.
    pub fn new(
        window: Arc<Window>,
        gpu: Rc<Gpu>,
        surface: WindowSurface,
        mut stage: Stage,
        panels: Panels,
        start: Instant,
    ) -> Self {
        stage.adapter.clone_from(&gpu.name);
        stage.move_to(&gpu);
        let (surroundings, generation) = stage.surroundings();
        let quality = Quality::of(gpu.is_software, surroundings);
        Self {
            renderer: Renderer::new(&gpu, surface.format(), quality, surroundings.clone()),
            several: Several::new(surface.format(), quality),
            overlay: Overlay::new(&gpu, &window, surface.format(), panels),
            input: Input::default(),
            guides: Guides::default(),
            last_frame: None,
            is_occluded: false,
            window,
            surface,
            stage,
            generation,
            start,
            gpu,
        }
    }

    /// Whether the user wants to close the window.
    pub fn wants_to_quit(&self) -> bool {
        self.input.wants_to_quit
    }

    /// Whether the device is gone that everything here lives on.
    pub fn has_lost_device(&self) -> bool {
        self.gpu.is_lost()
    }

    /// What outlives the device.
    pub fn take_apart(self) -> (Arc<Window>, Stage, Panels) {
        (self.window, self.stage, self.overlay.into_panels())
    }

    /// Whether there is anyone to draw for.
    pub fn is_visible(&self) -> bool {
        !self.is_occluded && self.surface.is_shown()
    }

    /// Asks for another frame, if there is anyone to draw it for.
    pub fn request_frame(&self) {
        if self.is_visible() {
            self.window.request_redraw();
        }
    }

    /// Takes an event of the window.
    ///
    /// # Errors
    /// [`ShellError::Graphics`] if the device has failed.
    pub fn on_event(&mut self, event: &WindowEvent) -> Result<(), ShellError> {
        match event {
            WindowEvent::RedrawRequested => return self.frame(),
            WindowEvent::Resized(size) => self.surface.resize(&self.gpu, size.width, size.height),
            WindowEvent::Occluded(is_occluded) => self.is_occluded = *is_occluded,
            _ => {}
        }
        let is_for_overlay = self.overlay.on_event(&self.window, event);
        self.input.on_event(&mut self.stage, event, is_for_overlay);
        Ok(())
    }

    /// One frame; none if the window shows nothing now.
    fn frame(&mut self) -> Result<(), ShellError> {
        self.gpu.look();
        if let Some(failure) = self.gpu.failure() {
            return Err(ShellError::Graphics(failure));
        }
        let Some(picture) = self.surface.next_picture(&self.gpu) else {
            return Ok(());
        };
        let elapsed = self.measure_time();
        self.leave_processor_to_runs();
        self.stage.advance(elapsed);
        self.guides.collect(&self.stage);
        let size = self.surface.size();
        let layout = self
            .overlay
            .lay_out(&self.window, size, &mut self.stage, &self.guides);
        if layout.views.is_empty() {
            self.stage.set_viewport(layout.viewport);
        } else {
            self.stage.set_rooms(layout.views.clone());
        }
        self.draw(&picture, layout);
        self.window.pre_present_notify();
        self.gpu.queue.present(picture);
        self.note_first_frame();
        Ok(())
    }

    /// Seconds since the last frame began.
    fn measure_time(&mut self) -> f64 {
        let now = Instant::now();
        let elapsed = self.last_frame.map_or(Duration::ZERO, |last| now - last);
        if self.last_frame.is_some() {
            self.stage.frame_rate.record(elapsed);
        }
        self.last_frame = Some(now);
        elapsed.as_secs_f64()
    }

    /// Runs side by side are compared by their times. A processor that imitates a graphics card ends the
    /// last picture first, which would otherwise be drawn while they are timed.
    fn leave_processor_to_runs(&self) {
        if self.gpu.is_software && self.stage.beside.is_some() {
            // What goes wrong here is the device's failure, or its loss.
            let _ = self.gpu.device.poll(wgpu::PollType::wait_indefinitely());
        }
    }

    /// Draws the scene and paints the overlay over it.
    fn draw(&mut self, picture: &wgpu::SurfaceTexture, layout: Layout) {
        self.follow_scene();
        let gpu = &self.gpu;
        let view = picture
            .texture
            .create_view(&wgpu::TextureViewDescriptor::default());
        let mut encoder = gpu
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let size = self.surface.size();
        let scene = Picture {
            session: self.stage.session(),
            alpha: self.stage.alpha(),
            camera: &self.stage.camera,
            viewport: layout.viewport,
            scale: layout.scale(),
            theme: self.stage.theme,
            margin: layout.background(),
            picked: self.stage.picked,
            pair: self.stage.show.pair.map(|pair| pair.bodies),
            is_glass: self.stage.show.is_glass(),
            strokes: &self.guides.strokes,
            faces: &self.guides.faces,
            is_as_read: self.stage.show.is_any(),
        };
        match self
            .stage
            .beside
            .as_ref()
            .filter(|_| !layout.views.is_empty())
        {
            Some(runs) => {
                let views = runs.views();
                let scenes = scene.of_each(&views, &layout.views);
                let (around, _) = self.stage.surroundings();
                let canvas = (&view, size);
                self.several
                    .draw(gpu, &mut encoder, canvas, around, &scenes);
            }
            None => self.renderer.draw(gpu, &mut encoder, &view, size, &scene),
        }
        let canvas = Canvas {
            texture: &picture.texture,
            view: &view,
        };
        self.overlay.paint(gpu, &mut encoder, &canvas, layout);
        gpu.queue.submit([encoder.finish()]);
    }

    /// Gives the renderer the walls of a new scene, or makes one that suits it better.
    fn follow_scene(&mut self) {
        let (surroundings, generation) = self.stage.surroundings();
        if self.generation != generation {
            self.generation = generation;
            let (gpu, around) = (&self.gpu, surroundings.clone());
            let quality = Quality::of(gpu.is_software, &around);
            self.several = Several::new(self.surface.format(), quality);
            if quality == self.renderer.quality() {
                self.renderer.set_surroundings(gpu, around);
            } else {
                self.renderer = Renderer::new(gpu, self.surface.format(), quality, around);
            }
        }
    }

    fn note_first_frame(&mut self) {
        if self.stage.start_up.is_none() {
            let start_up = self.start.elapsed();
            let [width, height] = self.surface.size();
            eprintln!(
                "window: {width}x{height} on {}, first frame after {} ms",
                self.gpu.name,
                start_up.as_millis()
            );
            self.stage.start_up = Some(start_up);
        }
    }
}
