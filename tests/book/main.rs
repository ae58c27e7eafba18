//! The book: mdBook ends with status 0 whatever is wrong with a page, so each mistake is looked for here.
//!
//! | mistake | what mdBook does | file |
//! |---|---|---|
//! | a page that SUMMARY doesn't name, or the reverse | leaves it out, or writes an empty one | `sources.rs` |
//! | `{{#include}}` of a missing file or anchor | prints the directive, or an empty block | `sources.rs` |
//! | pasted code, which drifts from the crates | nothing | `sources.rs` |
//! | a formula that KaTeX can't read | prints the TeX | `html.rs` |
//! | `*` or `}_` in a formula, which Markdown takes for emphasis | prints half of the formula | `sources.rs` |
//! | a dead link or picture | nothing | `html.rs` |
//! | a script, style or font from the network | nothing: the page needs the network | `html.rs` |
//! | a name in notation.md that the code no longer has | nothing | `notation.rs` |
//! | output in the text that the program no longer prints | nothing | `checkpoints.rs` |
//!
//! `planted.rs` makes each of these mistakes in a small book and asks the check to find it.
//!
//! # Checkpoints
//!
//! A block that shows a command and its output is written so, and is then run by this test:
//!
//! ````text
//! ```console,checkpoint
//! $ cargo run --release -p ch03_collision -- --headless --scene balls --count 10 --steps 60
//! scene balls, 10 bodies
//! step  [..] ms
//! ...
//! escaped 0
//! ```
//! ````
//!
//! - A line that begins with `$ ` is a command; what follows, up to the next command, is what it prints.
//!   A command that ends with `\` goes on in the next line.
//! - `[..]` stands for anything within a line (times, names of devices); a line `...` stands for any
//!   number of lines. Spaces at the end of a line don't count. All else must be equal.
//! - `console,checkpoint` wants exit status 0 and compares standard output;
//!   `console,checkpoint,fails` wants status 1 or 2 and compares standard error.
//! - `cargo run …` becomes the binary or example that this profile has already built (`cargo test` builds
//!   examples, `cargo build --workspace` binaries); without `-p` it is `ch07_findings`. Other commands go to `sh`.
//! - Commands run in the root of the repository, without a display and without standard input. Files
//!   belong under `target/`: a `--dump` or `--screenshot` elsewhere is an error. The limit is two minutes.
//!
//! A block with `console` alone is not run.

mod checkpoints;
mod html;
mod markdown;
mod notation;
mod planted;
mod sources;

use std::path::{Path, PathBuf};

use tests::{files_below, relative};

/// A book: the folder that holds `book.toml`, and its pages.
struct Book {
    root: PathBuf,
    pages: Vec<Page>,
}

/// A Markdown file below `src/`.
struct Page {
    /// Relative to `src/`, with `/` between folders: `ch01_hierarchy.md`.
    name: String,
    path: PathBuf,
    text: String,
}

/// What a check found: one line each, `page:line: what is wrong`. Empty when all is well.
type Complaints = Vec<String>;

impl Book {
    /// Reads every page below `root/src`, in the order of their names.
    fn open(root: &Path) -> Self {
        let src = root.join("src");
        let mut pages: Vec<Page> = files_below(&src)
            .into_iter()
            .filter(|path| path.extension().is_some_and(|e| e == "md"))
            .map(|path| Page {
                name: relative(&path, &src),
                text: std::fs::read_to_string(&path)
                    .unwrap_or_else(|e| panic!("{}: {e}", path.display())),
                path,
            })
            .collect();
        pages.sort_by(|a, b| a.name.cmp(&b.name));
        Self {
            root: root.to_path_buf(),
            pages,
        }
    }

    /// The pages that a reader sees: all but the table of contents.
    fn chapters(&self) -> impl Iterator<Item = &Page> {
        self.pages.iter().filter(|page| page.name != "SUMMARY.md")
    }
}

#[track_caller]
fn expect_none(complaints: &[String]) {
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

fn this_book() -> Book {
    Book::open(&tests::root().join("book"))
}

#[test]
fn the_summary_names_every_page_once() {
    expect_none(&sources::summary(&this_book()));
}

#[test]
fn every_include_finds_a_block_of_a_readable_length() {
    expect_none(&sources::includes(&this_book()));
}

#[test]
fn code_comes_from_the_crates() {
    expect_none(&sources::pasted_code(&this_book()));
}

#[test]
fn the_links_of_the_readme_lead_somewhere() {
    expect_none(&sources::readme(&tests::root()));
}

#[test]
fn formulas_hold_nothing_that_markdown_reads() {
    expect_none(&sources::formulas(&this_book()));
}

#[test]
fn the_book_builds_without_a_warning_into_pages_that_work_offline() {
    expect_none(&html::complaints(&this_book()));
}

#[test]
fn the_names_in_the_notation_are_those_of_the_code() {
    expect_none(&notation::complaints(&this_book(), &tests::root()));
}

#[test]
fn checkpoints_print_what_the_book_says() {
    expect_none(&checkpoints::complaints(&this_book(), &tests::root()));
}
