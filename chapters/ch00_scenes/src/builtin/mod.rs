//! The built-in scenes, one file each, and the list of them.

mod balls;
mod bounce;
mod chain;
mod cradle;
mod crowd;
mod door;
mod heavy_on_light;
mod incline;
mod magnets;
mod magnets_on_a_table;
mod mixed;
mod oblique;
mod orrery;
mod pair;
mod parts;
mod pile;
mod ragdoll_field;
pub mod ragdolls;
mod slide;
mod slip_to_roll;
mod slopes;
mod smooth_balls;
mod stack;
mod tops;
mod tunnelling;

use crate::{Scene, SceneError};

/// What `--count` and `--seed` do in a scene that scales.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scaling {
    /// What `--count` counts, in the plural, such as `balls`.
    pub counts: &'static str,
    /// How many there are unless the user says otherwise.
    pub default: u64,
    /// The fewest.
    pub least: u64,
    /// The most.
    pub most: u64,
    /// Whether anything in the scene is random, so that `--seed` (1 unless given) matters.
    pub seeded: bool,
}

/// Where a scene that scales notes its count, in its `meta`.
pub const COUNT: &str = "count";

/// A line of the list: a scene's name, what it shows in one sentence, and how it is built.
struct Entry {
    name: &'static str,
    about: &'static str,
    build: Build,
}

enum Build {
    /// Its bodies are fixed.
    Fixed(fn() -> Scene),
    /// It depends on a count within these limits, and on a seed.
    Scaled(Scaling, fn(u64, u64) -> Scene),
}

const fn fixed(name: &'static str, about: &'static str, build: fn() -> Scene) -> Entry {
    Entry {
        name,
        about,
        build: Build::Fixed(build),
    }
}

const fn scaled(
    name: &'static str,
    about: &'static str,
    scaling: Scaling,
    build: fn(u64, u64) -> Scene,
) -> Entry {
    Entry {
        name,
        about,
        build: Build::Scaled(scaling, build),
    }
}

/// `default` of what is counted, from `least` to `most` of them; nothing is random.
const fn count(counts: &'static str, default: u64, [least, most]: [u64; 2]) -> Scaling {
    Scaling {
        counts,
        default,
        least,
        most,
        seeded: false,
    }
}

/// The same where chance has a part.
const fn seeded(counts: &'static str, default: u64, range: [u64; 2]) -> Scaling {
    Scaling {
        seeded: true,
        ..count(counts, default, range)
    }
}

const LIST: &[Entry] = &[
    scaled(
        "balls",
        "balls of random size and speed fall into an open box (report, Table 1)",
        seeded("balls", 60, [0, 100_000]),
        balls::build,
    ),
    scaled(
        "smooth_balls",
        "the same balls without friction and without spin: the least that a body can need",
        seeded("balls", 60, [0, 100_000]),
        smooth_balls::build,
    ),
    scaled(
        "pile",
        "balls settle into a bed of six layers on a floor that grows with their number",
        seeded("balls", 1000, [1, 1_000_000]),
        pile::build,
    ),
    fixed(
        "pair",
        "two balls of 2 kg and 0.7 kg meet off-centre in free space",
        pair::build,
    ),
    fixed(
        "bounce",
        "one ball falls 4.9 m and bounces without loss",
        || bounce::build("bounce", 1.0),
    ),
    fixed(
        "bounce_half",
        "one ball falls 4.9 m and keeps half its speed at each bounce",
        || bounce::build("bounce_half", 0.5),
    ),
    fixed(
        "orrery",
        "a sun, planets, moons and a moon's moon: nested nodes",
        orrery::build,
    ),
    fixed(
        "tops",
        "a heavy top that precesses, and free tops in gimbals",
        tops::build,
    ),
    fixed(
        "magnets",
        "bar magnets that turn, attract and swing about each other",
        magnets::build,
    ),
    fixed(
        "magnets_on_a_table",
        "bar magnets on a smooth table turn, slide together and hold on to each other",
        magnets_on_a_table::build,
    ),
    scaled(
        "mixed",
        "balls, boxes, capsules and cylinders fall into an open box",
        seeded("bodies", 100, [0, 100_000]),
        mixed::build,
    ),
    scaled(
        "stack",
        "a tower of equal cubes that should stand still",
        count("cubes", 5, [1, 100]),
        |cubes, _| stack::build(cubes),
    ),
    scaled(
        "heavy_on_light",
        "a heavy cube rests on a cube of 1 kg",
        count("times the mass", 100, [1, 1_000_000]),
        |ratio, _| heavy_on_light::build(ratio),
    ),
    fixed(
        "slip_to_roll",
        "a ball that slides at 4 m/s begins to roll, and keeps 5/7 of its speed",
        slip_to_roll::build,
    ),
    fixed(
        "slopes",
        "a ball that rolls down 20 degrees and one that slips down 60",
        slopes::build,
    ),
    fixed(
        "incline",
        "four boxes on slopes about the angle of friction: two stay, two slip",
        incline::build,
    ),
    fixed(
        "slide",
        "thirteen boxes slide to rest in different directions, all equally far",
        slide::build,
    ),
    fixed(
        "oblique",
        "pairs of balls that collide with friction: one sticks, one slips, one is head-on",
        oblique::build,
    ),
    scaled(
        "tunnelling",
        "balls of 9 to 300 m/s fly at a thin wall, and some pass through it unseen",
        count("balls of each speed", 20, [1, 1000]),
        |balls, _| tunnelling::build(balls),
    ),
    scaled(
        "cradle",
        "Newton's cradle: as many balls leave as came in",
        count("balls drawn aside", 1, [1, 4]),
        |aside, _| cradle::build(aside),
    ),
    scaled(
        "chain",
        "a chain with a heavy ball at its end, released from the horizontal",
        count("links", 40, [1, 1000]),
        |links, _| chain::build("chain", links, chain::Start::Horizontal),
    ),
    scaled(
        "chain_hanging",
        "the same chain and ball, hanging at rest",
        count("links", 40, [1, 1000]),
        |links, _| chain::build("chain_hanging", links, chain::Start::Hanging),
    ),
    fixed(
        "door",
        "a door on a hinge, between two stops, and balls that hit it",
        || door::build("door", door::Hung::OnHinge),
    ),
    fixed(
        "door_pins",
        "the same door on two pins, one of which limits the twist",
        || door::build("door_pins", door::Hung::OnPins),
    ),
    scaled(
        "ragdolls",
        "ragdolls stacked above an open box fall into it (report, Table 2)",
        seeded("ragdolls", 5, [0, 1000]),
        ragdolls::build,
    ),
    scaled(
        "ragdoll_field",
        "ragdolls, one to three high, fall low over a floor that grows with their number",
        seeded("ragdolls", 20, [1, 10_000]),
        ragdoll_field::build,
    ),
];

