//! A chart as CSV (RFC 4180): a line a point, with all digits, so that reading it gives the
//! same numbers. Numbers that are not finite stand as `NaN`, `inf` and `-inf`.

use std::fmt::Write as _;

use crate::chart::Chart;

/// `series,x label,y label`, then the points in order.
#[must_use]
pub fn csv(chart: &Chart) -> String {
    let (x, y) = (quoted(&chart.x.label), quoted(&chart.y.label));
    let mut text = format!("series,{x},{y}\n");
    for series in &chart.series {
        let name = quoted(&series.name);
        for (x, y) in &series.points {
            // Writing into a String can't fail.
            let _ = writeln!(text, "{name},{x:?},{y:?}");
        }
    }
    text
}

/// A field, in quotes where it needs them.
#[must_use]
pub fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn only_what_needs_quotes_has_them() {
        assert_eq!(quoted("time (s)"), "time (s)");
        assert_eq!(quoted("a, \"b\""), "\"a, \"\"b\"\"\"");
    }
}
