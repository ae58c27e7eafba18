//! A table that is told while it is measured: lines of CSV on the standard output and, if one wants it, in a file.

use std::fs::File;
use std::io::Write as _;
use std::process::ExitCode;

pub type Problem = Box<dyn std::error::Error>;

/// A column's name, with its unit, and its value in a line.
pub type Column<Line> = (&'static str, fn(&Line) -> String);

/// Lines of these columns.
pub struct Table<Line: 'static> {
    columns: &'static [Column<Line>],
    file: Option<File>,
}

impl<Line> Table<Line> {
    /// Tells the names of the columns, here and in this file.
    ///
    /// # Errors
    /// What the system says of the file.
    pub fn begin(columns: &'static [Column<Line>], csv: Option<&String>) -> Result<Self, Problem> {
        let file = csv.map(File::create).transpose()?;
        let mut table = Self { columns, file };
        table.tell(|(name, _)| (*name).to_owned())?;
        Ok(table)
    }

    /// Tells a line.
    ///
    /// # Errors
    /// What the system says of the file.
    pub fn add(&mut self, line: &Line) -> Result<(), Problem> {
        self.tell(|(_, value)| value(line))
    }

    fn tell(&mut self, field: impl Fn(&Column<Line>) -> String) -> Result<(), Problem> {
        let fields: Vec<_> = self.columns.iter().map(field).collect();
        let line = fields.join(",");
        println!("{line}");
        if let Some(file) = &mut self.file {
            writeln!(file, "{line}")?;
            file.flush()?;
        }
        Ok(())
    }
}

/// How a program ends; it says what went wrong.
pub fn ended(run: Result<(), Problem>) -> ExitCode {
    match run {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

/// Four digits are enough for an error.
pub fn short(value: f64) -> String {
    format!("{value:.3e}")
}
