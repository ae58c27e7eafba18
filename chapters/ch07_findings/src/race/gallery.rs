//! Races worth seeing: a scene, who takes part, what to watch, and the page of the book that explains it.

use ch00_shell::Sight;

/// A race of the gallery.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// As `--race` says it.
    pub name: &'static str,
    /// Name of a built-in scene.
    pub scene: &'static str,
    /// What `--count` is, in a scene that has it.
    pub count: Option<u64>,
    /// As `--race` says them.
    pub contenders: &'static str,
    /// What to watch, in one sentence.
    pub watch: &'static str,
    /// The page of the book, and its title.
    pub page: (&'static str, &'static str),
    /// From where it is seen, where that is nearer than all of the scene.
    pub sight: Option<Sight>,
}

impl Setup {
    /// Seen so that a box from corner to corner fills the picture, from these angles, rad.
    const fn seen(mut self, low: [f32; 3], high: [f32; 3], [yaw, pitch]: [f32; 2]) -> Self {
        self.sight = Some(Sight {
            low,
            high,
            yaw,
            pitch,
        });
        self
    }
}

const fn setup(
    name: &'static str,
    (scene, count): (&'static str, Option<u64>),
    contenders: &'static str,
    watch: &'static str,
    page: (&'static str, &'static str),
) -> Setup {
    Setup {
        name,
        scene,
        count,
        contenders,
        watch,
        page,
        sight: None,
    }
}

const ERRATA: (&str, &str) = ("errata", "Errata");
const IMPULSES: (&str, &str) = ("ch03_impulses", "Impulses");
const FRICTION: (&str, &str) = ("ch03_friction", "Friction");
const LIMITS: (&str, &str) = ("ch03_limits", "What it costs, and where it ends");
const RAGDOLLS: (&str, &str) = ("ch04_ragdolls", "Ragdolls");
const TREES: (&str, &str) = ("ch06_ragdolls", "Ragdolls, solved whole");
const OWN_ROW: (&str, &str) = ("ch06_own_row", "A step in which every row writes itself");
const LANES: (&str, &str) = ("ch06_lanes", "The same step on lanes and threads");

/// The races, the simplest first.
pub const GALLERY: &[Setup] = &[
    // ANCHOR: gallery
    setup(
        "bounce",
        ("bounce", None),
        "objects:printed,objects:corrected,lanes",
        "Without loss the ball should come back to the height that it fell from: after ten seconds one of them doesn't.",
        IMPULSES,
    ),
    setup(
        "slip_to_roll",
        ("slip_to_roll", None),
        "objects:printed,objects:corrected,lanes",
        "Friction should turn the sliding ball until it rolls, at 5/7 of its speed; the report left friction open, so the printed ball slides on.",
        FRICTION,
    )
    .seen([-0.5, 0.0, -0.8], [11.5, 1.0, 0.8], [0.25, 0.3]),
    // ANCHOR_END: gallery
    setup(
        "oblique",
        ("oblique", None),
        "objects:printed,objects:corrected,lanes",
        "Watch where the balls go after they have met: half of an impulse, shared by mass, loses momentum wherever the masses differ.",
        ERRATA,
    ),
    setup(
        "cradle",
        ("cradle", Some(2)),
        "properties:printed,properties:corrected,lanes:own-row,lanes:coloured",
        "As many balls should leave as came in: watch whether those in the middle hang still.",
        RAGDOLLS,
    )
    .seen([-0.75, 0.4, -0.2], [0.75, 1.02, 0.2], [0.3, 0.15]),
    setup(
        "balls",
        ("balls", Some(300)),
        "objects,properties,lanes:own-row,lanes:coloured",
        "Objects and properties show the same picture, to the last bit: only their times differ.",
        ("ch05_engine", "The engine on columns"),
    ),
    setup(
        "stack",
        ("stack", Some(15)),
        "properties:printed,properties:corrected,lanes@10,lanes@20",
        "A tower should stand still: watch how far its cubes sink into each other, and who throws it over.",
        LIMITS,
    ),
    setup(
        "heavy_on_light",
        ("heavy_on_light", Some(100)),
        "properties:printed,properties:corrected,lanes@10,lanes@20",
        "The heavy cube should rest on one of a hundredth of its mass: watch who squeezes it out, and the overlap of the others.",
        OWN_ROW,
    ),
    setup(
        "chain",
        ("chain", Some(40)),
        "properties:printed,properties:corrected,lanes@10,lanes@16",
        "Forty links hold a ball of 672 times their mass: watch the widest joint, more than a metre here and a fraction of a millimetre there.",
        TREES,
    )
    .seen([-10.5, 1.6, -1.0], [10.5, 12.8, 1.0], [0.15, 0.1]),
    setup(
        "tunnelling",
        ("tunnelling", None),
        "objects:printed,objects:corrected,lanes",
        "Balls fly at a thin wall, the slowest at 9 m/s below, the fastest at 300 m/s on top: who came through is gone, and those who were held are a bar chart.",
        LIMITS,
    )
    .seen([-0.4, 0.0, -3.0], [0.4, 2.1, 3.0], [-1.1, 0.2]),
    setup(
        "ragdolls",
        ("ragdolls", Some(5)),
        "properties:corrected,lanes:own-row,lanes:coloured,compute",
        "Ragdolls fall on each other: watch the joints, and what a step costs.",
        TREES,
    )
    .seen([-0.9, 0.0, -0.9], [0.9, 2.6, 0.9], [0.6, 0.3]),
    setup(
        "tops",
        ("tops", None),
        "objects:printed,objects:corrected,lanes",
        "Nothing brakes these tops, so their energy should stay: the printed method turns them as no body turns, and loses almost half of it.",
        ("ch02_rigid_bodies", "Rigid bodies"),
    ),
    setup(
        "gyroscope",
        ("tops", None),
        "methods:constant-spin,methods:explicit-gyro,methods:implicit-gyro,methods:splitting",
        "Four ways to turn a body that is no ball: one turns it evenly, one ends in no number, one brakes it, and one is right.",
        ERRATA,
    ),
    setup(
        "solvers",
        ("chain", Some(40)),
        "properties:corrected,methods:sequential-impulses,methods:xpbd,lanes@16",
        "The same chain by what is in use elsewhere: watch the widest joint, and how much of its height the ball comes back to.",
        TREES,
    )
    .seen([-10.5, 1.6, -1.0], [10.5, 12.8, 1.0], [0.15, 0.1]),
    setup(
        "pile",
        ("pile", Some(2000)),
        "properties,lanes:own-row,lanes:coloured",
        "Two thousand balls settle: the same bed, and the time of a step is the difference.",
        LANES,
    ),
];

/// The race of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Setup> {
    GALLERY.iter().find(|setup| setup.name == name)
}

