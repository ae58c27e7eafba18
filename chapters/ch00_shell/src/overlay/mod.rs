//! The overlay: a panel at the left with collapsible sections, each section a file with a
//! name and a `show`, a table of properties at the bottom, and at the right, for a pair that is
//! looked at, its narrow phase. It draws nothing over the
//! scene but marks and notes; what is left of the window is the scene's.

mod beside;
mod counts;
mod errors;
mod format;
mod keys;
mod layers;
mod marks;
mod narrow;
mod notes;
mod painter;
mod plan;
mod properties;
mod setup;
mod sheet;
mod speed;
mod still;
mod style;
#[cfg(test)]
mod tests;
mod transport;
mod view;

use glam::Vec2;
use winit::event::WindowEvent;
use winit::window::Window;

use crate::camera::Viewport;
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::render::Theme;
use crate::side_by_side::Menu;
use crate::stage::Stage;
use painter::Painter;
use properties::Properties;

pub use painter::Canvas;
pub use still::Still;

/// Width of the left panel at the start, points.
const WIDTH: f32 = 304.0;

/// A section of the left panel.
pub trait Section {
    /// Its headline.
    fn name(&self) -> &'static str;

    /// Whether it is unfolded at the start.
    fn is_open_at_start(&self) -> bool;

    /// Shows it and does what its user wants.
    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage);
}

/// The overlay's state between frames.
pub struct Overlay {
    panels: Panels,
    input: egui_winit::State,
    painter: Painter,
}

/// What the overlay shows, without a window and without a device.
pub struct Panels {
    context: egui::Context,
    sections: Vec<Box<dyn Section>>,
    /// What the program added.
    menus: Vec<Box<dyn Menu>>,
    properties: Properties,
    theme: Option<Theme>,
}

/// A frame of the overlay, to be painted over the scene.
pub struct Layout {
    output: egui::FullOutput,
    /// What is left for the scene.
    pub viewport: Viewport,
    /// The views in it, where several runs are side by side.
    pub views: Vec<Viewport>,
    /// The same, points.
    free: egui::Rect,
    background: egui::Color32,
    /// Since the start, s.
    time: f64,
    /// Whether someone does something with the panels, or they move.
    is_touched: bool,
}

impl Layout {
    /// The panels' colour, as displayed. The scene's pass clears the picture with it, which
    /// costs less than to fill the panels.
    pub fn background(&self) -> wgpu::Color {
        background(self.background)
    }

    /// Pixels per point of the screen.
    pub fn scale(&self) -> f32 {
        self.output.pixels_per_point
    }
}

impl Overlay {
    /// For this window; pictures have this format.
    pub fn new(gpu: &Gpu, window: &Window, format: wgpu::TextureFormat, panels: Panels) -> Self {
        let most = gpu.device.limits().max_texture_dimension_2d as usize;
        #[expect(clippy::cast_possible_truncation, reason = "a factor such as 1.5")]
        let scale = window.scale_factor() as f32;
        let input = egui_winit::State::new(
            panels.context.clone(),
            egui::ViewportId::ROOT,
            window,
            Some(scale),
            None,
            Some(most),
        );
        Self {
            panels,
            input,
            painter: Painter::new(gpu, format),
        }
    }

    /// The panels as they are now, for another device.
    pub fn into_panels(self) -> Panels {
        // A context sends its letters to the device once, so that another device needs another one.
        let context = egui::Context::default();
        let memory = self.panels.context.memory(Clone::clone);
        context.memory_mut(|new| *new = memory);
        Panels {
            context,
            theme: None,
            ..self.panels
        }
    }

    /// Takes an event; whether it was meant for the overlay.
    pub fn on_event(&mut self, window: &Window, event: &WindowEvent) -> bool {
        let consumed = self.input.on_window_event(window, event).consumed;
        match event {
            // Keys are the overlay's only while someone types into it.
            WindowEvent::KeyboardInput { .. } => self.panels.context.text_edit_focused(),
            _ => consumed,
        }
    }

    /// Lays the overlay out and lets it act on the stage.
    pub fn lay_out(
        &mut self,
        window: &Window,
        size: [u32; 2],
        stage: &mut Stage,
        guides: &Guides,
    ) -> Layout {
        let input = self.input.take_egui_input(window);
        let mut layout = self.panels.lay_out(input, size, stage, guides);
        let platform = std::mem::take(&mut layout.output.platform_output);
        self.input.handle_platform_output(window, platform);
        layout
    }

    /// Paints a layout over the picture.
    pub fn paint(
        &mut self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        canvas: &Canvas,
        layout: Layout,
    ) {
        let context = &self.panels.context;
        self.painter.paint(gpu, encoder, canvas, context, layout);
    }
}

impl Default for Panels {
    fn default() -> Self {
        Self {
            context: egui::Context::default(),
            sections: vec![
                Box::new(speed::Speed),
                Box::new(setup::Setup),
                Box::new(layers::Layers),
                Box::new(narrow::Choice),
                Box::new(errors::Errors),
                Box::new(counts::Counts),
                Box::new(view::View),
                Box::new(plan::Plan),
                Box::new(keys::Keys),
            ],
            menus: Vec::new(),
            properties: Properties::default(),
            theme: None,
        }
    }
}

