//! Plants each mistake in a small book and asks the check to find it: a check that
//! never complains would look the same as a book without mistakes.

use std::path::Path;

use tempfile::TempDir;

use crate::{Book, Complaints, checkpoints, html, notation, sources};

/// A book without a mistake: a page with a formula, a picture, an include and a checkpoint.
const PAGE: &str = r"# A page

The square of $x$ is $x^2$, see [the other page](other.md#a-place). ![A dot](dot.svg)

$$\frac{a}{b}$$

```rust
{{#include ../../code.rs:square}}
```

```console,checkpoint
$ echo took 25 ms
took [..] ms
```
";

const OTHER: &str = "# Another page\n\n## A place\n\nThe price is `$5`.\n";

const CODE: &str = "\
// ANCHOR: square
/// The square.
fn square(x: f32) -> f32 {
    // ANCHOR: inner
    x * x
    // ANCHOR_END: inner
}
// ANCHOR_END: square
";

const BOOK: &str = r#"[book]
title = "Small"

[preprocessor.katex]
after = ["links"]
output = "mathml"
no-css = true
"#;

const DOT: &str =
    r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><circle r="1"/></svg>"#;

/// A small book on disk, in a folder of its own.
struct Small(TempDir);

impl Small {
    fn new() -> Self {
        let small = Self(tempfile::tempdir().expect("a temporary folder"));
        std::fs::create_dir_all(small.0.path().join("book/src")).expect("a folder");
        small.write("code.rs", CODE);
        small.write("book/book.toml", BOOK);
        small.write(
            "book/src/SUMMARY.md",
            "# Summary\n\n- [A](page.md)\n- [B](other.md)\n",
        );
        small.write("book/src/page.md", PAGE);
        small.write("book/src/other.md", OTHER);
        small.write("book/src/dot.svg", DOT);
        small
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.path().join(name), text).expect("a file");
    }

    /// Replaces a part of a file, which must be there.
    fn change(self, name: &str, from: &str, to: &str) -> Self {
        let path = self.0.path().join(name);
        let text = std::fs::read_to_string(&path).expect("a file");
        assert!(text.contains(from), "{name} holds no {from:?}");
        std::fs::write(path, text.replacen(from, to, 1)).expect("a file");
        self
    }

    /// The complaints of one check.
    fn check(&self, check: impl Fn(&Book, &Path) -> Complaints) -> Complaints {
        check(&Book::open(&self.0.path().join("book")), self.0.path())
    }
}

/// Exactly one complaint, and it names the mistake.
#[track_caller]
fn expect_one(complaints: &Complaints, about: &str) {
    assert!(
        complaints.len() == 1 && complaints[0].contains(about),
        "wanted one complaint about {about:?}, got {complaints:#?}"
    );
}

/// At least one complaint names the mistake (mdBook may add its own).
#[track_caller]
fn expect_some(complaints: &Complaints, about: &str) {
    assert!(
        complaints.iter().any(|line| line.contains(about)),
        "wanted a complaint about {about:?}, got {complaints:#?}"
    );
}

const PAGE_FILE: &str = "book/src/page.md";

fn summary(book: &Book, _: &Path) -> Complaints {
    sources::summary(book)
}

fn includes(book: &Book, _: &Path) -> Complaints {
    sources::includes(book)
}

fn formulas(book: &Book, _: &Path) -> Complaints {
    sources::formulas(book)
}

fn pasted(book: &Book, _: &Path) -> Complaints {
    sources::pasted_code(book)
}

fn built(book: &Book, _: &Path) -> Complaints {
    html::complaints(book)
}

#[test]
fn a_book_without_mistakes_passes_every_check() {
    let small = Small::new();
    for check in [
        summary,
        includes,
        formulas,
        pasted,
        built,
        checkpoints::complaints,
    ] {
        assert_eq!(small.check(check), Complaints::new());
    }
}

#[test]
fn a_page_that_the_summary_forgets_is_found() {
    let small = Small::new().change("book/src/SUMMARY.md", "- [B](other.md)\n", "");
    expect_one(&small.check(summary), "other.md: not in SUMMARY.md");
}