/// The names, separated by commas.
#[must_use]
pub fn names() -> String {
    let names: Vec<_> = GALLERY.iter().map(|setup| setup.name).collect();
    names.join(", ")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::race::of_gallery;

    #[test]
    fn every_race_of_the_gallery_can_be_run() {
        for setup in GALLERY {
            let mut race = of_gallery(setup).expect(setup.name);
            race.check_settings().expect(setup.name);
            race.step_all();
            race.measure();
            assert_eq!(race.steps(), 1);
        }
    }

    #[test]
    fn names_are_not_those_of_engines_and_none_stands_twice() {
        for (i, setup) in GALLERY.iter().enumerate() {
            assert!(crate::CHAPTER.engine(setup.name).is_err());
            assert!(GALLERY[..i].iter().all(|other| other.name != setup.name));
            assert!(setup.watch.ends_with('.') && !setup.watch.contains(". "));
        }
    }

    #[test]
    fn every_page_is_in_the_book_with_this_title() {
        let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src");
        for setup in GALLERY {
            let (page, title) = setup.page;
            let file = pages.join(page).with_extension("md");
            let text = std::fs::read_to_string(&file).expect(page);
            let heading = text.lines().next().unwrap_or_default();
            assert!(heading.ends_with(title), "{page}: {heading}");
        }
    }
}
