//! What the tables of measured styles have in common: large numbers, and where the times were taken.

/// What the times are, and where they were taken.
#[must_use]
pub fn taken_on(runs: usize) -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let machine = processor().unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    format!("Median (fastest–slowest) of {runs} runs, one core of {cores}: {machine}.")
}

/// The processor's name where Linux tells it.
#[must_use]
pub fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// 1234567 as 1,234,567.
#[must_use]
pub fn thousands(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_stands_after_every_three_digits_from_the_right() {
        assert_eq!(
            [7, 123, 1234, 1_234_567].map(thousands),
            ["7", "123", "1,234", "1,234,567"]
        );
    }
}
