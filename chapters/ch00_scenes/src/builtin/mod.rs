//! The built-in scenes, one file each.

mod balls;
mod bounce;
mod magnets;
mod orrery;
mod pair;
mod tops;

use crate::{Scene, SceneError};

/// The names of the built-in scenes, in the order in which `--help` and the overlay list
/// them.
pub const NAMES: &[&str] = &[
    "balls",
    "pair",
    "bounce",
    "bounce_half",
    "orrery",
    "tops",
    "magnets",
];

/// Bodies that `balls` has at most.
pub const MOST_BALLS: u64 = 100_000;

/// Builds the scene of this name. `count` and `seed` are for scenes that scale (`balls`:
/// 60 balls and seed 1 unless given).
///
/// # Errors
/// [`SceneError::Unknown`] lists the known names; [`SceneError::Count`] tells the range;
/// [`SceneError::Flag`] where the scene has no use for `count` or `seed`.
pub fn build(name: &str, count: Option<u64>, seed: Option<u64>) -> Result<Scene, SceneError> {
    if name == "balls" {
        return balls::build(count.unwrap_or(60), seed.unwrap_or(1));
    }
    let scene = match name {
        "pair" => pair::build(),
        "bounce" => bounce::build("bounce", 1.0),
        "bounce_half" => bounce::build("bounce_half", 0.5),
        "orrery" => orrery::build(),
        "tops" => tops::build(),
        "magnets" => magnets::build(),
        _ => return Err(unknown(name)),
    };
    refuse(&scene.name, "count", count.is_some())?;
    refuse(&scene.name, "seed", seed.is_some())?;
    Ok(scene)
}

/// What the scene of this name shows, in one sentence; `None` for an unknown name.
#[must_use]
pub fn about(name: &str) -> Option<&'static str> {
    Some(match name {
        "balls" => "balls of random size and speed fall into an open box (report, Table 1)",
        "pair" => "two balls of 2 kg and 0.7 kg meet off-centre in free space",
        "bounce" => "one ball falls 4.9 m and bounces without loss",
        "bounce_half" => "one ball falls 4.9 m and keeps half its speed at each bounce",
        "orrery" => "a sun, planets, moons and a moon's moon: nested nodes",
        "tops" => "a heavy top that precesses, and free tops in gimbals",
        "magnets" => "bar magnets that turn, attract and swing about each other",
        _ => return None,
    })
}

fn unknown(name: &str) -> SceneError {
    SceneError::Unknown {
        name: name.to_owned(),
        known: NAMES.join(", "),
    }
}

fn refuse(scene: &str, flag: &'static str, given: bool) -> Result<(), SceneError> {
    if !given {
        return Ok(());
    }
    Err(SceneError::Flag {
        scene: scene.to_owned(),
        flag,
        why: "its bodies are fixed; only `balls` scales",
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_builds_a_valid_scene_of_that_name() {
        for name in NAMES {
            let scene = build(name, None, None).unwrap();
            assert_eq!(&scene.name, name);
            scene.validate(name).unwrap();
        }
    }

    #[test]
    fn every_name_says_what_it_shows() {
        assert!(NAMES.iter().all(|name| about(name).is_some()));
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_known_ones() {
        let message = build("bals", None, None).unwrap_err().to_string();
        assert!(message.contains("`bals`"), "{message}");
        assert!(message.contains("balls, pair, bounce"), "{message}");
    }

    #[test]
    fn a_scene_of_fixed_bodies_refuses_a_count_and_a_seed() {
        let message = build("pair", Some(3), None).unwrap_err().to_string();
        assert!(message.contains("`pair` has no `--count`"), "{message}");
        let message = build("tops", None, Some(3)).unwrap_err().to_string();
        assert!(message.contains("`tops` has no `--seed`"), "{message}");
    }
}
