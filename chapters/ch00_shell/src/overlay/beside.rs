//! The panels of several runs side by side: at the left what runs and the sections that start other
//! runs, under the views whatever the runs plot, and over each view its name and its numbers.

use std::sync::Arc;

use egui::{Align2, Color32, FontId, Galley, Painter, Pos2, Rect, RichText, Ui, Visuals, vec2};

use super::transport::clock_buttons;
use super::{Panels, WIDTH, hint, style};
use crate::side_by_side::{SideBySide, View, arrange};
use crate::stage::Stage;

/// Height of what stands under the views, points.
const PLOTS: f32 = 186.0;

/// Between a text and an edge, points.
const MARGIN: f32 = 6.0;

/// Width of a view's mark of colour and the gap after it, points.
const MARK: f32 = 15.0;

/// What the panels leave free, and the views in it, points.
pub struct Free {
    pub all: Rect,
    pub views: Vec<Rect>,
}

impl Panels {
    /// All panels while runs are side by side.
    pub(super) fn show_beside(&mut self, ui: &mut Ui, stage: &mut Stage) -> Free {
        let mut is_shown = stage.shows_overlay;
        egui::Panel::left("beside")
            .default_size(WIDTH)
            .size_range(240.0..=520.0)
            .drag_to_open(false)
            .frame(style::panel(ui))
            .show_collapsible(ui, &mut is_shown, |ui| self.show_runs(ui, stage));
        stage.shows_overlay = is_shown;
        if !is_shown {
            hint(ui);
        }
        match &mut stage.beside {
            Some(runs) => show_views(ui, runs.as_mut()),
            None => Free {
                all: ui.available_rect_before_wrap(),
                views: Vec::new(),
            },
        }
    }

    fn show_runs(&mut self, ui: &mut Ui, stage: &mut Stage) {
        ui.add_space(4.0);
        ui.heading(stage.chapter.title);
        ui.horizontal(|ui| buttons(ui, stage));
        if let Some(notice) = &stage.notice {
            ui.colored_label(style::WARNING, notice);
        }
        ui.separator();
        egui::ScrollArea::vertical()
            .auto_shrink(false)
            .show(ui, |ui| {
                if let Some(runs) = &mut stage.beside {
                    runs.show_panel(ui);
                    ui.add_space(4.0);
                }
                self.show_menus(ui, stage);
            });
    }

    /// The sections that the program added.
    pub(super) fn show_menus(&mut self, ui: &mut Ui, stage: &mut Stage) {
        let is_open = stage.beside.is_some();
        for menu in &mut self.menus {
            let opening = egui::CollapsingHeader::new(RichText::new(menu.name()).strong())
                .default_open(is_open)
                .show_unindented(ui, |ui| menu.show(ui, stage.session()))
                .body_returned
                .flatten();
            if let Some(opening) = opening {
                stage.open_beside(opening);
            }
        }
    }
}

fn buttons(ui: &mut Ui, stage: &mut Stage) {
    clock_buttons(ui, stage);
    if ui.button("Close").on_hover_text("Esc").clicked() {
        stage.close_beside();
    }
}

/// The plots, and over them the views with their texts.
pub fn show_views(ui: &mut Ui, runs: &mut dyn SideBySide) -> Free {
    egui::Panel::bottom("plots")
        .exact_size(PLOTS)
        .show_separator_line(false)
        .frame(style::panel(ui))
        .show(ui, |ui| runs.show_plots(ui));
    let all = ui.available_rect_before_wrap();
    let shown = runs.views();
    let places = arrange(all, shown.len());
    let captions: Vec<Caption> = shown
        .iter()
        .zip(&places)
        .map(|(view, place)| Caption::new(ui, view, place.width()))
        .collect();
    let height = captions.iter().map(Caption::height).fold(0.0, f32::max);
    let mut views = Vec::new();
    for ((view, place), caption) in shown.iter().zip(&places).zip(captions) {
        let (above, room) = place.split_top_bottom_at_y(place.min.y + height);
        caption.paint(&ui.painter_at(above), above.min);
        if let Some(trouble) = &view.trouble {
            say_trouble(&ui.painter_at(room), ui.visuals(), room, trouble);
        }
        views.extend(view.session.map(|_| room));
    }
    Free { all, views }
}

/// The name and the numbers of a view, over it.
struct Caption {
    mark: Color32,
    name: Arc<Galley>,
    numbers: Arc<Galley>,
}

impl Caption {
    fn new(ui: &Ui, view: &View, width: f32) -> Self {
        let [r, g, b] = view.color;
        let (strong, plain) = (ui.visuals().strong_text_color(), ui.visuals().text_color());
        let lay_out = |text: &str, size, color| {
            let font = FontId::proportional(size);
            let room = width - 2.0 * MARGIN - MARK;
            ui.painter().layout(text.to_owned(), font, color, room)
        };
        Self {
            mark: Color32::from_rgb(r, g, b),
            name: lay_out(&view.name, 13.5, strong),
            numbers: lay_out(&view.text, 11.5, plain),
        }
    }

    fn height(&self) -> f32 {
        self.name.size().y + self.numbers.size().y + MARGIN
    }

    fn paint(self, painter: &Painter, corner: Pos2) {
        let start = corner + vec2(MARGIN, 0.5 * MARGIN);
        let mark = Rect::from_min_size(start + vec2(0.0, 3.0), vec2(10.0, 10.0));
        painter.rect_filled(mark, 2.0, self.mark);
        let name = start + vec2(MARK, 0.0);
        let numbers = name + vec2(0.0, self.name.size().y);
        painter.galley(name, self.name, Color32::PLACEHOLDER);
        painter.galley(numbers, self.numbers, Color32::PLACEHOLDER);
    }
}

/// In the middle of a view.
fn say_trouble(painter: &Painter, visuals: &Visuals, room: Rect, trouble: &str) {
    let width = room.width() - 4.0 * MARGIN;
    let font = FontId::proportional(13.5);
    let words = painter.layout(trouble.to_owned(), font, style::WARNING, width);
    let place = Align2::CENTER_CENTER.anchor_size(room.center(), words.size());
    let back = visuals.panel_fill.gamma_multiply(0.86);
    painter.rect_filled(place.expand(MARGIN), 4.0, back);
    painter.galley(place.min, words, style::WARNING);
}
