//! Checks of the pages that mdBook writes: warnings, directives and formulas that were not rendered,
//! links, pictures, and that nothing is loaded from the network.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use regex::Regex;
use tests::{files_below, relative};

use crate::{Book, Complaints, Page, markdown};

/// mdbook-katex says on every run that it was built against another patch release of mdBook.
const HARMLESS: &str = "was built against mdbook";

/// Pages that mdBook makes out of the others (or, 404, that is only right at a server's root).
const DERIVED: [&str; 4] = ["index.html", "print.html", "toc.html", "404.html"];

/// Builds the book in a temporary folder and checks what came out.
pub fn complaints(book: &Book) -> Complaints {
    let out = tempfile::tempdir().expect("a temporary folder");
    let mut complaints = build(book, out.path());
    let written = Written::read(out.path());
    complaints.extend(not_rendered(book, &written));
    complaints.extend(dead_links(&written));
    complaints.extend(network(&written));
    complaints
}

/// Runs mdBook; every warning is a complaint.
fn build(book: &Book, out: &Path) -> Complaints {
    let run = Command::new("mdbook")
        .arg("build")
        .arg(&book.root)
        .arg("--dest-dir")
        .arg(out)
        .env("NO_COLOR", "1")
        .output()
        .unwrap_or_else(|e| {
            panic!("mdbook: {e}; `cargo install --locked mdbook@0.5.4 mdbook-katex@0.10.0`")
        });
    let printed =
        String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr);
    let bad = Regex::new(r"\b(WARN|ERROR)\b").expect("a valid pattern");
    let mut complaints: Complaints = printed
        .lines()
        .filter(|line| bad.is_match(line) && !line.contains(HARMLESS))
        .map(|line| format!("mdbook: {line}"))
        .collect();
    if !run.status.success() {
        complaints.push(format!("mdbook: {}:\n{printed}", run.status));
    }
    complaints
}

/// The book as mdBook wrote it.
struct Written {
    root: PathBuf,
    /// Pages that a chapter became, by their name: `ch01_hierarchy.html`.
    pages: BTreeMap<String, String>,
    files: BTreeSet<String>,
}

impl Written {
    fn read(root: &Path) -> Self {
        let files: BTreeSet<String> = files_below(root)
            .iter()
            .map(|path| relative(path, root))
            .collect();
        let pages = files
            .iter()
            .filter(|name| kind(name) == "html" && !DERIVED.contains(&name.as_str()))
            .map(|name| (name.clone(), read(&root.join(name))))
            .collect();
        Self {
            root: root.to_path_buf(),
            pages,
            files,
        }
    }
}

/// What stands after the last dot of a file's name.
fn kind(name: &str) -> &str {
    name.rsplit_once('.').map_or("", |(_, kind)| kind)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Directives and formulas that are still in the text.
fn not_rendered(book: &Book, written: &Written) -> Complaints {
    let code = Regex::new(r"(?s)<pre\b.*?</pre>|<code\b.*?</code>|<script\b.*?</script>|<[^>]*>")
        .expect("a valid pattern");
    // MathML keeps the TeX of a formula as an annotation. What Markdown made of it shows there.
    let tex = Regex::new("(?s)<annotation[^>]*>(.*?)</annotation>").expect("a valid pattern");
    let has_formulas = |page: &Page| !markdown::formulas(&page.text).is_empty();
    let mut complaints = Vec::new();
    for (name, html) in &written.pages {
        if html.contains("{{#") {
            complaints.push(format!("{name}: an unresolved `{{{{#…}}}}`"));
        }
        let text = code.replace_all(html, " ");
        for line in text.lines().filter(|line| line.contains('$')) {
            complaints.push(format!("{name}: not rendered: {}", line.trim()));
        }
        for formula in tex.captures_iter(html).filter(|c| c[1].contains('<')) {
            complaints.push(format!(
                "{name}: Markdown took this formula apart: {}",
                &formula[1]
            ));
        }
    }
    for page in book.chapters() {
        let name = page.name.replace(".md", ".html");
        match written.pages.get(&name) {
            None => complaints.push(format!("{}: became no page", page.name)),
            Some(html) if has_formulas(page) && !html.contains("<math") => {
                complaints.push(format!("{name}: has formulas, but no <math>"));
            }
            Some(_) => {}
        }
    }
    complaints
}

/// A tag that points at something.
struct Reference<'a> {
    tag: &'a str,
    target: &'a str,
}

