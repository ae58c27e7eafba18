//! What the property `glow` cost a developer in each style, counted from the sources.

use super::{Style, components, hierarchy, hybrid};

/// A source file: path below `src/styles`, and text.
pub type Source = (&'static str, &'static str);

/// The price of a property.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Files that were there before.
    pub changed: usize,
    /// Files that are all marked.
    pub added: usize,
    /// Runs of lines between a pair of marks.
    pub places: usize,
    /// Lines of code in them, without blank lines and comments.
    pub lines: usize,
}

macro_rules! sources {
    ($($path:literal),* $(,)?) => { &[$(($path, include_str!($path))),*] };
}

/// The sources of each style, by its name.
pub const SOURCES: [(&str, &[Source]); 3] = [
    (
        hierarchy::World::NAME,
        sources![
            "hierarchy.rs",
            "hierarchy/orbiter.rs",
            "hierarchy/scene_object.rs",
            "hierarchy/spinner.rs",
            "hierarchy/spinning_orbiter.rs",
        ],
    ),
    (
        components::World::NAME,
        sources![
            "components.rs",
            "components/circle.rs",
            "components/entity.rs",
            "components/glow.rs",
            "components/placement.rs",
            "components/spin.rs",
        ],
    ),
    (
        hybrid::World::NAME,
        sources![
            "hybrid.rs",
            "hybrid/circle.rs",
            "hybrid/orbiter.rs",
            "hybrid/spin.rs",
            "hybrid/spinner.rs",
            "hybrid/spinning_orbiter.rs",
        ],
    ),
];

/// What [`super::living`] added to each style when chapter 5 asked for it. It is not in chapter 1's
/// table; chapter 5 counts it with the rest.
pub const LATER: [(&str, Source); 3] = [
    (
        hierarchy::World::NAME,
        ("hierarchy/living.rs", include_str!("hierarchy/living.rs")),
    ),
    (
        components::World::NAME,
        ("components/living.rs", include_str!("components/living.rs")),
    ),
    (
        hybrid::World::NAME,
        ("hybrid/living.rs", include_str!("hybrid/living.rs")),
    ),
];

/// What the property `glow` cost the style of this name; nothing if there is no such style.
#[must_use]
pub fn of(style: &str) -> Cost {
    let sources = SOURCES.iter().filter(|(name, _)| *name == style);
    let texts = sources.flat_map(|(_, files)| files.iter().map(|(_, text)| *text));
    marked(texts, "glow", None)
}

/// What stands between the marks `mark` in some sources, without what a mark `except` inside sets
/// apart.
#[must_use]
pub fn marked<'a>(
    texts: impl IntoIterator<Item = &'a str>,
    mark: &str,
    except: Option<&str>,
) -> Cost {
    let files = texts.into_iter().map(|text| in_file(text, mark, except));
    files.fold(Cost::default(), |sum, file| Cost {
        changed: sum.changed + file.changed,
        added: sum.added + file.added,
        places: sum.places + file.places,
        lines: sum.lines + file.lines,
    })
}

fn in_file(text: &str, mark: &str, except: Option<&str>) -> Cost {
    let (begin, end) = (
        format!("// ANCHOR: {mark}"),
        format!("// ANCHOR_END: {mark}"),
    );
    let apart = |kind: &str| except.map(|except| format!("// {kind}: {except}"));
    let (begin_apart, end_apart) = (apart("ANCHOR"), apart("ANCHOR_END"));
    let mut cost = Cost::default();
    let (mut inside, mut is_apart) = (false, false);
    for line in text.lines().map(str::trim) {
        if line == begin {
            inside = true;
            cost.places += 1;
        } else if line == end {
            inside = false;
        } else if Some(line) == begin_apart.as_deref() {
            is_apart = true;
        } else if Some(line) == end_apart.as_deref() {
            is_apart = false;
        } else if inside && !is_apart && !line.is_empty() && !line.starts_with("//") {
            cost.lines += 1;
        }
    }
    cost.added = usize::from(text.starts_with(&begin));
    cost.changed = usize::from(cost.places > 0) - cost.added;
    cost
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn code_lines_between_marks_are_counted_and_no_others() {
        let text = "a\n// ANCHOR: glow\n/// doc\nb\n\nc\n// ANCHOR_END: glow\n\
                    d\n  // ANCHOR: glow\n  e\n  // ANCHOR_END: glow\n";
        let cost = in_file(text, "glow", None);
        let expected = Cost {
            changed: 1,
            added: 0,
            places: 2,
            lines: 3,
        };
        assert_eq!(cost, expected);
        assert_eq!(in_file("a\nb\n", "glow", None), Cost::default());
        assert_eq!(in_file("// ANCHOR: glow\na\n", "glow", None).added, 1);
    }

    #[test]
    fn what_is_set_apart_inside_a_mark_is_not_counted_with_it() {
        let text = "// ANCHOR: spin\na\n// ANCHOR: glow\nb\n// ANCHOR_END: glow\n\
                    // ANCHOR: shown\nc\n// ANCHOR_END: shown\n// ANCHOR_END: spin\nd\n";
        assert_eq!(marked([text], "spin", Some("glow")).lines, 2);
        assert_eq!(marked([text], "spin", None).lines, 3);
    }

    #[test]
    fn every_mark_stands_on_a_line_of_its_own_and_has_its_end() {
        let sources = SOURCES.iter().flat_map(|(_, files)| files.iter());
        for (path, text) in sources.chain(LATER.iter().map(|(_, file)| file)) {
            for mark in ["glow", "spinning"] {
                let lines = |kind| {
                    let whole = format!("// {kind}: {mark}");
                    text.lines().filter(|line| line.trim() == whole).count()
                };
                let all = text.matches(&format!(": {mark}\n")).count();
                assert_eq!(lines("ANCHOR"), lines("ANCHOR_END"), "{path}: {mark}");
                assert_eq!(2 * lines("ANCHOR"), all, "{path}: {mark}");
            }
        }
    }

    #[test]
    fn every_source_file_of_a_style_is_counted() {
        let styles = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/styles");
        for (style, sources) in SOURCES {
            let folder = std::fs::read_dir(styles.join(style)).unwrap();
            let later = LATER.iter().filter(|(name, _)| *name == style).count();
            assert_eq!(folder.count() + 1, sources.len() + later, "{style}");
        }
    }
}
