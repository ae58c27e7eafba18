//! How the answer closes in: a column for each iteration, from the lower to the upper bound of
//! the distance. Clicking or dragging goes to an iteration.

use ch00_scenes::{Dissection, palette};
use egui::epaint::Mesh;
use egui::{FontId, Pos2, Rect, Sense, Shape, Stroke, pos2, vec2};

use crate::overlay::format::length;
use crate::overlay::marks::color32;
use crate::show::Pair;

const HEIGHT: f32 = 92.0;

/// Room for the names of the phases.
const NAMES: f32 = 15.0;

/// Shows it.
pub fn show(ui: &mut egui::Ui, pair: &mut Pair, dissection: &Dissection) {
    let size = vec2(ui.available_width(), HEIGHT);
    let (whole, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let steps = dissection.steps();
    if steps == 0 {
        return;
    }
    let chart = Chart::new(whole, dissection);
    if let Some(pointer) = response.interact_pointer_pos() {
        let step = chart.step_at(pointer);
        pair.step = (step + 1 < steps).then_some(step);
    }
    let painter = ui.painter_at(whole);
    let visuals = ui.visuals();
    painter.rect_filled(whole, 4.0, visuals.extreme_bg_color);
    chart.paint(&painter, visuals, dissection);
    if let Some(&bounds) = dissection.bounds.get(dissection.step) {
        caption(ui, bounds);
    }
}

/// The two bounds of the iteration that is looked at.
fn caption(ui: &mut egui::Ui, bounds: [f32; 2]) {
    let [low, high] = bounds.map(|bound| length(f64::from(bound)));
    let text = if low == high {
        format!("distance {high}")
    } else {
        format!("distance between {low} and {high}")
    };
    ui.small(text).on_hover_text(
        "negative where the two overlap; heights in the chart show the root, dashes are at 0",
    );
}

/// The root with the sign: heights show it, so that what is left at the end can be seen beside
/// what was unknown at the start.
fn root(distance: f32) -> f32 {
    distance.abs().sqrt().copysign(distance)
}

/// Where everything is.
struct Chart {
    room: Rect,
    column: f32,
    /// Of distances, m.
    low: f32,
    high: f32,
}

impl Chart {
    fn new(whole: Rect, dissection: &Dissection) -> Self {
        let room = Rect::from_min_max(
            whole.min + vec2(4.0, NAMES + 4.0),
            whole.max - vec2(4.0, 6.0),
        );
        let bounds = || dissection.bounds.iter().flatten().filter(|b| b.is_finite());
        let low = bounds().copied().fold(0.0, f32::min);
        let high = bounds().copied().fold(0.0, f32::max);
        #[expect(clippy::cast_precision_loss, reason = "a few dozen iterations")]
        let column = room.width() / dissection.steps() as f32;
        Self {
            room,
            column,
            low,
            high: high.max(low + 1e-6),
        }
    }

    /// The left edge of a column.
    #[expect(clippy::cast_precision_loss, reason = "a few dozen iterations")]
    fn x(&self, step: usize) -> f32 {
        self.room.min.x + self.column * step as f32
    }

    fn y(&self, distance: f32) -> f32 {
        let [low, high, here] = [self.low, self.high, distance].map(root);
        let place = (here - low) / (high - low);
        self.room.max.y - place.clamp(0.0, 1.0) * self.room.height()
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few dozen iterations"
    )]
    fn step_at(&self, pointer: Pos2) -> usize {
        ((pointer.x - self.room.min.x) / self.column).max(0.0) as usize
    }

    fn paint(&self, painter: &egui::Painter, visuals: &egui::Visuals, dissection: &Dissection) {
        let weak = visuals.weak_text_color();
        let now = dissection.step;
        let column = Rect::from_x_y_ranges(self.x(now)..=self.x(now + 1), self.room.y_range());
        let highlight = visuals.selection.bg_fill.gamma_multiply(0.35);
        painter.rect_filled(column.expand2(vec2(0.0, 4.0)), 3.0, highlight);
        self.paint_phases(painter, dissection, weak);
        let zero = self.y(0.0);
        let ends = [pos2(self.room.min.x, zero), pos2(self.room.max.x, zero)];
        painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, weak), 3.0, 3.0));
        for (step, &bounds) in dissection.bounds.iter().enumerate() {
            self.paint_column(painter, visuals, step, bounds, step == now);
        }
    }

    /// Names, and lines between the phases.
    fn paint_phases(&self, painter: &egui::Painter, dissection: &Dissection, weak: egui::Color32) {
        let mut first = 0;
        for phase in &dissection.phases {
            let end = first + phase.steps;
            let middle = f32::midpoint(self.x(first), self.x(end));
            let font = FontId::proportional(11.0);
            let name = painter.layout_no_wrap(phase.name.to_owned(), font, weak);
            let size = name.size();
            let left = (middle - 0.5 * size.x)
                .min(self.room.max.x - size.x)
                .max(self.room.min.x);
            painter.galley(pos2(left, self.room.min.y - 2.0 - size.y), name, weak);
            if first > 0 {
                let range = self.room.y_range().expand(3.0);
                painter.vline(self.x(first), range, Stroke::new(1.0, weak));
            }
            first = end;
        }
    }

    /// Between the two bounds, with a bolder line at each.
    fn paint_column(
        &self,
        painter: &egui::Painter,
        visuals: &egui::Visuals,
        step: usize,
        bounds: [f32; 2],
        is_now: bool,
    ) {
        let gap = (0.12 * self.column).min(3.0);
        let (left, right) = (self.x(step) + gap, self.x(step + 1) - gap);
        let [low, high] = bounds.map(|bound| self.y(bound));
        let strength = if is_now { 1.0 } else { 0.55 };
        let mut band = Mesh::default();
        let area = Rect::from_min_max(pos2(left, high), pos2(right, low));
        band.add_colored_rect(area, color32(visuals, palette::BLUE, 0.25 * strength));
        painter.add(Shape::mesh(band));
        for (y, color) in [(low, palette::BLUE), (high, palette::VERMILLION)] {
            painter.hline(
                left..=right,
                y,
                Stroke::new(2.0, color32(visuals, color, strength)),
            );
        }
    }
}
