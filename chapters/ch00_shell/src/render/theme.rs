//! Colours: of sky, ground and grid, light and dark, and of the bodies.

use ch00_scenes::Rgb;
use glam::Vec3;

/// A look of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// A bright room.
    #[default]
    Light,
    /// Dusk.
    Dark,
}

/// The colours of a theme. Those that end in `_display` are sRGB, the others linear light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colors {
    /// At the top of the background.
    pub sky_top_display: Vec3,
    /// At the bottom of the background.
    pub sky_low_display: Vec3,
    /// What the sun adds on a surface that faces it.
    pub sun_light: Vec3,
    /// What a surface that faces up receives from the sky.
    pub sky_light: Vec3,
    /// What a surface that faces down receives from the ground.
    pub ground_light: Vec3,
    /// Colour of ground and floor.
    pub ground: Vec3,
    /// Colour of the grid on them.
    pub grid: Vec3,
    /// Opacity of the grid.
    pub grid_strength: f32,
    /// Edges of walls.
    pub edge_display: [u8; 4],
}

impl Theme {
    /// Its colours.
    #[must_use]
    pub fn colors(self) -> Colors {
        match self {
            Theme::Light => Colors {
                sky_top_display: display(0xC3_D3_E4),
                sky_low_display: display(0xF1_F3_F4),
                sun_light: Vec3::new(1.05, 1.0, 0.9) * 0.72,
                sky_light: Vec3::new(0.47, 0.52, 0.6),
                ground_light: Vec3::new(0.25, 0.23, 0.21),
                ground: linear(0xE4_E6_E8),
                grid: linear(0x7C_88_96),
                grid_strength: 0.5,
                edge_display: [90, 104, 122, 150],
            },
            Theme::Dark => Colors {
                sky_top_display: display(0x16_1D_29),
                sky_low_display: display(0x3B_4A_5E),
                sun_light: Vec3::new(1.1, 1.0, 0.86) * 0.78,
                sky_light: Vec3::new(0.24, 0.29, 0.38),
                ground_light: Vec3::new(0.10, 0.10, 0.12),
                ground: linear(0x6B_78_88),
                grid: linear(0xB4_C2_D2),
                grid_strength: 0.35,
                edge_display: [170, 190, 214, 110],
            },
        }
    }
}

impl Theme {
    /// A colour of a drawing so that it stands out from this theme's background.
    #[must_use]
    pub fn standing_out(self, color: Rgb) -> Rgb {
        match self {
            Theme::Light => color.map(|part| 0.92 * part),
            Theme::Dark => color.map(|part| part + 0.3 * (1.0 - part)),
        }
    }
}

/// Okabe and Ito's palette, which people of all kinds of colour vision tell apart, without
/// its black and in an order that puts unlike hues side by side.
const PALETTE: [u32; 7] = [
    0xE6_9F_00, // orange
    0x00_72_B2, // blue
    0x00_9E_73, // bluish green
    0xCC_79_A7, // reddish purple
    0x56_B4_E9, // sky blue
    0xD5_5E_00, // vermillion
    0xF0_E4_42, // yellow
];

/// Linear colour of body `i`.
#[must_use]
pub fn body_color(i: usize) -> Vec3 {
    linear(PALETTE[i % PALETTE.len()])
}

/// Linear colour of the first (0) or second (1) body of a pair that is looked at.
#[must_use]
pub fn pair_color(place: usize) -> Vec3 {
    linear([PALETTE[0], PALETTE[4]][place])
}

/// sRGB parts, 0 … 1, of a colour 0xRRGGBB.
fn display(rgb: u32) -> Vec3 {
    let [_, r, g, b] = rgb.to_be_bytes();
    Vec3::new(f32::from(r), f32::from(g), f32::from(b)) / 255.0
}

/// Linear light of an sRGB colour 0xRRGGBB. IEC 61966-2-1.
fn linear(rgb: u32) -> Vec3 {
    display(rgb).map(|c| {
        if c <= 0.040_45 {
            c / 12.92
        } else {
            ((c + 0.055) / 1.055).powf(2.4)
        }
    })
}
