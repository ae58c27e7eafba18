//! How the overlay looks: calm, dense enough for a small window, in the picture's theme.

use egui::{Color32, FontDefinitions, FontFamily, FontId, TextStyle};

use crate::render::Theme;

/// Sets colours, letters, text sizes and spacing.
pub fn apply(context: &egui::Context, theme: Theme) {
    context.set_fonts(fonts());
    context.set_theme(match theme {
        Theme::Light => egui::Theme::Light,
        Theme::Dark => egui::Theme::Dark,
    });
    context.all_styles_mut(|style| {
        let font = |size, family| FontId::new(size, family);
        style.text_styles = [
            (TextStyle::Heading, font(16.0, FontFamily::Proportional)),
            (TextStyle::Body, font(12.5, FontFamily::Proportional)),
            (TextStyle::Button, font(12.5, FontFamily::Proportional)),
            (TextStyle::Small, font(10.5, FontFamily::Proportional)),
            (TextStyle::Monospace, font(11.5, FontFamily::Monospace)),
        ]
        .into();
        style.spacing.item_spacing = egui::vec2(6.0, 4.0);
        style.spacing.interact_size.y = 16.0;
        style.spacing.combo_width = 150.0;
        style.animation_time = 0.1;
    });
    context.style_mut_of(egui::Theme::Dark, |style| {
        style.visuals.panel_fill = Color32::from_rgb(24, 29, 38);
        style.visuals.extreme_bg_color = Color32::from_rgb(14, 18, 25);
        style.visuals.override_text_color = Some(Color32::from_gray(215));
        style.visuals.weak_text_color = Some(Color32::from_gray(150));
    });
    context.style_mut_of(egui::Theme::Light, |style| {
        style.visuals.panel_fill = Color32::from_rgb(247, 248, 249);
        style.visuals.override_text_color = Some(Color32::from_gray(45));
        style.visuals.weak_text_color = Some(Color32::from_gray(95));
    });
}

/// egui's own letters; where the proportional ones lack a symbol, the monospaced ones' is taken.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let monospaced = fonts.families.get(&FontFamily::Monospace).cloned();
    let proportional = fonts.families.entry(FontFamily::Proportional).or_default();
    proportional.extend(monospaced.unwrap_or_default());
    fonts
}

/// The frame of a panel: nothing is filled, as the picture has the panels' colour there.
pub fn panel(ui: &egui::Ui) -> egui::Frame {
    egui::Frame::side_top_panel(ui.style()).fill(Color32::TRANSPARENT)
}

/// For what needs attention.
pub const WARNING: Color32 = Color32::from_rgb(230, 120, 40);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_symbol_of_a_formula_and_of_a_header_can_be_drawn() {
        let context = egui::Context::default();
        apply(&context, Theme::Dark);
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            let font = FontId::proportional(12.0);
            let missing = |symbol: &char| {
                let has =
                    |fonts: &mut egui::epaint::text::FontsView| fonts.has_glyph(&font, *symbol);
                !ui.ctx().fonts_mut(has)
            };
            let missing: String = "▲▼…–*ωτλμεθΔΣ²³⁻¹·×√₀₁₂≤".chars().filter(missing).collect();
            assert_eq!(missing, "");
        });
        output.textures_delta.clear(); // nothing is painted
    }
}