/// The names of the built-in scenes, in the order in which `--help` and the overlay list
/// them.
pub const NAMES: &[&str] = &names();

const fn names() -> [&'static str; LIST.len()] {
    let mut names = [""; LIST.len()];
    let mut i = 0;
    while i < LIST.len() {
        names[i] = LIST[i].name;
        i += 1;
    }
    names
}

/// Builds the scene of this name. `count` and `seed` are for scenes that scale
/// ([`scaling`]).
///
/// # Errors
/// [`SceneError::Unknown`] lists the known names; [`SceneError::Count`] tells the range;
/// [`SceneError::Flag`] where the scene has no use for `count` or `seed`.
pub fn build(name: &str, count: Option<u64>, seed: Option<u64>) -> Result<Scene, SceneError> {
    let entry = find(name).ok_or_else(|| unknown(name))?;
    let refused = |flag, is_for: fn(Scaling) -> bool| SceneError::Flag {
        scene: name.to_owned(),
        flag,
        why: format!("these scenes have one: {}", names_of(is_for)),
    };
    match entry.build {
        Build::Fixed(_) if count.is_some() => Err(refused("count", |_| true)),
        Build::Fixed(_) | Build::Scaled(Scaling { seeded: false, .. }, _) if seed.is_some() => {
            Err(refused("seed", |scaling| scaling.seeded))
        }
        Build::Fixed(build) => Ok(build()),
        Build::Scaled(scaling, build) => {
            let count = count.unwrap_or(scaling.default);
            if (scaling.least..=scaling.most).contains(&count) {
                let mut scene = build(count, seed.unwrap_or(1));
                scene.meta.insert(COUNT.to_owned(), count.into());
                Ok(scene)
            } else {
                Err(SceneError::Count {
                    scene: entry.name,
                    count,
                    least: scaling.least,
                    most: scaling.most,
                    counts: scaling.counts,
                })
            }
        }
    }
}

/// What the scene of this name shows, in one sentence; `None` for an unknown name.
#[must_use]
pub fn about(name: &str) -> Option<&'static str> {
    find(name).map(|entry| entry.about)
}

/// How the scene of this name scales; `None` if its bodies are fixed, and for an unknown
/// name.
#[must_use]
pub fn scaling(name: &str) -> Option<Scaling> {
    match find(name)?.build {
        Build::Fixed(_) => None,
        Build::Scaled(scaling, _) => Some(scaling),
    }
}

fn find(name: &str) -> Option<&'static Entry> {
    LIST.iter().find(|entry| entry.name == name)
}

fn unknown(name: &str) -> SceneError {
    SceneError::Unknown {
        name: name.to_owned(),
        known: NAMES.join(", "),
    }
}

/// The names of the scenes that scale as `is_meant` says, separated by commas.
fn names_of(is_meant: fn(Scaling) -> bool) -> String {
    let meant = |name: &&str| scaling(name).is_some_and(is_meant);
    let names: Vec<_> = NAMES.iter().copied().filter(meant).collect();
    names.join(", ")
}

#[cfg(test)]
mod tests;
