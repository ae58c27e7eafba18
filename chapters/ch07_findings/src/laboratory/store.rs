//! The table on the disk: a line is added as soon as it is measured, so that nothing that was measured is
//! lost, whatever ends the program. A run that was cut short goes on where it stopped.

use std::fs::{File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use crate::FindingsError;

/// What a table keeps, a line each. A line that was cut off must not be readable.
pub trait Kept: Sized {
    /// The first line of the file.
    const HEADINGS: &'static str;

    /// A line without its end.
    fn line(&self) -> String;

    /// What a line says; None where it is none of this table.
    fn read(line: &str) -> Option<Self>;
}

/// The cells that are known, and the file that they are in.
pub struct Store<C> {
    path: PathBuf,
    file: File,
    /// In the order of the file.
    pub cells: Vec<C>,
}

impl<C: Kept> Store<C> {
    /// Opens the table of a folder, or begins one. A last line that was cut off is taken away; a line that
    /// can't be read is an error, since a table of something else must not be spoilt.
    ///
    /// # Errors
    /// [`FindingsError::Write`] where it can't be written, [`FindingsError::Store`] where it is no such table.
    pub fn open(path: &Path) -> Result<Self, FindingsError> {
        let write = |source| FindingsError::Write {
            path: path.to_owned(),
            source,
        };
        let text = match std::fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(write(error)),
        };
        let whole = text.rfind('\n').map_or(0, |end| end + 1);
        let cells = Self::parse(path, &text[..whole])?;
        if whole < text.len() || text.is_empty() {
            let kept = if whole == 0 {
                format!("{}\n", C::HEADINGS)
            } else {
                text[..whole].to_owned()
            };
            std::fs::write(path, kept).map_err(write)?;
        }
        let file = OpenOptions::new().append(true).open(path).map_err(write)?;
        Ok(Self {
            path: path.to_owned(),
            file,
            cells,
        })
    }

    fn parse(path: &Path, text: &str) -> Result<Vec<C>, FindingsError> {
        let wrong = |line: usize| FindingsError::Store {
            path: path.to_owned(),
            line,
        };
        let mut lines = text.lines().zip(1..);
        match lines.next() {
            None => return Ok(Vec::new()),
            Some((first, _)) if first == C::HEADINGS => {}
            Some(_) => return Err(wrong(1)),
        }
        lines
            .map(|(line, number)| C::read(line).ok_or_else(|| wrong(number)))
            .collect()
    }

    /// Adds a cell, on the disk first.
    ///
    /// # Errors
    /// [`FindingsError::Write`] where the disk is full.
    pub fn add(&mut self, cell: C) -> Result<(), FindingsError> {
        let line = cell.line() + "\n";
        let done = self.file.write_all(line.as_bytes());
        done.and_then(|()| self.file.flush())
            .map_err(|source| FindingsError::Write {
                path: self.path.clone(),
                source,
            })?;
        self.cells.push(cell);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::cell::{Cell, End, HEADINGS};
    use super::*;

    fn cell(rate: u32) -> Cell {
        Cell {
            scenario: "bounce".to_owned(),
            contender: "xpbd".to_owned(),
            rate,
            substeps: 20,
            sweeps: 1,
            error: 0.5,
            cost: 1e-3,
            runs: 1,
            end: End::Measured,
        }
    }

    #[test]
    fn a_table_goes_on_after_a_line_that_was_cut_off() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("cells.csv");
        let mut store = Store::<Cell>::open(&path).expect("a new one");
        store.add(cell(60)).expect("written");
        store.add(cell(120)).expect("written");
        drop(store);
        let text = std::fs::read_to_string(&path).expect("there");
        std::fs::write(&path, &text[..text.len() - 9]).expect("cut");
        let mut store = Store::open(&path).expect("the rest");
        assert_eq!(store.cells, [cell(60)]);
        store.add(cell(240)).expect("written");
        drop(store);
        let again = Store::<Cell>::open(&path).expect("whole");
        assert_eq!(again.cells, [cell(60), cell(240)]);
    }

    #[test]
    fn another_table_is_refused_and_left_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("cells.csv");
        for text in ["a,b\n1,2\n", &format!("{HEADINGS}\nbounce,xpbd\n")] {
            std::fs::write(&path, text).expect("written");
            let error = Store::<Cell>::open(&path)
                .err()
                .expect("refused")
                .to_string();
            assert!(
                error.contains("cells.csv") && error.contains("line"),
                "{error}"
            );
            assert_eq!(std::fs::read_to_string(&path).expect("there"), text);
        }
    }

    #[test]
    fn a_folder_that_is_not_there_is_told() {
        let error = Store::<Cell>::open(Path::new("/nowhere/at/all.csv")).err();
        assert!(
            error
                .expect("refused")
                .to_string()
                .contains("/nowhere/at/all.csv")
        );
    }
}
