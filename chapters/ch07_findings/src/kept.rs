//! Tables that are kept in the book, because few readers have the machine that they were measured on.
//! Charts are drawn from them; what can't be read says where and why.

use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use crate::FindingsError;
use crate::product::{Product, Say};

/// A kept table: which file it is, and what writes it anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Its name in the book's folder of charts.
    pub file: &'static str,
    /// The command that measures it, on whatever machine it is started.
    pub command: &'static str,
}

/// A kept table, read.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    source: Source,
    path: PathBuf,
    names: Vec<String>,
    /// Number of the line, from 1, and its fields, as many as there are names.
    lines: Vec<(usize, Vec<String>)>,
}

/// A line of a kept table.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    kept: &'a Kept,
    number: usize,
    fields: &'a [String],
}

/// `book/src/charts` of the checkout that the program was built in; where that is gone, of the
/// current directory.
pub fn folder_of_book() -> PathBuf {
    let chapter = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = chapter.ancestors().nth(2).unwrap_or(chapter);
    let root = if root.join("book/src").is_dir() {
        root
    } else {
        Path::new(".")
    };
    root.join("book/src/charts")
}

impl Source {
    /// Reads the table from the book.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where there is no such file, or it is no table.
    pub fn read(self) -> Result<Kept, FindingsError> {
        let path = folder_of_book().join(self.file);
        match fs::read_to_string(&path) {
            Ok(text) => self.parse(path, &text),
            Err(error) => Err(self.wrong(path, format!("it can't be read: {error}"))),
        }
    }

    /// The table that `text` holds, which stood at `path`. The first line has the names. A line that has
    /// them again is skipped, so that tables can be put one behind the other.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where a line has other fields than the first, or none follows it.
    pub fn parse(self, path: PathBuf, text: &str) -> Result<Kept, FindingsError> {
        let mut all = text.lines().map(fields).zip(1..);
        let names = all.next().map(|(names, _)| names).unwrap_or_default();
        let mut lines = Vec::new();
        for (fields, number) in all.filter(|(fields, _)| *fields != names) {
            if fields.len() != names.len() {
                let [found, wanted] = [fields.len(), names.len()];
                let why = format!("line {number} has {found} fields, but the first has {wanted}");
                return Err(self.wrong(path, why));
            }
            lines.push((number, fields));
        }
        if lines.is_empty() {
            return Err(self.wrong(path, "it holds no measurement".to_owned()));
        }
        Ok(Kept {
            source: self,
            path,
            names,
            lines,
        })
    }

    /// Reads the table, has it laid out, and says where it is from.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where there is no such file, or it can't be read.
    pub fn drawn(
        self,
        say: Say,
        draw: impl FnOnce(&Kept) -> Result<Product, FindingsError>,
    ) -> Result<Product, FindingsError> {
        let made = draw(&self.read()?)?;
        say(&format!("from {}", self.file));
        Ok(made)
    }

    fn wrong(self, path: PathBuf, why: String) -> FindingsError {
        FindingsError::Kept {
            path,
            why,
            command: self.command,
        }
    }
}

impl Kept {
    /// The lines below the names.
    pub fn lines(&self) -> impl Iterator<Item = Line<'_>> {
        self.lines.iter().map(|(number, fields)| Line {
            kept: self,
            number: *number,
            fields,
        })
    }

    /// What every line says.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where one can't be read.
    pub fn samples<T>(
        &self,
        of: impl Fn(Line<'_>) -> Result<T, FindingsError>,
    ) -> Result<Vec<T>, FindingsError> {
        self.lines().map(of).collect()
    }

    /// What all lines have in a column.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where there is no such column, or two lines differ in it.
    pub fn common(&self, column: &str) -> Result<&str, FindingsError> {
        let mut first = None;
        for line in self.lines() {
            let text = line.text(column)?;
            if *first.get_or_insert(text) != text {
                return Err(line.wrong(&format!("has another `{column}` than the first")));
            }
        }
        Ok(first.unwrap_or_default())
    }

    /// Where a caption says that it comes from: the file's name and its command.
    pub fn origin(&self) -> String {
        format!(
            "kept in `{}`, which `{}` wrote",
            self.source.file, self.source.command
        )
    }
}