#[test]
fn a_line_of_the_summary_without_a_page_is_found() {
    let small = Small::new().change("book/src/SUMMARY.md", "- [B]", "- [C](c.md)\n- [B]");
    expect_one(&small.check(summary), "`c.md` has no file");
}

#[test]
fn a_page_without_a_title_is_found() {
    let small = Small::new().change(PAGE_FILE, "# A page", "A page");
    expect_one(&small.check(summary), "no title");
}

#[test]
fn an_include_of_a_missing_file_is_found() {
    let small = Small::new().change(PAGE_FILE, "code.rs", "gone.rs");
    expect_one(&small.check(includes), "page.md:8");
    expect_some(&small.check(built), "unresolved");
}

#[test]
fn an_include_of_a_missing_anchor_is_found() {
    let small = Small::new().change(PAGE_FILE, ":square", ":cube");
    expect_one(&small.check(includes), "no `ANCHOR: cube`");
}

#[test]
fn an_anchor_without_an_end_is_found() {
    let small = Small::new().change("code.rs", "ANCHOR_END: square", "");
    expect_one(&small.check(includes), "no `ANCHOR_END: square`");
}

#[test]
fn an_empty_block_is_found() {
    let small = Small::new().change(
        "code.rs",
        CODE,
        "// ANCHOR: square\n\n// ANCHOR_END: square",
    );
    expect_one(&small.check(includes), "empty");
}

#[test]
fn a_listing_that_nobody_reads_is_found() {
    let long = "    // a line\n".repeat(50) + "    x * x";
    let small = Small::new().change("code.rs", "    x * x", &long);
    expect_one(&small.check(includes), "54 lines");
}

#[test]
fn an_include_by_line_numbers_is_found() {
    let small = Small::new().change(PAGE_FILE, ":square", ":1:4");
    expect_one(&small.check(includes), "line numbers drift");
}

#[test]
fn pasted_code_is_found() {
    let paste = "fn f() {\n    let a = 1;\n    let b = 2;\n}";
    let small = Small::new().change(PAGE_FILE, "{{#include ../../code.rs:square}}", paste);
    expect_one(&small.check(pasted), "4 lines of code");
}

#[test]
fn a_block_that_never_ends_is_found() {
    let small = Small::new().change(PAGE_FILE, "took [..] ms\n```", "took [..] ms\n");
    expect_one(
        &small.check(pasted),
        "page.md:11: this block is never closed",
    );
}

#[test]
fn a_formula_that_katex_cannot_read_is_found() {
    let small = Small::new().change(PAGE_FILE, r"$$\frac{a}{b}$$", r"$$\frac{a$$");
    expect_some(&small.check(built), r"not rendered: $$\frac{a$$");
}

#[test]
fn a_formula_that_markdown_takes_apart_is_found() {
    let small = Small::new().change(PAGE_FILE, "$x$", r"$\hat{n}_1 + a_{b}$");
    expect_one(&small.check(formulas), "page.md:3");
    expect_some(&small.check(built), "took this formula apart");
    let small = Small::new().change(PAGE_FILE, "$x$ is $x^2$", "$x^*$ is $y^*$");
    expect_some(&small.check(formulas), r"write `\ast`");
    expect_some(&small.check(built), "took this formula apart");
}

#[test]
fn formulas_without_the_preprocessor_are_found() {
    let small = Small::new();
    small.write("book/book.toml", "[book]\ntitle = \"Small\"\n");
    expect_some(&small.check(built), "has formulas, but no <math>");
}

#[test]
fn a_dead_link_is_found() {
    let small = Small::new().change(PAGE_FILE, "other.md#a-place", "gone.md");
    expect_one(&small.check(built), "leads nowhere");
}

#[test]
fn a_dead_link_in_the_readme_is_found() {
    let small = Small::new();
    small.write(
        "README.md",
        "[Rust](https://rust-lang.org) ![a dot](book/src/dot.svg)",
    );
    assert_eq!(sources::readme(small.0.path()), Complaints::new());
    small.write("README.md", "[the licence](LICENSE)");
    expect_one(&sources::readme(small.0.path()), "`LICENSE` leads nowhere");
}

