//! Letters: their sizes and colours, and how wide a line of them is. The font is whatever
//! sans-serif the reader's system has, so widths are estimates, on the generous side.

use plotters::style::text_anchor::HPos;

use super::canvas::{Ink, Lettering};

/// Grey that reads on white (4.5 : 1) and on near-black (3.8 : 1).
pub const GREY: Ink = Ink::full((0x76, 0x76, 0x76));

/// Height of the title, pixels.
pub const TITLE: f64 = 16.0;
/// How much wider bold letters are.
pub const BOLD: f64 = 1.12;
/// Height of the names of axes and curves, pixels.
pub const LABEL: f64 = 13.5;
/// Height of the numbers at the axes, pixels.
pub const NUMBER: f64 = 12.5;

/// Letters of the title, from its left end.
pub fn title() -> Lettering {
    Lettering {
        bold: true,
        ..label(HPos::Left)
    }
    .sized(TITLE)
}

/// Letters of an axis or a curve.
pub fn label(anchor: HPos) -> Lettering {
    Lettering {
        size: LABEL,
        bold: false,
        anchor,
        upwards: false,
        ink: GREY,
    }
}

/// Letters of a number.
pub fn number(anchor: HPos) -> Lettering {
    label(anchor).sized(NUMBER)
}

impl Lettering {
    fn sized(self, size: f64) -> Self {
        Self { size, ..self }
    }
}

/// About how wide a line is in a wide sans-serif, pixels.
pub fn width(text: &str, size: f64) -> f64 {
    text.chars().map(em).sum::<f64>() * size
}

/// Width of a character over the height of the font.
fn em(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '\'' | ' ' => 0.33,
        'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '/' | '⁻' => 0.4,
        '⁰'..='⁹' | '¹' | '²' | '³' => 0.42,
        'm' | 'w' | 'M' | 'W' | '%' | 'Σ' | '√' => 0.9,
        'A'..='Z' | '−' | '+' | '=' | '<' | '>' | '×' => 0.74,
        _ => 0.62,
    }
}

/// The text in lines of at most so many pixels, broken between words.
pub fn wrapped(text: &str, size: f64, most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(word, size) + size * em(' ') <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_title_is_broken_between_words() {
        let lines = wrapped("one two three four five", 10.0, 60.0);
        assert!(lines.len() > 1);
        assert_eq!(lines.join(" "), "one two three four five");
        assert!(lines.iter().all(|line| width(line, 10.0) <= 60.0));
    }

    #[test]
    fn a_word_longer_than_a_line_stays_whole() {
        assert_eq!(wrapped("incomprehensibilities", 10.0, 5.0).len(), 1);
    }
}