fn references(html: &str) -> Vec<Reference<'_>> {
    let tag = Regex::new(r"(?s)<([a-zA-Z]\w*)\s([^>]*)>").expect("a valid pattern");
    let target = Regex::new(r#"(?:^|\s)(?:xlink:)?(?:href|src|poster|data)="([^"]*)""#)
        .expect("a valid pattern");
    let mut found = Vec::new();
    for tag in tag.captures_iter(html) {
        let attributes = tag.get(2).map_or("", |m| m.as_str());
        found.extend(target.captures_iter(attributes).map(|c| Reference {
            tag: tag.get(1).map_or("", |m| m.as_str()),
            target: c.get(1).map_or("", |m| m.as_str()),
        }));
    }
    found
}

/// Whether a target lies on another machine.
fn is_remote(target: &str) -> bool {
    target.contains("://") || target.starts_with("//")
}

/// Links and pictures whose file, or whose place on the page, doesn't exist.
fn dead_links(written: &Written) -> Complaints {
    let id = Regex::new(r#"\sid="([^"]*)""#).expect("a valid pattern");
    let ids: BTreeSet<(&str, String)> = written
        .pages
        .iter()
        .flat_map(|(name, html)| {
            id.captures_iter(html)
                .map(move |c| (name.as_str(), c[1].to_owned()))
        })
        .collect();
    let mut complaints = Vec::new();
    for (name, html) in &written.pages {
        for Reference { target, .. } in references(html) {
            if is_remote(target) || target.starts_with("mailto:") || target.starts_with("data:") {
                continue;
            }
            let (file, place) = target.split_once('#').unwrap_or((target, ""));
            let file = resolve(name, file.split('?').next().unwrap_or_default());
            if !written.files.contains(&file) {
                complaints.push(format!("{name}: `{target}` leads nowhere"));
            } else if !place.is_empty()
                && written.pages.contains_key(&file)
                && !ids.contains(&(file.as_str(), place.to_owned()))
            {
                complaints.push(format!("{name}: `{target}`: no such place on that page"));
            }
        }
    }
    complaints
}

/// The file that a relative link on `page` means; the page itself for an empty link.
fn resolve(page: &str, link: &str) -> String {
    if link.is_empty() {
        return page.to_owned();
    }
    let folder = Path::new(page).parent().unwrap_or(Path::new(""));
    let mut parts: Vec<String> = Vec::new();
    for part in folder.join(link).components() {
        match part {
            Component::ParentDir if parts.pop().is_none() => parts.push("..".into()),
            Component::Normal(name) => parts.push(name.to_string_lossy().into_owned()),
            _ => {}
        }
    }
    parts.join("/")
}

/// Scripts, styles, pictures and fonts that would come over the network.
fn network(written: &Written) -> Complaints {
    let css = Regex::new(r#"(@import\s+|url\(\s*)["']?(https?:)?//"#).expect("a valid pattern");
    let mut complaints = Vec::new();
    for name in &written.files {
        if !matches!(kind(name), "html" | "css" | "svg") {
            continue;
        }
        let text = read(&written.root.join(name));
        for Reference { tag, target } in references(&text) {
            if tag != "a" && is_remote(target) {
                complaints.push(format!("{name}: <{tag}> loads {target}"));
            }
        }
        for found in css.find_iter(&text) {
            complaints.push(format!("{name}: a style loads {}…", found.as_str()));
        }
    }
    complaints
}
