//! The panel at the right: the narrow phase of one pair of bodies, iteration by iteration. Above,
//! the set of differences a − b with what the iteration has found in it; below, how the answer
//! closes in, and the iteration in words.

mod canvas;
mod choice;
mod progress;

pub use choice::Choice;

use ch00_scenes::{Dissection, Shape, palette};

use super::marks::color32;
use super::style;
use crate::Session;
use crate::camera::Camera;
use crate::show::Pair;

/// Width at the start, points.
const WIDTH: f32 = 410.0;

/// What the panel needs besides the canvas and the buttons, points.
const REST: f32 = 222.0;

/// What the buttons need, points.
const BUTTONS: f32 = 26.0;

/// Shows it; whether it shall stay. A still picture has no buttons.
pub fn show(
    ui: &mut egui::Ui,
    session: &Session,
    pair: &mut Pair,
    dissection: Option<&Dissection>,
    camera: &Camera,
    is_still: bool,
) -> bool {
    let mut stays = true;
    egui::Panel::right("narrow phase")
        .default_size(WIDTH)
        .size_range(300.0..=640.0)
        .frame(style::panel(ui))
        .show(ui, |ui| {
            stays = head(ui, dissection, is_still);
            bodies(ui, session, pair);
            match dissection {
                Some(dissection) => contents(ui, pair, dissection, camera, is_still),
                None => {
                    ui.weak("This engine has no narrow phase to look into.");
                }
            }
        });
    stays
}

/// The headline, and the button that closes the panel.
fn head(ui: &mut egui::Ui, dissection: Option<&Dissection>, is_still: bool) -> bool {
    let title = dissection.map_or("Narrow phase", |dissection| dissection.title.as_str());
    let mut stays = true;
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.heading(title);
        let right = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(right, |ui| {
            if !is_still && ui.small_button("close").on_hover_text("G").clicked() {
                stays = false;
            }
        });
    });
    stays
}

/// Which two bodies, in their colours.
fn bodies(ui: &mut egui::Ui, session: &Session, pair: &mut Pair) {
    ui.horizontal(|ui| {
        for (name, i, color) in [
            ("a", pair.bodies[0], palette::ORANGE),
            ("b", pair.bodies[1], palette::SKY),
        ] {
            let (dot, _) = ui.allocate_exact_size(egui::vec2(10.0, 10.0), egui::Sense::hover());
            ui.painter()
                .circle_filled(dot.center(), 5.0, color32(ui.visuals(), color, 1.0));
            let shape = shape_name(&session.scene().bodies[i].shape);
            ui.label(format!("{name}: body {i}, {shape}"));
            ui.add_space(8.0);
        }
    });
}

fn shape_name(shape: &Shape) -> &'static str {
    match shape {
        Shape::Sphere { .. } => "a ball",
        Shape::Box { .. } => "a box",
        Shape::Capsule { .. } => "a capsule",
        Shape::Cylinder { .. } => "a cylinder",
    }
}

fn contents(
    ui: &mut egui::Ui,
    pair: &mut Pair,
    dissection: &Dissection,
    camera: &Camera,
    is_still: bool,
) {
    let rest = REST + if is_still { 0.0 } else { BUTTONS };
    let height = (ui.available_height() - rest).max(160.0);
    canvas::show(ui, height, pair, dissection, camera);
    ui.add_space(2.0);
    key(ui, dissection);
    ui.add_space(2.0);
    progress::show(ui, pair, dissection);
    if !is_still {
        buttons(ui, pair, dissection);
    }
    ui.label(&dissection.text);
}

/// What the canvas's colours mean, as many in a line as fit.
fn key(ui: &mut egui::Ui, dissection: &Dissection) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(4.0, 2.0);
        for entry in &dissection.difference.key {
            let font = egui::TextStyle::Small.resolve(ui.style());
            let ink = ui.visuals().text_color();
            let text = ui.painter().layout_no_wrap(entry.text.clone(), font, ink);
            let size = text.size() + egui::vec2(28.0, 0.0);
            let (place, _) = ui.allocate_exact_size(size, egui::Sense::hover());
            let middle = place.left_center() + egui::vec2(6.0, 0.0);
            let swatch = egui::Rect::from_center_size(middle, egui::vec2(12.0, 5.0));
            ui.painter()
                .rect_filled(swatch, 2.5, color32(ui.visuals(), entry.color, 1.0));
            ui.painter()
                .galley(place.min + egui::vec2(17.0, 0.0), text, ink);
        }
    });
}

fn buttons(ui: &mut egui::Ui, pair: &mut Pair, dissection: &Dissection) {
    ui.horizontal(|ui| {
        for (by, tip) in [
            (isize::MIN, "first iteration: Home"),
            (-1, "back: Left"),
            (1, "on: Right"),
            (isize::MAX, "last iteration: End"),
        ] {
            let button = egui::Button::new("").min_size(egui::vec2(26.0, 18.0));
            let response = ui.add(button).on_hover_text(tip);
            paint_sign(ui, response.rect.center(), by);
            if response.clicked() {
                pair.move_step(by, dissection);
            }
        }
        let mut step = dissection.step;
        let last = dissection.steps().saturating_sub(1);
        let slider = egui::Slider::new(&mut step, 0..=last).show_value(false);
        if ui.add(slider).changed() {
            pair.step = (step < last).then_some(step);
        }
        ui.weak(format!("{} / {}", dissection.step + 1, last + 1));
    });
}

/// A triangle that points on or back, with a bar at its tip where it goes to the end.
fn paint_sign(ui: &egui::Ui, middle: egui::Pos2, by: isize) {
    const HALF: f32 = 4.5;
    let ink = ui.visuals().text_color();
    #[expect(clippy::cast_precision_loss, reason = "1 or -1")]
    let along = egui::vec2(HALF * by.signum() as f32, 0.0);
    let across = egui::vec2(0.0, HALF);
    let triangle = vec![
        middle + along,
        middle - along + across,
        middle - along - across,
    ];
    let painter = ui.painter();
    painter.add(egui::Shape::convex_polygon(
        triangle,
        ink,
        egui::Stroke::NONE,
    ));
    if by.unsigned_abs() > 1 {
        let tip = middle + 1.2 * along;
        painter.line_segment([tip - across, tip + across], egui::Stroke::new(1.8, ink));
    }
}
