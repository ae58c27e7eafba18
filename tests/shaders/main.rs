//! Every shader parses and validates with naga, without a graphics card.
//!
//! WGSL has no include. A shader that uses others says so at the end of its first comment,
//! `Needs common/rotation, ch00_frame.`, in the order in which the Rust side puts them before it. Some
//! texts, such as `rows`, are generated: chapter 6 knows those.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Every shader below `shaders/`, by its name: `common/rotation`, `ch00_frame`.
fn shaders() -> BTreeMap<String, String> {
    let root = tests::root().join("shaders");
    let mut found = BTreeMap::new();
    for path in tests::files_below(&root) {
        if path.extension().is_some_and(|e| e == "wgsl") {
            let name = tests::relative(&path.with_extension(""), &root);
            found.insert(name, read(&path));
        }
    }
    assert!(!found.is_empty(), "no shader below {}", root.display());
    found
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The shaders that a shader's first comment names after `Needs`.
fn needs(text: &str) -> Vec<String> {
    let comment: Vec<&str> = text
        .lines()
        .map_while(|line| line.strip_prefix("//"))
        .map(str::trim)
        .collect();
    let comment = comment.join(" ");
    let Some((_, list)) = comment.split_once("Needs ") else {
        return Vec::new();
    };
    let list = list.split_once('.').map_or(list, |(list, _)| list);
    list.split([',', ' '])
        .filter(|word| !word.is_empty() && *word != "and")
        .map(ToOwned::to_owned)
        .collect()
}

/// Parses and validates a shader behind the ones that it needs; the error names file and line.
fn check(name: &str, shaders: &BTreeMap<String, String>) -> Result<(), String> {
    let mut source = String::new();
    for needed in needs(&shaders[name]) {
        let text = shaders.get(&needed).cloned();
        source += &text
            .or_else(|| ch06_compute::stream::generated(&needed))
            .ok_or(format!("{name}: needs `{needed}`, which is no shader"))?;
    }
    let before = source.lines().count();
    source += &shaders[name];
    let module = naga::front::wgsl::parse_str(&source).map_err(|e| {
        let line = e.location(&source).map_or(0, |l| l.line_number as usize);
        let line = line.saturating_sub(before);
        format!("{name}.wgsl:{line}: {}", e.emit_to_string(&source))
    })?;
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(&module)
        .map(|_| ())
        .map_err(|e| format!("{name}: {}", e.emit_to_string(&source)))
}

#[test]
fn every_shader_is_valid() {
    let shaders = shaders();
    let errors: Vec<String> = shaders
        .keys()
        .filter_map(|name| check(name, &shaders).err())
        .collect();
    assert!(errors.is_empty(), "\n{}", errors.join("\n"));
}

#[test]
fn every_shader_is_used() {
    let rust: Vec<PathBuf> = tests::files_below(&tests::root().join("chapters"));
    let rust: String = rust
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
        .map(|path| read(path))
        .collect();
    let unused: Vec<String> = shaders()
        .into_keys()
        .filter(|name| !rust.contains(&format!("{name}.wgsl")))
        .collect();
    assert!(unused.is_empty(), "no chapter includes {unused:?}");
}

#[test]
fn a_mistake_is_found_in_its_file() {
    let shaders: BTreeMap<String, String> = [
        ("one", "fn one() -> f32 {\n    return 1.0;\n}\n"),
        (
            "good",
            "// Two.\n// Needs one.\nfn two() -> f32 { return 2.0 * one(); }\n",
        ),
        ("forgets", "fn two() -> f32 { return 2.0 * one(); }\n"),
        ("dreams", "// Needs three.\n"),
        (
            "bad_type",
            "// Needs one.\n\nfn two() -> u32 { return one(); }\n",
        ),
        ("bad_word", "// Needs one.\nfunction two() {}\n"),
    ]
    .map(|(name, text)| (name.to_owned(), text.to_owned()))
    .into();
    assert_eq!(check("good", &shaders), Ok(()));
    let error = |name| check(name, &shaders).expect_err(name);
    assert!(error("forgets").contains("one"));
    assert!(error("dreams").contains("`three`, which is no shader"));
    assert!(error("bad_type").contains("two"));
    assert!(error("bad_word").contains("bad_word.wgsl:2"));
}
