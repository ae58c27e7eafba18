//! What the property `glow` cost a developer in each style, counted from the sources.

use super::{Style, components, hierarchy, hybrid};

/// A source file: path below `src/styles`, and text.
type Source = (&'static str, &'static str);

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

/// What the marked property cost the style of this name; nothing if there is no such style.
#[must_use]
pub fn of(style: &str) -> Cost {
    let sources = SOURCES.iter().filter(|(name, _)| *name == style);
    sources
        .flat_map(|(_, files)| files.iter())
        .map(|(_, text)| in_file(text))
        .fold(Cost::default(), |sum, file| Cost {
            changed: sum.changed + file.changed,
            added: sum.added + file.added,
            places: sum.places + file.places,
            lines: sum.lines + file.lines,
        })
}

fn in_file(text: &str) -> Cost {
    let mut cost = Cost::default();
    let mut inside = false;
    for line in text.lines().map(str::trim) {
        match line {
            "// ANCHOR: glow" => {
                inside = true;
                cost.places += 1;
            }
            "// ANCHOR_END: glow" => inside = false,
            _ if inside && !line.is_empty() && !line.starts_with("//") => cost.lines += 1,
            _ => {}
        }
    }
    cost.added = usize::from(text.starts_with("// ANCHOR: glow"));
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
        let cost = in_file(text);
        let expected = Cost {
            changed: 1,
            added: 0,
            places: 2,
            lines: 3,
        };
        assert_eq!(cost, expected);
        assert_eq!(in_file("a\nb\n"), Cost::default());
        assert_eq!(in_file("// ANCHOR: glow\na\n").added, 1);
    }

    #[test]
    fn every_source_file_of_a_style_is_counted() {
        let styles = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/styles");
        for (style, sources) in SOURCES {
            let folder = std::fs::read_dir(styles.join(style)).unwrap();
            assert_eq!(folder.count() + 1, sources.len(), "{style}");
        }
    }
}
