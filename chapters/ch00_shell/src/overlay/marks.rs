//! Dots with letters, swatches with words, and notes, painted by the overlay over a picture.

use ch00_scenes::{Key, Rgb};
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Visuals, vec2};

use crate::render::{Theme, byte};

/// A colour of a drawing as the overlay wants it.
pub fn color32(visuals: &Visuals, color: Rgb, opacity: f32) -> Color32 {
    let theme = if visuals.dark_mode {
        Theme::Dark
    } else {
        Theme::Light
    };
    plain_color(theme.standing_out(color), opacity)
}

/// A colour as it is.
pub fn plain_color(color: Rgb, opacity: f32) -> Color32 {
    let [r, g, b] = color.map(byte);
    Color32::from_rgba_unmultiplied(r, g, b, byte(opacity))
}

/// A dot with a rim that stands out from what is behind it, and letters beside it.
pub fn dot(painter: &Painter, visuals: &Visuals, at: Pos2, color: Rgb, text: &str) {
    const RADIUS: f32 = 4.0;
    let paper = visuals.extreme_bg_color;
    painter.circle_filled(at, RADIUS + 1.5, paper.gamma_multiply(0.85));
    painter.circle_filled(at, RADIUS, color32(visuals, color, 1.0));
    if !text.is_empty() {
        let place = at + vec2(7.0, -7.0);
        letters(painter, visuals, place, Align2::LEFT_BOTTOM, text, 13.0);
    }
}

/// Letters with a rim that stands out from what is behind them.
pub fn letters(
    painter: &Painter,
    visuals: &Visuals,
    at: Pos2,
    align: Align2,
    text: &str,
    size: f32,
) {
    let font = FontId::proportional(size);
    let rim = visuals.extreme_bg_color.gamma_multiply(0.8);
    for offset in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
        painter.text(at + offset.into(), align, text, font.clone(), rim);
    }
    painter.text(at, align, text, font, visuals.strong_text_color());
}

/// What colours mean, a line each, in a box whose lower left corner is here.
pub fn key_box(painter: &Painter, visuals: &Visuals, corner: Pos2, key: &[Key]) {
    const LINE: f32 = 16.0;
    const PADDING: f32 = 8.0;
    const SWATCH: f32 = 14.0;
    let ink = visuals.text_color();
    let font = FontId::proportional(11.5);
    let texts: Vec<_> = key
        .iter()
        .map(|entry| painter.layout_no_wrap(entry.text.clone(), font.clone(), ink))
        .collect();
    let widest = texts.iter().map(|text| text.size().x).fold(0.0, f32::max);
    #[expect(clippy::cast_precision_loss, reason = "a few lines")]
    let height = LINE * texts.len() as f32 + 2.0 * PADDING - 2.0;
    let size = vec2(widest + SWATCH + 8.0 + 2.0 * PADDING, height);
    let frame = Rect::from_min_size(corner - vec2(0.0, size.y), size);
    note_box(painter, visuals, frame);
    let mut at = frame.min + vec2(PADDING, PADDING - 1.0);
    for (entry, text) in key.iter().zip(texts) {
        let swatch = Rect::from_min_size(at + vec2(0.0, 5.0), vec2(SWATCH, 5.0));
        painter.rect_filled(swatch, 2.5, color32(visuals, entry.color, 1.0));
        painter.galley(at + vec2(SWATCH + 8.0, 1.0), text, ink);
        at.y += LINE;
    }
}

/// Lines of text in a box beside the pointer, inside `room`.
pub fn note(painter: &Painter, visuals: &Visuals, pointer: Pos2, room: Rect, text: String) {
    let ink = visuals.text_color();
    let lines = painter.layout_no_wrap(text, FontId::monospace(11.5), ink);
    let size = lines.size() + vec2(16.0, 12.0);
    let corner = pointer + vec2(14.0, 14.0);
    let corner = corner.min(room.max - size).max(room.min);
    note_box(painter, visuals, Rect::from_min_size(corner, size));
    painter.galley(corner + vec2(8.0, 6.0), lines, ink);
}

fn note_box(painter: &Painter, visuals: &Visuals, frame: Rect) {
    let stroke = visuals.widgets.noninteractive.bg_stroke;
    let fill = visuals.panel_fill.gamma_multiply(0.92);
    painter.rect(frame, 5.0, fill, stroke, egui::StrokeKind::Inside);
}
