//! A table in Markdown that also reads well on a terminal, and numbers as it shows them.

use crate::draw;

/// Cells of text under headings.
pub struct Table {
    headings: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new(headings: &[&str]) -> Self {
        Self {
            headings: headings.iter().map(|&heading| heading.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row, as long as the headings.
    pub fn push(&mut self, row: Vec<String>) {
        debug_assert_eq!(row.len(), self.headings.len());
        self.rows.push(row);
    }

    /// Columns in line, all but the first `left` to the right.
    pub fn markdown(&self, left: usize) -> String {
        let lines = || std::iter::once(&self.headings).chain(&self.rows);
        let widths: Vec<usize> = (0..self.headings.len())
            .map(|k| {
                lines()
                    .map(|row| row[k].chars().count())
                    .max()
                    .unwrap_or(0)
                    .max(2)
            })
            .collect();
        let line = |cells: Vec<String>| format!("|{}|\n", cells.join("|"));
        let padded = |row: &Vec<String>| {
            let cells = row.iter().zip(&widths).enumerate();
            line(
                cells
                    .map(|(k, (cell, &width))| {
                        if k < left {
                            format!(" {cell:<width$} ")
                        } else {
                            format!(" {cell:>width$} ")
                        }
                    })
                    .collect(),
            )
        };
        let rule = widths.iter().enumerate().map(|(k, &width)| {
            let dashes = "-".repeat(width + 1);
            if k < left {
                format!(":{dashes}")
            } else {
                format!("{dashes}:")
            }
        });
        let mut text = padded(&self.headings) + &line(rule.collect());
        text.extend(self.rows.iter().map(padded));
        text
    }
}

/// Three digits, in groups of thousands: 1,230,000 or 0.0123; 10ᵏ where it is very small.
pub fn three_digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "lost".to_owned();
    }
    let exponent = |x: f64| x.abs().log10().floor() as i32;
    // Rounding may carry into the next decade: 9.996 is 10.0.
    let unit = 10f64.powi(exponent(value) - 2);
    let rounded = (value / unit).round() * unit;
    let exponent = exponent(rounded * (1.0 + 1e-12));
    let decimals = (2 - exponent).max(0) as usize;
    if exponent < -4 {
        let power = draw::superscript(exponent);
        return format!("{:.1}·10{power}", rounded / 10f64.powi(exponent)).replace('-', "−");
    }
    draw::grouped(&format!("{rounded:.decimals$}")).replace('-', "−")
}

/// A length in millimetres.
pub fn millimetres(metres: f64) -> String {
    three_digits(1e3 * metres)
}

/// A share of one as percent.
pub fn percent(share: f64) -> String {
    if share.is_finite() {
        format!("{} %", three_digits(100.0 * share))
    } else {
        three_digits(share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_three() {
        for (value, text) in [
            (0.0, "0"),
            (1_234_567.0, "1,230,000"),
            (59.17, "59.2"),
            (9.996, "10.0"),
            (0.012_34, "0.0123"),
            (-2.5, "−2.50"),
            (3.21e-7, "3.2·10⁻⁷"),
            (f64::NAN, "lost"),
        ] {
            assert_eq!(three_digits(value), text);
        }
    }

    #[test]
    fn columns_stand_in_line() {
        let mut table = Table::new(&["N", "ms"]);
        table.push(vec!["10".to_owned(), "0.25".to_owned()]);
        let wanted = "| N  |   ms |\n|:---|-----:|\n| 10 | 0.25 |\n";
        assert_eq!(table.markdown(1), wanted);
    }
}
