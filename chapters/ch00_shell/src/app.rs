//! The window: opened when the system is ready, given a device when one is found, and from
//! then on one frame after the other until it is closed.
//!
//! A frame never waits for the device, and the device is asked for asynchronously, as a
//! browser demands. Where there is no display or no adapter, [`run`] answers with an error,
//! and its caller goes on without a window. A device that is lost later is opened again.

use std::rc::Rc;
use std::sync::Arc;

use web_time::Instant;
use winit::application::ApplicationHandler;
use winit::dpi::LogicalSize;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::window::{Window, WindowId};

use crate::clock::Pace;
use crate::gpu::Gpu;
use crate::overlay::Panels;
use crate::show::Show;
use crate::side_by_side::{Extras, Menu};
use crate::stage::Stage;
use crate::surface::{self, WindowSurface};
use crate::window_loop::WindowLoop;
use crate::{Chapter, Session, ShellError};

/// A device may be lost so often; then something is wrong for good.
const MOST_LOSSES: u32 = 3;

/// Width and height of the window at the start, points.
const SIZE: LogicalSize<u32> = LogicalSize::new(1280, 720);

/// Opens a window on a session, with this shown in it and what the program adds, and returns when it is
/// closed.
///
/// # Errors
/// [`ShellError::NoDisplay`] or [`ShellError::NoAdapter`] where there can be no window,
/// [`ShellError::Graphics`] if the device fails.
pub fn run(
    chapter: &Chapter,
    session: Session,
    pace: Pace,
    show: Show,
    extras: Extras,
) -> Result<(), ShellError> {
    let start = Instant::now();
    let event_loop = EventLoop::<Ready>::with_user_event()
        .build()
        .map_err(|error| ShellError::NoDisplay(error.to_string()))?;
    let mut stage = Stage::new(*chapter, session, pace, show);
    if let Some(runs) = extras.runs {
        stage.show_beside(runs);
    }
    let mut app = App {
        start,
        proxy: event_loop.create_proxy(),
        phase: Phase::Waiting(Box::new(stage), None),
        menus: extras.menus,
        losses: 0,
        failure: None,
    };
    event_loop
        .run_app(&mut app)
        .map_err(|error| ShellError::NoDisplay(error.to_string()))?;
    app.failure.map_or(Ok(()), Err)
}

/// A window whose device has been found, or not.
type Ready = Result<(Arc<Window>, Rc<Gpu>, wgpu::Surface<'static>), ShellError>;

/// What the event loop drives.
struct App {
    start: Instant,
    proxy: EventLoopProxy<Ready>,
    phase: Phase,
    /// What the program adds to the panels; they have it from the first frame on.
    menus: Vec<Box<dyn Menu>>,
    /// How often the device was lost.
    losses: u32,
    failure: Option<ShellError>,
}

/// How far the window is.
enum Phase {
    /// For the system or the device; with the panels as they were before a device was lost.
    Waiting(Box<Stage>, Option<Box<Panels>>),
    /// Frames are drawn.
    Running(Box<WindowLoop>),
    /// Nothing more to do.
    Over,
}

impl App {
    /// Opens the window and asks for a device; the answer comes as a user event.
    fn open(&self, event_loop: &ActiveEventLoop, title: &str) -> Result<(), ShellError> {
        let attributes = Window::default_attributes()
            .with_title(title)
            .with_inner_size(SIZE);
        let window = event_loop
            .create_window(attributes)
            .map_err(|error| ShellError::NoDisplay(error.to_string()))?;
        self.request_device(Arc::new(window))
    }

    /// Asks for a device that can draw to a window.
    fn request_device(&self, window: Arc<Window>) -> Result<(), ShellError> {
        let instance = Gpu::instance();
        let surface = surface::create(&instance, &window)?;
        let proxy = self.proxy.clone();
        spawn(async move {
            let gpu = Gpu::for_surface(&instance, &surface).await;
            // The loop is gone only if the window was closed meanwhile.
            let _ = proxy.send_event(gpu.map(|gpu| (window, gpu, surface)));
        });
        Ok(())
    }

    fn begin(&mut self, ready: Ready) -> Result<(), ShellError> {
        let (window, gpu, surface) = ready?;
        let surface = WindowSurface::new(&gpu, surface, &window)?;
        match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Waiting(stage, panels) => {
                let menus = std::mem::take(&mut self.menus);
                let panels = panels.map_or_else(|| Panels::with(menus), |panels| *panels);
                let running = WindowLoop::new(window, gpu, surface, *stage, panels, self.start);
                self.phase = Phase::Running(Box::new(running));
            }
            phase => self.phase = phase,
        }
        Ok(())
    }

    /// Opens another device after a loss; the scene goes on where it was.
    fn replace_device(&mut self) -> Result<(), ShellError> {
        self.losses += 1;
        match std::mem::replace(&mut self.phase, Phase::Over) {
            Phase::Running(running) => {
                let (window, mut stage, panels) = running.take_apart();
                stage.tell("The graphics device was lost and another one opened.");
                self.phase = Phase::Waiting(Box::new(stage), Some(Box::new(panels)));
                self.request_device(window)
            }
            phase => {
                self.phase = phase;
                Ok(())
            }
        }
    }

    /// Ends the loop with an error, if there is one.
    fn check(&mut self, event_loop: &ActiveEventLoop, outcome: Result<(), ShellError>) {
        if let Err(error) = outcome {
            self.failure = Some(match error {
                // There was one before: the run is over, and none without a window begins.
                ShellError::NoAdapter(why) if self.losses > 0 => ShellError::Graphics(why),
                error => error,
            });
            self.phase = Phase::Over;
            event_loop.exit();
        }
    }
}

impl ApplicationHandler<Ready> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if let Phase::Waiting(stage, None) = &self.phase {
            let title = stage.chapter.title;
            let outcome = self.open(event_loop, title);
            self.check(event_loop, outcome);
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, ready: Ready) {
        let outcome = self.begin(ready);
        self.check(event_loop, outcome);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        if event == WindowEvent::CloseRequested {
            self.phase = Phase::Over;
            event_loop.exit();
        } else if let Phase::Running(running) = &mut self.phase {
            let mut outcome = running.on_event(&event);
            if running.wants_to_quit() {
                self.phase = Phase::Over;
                event_loop.exit();
            } else if running.has_lost_device() && self.losses < MOST_LOSSES {
                outcome = self.replace_device();
            }
            self.check(event_loop, outcome);
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        if let Phase::Running(running) = &self.phase {
            event_loop.set_control_flow(if running.is_visible() {
                ControlFlow::Poll
            } else {
                ControlFlow::Wait
            });
            running.request_frame();
        }
    }
}

/// Runs a future to its end: here and now where that is possible. In a browser it would be
/// handed to the page instead.
fn spawn(future: impl Future<Output = ()> + 'static) {
    pollster::block_on(future);
}
