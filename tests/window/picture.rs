//! A picture of the screen, and questions about what is in a part of it.

use std::collections::HashMap;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Red, green, blue.
type Pixel = [u8; 3];

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug)]
pub struct Area {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

impl Area {
    /// From its upper left corner and its size.
    pub const fn new(x: u32, y: u32, width: u32, height: u32) -> Self {
        Self {
            x,
            y,
            width,
            height,
        }
    }
}

/// Pixels, row by row from the top.
pub struct Picture {
    width: u32,
    height: u32,
    pixels: Vec<Pixel>,
}

impl Picture {
    /// Reads a PNG.
    pub fn load(file: &Path) -> Self {
        let shown = file.display();
        let reader = BufReader::new(File::open(file).unwrap_or_else(|e| panic!("{shown}: {e}")));
        let mut decoder = png::Decoder::new(reader);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder
            .read_info()
            .unwrap_or_else(|e| panic!("{shown}: {e}"));
        let size = reader
            .output_buffer_size()
            .expect("a screen fits in memory");
        let mut bytes = vec![0; size];
        let info = reader
            .next_frame(&mut bytes)
            .unwrap_or_else(|e| panic!("{shown}: {e}"));
        let samples = info.color_type.samples();
        let pixels = bytes[..info.buffer_size()]
            .chunks_exact(samples)
            .map(|p| {
                if samples < 3 {
                    [p[0]; 3]
                } else {
                    [p[0], p[1], p[2]]
                }
            })
            .collect();
        Self {
            width: info.width,
            height: info.height,
            pixels,
        }
    }

    /// Mean of all parts of all pixels, 0 … 255.
    pub fn brightness(&self) -> f64 {
        self.brightness_of(Area::new(0, 0, self.width, self.height))
    }

    /// Mean of all parts of an area's pixels, 0 … 255.
    pub fn brightness_of(&self, area: Area) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for part in self.of(area).flatten() {
            sum += f64::from(part);
            count += 1.0;
        }
        sum / count
    }

    /// How many colours there are.
    pub fn colors(&self, area: Area) -> usize {
        self.histogram(area).len()
    }

    /// The share of the area that has its commonest colour, 0 … 1.
    pub fn share_of_commonest(&self, area: Area) -> f64 {
        let most = self.histogram(area).into_values().max().unwrap_or(0);
        f64::from(most) / f64::from(area.width * area.height)
    }

    /// How many of twelve parts of the colour wheel fill at least 100 pixels, counting strong
    /// colours only.
    pub fn hues(&self, area: Area) -> usize {
        let mut counts = [0; 12];
        for pixel in self.of(area) {
            if let Some(hue) = strong_hue(pixel) {
                counts[hue] += 1;
            }
        }
        counts.iter().filter(|&&count| count >= 100).count()
    }

    /// How many pixels of the area differ visibly.
    pub fn differences(&self, other: &Self, area: Area) -> usize {
        let differs = |(a, b): &(Pixel, Pixel)| (0..3).any(|i| a[i].abs_diff(b[i]) > 8);
        self.of(area).zip(other.of(area)).filter(differs).count()
    }

    fn histogram(&self, area: Area) -> HashMap<Pixel, u32> {
        let mut counts = HashMap::new();
        for pixel in self.of(area) {
            *counts.entry(pixel).or_default() += 1;
        }
        counts
    }

    fn of(&self, area: Area) -> impl Iterator<Item = Pixel> + '_ {
        assert!(area.x + area.width <= self.width && area.y + area.height <= self.height);
        (area.y..area.y + area.height).flat_map(move |y| {
            let start = (y * self.width + area.x) as usize;
            self.pixels[start..start + area.width as usize]
                .iter()
                .copied()
        })
    }
}

/// Which twelfth of the colour wheel a pixel is in; none if it is nearly grey.
fn strong_hue([r, g, b]: Pixel) -> Option<usize> {
    let [r, g, b] = [r, g, b].map(i32::from);
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let spread = most - least;
    if spread < 90 {
        return None;
    }
    let sixty_degrees = if most == r {
        60 * (g - b) / spread
    } else if most == g {
        120 + 60 * (b - r) / spread
    } else {
        240 + 60 * (r - g) / spread
    };
    usize::try_from(sixty_degrees.rem_euclid(360) / 30).ok()
}
