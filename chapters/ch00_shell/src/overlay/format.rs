//! Numbers as the overlay shows them, and tables of two columns to show them in.

use std::time::Duration;

use crate::Session;

/// A time in milliseconds, or in microseconds where it is short.
pub fn time(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds < 1e-5 {
        format!("{:.1} µs", 1e6 * seconds)
    } else if seconds < 1e-3 {
        format!("{:.0} µs", 1e6 * seconds)
    } else if seconds < 0.1 {
        format!("{:.2} ms", 1e3 * seconds)
    } else {
        format!("{:.0} ms", 1e3 * seconds)
    }
}

/// A length in metres, or in millimetres or micrometres where it is short.
pub fn length(metres: f64) -> String {
    let size = metres.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if size < 1e-3 {
        format!("{:.1} µm", 1e6 * metres)
    } else if size < 0.1 {
        format!("{:.2} mm", 1e3 * metres)
    } else {
        format!("{metres:.3} m")
    }
}

/// A number that may not be there yet.
pub fn or_dash<T>(value: Option<T>, show: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "–".to_owned(), show)
}

/// When the numbers that are shown were true, where that isn't always now: `3 frames ago`.
pub fn as_of(session: &Session) -> Option<String> {
    session.is_late().then(|| match session.frames_late() {
        0 => "now".to_owned(),
        1 => "1 frame ago".to_owned(),
        frames => format!("{frames} frames ago"),
    })
}

/// `every 3rd step`.
pub fn every_step(every: u64) -> String {
    let end = match (every % 100, every % 10) {
        (11..=13, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    format!("every {every}{end} step")
}

/// Rows of a name and its value.
pub fn rows(ui: &mut egui::Ui, id: &str, add: impl FnOnce(&mut egui::Ui)) {
    egui::Grid::new(id)
        .num_columns(2)
        .spacing([12.0, 2.0])
        .min_col_width(112.0)
        .show(ui, add);
}

/// One of these rows.
pub fn row(ui: &mut egui::Ui, name: &str, value: impl Into<String>) -> egui::Response {
    ui.weak(name);
    let response = ui.monospace(value.into());
    ui.end_row();
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_keep_three_digits_or_so() {
        assert_eq!(length(0.0), "0");
        assert_eq!(length(0.00001), "10.0 µm");
        assert_eq!(length(-0.0123), "-12.30 mm");
        assert_eq!(length(1.5), "1.500 m");
    }

    #[test]
    fn steps_are_counted_as_they_are_said() {
        let said = [2, 3, 10, 11, 13, 21, 112].map(every_step);
        let ends = said.map(|text| text[6..].to_owned());
        let expected = ["2nd", "3rd", "10th", "11th", "13th", "21st", "112th"];
        assert_eq!(ends, expected.map(|end| format!("{end} step")));
    }

    #[test]
    fn times_have_three_digits_or_so() {
        assert_eq!(time(Duration::from_nanos(740)), "0.7 µs");
        assert_eq!(time(Duration::from_micros(70)), "70 µs");
        assert_eq!(time(Duration::from_micros(16_667)), "16.67 ms");
        assert_eq!(time(Duration::from_millis(250)), "250 ms");
    }
}
