//! Checks that the names in notation.md are the code's: a table that lags behind is worse than none.

use std::path::Path;

use regex::Regex;
use tests::files_below;

use crate::{Book, Complaints};

/// Every name in a column headed Rust, WGSL or overlay stands in the code below `root`.
pub fn complaints(book: &Book, root: &Path) -> Complaints {
    let Some(page) = book.pages.iter().find(|page| page.name == "notation.md") else {
        return vec!["notation.md: missing".into()];
    };
    let code = Code::read(root);
    let name = Regex::new("`([^`]+)`").expect("a valid pattern");
    let mut header: Vec<&str> = Vec::new();
    let mut complaints = Vec::new();
    for (i, line) in page.text.lines().enumerate() {
        let cells = cells(line);
        if header.is_empty() || cells.is_empty() {
            header = cells;
            continue;
        }
        for (column, cell) in header.iter().zip(cells) {
            for found in name.captures_iter(cell) {
                if !code.has(column, &found[1]) {
                    let what = format!("`{}` is no name in the code ({column})", &found[1]);
                    complaints.push(format!("notation.md:{}: {what}", i + 1));
                }
            }
        }
    }
    complaints
}

/// The cells of a table's row; none where the line is no row.
fn cells(line: &str) -> Vec<&str> {
    let line = line.trim();
    match line.strip_prefix('|').and_then(|l| l.strip_suffix('|')) {
        Some(row) => row.split('|').map(str::trim).collect(),
        None => Vec::new(),
    }
}

/// The text of all chapters and all shaders.
struct Code {
    rust: String,
    wgsl: String,
    formulas: Vec<(String, String)>,
}

impl Code {
    fn read(root: &Path) -> Self {
        let text = |folder: &str, extension: &str| -> Vec<(String, String)> {
            files_below(&root.join(folder))
                .into_iter()
                .filter(|path| path.extension().is_some_and(|e| e == extension))
                .map(|path| {
                    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
                    let text = std::fs::read_to_string(&path);
                    (
                        stem.into_owned(),
                        text.unwrap_or_else(|e| panic!("{}: {e}", path.display())),
                    )
                })
                .collect()
        };
        let all = |files: Vec<(String, String)>| -> String {
            files.into_iter().map(|(_, text)| text).collect()
        };
        Self {
            rust: all(text("chapters", "rs")),
            wgsl: all(text("shaders", "wgsl")),
            formulas: text("chapters/ch00_maths/src/formulas", "rs"),
        }
    }

    /// Whether `name` is what a column with this head promises.
    fn has(&self, column: &str, name: &str) -> bool {
        match column {
            "Rust" => self.has_rust(name),
            "WGSL" => word(&self.wgsl, first_word(name)),
            "overlay" => self.rust.contains(&format!("\"{name}\"")),
            _ => true,
        }
    }

    /// `verlet::velocity` is a function of that file; a single word stands somewhere.
    fn has_rust(&self, name: &str) -> bool {
        let parts: Vec<&str> = name.split("::").collect();
        let Some(function) = parts.last().filter(|_| parts.len() > 1) else {
            return word(&self.rust, first_word(name));
        };
        let mut files = self.formulas.iter();
        match files.find(|(stem, _)| stem == parts[0]) {
            Some((_, text)) => word(text, &format!("fn {function}")),
            None => word(&self.rust, parts[0]),
        }
    }
}

/// The identifier that an expression begins with.
fn first_word(name: &str) -> &str {
    let end = name.find(|c: char| !c.is_alphanumeric() && c != '_');
    &name[..end.unwrap_or(name.len())]
}

/// Whether these words stand in the text, whole.
fn word(text: &str, words: &str) -> bool {
    let pattern = format!(r"\b{}\b", regex::escape(words));
    Regex::new(&pattern).is_ok_and(|pattern| pattern.is_match(text))
}
