//! What a new property and a new behaviour cost a developer in each architecture, counted from the
//! sources: the lines between marks, as in chapter 1.
//!
//! The property is `glow`. The behaviour is spinning, with the two kinds that do it, but without glow.

use ch01_hierarchy::styles::cost::{Cost, LATER, SOURCES, marked};

macro_rules! sources {
    ($($path:literal),* $(,)?) => { &[$(include_str!($path)),*] };
}

/// The sources of the architectures that chapter 5 adds.
const ADDED: [(&str, &[&str]); 2] = [
    (
        "properties",
        sources![
            "properties.rs",
            "properties/systems.rs",
            "properties/tables.rs"
        ],
    ),
    (
        "ECS",
        sources!["ecs.rs", "ecs/components.rs", "ecs/systems.rs"],
    ),
];

/// An architecture's name and its prices.
pub struct Prices {
    pub architecture: &'static str,
    pub property: Cost,
    pub behaviour: Cost,
}

/// All five.
pub fn all() -> Vec<Prices> {
    let first = SOURCES.iter().map(|(name, files)| {
        let later = LATER.iter().filter(move |(other, _)| other == name);
        let files = files.iter().chain(later.map(|(_, file)| file));
        (*name, files.map(|(_, text)| *text).collect())
    });
    let added = ADDED.iter().map(|(name, texts)| (*name, texts.to_vec()));
    let all = first.chain(added);
    all.map(|(architecture, texts): (_, Vec<&str>)| Prices {
        architecture,
        property: marked(texts.iter().copied(), "glow", None),
        behaviour: marked(texts.iter().copied(), "spinning", Some("glow")),
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn every_architecture_paid_for_both() {
        for prices in all() {
            for cost in [prices.property, prices.behaviour] {
                let name = prices.architecture;
                assert!(
                    cost.changed > 0 && cost.lines > cost.places,
                    "{name}: {cost:?}"
                );
            }
        }
    }

    #[test]
    fn every_source_file_is_counted() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/architectures");
        for (folder, (_, sources)) in ["properties", "ecs"].iter().zip(ADDED) {
            let files = std::fs::read_dir(here.join(folder)).expect("it is there");
            assert_eq!(files.count() + 1, sources.len(), "{folder}");
        }
    }
}
