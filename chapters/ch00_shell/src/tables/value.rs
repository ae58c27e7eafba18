//! Cells as text: as the table shows them, and as they are typed.

use ch00_scenes::{Cell, ColumnInfo, Kind, TableError};

/// A cell as the table shows it: every number nine wide, so that columns align.
#[must_use]
pub fn shown(cell: &Cell) -> String {
    if let Cell::Index(value) = cell {
        return value.to_string();
    }
    let texts: Vec<String> = cell.numbers().iter().map(|&x| number(x)).collect();
    texts.join(" ")
}

/// Four decimals, or an exponent where these would hide the number or be too wide.
fn number(x: f32) -> String {
    let size = x.abs();
    if size.is_finite() && size != 0.0 && !(5e-4..1e4).contains(&size) {
        format!("{x:9.2e}")
    } else {
        format!("{x:9.4}")
    }
}

/// A cell's numbers as they are typed: with all digits, so that a number that isn't changed stays
/// the same to the bit.
#[must_use]
pub fn typed(cell: &Cell) -> Vec<String> {
    match cell {
        Cell::Index(value) => vec![value.to_string()],
        _ => cell.numbers().iter().map(|x| format!("{x:?}")).collect(),
    }
}

/// The cell that was typed into a column.
///
/// # Errors
/// [`TableError::BadValue`] that names what is no number.
pub fn parsed(table: &str, column: &ColumnInfo, texts: &[String]) -> Result<Cell, TableError> {
    cell_of(column.kind, texts).map_err(|what| TableError::BadValue {
        table: table.to_owned(),
        column: column.name.to_owned(),
        what,
    })
}

fn cell_of(kind: Kind, texts: &[String]) -> Result<Cell, String> {
    match kind {
        Kind::Scalar => numbers(texts).map(|[x]| Cell::Scalar(x)),
        Kind::Vector => numbers(texts).map(Cell::Vector),
        Kind::Quaternion => numbers(texts).map(Cell::Quaternion),
        Kind::Matrix => numbers(texts).map(Cell::Matrix),
        Kind::Index => {
            let text = texts.first().map_or("", |text| text.trim());
            let read = text.parse().map(Cell::Index);
            read.map_err(|_| format!("`{text}` is no whole number from 0 to {}", u32::MAX))
        }
    }
}

fn numbers<const N: usize>(texts: &[String]) -> Result<[f32; N], String> {
    let read = |text: &String| {
        let text = text.trim();
        text.parse::<f32>()
            .map_err(|_| format!("`{text}` is no number"))
    };
    let numbers = texts.iter().map(read).collect::<Result<Vec<f32>, _>>()?;
    let count = numbers.len();
    numbers
        .try_into()
        .map_err(|_| format!("{N} numbers are needed, not {count}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_engine::balls;

    fn texts(texts: &[&str]) -> Vec<String> {
        texts.iter().map(|&text| text.to_owned()).collect()
    }

    #[test]
    fn a_cell_shows_all_numbers_of_a_value() {
        let cell = Cell::Vector([1.0, -2.5, 0.0]);
        assert_eq!(shown(&cell), "   1.0000   -2.5000    0.0000");
        assert_eq!(shown(&Cell::Index(7)), "7");
    }

    #[test]
    fn small_and_large_numbers_keep_their_digits_and_their_width() {
        let cell = Cell::Vector([1.5e-5, -2.25e9, f32::NAN]);
        assert_eq!(shown(&cell), "  1.50e-5   -2.25e9       NaN");
        assert_eq!(shown(&Cell::Scalar(f32::INFINITY)), "      inf");
    }

    #[test]
    fn what_is_typed_back_unchanged_is_the_same_to_the_bit() {
        let third = 1.0_f32 / 3.0;
        for cell in [
            Cell::Scalar(third),
            Cell::Vector([third, -0.0, 1e-40]),
            Cell::Quaternion([0.1, f32::MAX, f32::MIN_POSITIVE, 1.0]),
            Cell::Matrix([third; 9]),
            Cell::Index(u32::MAX),
        ] {
            let again = cell_of(cell.kind(), &typed(&cell)).expect("it was a cell");
            assert_eq!(shown(&again), shown(&cell));
            let bits = |cell: &Cell| {
                cell.numbers()
                    .iter()
                    .map(|x| x.to_bits())
                    .collect::<Vec<_>>()
            };
            assert_eq!((bits(&again), &again), (bits(&cell), &cell));
        }
    }

    #[test]
    fn what_is_no_number_is_named() {
        let error = |kind, typed: &[&str]| cell_of(kind, &texts(typed)).expect_err("bad");
        assert_eq!(error(Kind::Vector, &["1", " x ", "3"]), "`x` is no number");
        assert_eq!(error(Kind::Scalar, &[""]), "`` is no number");
        assert_eq!(error(Kind::Vector, &["1"]), "3 numbers are needed, not 1");
        for bad in ["-1", "1.5", "4294967296", ""] {
            assert!(error(Kind::Index, &[bad]).starts_with(&format!("`{bad}` is no whole")));
        }
    }

    #[test]
    fn the_error_names_table_and_column() {
        let tables = balls(1).engine().tables();
        let error = parsed("bodies", &tables[0].columns[0], &texts(&["1", "2", "?"]));
        let text = error.expect_err("no number").to_string();
        assert_eq!(text, "column `bodies.position`: `?` is no number");
    }
}
