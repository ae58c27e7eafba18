//! Scene files in and out: the reference's files, the example of the format's page, what
//! is refused and how the error says so, and text that nobody meant.

use ch00_scenes::measures::Measures;
use ch00_scenes::{Joint, Scene, SceneError, Shape, State, builtin};
use proptest::prelude::*;

const FILES: [(&str, &str); 3] = [
    (
        "balls_60",
        include_str!("../../../tests/reference/scenes/balls_60.json"),
    ),
    (
        "half_metre_boxes_15",
        include_str!("../../../tests/reference/scenes/half_metre_boxes_15.json"),
    ),
    (
        "ragdolls_5",
        include_str!("../../../tests/reference/scenes/ragdolls_5.json"),
    ),
];

const EXAMPLE: &str = r#"{
  "name": "pair",
  "gravity": [0, -9.81, 0],
  "dt": 0.016666667,
  "steps": 600,
  "bodies": [
    {"shape": {"box": {"half_extents": [5, 0.5, 5]}}, "mass": 0, "position": [0, -0.5, 0]},
    {"shape": {"sphere": {"radius": 0.2}}, "mass": 1.5,
     "position": [0, 2, 0], "orientation": [0, 0, 0, 1],
     "linear_velocity": [0, 0, 0], "angular_velocity": [0, 0, 0],
     "restitution": 0.95, "friction": 0.5, "static_friction": 0.6}
  ],
  "joints": [],
  "meta": {"anything": ["is", {"kept": true}]}
}"#;

/// A scene with one joint of each kind and a force of each kind.
const JOINTS: &str = r#"{
  "name": "joints", "gravity": [0, 0, 0],
  "bodies": [
    {"shape": {"capsule": {"radius": 0.1, "half_height": 0.2}}, "mass": 1, "position": [0, 0, 0]},
    {"shape": {"cylinder": {"radius": 0.1, "half_height": 0.2}}, "mass": 1, "position": [1, 0, 0]}
  ],
  "joints": [
    {"ball": {"a": 0, "b": 1, "anchor_a": [0.5, 0, 0], "anchor_b": [-0.5, 0, 0],
              "cone": 1, "twist": [-0.1, 0.2], "rest": [0, 0, 0, 1]}},
    {"ball": {"a": 0, "b": 1, "anchor_a": [0.5, 0, 0], "anchor_b": [-0.5, 0, 0],
              "limits": {"pitch": [-1, 1], "yaw": [-0.5, 0.5], "roll": [0, 0]}}},
    {"distance": {"a": 1, "b": 0, "anchor_a": [0, 0, 0], "anchor_b": [0, 0, 0], "length": 1}},
    {"hinge": {"a": 0, "b": 1, "anchor_a": [0.5, 0, 0], "anchor_b": [-0.5, 0, 0],
               "axis_a": [0, 2, 0], "axis_b": [0, 1, 0], "range": [-1, 1]}}
  ],
  "forces": [
    {"fixed_point": {"body": 1, "arm": [0, 0.1, 0]}},
    {"magnets": {"softening": 0.05, "poles": [{"body": 0, "position": [0, 0.2, 0], "strength": 1}]}}
  ],
  "orbits": [{"body": 0, "radius": 1, "rate": 2}]
}"#;

fn load(text: &str) -> Scene {
    Scene::from_json(text, "file.json").unwrap()
}

fn refusal(text: &str) -> String {
    Scene::from_json(text, "file.json").unwrap_err().to_string()
}

#[test]
fn the_files_of_the_reference_load() {
    let counts = FILES.map(|(name, text)| {
        let scene = load(text);
        assert_eq!(scene.name, name);
        (scene.bodies.len(), scene.joints.len())
    });
    assert_eq!(counts, [(65, 0), (16, 0), (65, 55)]);
}

#[test]
fn the_example_of_the_format_loads_with_its_defaults() {
    let scene = load(EXAMPLE);
    let floor = &scene.bodies[0];
    assert!(floor.is_static());
    assert_eq!((floor.restitution, floor.friction), (0.0, 0.5));
    assert_eq!(floor.static_friction(), 0.5);
    assert_eq!(scene.bodies[1].static_friction(), 0.6);
    assert_eq!((scene.drag, scene.restitution_threshold), (0.0, None));
}

#[test]
fn meta_is_kept() {
    let scene = load(&load(EXAMPLE).to_json());
    assert_eq!(scene.meta["anything"][1]["kept"], true);
}

#[test]
fn every_scene_comes_back_from_json_as_it_went() {
    let texts = FILES.map(|(_, text)| text);
    let from_files = texts.into_iter().chain([EXAMPLE, JOINTS]).map(load);
    let built = builtin::NAMES
        .iter()
        .map(|name| builtin::build(name, None, None).unwrap());
    for scene in from_files.chain(built) {
        assert_eq!(load(&scene.to_json()), scene, "{}", scene.name);
    }
}

#[test]
fn an_axis_is_given_unit_length() {
    let Joint::Hinge { axis_a, .. } = load(JOINTS).joints[3] else {
        panic!("the fourth joint is the hinge");
    };
    assert_eq!(axis_a.to_array(), [0.0, 1.0, 0.0]);
}

#[test]
fn a_quaternion_that_is_nearly_of_unit_length_is_made_so() {
    let text = EXAMPLE.replace("[0, 0, 0, 1]", "[0, 0, 0, 1.0009]");
    assert_eq!(load(&text).bodies[1].orientation.w, 1.0);
}

#[test]
fn an_unknown_field_is_named_with_its_place() {
    let message = refusal(&EXAMPLE.replace("\"friction\"", "\"fricton\""));
    assert!(
        message.starts_with("file.json: at `bodies[1].fricton`, line 11, column "),
        "{message}"
    );
    assert!(message.contains("unknown field `fricton`"), "{message}");
}

