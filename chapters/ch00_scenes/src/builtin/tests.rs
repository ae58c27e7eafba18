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
fn every_scene_that_scales_is_valid_from_its_fewest_to_a_thousand() {
    for name in NAMES {
        let Some(scaling) = scaling(name) else {
            continue;
        };
        for count in [scaling.least, scaling.most.min(1000)] {
            let scene = build(name, Some(count), None).unwrap();
            scene.validate(name).unwrap();
        }
    }
}

#[test]
fn no_two_scenes_have_one_name() {
    for (i, name) in NAMES.iter().enumerate() {
        assert!(!NAMES[..i].contains(name), "{name}");
    }
}

#[test]
fn an_unknown_name_is_answered_with_the_known_ones() {
    let message = build("bals", None, None).unwrap_err().to_string();
    assert!(message.contains("`bals`"), "{message}");
    assert!(
        message.contains("balls, smooth_balls, pile, pair, bounce"),
        "{message}"
    );
}

#[test]
fn a_scene_of_fixed_bodies_refuses_a_count_and_names_those_that_scale() {
    let message = build("pair", Some(3), None).unwrap_err().to_string();
    assert_eq!(
        message,
        "scene `pair` has no `--count`: these scenes have one: balls, smooth_balls, pile, \
         mixed, stack, heavy_on_light, tunnelling, cradle, chain, chain_hanging, ragdolls, \
         ragdoll_field"
    );
}

#[test]
fn a_scene_without_chance_refuses_a_seed_and_names_those_with_it() {
    for name in ["tops", "chain"] {
        let message = build(name, None, Some(3)).unwrap_err().to_string();
        assert_eq!(
            message,
            format!(
                "scene `{name}` has no `--seed`: these scenes have one: balls, smooth_balls, \
                 pile, mixed, ragdolls, ragdoll_field"
            )
        );
    }
}

#[test]
fn a_count_out_of_range_is_refused_with_the_range_and_what_it_counts() {
    for (name, count, expected) in [
        ("balls", 100_001, "it can have 0 to 100000 balls"),
        ("smooth_balls", 100_001, "it can have 0 to 100000 balls"),
        ("ragdolls", 1001, "it can have 0 to 1000 ragdolls"),
        ("pile", 0, "it can have 1 to 1000000 balls"),
        ("ragdoll_field", 10_001, "it can have 1 to 10000 ragdolls"),
        ("stack", 0, "it can have 1 to 100 cubes"),
        ("chain", 0, "it can have 1 to 1000 links"),
    ] {
        let message = build(name, Some(count), None).unwrap_err().to_string();
        let start = format!("scene `{name}`: --count {count}: ");
        assert_eq!(message, start + expected);
    }
}
