//! How the overlay looks: calm, dense enough for a small window, in the picture's theme.

use egui::{Color32, FontFamily, FontId, TextStyle};

use crate::render::Theme;

/// Sets colours, text sizes and spacing.
pub fn apply(context: &egui::Context, theme: Theme) {
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

/// The frame of a panel: nothing is filled, as the picture has the panels' colour there.
pub fn panel(ui: &egui::Ui) -> egui::Frame {
    egui::Frame::side_top_panel(ui.style()).fill(Color32::TRANSPARENT)
}

/// For what needs attention.
pub const WARNING: Color32 = Color32::from_rgb(230, 120, 40);