#[test]
fn an_unknown_field_of_the_scene_a_shape_and_a_joint_is_an_error() {
    for (from, to) in [
        ("\"gravity\"", "\"gravitas\""),
        ("\"half_height\"", "\"height\""),
        ("\"axis_b\"", "\"axis\""),
        ("\"softening\"", "\"softness\""),
    ] {
        let message = refusal(&JOINTS.replace(from, to));
        assert!(message.contains(&format!("unknown field `{}`", &to[1..to.len() - 1])));
    }
}

#[test]
fn a_missing_field_is_named_with_its_place() {
    let message = refusal(&EXAMPLE.replace("\"mass\": 1.5,", ""));
    assert!(message.contains("at `bodies[1]`"), "{message}");
    assert!(message.contains("missing field `mass`"), "{message}");
}

#[test]
fn a_word_for_a_number_is_named_with_its_place() {
    let message = refusal(&EXAMPLE.replace("1.5", "\"heavy\""));
    assert!(message.contains("at `bodies[1].mass`"), "{message}");
}

#[test]
fn not_a_number_and_numbers_too_large_are_no_json() {
    for number in ["NaN", "Infinity", "1e999"] {
        let message = refusal(&EXAMPLE.replace("1.5", number));
        assert!(message.contains("at `bodies[1].mass`"), "{message}");
    }
}

#[test]
fn a_negative_mass_names_file_index_and_field() {
    let message = refusal(&EXAMPLE.replace("1.5", "-1.5"));
    assert!(
        message.starts_with("file.json: bodies[1].mass = -1.5: "),
        "{message}"
    );
}

#[test]
fn text_after_the_scene_is_an_error() {
    let message = refusal(&format!("{EXAMPLE} {{}}"));
    assert!(message.contains("trailing characters"), "{message}");
}

#[test]
fn text_that_breaks_off_is_an_error() {
    let message = refusal(&EXAMPLE[..EXAMPLE.len() / 2]);
    assert!(message.contains("EOF"), "{message}");
}

#[test]
fn a_name_that_ends_in_json_is_a_file_and_a_missing_one_is_named() {
    let error = Scene::open("no/such.json", None, None).unwrap_err();
    assert!(matches!(error, SceneError::Read { .. }), "{error}");
    assert!(error.to_string().starts_with("no/such.json: can't read: "));
}

#[test]
fn a_count_beside_a_file_is_refused() {
    let message = Scene::open("some.json", Some(3), None)
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("`some.json` has no `--count`"),
        "{message}"
    );
}

#[test]
fn a_built_in_scene_opens_with_its_count() {
    let scene = Scene::open("balls", Some(7), Some(2)).unwrap();
    assert_eq!(scene.dynamic_count(), 7);
}

#[test]
fn a_file_opens_by_its_path() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/scenes/balls_60.json"
    );
    let scene = Scene::open(path, None, None).unwrap();
    assert_eq!(scene.bodies[5].shape, Shape::Sphere { radius: 0.133_519 });
}

/// Loads text that may be anything; what loads is measured too.
fn use_it(text: &str) {
    if let Ok(scene) = Scene::from_json(text, "fuzz.json") {
        let _ = Measures::of(&scene, &State::start_of(&scene));
    }
}

/// Things that a slip of an editor may leave in a file.
fn fragment() -> impl Strategy<Value = String> {
    prop_oneof![
        Just(String::new()),
        "[\\[\\]{}\",:0-9eE.-]{1,4}",
        "\\PC{1,3}",
        Just("1e308".to_owned()),
        Just("-0".to_owned()),
        Just("null".to_owned()),
        Just("18446744073709551616".to_owned()),
        Just("[0, 0, 0, 0]".to_owned()),
    ]
}

proptest! {
    #[test]
    fn no_spoilt_text_panics(
        text in prop_oneof![Just(EXAMPLE), Just(JOINTS)],
        spoils in prop::collection::vec((any::<prop::sample::Index>(), 0_usize..6, fragment()), 1..4),
    ) {
        let mut text: Vec<char> = text.chars().collect();
        for (at, removed, fragment) in spoils {
            let at = at.index(text.len() + 1);
            let end = (at + removed).min(text.len());
            text.splice(at..end, fragment.chars());
        }
        use_it(&text.into_iter().collect::<String>());
    }

    #[test]
    fn no_number_in_any_place_panics(
        place in any::<prop::sample::Index>(),
        number in prop_oneof![
            any::<f64>().prop_map(|number| number.to_string()),
            any::<i64>().prop_map(|number| number.to_string()),
            (-3_i32..4).prop_map(|number| number.to_string()),
        ],
        text in prop_oneof![Just(EXAMPLE), Just(JOINTS)],
    ) {
        // Each word between these marks is a candidate.
        let is_mark = |c: char| matches!(c, ',' | ' ' | '[' | ']' | '}' | '\n');
        let words: Vec<_> = text.match_indices(|c: char| c.is_ascii_digit()).collect();
        let (start, _) = words[place.index(words.len())];
        let end = text[start..].find(is_mark).map_or(text.len(), |length| start + length);
        let begin = text[..start].rfind(is_mark).map_or(0, |mark| mark + 1);
        use_it(&format!("{}{number}{}", &text[..begin], &text[end..]));
    }

    #[test]
    fn numbers_keep_every_digit(x in any::<f64>().prop_filter("fits f32", |x| x.abs() < 1e38)) {
        let mut scene = load(EXAMPLE);
        scene.bodies[1].position.x = x;
        prop_assert_eq!(load(&scene.to_json()), scene);
    }
}