#[test]
fn a_link_to_a_missing_place_is_found() {
    let small = Small::new().change(PAGE_FILE, "#a-place", "#no-place");
    expect_one(&small.check(built), "no such place");
}

#[test]
fn a_missing_picture_is_found() {
    let small = Small::new().change(PAGE_FILE, "dot.svg", "gone.svg");
    expect_some(&small.check(built), "`gone.svg` leads nowhere");
}

#[test]
fn a_script_from_the_network_is_found() {
    let script = "<script src=\"https://example.org/x.js\"></script>\n\n$$\\frac";
    let small = Small::new().change(PAGE_FILE, "$$\\frac", script);
    expect_some(
        &small.check(built),
        "<script> loads https://example.org/x.js",
    );
}

#[test]
fn a_font_from_the_network_is_found() {
    let small = Small::new().change(
        "book/book.toml",
        "[preprocessor",
        "[output.html]\nadditional-css = [\"x.css\"]\n\n[preprocessor",
    );
    small.write("book/x.css", "@import url('https://example.org/font.css');");
    expect_some(&small.check(built), "a style loads");
}

#[test]
fn a_warning_of_mdbook_is_found() {
    let small = Small::new().change(PAGE_FILE, "$$\\frac", "<div>\n\n$$\\frac");
    expect_some(&small.check(built), "unclosed HTML tag");
}

#[test]
fn a_name_that_the_code_no_longer_has_is_found() {
    let small = Small::new();
    let formulas = "chapters/ch00_maths/src/formulas";
    std::fs::create_dir_all(small.0.path().join(formulas)).expect("a folder");
    std::fs::create_dir_all(small.0.path().join("shaders")).expect("a folder");
    small.write("shaders/quat.wgsl", "fn quat_rotate() {}");
    small.write(
        &format!("{formulas}/verlet.rs"),
        "pub fn velocity(p_last: Vec3) {}\nconst NAME: &str = \"p*\";",
    );
    let table = "\
# Notation

| symbol | Rust | WGSL | overlay |
|---|---|---|---|
| v | `verlet::velocity`, `p_last` | `quat_rotate(q, v)` | `p*` |
";
    small.write("book/src/notation.md", table);
    assert_eq!(small.check(notation::complaints), Complaints::new());
    for (name, wrong) in [
        ("verlet::velocity", "verlet::speed"),
        ("p_last", "p_first"),
        ("quat_rotate", "quat_turn"),
        ("`p*`", "`p`"),
    ] {
        small.write("book/src/notation.md", &table.replace(name, wrong));
        expect_one(&small.check(notation::complaints), "notation.md:5");
    }
}

#[test]
fn output_that_no_longer_comes_is_found() {
    let small = Small::new().change(PAGE_FILE, "took [..] ms", "took [..] s");
    expect_one(&small.check(checkpoints::complaints), "page.md:11");
}

#[test]
fn a_command_that_fails_is_found() {
    let small = Small::new().change(PAGE_FILE, "echo took 25 ms", "sh -c 'exit 3'");
    expect_one(&small.check(checkpoints::complaints), "ended with status 3");
}

#[test]
fn a_command_that_should_fail_and_does_not_is_found() {
    let small = Small::new().change(PAGE_FILE, "console,checkpoint", "console,checkpoint,fails");
    expect_one(&small.check(checkpoints::complaints), "ended with status 0");
}

#[test]
fn a_block_that_expects_nothing_is_found() {
    let small = Small::new().change(PAGE_FILE, "took [..] ms\n", "");
    expect_one(&small.check(checkpoints::complaints), "no expected output");
}

#[test]
fn a_checkpoint_that_writes_into_the_repository_is_found() {
    let small = Small::new().change(PAGE_FILE, "echo took", "echo --dump book/x.rbd");
    expect_one(&small.check(checkpoints::complaints), "write below target/");
}

#[test]
fn a_kind_of_block_that_does_not_exist_is_found() {
    let small = Small::new().change(PAGE_FILE, "console,checkpoint", "bash,checkpoint");
    expect_one(&small.check(checkpoints::complaints), "no kind of block");
}
