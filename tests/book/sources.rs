//! Checks of the Markdown itself: the table of contents, the includes, the code.

use std::path::Path;

use regex::Regex;

use crate::{Book, Complaints, Page, markdown};

/// Lines of code that an include may show: fewer explains nothing, more is not read.
const READABLE: std::ops::RangeInclusive<usize> = 3..=40;

/// Lines of Rust or WGSL that a page may hold itself: a signature, not a listing.
const PASTED: usize = 3;

/// Every page stands in SUMMARY.md once, and every line of SUMMARY.md has its page.
pub fn summary(book: &Book) -> Complaints {
    let Some(summary) = book.pages.iter().find(|page| page.name == "SUMMARY.md") else {
        return vec!["SUMMARY.md: missing".into()];
    };
    let link = Regex::new(r"\]\(([^)]*)\)").expect("a valid pattern");
    let named: Vec<&str> = link
        .captures_iter(&summary.text)
        .map(|c| c.get(1).map_or("", |m| m.as_str()).trim_start_matches("./"))
        .collect();
    let mut complaints = Vec::new();
    for name in &named {
        if !book.pages.iter().any(|page| page.name == *name) {
            complaints.push(format!("SUMMARY.md: `{name}` has no file"));
        }
    }
    for page in book.chapters() {
        match named.iter().filter(|name| **name == page.name).count() {
            1 => {}
            0 => complaints.push(format!("{}: not in SUMMARY.md", page.name)),
            n => complaints.push(format!("{}: {n} times in SUMMARY.md", page.name)),
        }
        if !page.text.starts_with("# ") {
            complaints.push(format!("{}:1: no title (`# …`)", page.name));
        }
    }
    complaints
}

/// Every include finds its file and its anchor, and code is of a readable length.
pub fn includes(book: &Book) -> Complaints {
    let directive = Regex::new(r"(\\?)\{\{\s*#(\w+)\s+([^}]+?)\s*\}\}").expect("a valid pattern");
    let mut complaints = Vec::new();
    for page in &book.pages {
        for (i, line) in page.text.lines().enumerate() {
            for found in directive.captures_iter(line).filter(|c| c[1].is_empty()) {
                if let Err(why) = include(page, &found[2], &found[3]) {
                    complaints.push(format!("{}:{}: {}: {why}", page.name, i + 1, &found[0]));
                }
            }
        }
    }
    complaints
}

/// One include directive: `{{#kind target}}`.
fn include(page: &Page, kind: &str, target: &str) -> Result<(), String> {
    if kind != "include" {
        return Err("this book uses `#include` only".into());
    }
    let (file, anchor) = match target.split_once(':') {
        Some((file, anchor)) => (file, Some(anchor)),
        None => (target, None),
    };
    let path = page.path.parent().unwrap_or(Path::new("")).join(file);
    let text = std::fs::read_to_string(&path).map_err(|e| format!("{e}"))?;
    let is_code = path
        .extension()
        .is_some_and(|e| e == "rs" || e == "wgsl" || e == "toml");
    let shown = match anchor {
        Some(anchor) => anchored(&text, anchor)?,
        None if is_code => return Err("code is included by anchor".into()),
        None => text.lines().collect(),
    };
    if shown.iter().all(|line| line.trim().is_empty()) {
        return Err("the block is empty".into());
    }
    if is_code && !READABLE.contains(&shown.len()) {
        return Err(format!(
            "{} lines; a reader wants {} to {}",
            shown.len(),
            READABLE.start(),
            READABLE.end()
        ));
    }
    Ok(())
}

/// The lines between `ANCHOR: name` and `ANCHOR_END: name`, without the marks of other anchors.
fn anchored<'a>(text: &'a str, name: &str) -> Result<Vec<&'a str>, String> {
    if !name.starts_with(|c: char| c.is_alphabetic()) {
        return Err("line numbers drift: use an anchor".into());
    }
    let mark = |line: &str, word: &str| {
        let (_, rest) = line.split_once(word)?;
        rest.split_whitespace().next().map(ToOwned::to_owned)
    };
    let lines: Vec<&str> = text.lines().collect();
    let find = |word: &str| {
        let at: Vec<usize> = (0..lines.len())
            .filter(|i| mark(lines[*i], word).as_deref() == Some(name))
            .collect();
        match at[..] {
            [at] => Ok(at),
            [] => Err(format!("no `{word} {name}`")),
            _ => Err(format!("`{word} {name}` stands there {} times", at.len())),
        }
    };
    let (start, end) = (find("ANCHOR:")?, find("ANCHOR_END:")?);
    if end < start {
        return Err(format!("`ANCHOR_END: {name}` stands before its start"));
    }
    let block = lines[start + 1..end].iter().copied();
    Ok(block
        .filter(|line| mark(line, "ANCHOR:").is_none() && mark(line, "ANCHOR_END:").is_none())
        .collect())
}

/// The links of README.md, which isn't a page of the book, lead to files of the repository.
pub fn readme(root: &Path) -> Complaints {
    let text = std::fs::read_to_string(root.join("README.md")).unwrap_or_default();
    let link = Regex::new(r"\]\(([^)#]+)\)").expect("a valid pattern");
    link.captures_iter(&text)
        .filter(|c| !c[1].contains("://") && !root.join(&c[1]).exists())
        .map(|c| format!("README.md: `{}` leads nowhere", &c[1]))
        .collect()
}

/// Formulas pass through Markdown after KaTeX, so they must hold nothing that Markdown takes for emphasis.
pub fn formulas(book: &Book) -> Complaints {
    let underscore = Regex::new(r"[^\w]_").expect("a valid pattern");
    let mut complaints = Vec::new();
    for page in &book.pages {
        for (line, formula) in markdown::formulas(&page.text) {
            let advice = if formula.contains('*') {
                r"`*` would become emphasis: write `\ast`"
            } else if underscore.is_match(&formula) {
                r"`_` after a bracket would become emphasis: write `\hat n_1` for `\hat{n}_1`, or `\sub{1}`"
            } else {
                continue;
            };
            complaints.push(format!("{}:{line}: ${formula}$: {advice}", page.name));
        }
    }
    complaints
}

/// Rust and WGSL blocks hold includes, not pasted code; and every block is closed.
pub fn pasted_code(book: &Book) -> Complaints {
    let mut complaints = Vec::new();
    for page in &book.pages {
        let (fences, _) = markdown::split(&page.text);
        for fence in fences {
            let place = format!("{}:{}", page.name, fence.line);
            if !fence.closed {
                complaints.push(format!("{place}: this block is never closed"));
            }
            let own = |line: &&&str| !line.trim().is_empty() && !line.contains("{{#include");
            let pasted = fence.lines.iter().filter(own).count();
            let code = matches!(fence.language(), "rust" | "rs" | "wgsl");
            if code && pasted > PASTED {
                complaints.push(format!("{place}: {pasted} lines of code, none included"));
            }
        }
    }
    complaints
}