impl Panels {
    /// The panels with these sections besides the shell's.
    pub fn with(menus: Vec<Box<dyn Menu>>) -> Self {
        Self {
            menus,
            ..Self::default()
        }
    }

    /// Lays the panels out and lets them act on the stage.
    fn lay_out(
        &mut self,
        input: egui::RawInput,
        size: [u32; 2],
        stage: &mut Stage,
        guides: &Guides,
    ) -> Layout {
        let has_new_theme = self.theme != Some(stage.theme);
        if has_new_theme {
            self.theme = Some(stage.theme);
            style::apply(&self.context, stage.theme);
        }
        let context = self.context.clone();
        let mut free = egui::Rect::ZERO;
        let mut views = Vec::new();
        let output = context.run_ui(input, |ui| {
            if stage.beside.is_some() {
                let left = self.show_beside(ui, stage);
                (free, views) = (left.all, left.views);
            } else {
                free = self.show(ui, stage, guides);
                views.clear();
            }
        });
        let in_pixels = |room| viewport(room, output.pixels_per_point, size);
        Layout {
            viewport: in_pixels(free),
            views: views.into_iter().map(in_pixels).collect(),
            free,
            background: context.global_style().visuals.panel_fill,
            time: context.input(|input| input.time),
            is_touched: has_new_theme || is_touched(&context, free, &output),
            output,
        }
    }

    /// All panels; gives the rectangle that they leave free, in points.
    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage, guides: &Guides) -> egui::Rect {
        let mut is_shown = stage.shows_overlay;
        egui::Panel::left("overlay")
            .default_size(WIDTH)
            .size_range(240.0..=520.0)
            .drag_to_open(false)
            .frame(style::panel(ui))
            .show_collapsible(ui, &mut is_shown, |ui| self.show_sections(ui, stage));
        stage.shows_overlay = is_shown;
        if !is_shown {
            hint(ui);
        }
        if stage.shows_overlay && self.properties.is_table_shown() {
            self.properties.show_table(ui, stage);
        }
        show_pair(ui, stage, guides);
        let free = ui.available_rect_before_wrap();
        let painter = ui.painter_at(free);
        notes::paint(&painter, ui.visuals(), free, &stage.camera, guides);
        free
    }

    fn show_sections(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        transport::show(ui, stage);
        ui.separator();
        egui::ScrollArea::vertical()
            .auto_shrink(false)
            .show(ui, |ui| {
                self.show_menus(ui, stage);
                for section in &mut self.sections {
                    fold(ui, section.as_mut(), stage);
                }
                fold(ui, &mut self.properties, stage);
            });
    }
}

/// The narrow phase of the pair that is looked at, if there is one.
fn show_pair(ui: &mut egui::Ui, stage: &mut Stage, guides: &Guides) {
    if let Some(mut pair) = stage.show.pair {
        let dissection = guides.dissection.as_ref();
        let session = stage.session();
        let stays = narrow::show(ui, session, &mut pair, dissection, &stage.camera, false);
        stage.show.pair = stays.then_some(pair);
    }
}

/// A colour of the overlay as a picture is cleared with.
fn background(color: egui::Color32) -> wgpu::Color {
    let [r, g, b, _] = color.to_array().map(|part| f64::from(part) / 255.0);
    wgpu::Color { r, g, b, a: 1.0 }
}

/// Whether someone does something with the panels beside the scene, or they move.
fn is_touched(context: &egui::Context, scene: egui::Rect, output: &egui::FullOutput) -> bool {
    let is_moving = output
        .viewport_output
        .values()
        .any(|viewport| viewport.repaint_delay.is_zero());
    let acts = |event: &egui::Event| match event {
        egui::Event::PointerMoved(place) => !scene.contains(*place),
        _ => true,
    };
    is_moving || context.input(|input| input.events.iter().any(acts))
}

/// How to get a hidden panel back.
fn hint(ui: &egui::Ui) {
    egui::Area::new(egui::Id::unique("hint"))
        .anchor(egui::Align2::LEFT_BOTTOM, [10.0, -8.0])
        .interactable(false)
        .show(ui.ctx(), |ui| ui.weak("H: panel"));
}

/// A section under its headline.
fn fold(ui: &mut egui::Ui, section: &mut dyn Section, stage: &mut Stage) {
    egui::CollapsingHeader::new(egui::RichText::new(section.name()).strong())
        .default_open(section.is_open_at_start())
        .show_unindented(ui, |ui| {
            section.show(ui, stage);
            ui.add_space(4.0);
        });
}

/// A rectangle in points as a viewport in pixels, inside the picture and never empty.
fn viewport(free: egui::Rect, scale: f32, size: [u32; 2]) -> Viewport {
    let size = Viewport::whole(size).size;
    let low = Vec2::new(free.min.x, free.min.y) * scale;
    let high = Vec2::new(free.max.x, free.max.y) * scale;
    let origin = low.round().clamp(Vec2::ZERO, size - 1.0);
    let end = high.round().clamp(origin + 1.0, size);
    Viewport {
        origin,
        size: end - origin,
    }
}
