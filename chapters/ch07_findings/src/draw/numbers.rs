//! Numbers as a chart's axes show them.

/// 10ᵏ, plain where that is short.
pub fn power_of_ten(exponent: i32, plain: bool) -> String {
    match exponent {
        0.. if plain => grouped(&format!(
            "1{}",
            "0".repeat(exponent.unsigned_abs() as usize)
        )),
        ..0 if plain => format!(
            "{:.*}",
            exponent.unsigned_abs() as usize,
            10f64.powi(exponent)
        ),
        _ => format!("10{}", superscript(exponent)),
    }
}

/// `digit` · 10ᵏ, plain where that is short.
pub fn part_of_decade(digit: i32, exponent: i32, plain: bool) -> String {
    if plain {
        power_of_ten(exponent, true).replace('1', &digit.to_string())
    } else {
        format!("{digit}·{}", power_of_ten(exponent, false))
    }
}

/// A multiple of `step`, with as many decimals as tell it from its neighbours.
pub fn multiple(value: f64, step: f64, largest: f64) -> String {
    let sign = if value < 0.0 { "−" } else { "" };
    let size = value.abs();
    if size < 1e-9 * step {
        return "0".to_owned();
    }
    let step_exponent = exponent(step);
    if largest < 1e7 && step_exponent >= -4 {
        let decimals = (-step_exponent).max(0) as usize;
        return sign.to_owned() + &grouped(&format!("{size:.decimals$}"));
    }
    let shared = exponent(largest);
    let decimals = (shared - step_exponent).max(0) as usize;
    let mantissa = size / 10f64.powi(shared);
    format!("{sign}{mantissa:.decimals$}·10{}", superscript(shared))
}

/// ⌊log₁₀ x⌋, safe against rounding at powers of ten.
fn exponent(x: f64) -> i32 {
    (x.log10() + 1e-9).floor() as i32
}

/// Digits in threes: 10,000.
pub fn grouped(number: &str) -> String {
    let (whole, rest) = number.split_at(number.find('.').unwrap_or(number.len()));
    let mut out = String::new();
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out + rest
}

/// k as it stands above 10.
pub fn superscript(k: i32) -> String {
    k.to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            // ⁴ to ⁹ stand in a row after ⁰.
            digit => digit
                .to_digit(10)
                .and_then(|d| char::from_u32(0x2070 + d))
                .unwrap_or(digit),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_plain_or_raised() {
        assert_eq!(power_of_ten(4, true), "10,000");
        assert_eq!(power_of_ten(0, true), "1");
        assert_eq!(power_of_ten(-3, true), "0.001");
        assert_eq!(power_of_ten(-12, false), "10⁻¹²");
        assert_eq!(power_of_ten(15, false), "10¹⁵");
        assert_eq!(part_of_decade(5, -2, true), "0.05");
        assert_eq!(part_of_decade(2, -9, false), "2·10⁻⁹");
    }

    #[test]
    fn multiples_have_the_decimals_of_their_step() {
        assert_eq!(multiple(0.25, 0.05, 1.0), "0.25");
        assert_eq!(multiple(-2.0, 0.5, 3.0), "−2.0");
        assert_eq!(multiple(120_000.0, 20_000.0, 2e5), "120,000");
        assert_eq!(multiple(2.5e-7, 5e-8, 4e-7), "2.5·10⁻⁷");
        assert_eq!(multiple(1e-20, 0.1, 1.0), "0");
    }
}
