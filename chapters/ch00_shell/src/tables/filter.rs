//! Which rows are let through, by their IDs: `7`, `7-20`, `12.3`, `3, 9, 12-15`.
//!
//! A number alone lets the row through that has it now, whichever generation that is; with a
//! generation, only that one.

use std::num::IntErrorKind;
use std::ops::RangeInclusive;

use ch00_scenes::RowId;
use thiserror::Error;

/// IDs that are let through.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filter {
    /// None for all.
    parts: Vec<Part>,
}

#[derive(Clone, Debug, PartialEq)]
enum Part {
    Slots(RangeInclusive<u32>),
    Row(RowId),
}

/// Why a text is no filter.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum FilterError {
    /// Something that is no ID.
    #[error("`{0}` is no ID: write 7, 7-20 or 12.3, with commas between")]
    NoId(String),
    /// A number that no row can have.
    #[error("`{0}` is larger than any ID")]
    TooLarge(String),
    /// A range whose end comes before its start.
    #[error("`{from}-{to}` runs backwards: write {to}-{from}")]
    Backwards {
        /// Its first number.
        from: u32,
        /// Its second number.
        to: u32,
    },
}

impl Filter {
    /// Reads a filter. Nothing between commas is nothing, so that a list can be typed.
    ///
    /// # Errors
    /// [`FilterError`] that names the part which is no ID.
    pub fn parse(text: &str) -> Result<Self, FilterError> {
        let parts = text
            .split(',')
            .map(str::trim)
            .filter(|part| !part.is_empty());
        let parts = parts.map(part).collect::<Result<_, _>>()?;
        Ok(Self { parts })
    }

    /// Whether it lets all rows through.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Whether it lets this row through.
    #[must_use]
    pub fn lets_through(&self, id: RowId) -> bool {
        let fits = |part: &Part| match part {
            Part::Slots(slots) => slots.contains(&id.slot),
            Part::Row(row) => *row == id,
        };
        self.is_empty() || self.parts.iter().any(fits)
    }
}

fn part(text: &str) -> Result<Part, FilterError> {
    if let Some((slot, generation)) = text.split_once('.') {
        return Ok(Part::Row(RowId {
            slot: number(slot, text)?,
            generation: number(generation, text)?,
        }));
    }
    let Some((from, to)) = text.split_once(['-', '–']) else {
        let slot = number(text, text)?;
        return Ok(Part::Slots(slot..=slot));
    };
    let (from, to) = (number(from, text)?, number(to, text)?);
    if from > to {
        return Err(FilterError::Backwards { from, to });
    }
    Ok(Part::Slots(from..=to))
}

/// A number in a part; `part` is what an error names.
fn number(text: &str, part: &str) -> Result<u32, FilterError> {
    let text = text.trim();
    // `+7` would be a number to the standard library.
    if !text.starts_with(|first: char| first.is_ascii_digit()) {
        return Err(FilterError::NoId(part.to_owned()));
    }
    text.parse::<u32>().map_err(|error| match error.kind() {
        IntErrorKind::PosOverflow => FilterError::TooLarge(text.to_owned()),
        _ => FilterError::NoId(part.to_owned()),
    })
}

/// A filter as it is typed: while the text is wrong, the last good filter goes on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilterField {
    /// What was typed.
    pub text: String,
    good: Filter,
    error: Option<FilterError>,
}

impl FilterField {
    /// Reads the text again after it has changed.
    pub fn read(&mut self) {
        match Filter::parse(&self.text) {
            Ok(filter) => {
                self.good = filter;
                self.error = None;
            }
            Err(error) => self.error = Some(error),
        }
    }

    /// The last good filter.
    #[must_use]
    pub fn filter(&self) -> &Filter {
        &self.good
    }

    /// What is wrong with the text.
    #[must_use]
    pub fn error(&self) -> Option<&FilterError> {
        self.error.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn let_through(text: &str) -> Vec<String> {
        let filter = Filter::parse(text).expect("a filter");
        let ids = (0..30).flat_map(|slot| [0, 3].map(|generation| RowId { slot, generation }));
        ids.filter(|&id| filter.lets_through(id))
            .map(|id| id.to_string())
            .collect()
    }

    #[test]
    fn a_number_a_range_and_a_list_let_their_rows_through() {
        assert_eq!(let_through("7"), ["7", "7.3"]);
        assert_eq!(
            let_through("27-40"),
            ["27", "27.3", "28", "28.3", "29", "29.3"]
        );
        assert_eq!(
            let_through("3, 9, 12-12"),
            ["3", "3.3", "9", "9.3", "12", "12.3"]
        );
        assert_eq!(let_through(" 12 – 12 "), ["12", "12.3"]);
    }

    #[test]
    fn a_number_with_a_generation_lets_only_that_row_through() {
        assert_eq!(let_through("12.3"), ["12.3"]);
        assert_eq!(let_through("12.0"), ["12"]);
        assert!(let_through("12.4").is_empty());
    }

    #[test]
    fn an_empty_text_lets_all_through_and_so_does_a_lone_comma() {
        assert_eq!((let_through("").len(), let_through(" , ").len()), (60, 60));
        assert_eq!(let_through("7,"), ["7", "7.3"]);
    }

    #[test]
    fn what_is_no_filter_is_said() {
        let error = |text| Filter::parse(text).expect_err("no filter");
        for text in [
            "x", "-7", "7-", "7..9", "7.", ".3", "+7", "7 8", "1-2-3", "²",
        ] {
            assert_eq!(error(text), FilterError::NoId(text.to_owned()), "{text}");
        }
        assert_eq!(error("7, x"), FilterError::NoId("x".to_owned()));
        assert_eq!(error("20-7"), FilterError::Backwards { from: 20, to: 7 });
        assert_eq!(
            error("5000000000"),
            FilterError::TooLarge("5000000000".to_owned())
        );
        assert_eq!(
            error("20-7").to_string(),
            "`20-7` runs backwards: write 7-20"
        );
    }

    #[test]
    fn while_the_text_is_wrong_the_last_good_filter_goes_on() {
        let mut field = FilterField::default();
        let mut typed = |text: &str| {
            text.clone_into(&mut field.text);
            field.read();
            let lets = |slot| field.filter().lets_through(RowId::first(slot));
            (lets(7), lets(8), field.error().is_some())
        };
        assert_eq!(typed("7"), (true, false, false));
        assert_eq!(typed("7-"), (true, false, true));
        assert_eq!(typed("7-8"), (true, true, false));
    }
}