impl<'a> Line<'a> {
    /// What stands in a column.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where there is no such column.
    pub fn text(self, column: &str) -> Result<&'a str, FindingsError> {
        let place = self.kept.names.iter().position(|name| name == column);
        let absent = || self.wrong(&format!("has no column `{column}`"));
        place.map(|k| self.fields[k].as_str()).ok_or_else(absent)
    }

    /// That a column has one of these words.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where it has another one.
    pub fn one_of(self, column: &str, words: &[&str]) -> Result<(), FindingsError> {
        let text = self.text(column)?;
        if words.contains(&text) {
            return Ok(());
        }
        let known = words.join(", ");
        Err(self.wrong(&format!(
            "has `{text}` as `{column}`, which isn't among: {known}"
        )))
    }

    /// A number; one that is not finite stands as `NaN` or `inf`.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where there is no such column or no number in it.
    pub fn number<T: FromStr>(self, column: &str) -> Result<T, FindingsError> {
        let text = self.text(column)?;
        let none = |_| {
            self.wrong(&format!(
                "has `{text}` as `{column}`, which is no such number"
            ))
        };
        text.parse().map_err(none)
    }

    /// A time or another number that is finite and more than nothing.
    ///
    /// # Errors
    /// [`FindingsError::Kept`] where it isn't.
    pub fn positive(self, column: &str) -> Result<f64, FindingsError> {
        let number: f64 = self.number(column)?;
        if number > 0.0 && number.is_finite() {
            Ok(number)
        } else {
            Err(self.wrong(&format!(
                "has {number} as `{column}`, which must be more than 0"
            )))
        }
    }

    /// That this line can't be used, in words that follow its number.
    fn wrong(self, why: &str) -> FindingsError {
        let path = self.kept.path.clone();
        let why = format!("line {} {why}", self.number);
        self.kept.source.wrong(path, why)
    }
}

/// The fields of a line of CSV (RFC 4180), without quotes around them.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut is_quoted = false;
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            // Two quotes within quotes are one.
            '"' if is_quoted && chars.peek() == Some(&'"') => push(&mut fields, chars.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => fields.push(String::new()),
            c => push(&mut fields, Some(c)),
        }
    }
    fields
}

fn push(fields: &mut [String], c: Option<char>) {
    if let Some(field) = fields.last_mut() {
        field.extend(c);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: Source = Source {
        file: "any.csv",
        command: "measure --csv FILE",
    };

    fn parse(text: &str) -> Result<Kept, FindingsError> {
        SOURCE.parse(PathBuf::from("any.csv"), text)
    }

    fn said<T: std::fmt::Debug>(outcome: Result<T, FindingsError>) -> String {
        outcome.expect_err("it can't be read").to_string()
    }

    #[test]
    fn fields_are_told_apart_with_quotes_and_without() {
        let quoted = fields("\"a, \"\"b\"\"\",1,,c");
        assert_eq!(quoted, ["a, \"b\"", "1", "", "c"]);
    }

    #[test]
    fn tables_one_behind_the_other_are_one() {
        let kept = parse("device,ms\n\"a, b\",1\ndevice,ms\n\"a, b\",2.5\n").expect("a table");
        assert_eq!(kept.common("device").expect("the same"), "a, b");
        let times: Vec<f64> = kept
            .lines()
            .map(|l| l.positive("ms").expect("a time"))
            .collect();
        assert_eq!(times, [1.0, 2.5]);
    }

    #[test]
    fn what_is_wrong_is_told_with_file_line_and_command() {
        let short = said(parse("device,ms\na,1\nb\n"));
        for word in ["any.csv", "line 3", "1 fields", "2", "measure --csv FILE"] {
            assert!(short.contains(word), "{short}");
        }
        assert!(said(parse("")).contains("no measurement"));
        assert!(said(parse("device,ms\n")).contains("no measurement"));
        let kept = parse("device,ms\na,1\nb,x\nb,-1\n").expect("a table");
        let lines: Vec<Line> = kept.lines().collect();
        assert!(said(lines[1].number::<f64>("ms")).contains("line 3 has `x` as `ms`"));
        assert!(said(lines[2].positive("ms")).contains("line 4 has -1 as `ms`"));
        assert!(said(lines[0].text("bodies")).contains("no column `bodies`"));
        assert!(said(kept.common("device")).contains("line 3 has another `device`"));
    }

    #[test]
    fn a_missing_file_says_what_writes_it() {
        let file = "there_is_no_such_table.csv";
        let message = said(Source { file, ..SOURCE }.read());
        assert!(message.contains(file) && message.contains("measure --csv FILE"));
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}
