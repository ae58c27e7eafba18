//! The shaders' texts, put together. WGSL has no include: at the end of a shader's first comment stands
//! what it needs before it, `Needs common/rotation, rows.`, in that order.

use ch05_properties::data::Data;

use super::error::listed;
use super::{StreamError, table_wgsl};
use crate::round_trip::Advance;
use crate::rows;

/// Reads shaders into this program, by their paths below `shaders/`.
macro_rules! shaders {
    ($($file:literal),* $(,)?) => {
        &[$(($file, include_str!(concat!("../../../../shaders/", $file)))),*]
    };
}

/// All that kernels are made of.
const SHADERS: &[(&str, &str)] = shaders![
    "common/articulated.wgsl",
    "common/ball.wgsl",
    "common/body.wgsl",
    "common/contact.wgsl",
    "common/fold.wgsl",
    "common/free_rotation.wgsl",
    "common/grid.wgsl",
    "common/index.wgsl",
    "common/limit.wgsl",
    "common/link.wgsl",
    "common/mouse.wgsl",
    "common/moving.wgsl",
    "common/narrow.wgsl",
    "common/narrow_axis.wgsl",
    "common/narrow_ball.wgsl",
    "common/narrow_capsule.wgsl",
    "common/narrow_contacts.wgsl",
    "common/narrow_convex.wgsl",
    "common/narrow_core.wgsl",
    "common/narrow_edges.wgsl",
    "common/narrow_faces.wgsl",
    "common/narrow_features.wgsl",
    "common/narrow_gjk.wgsl",
    "common/narrow_simplex.wgsl",
    "common/narrow_spots.wgsl",
    "common/narrow_way.wgsl",
    "common/pairing.wgsl",
    "common/point_reply.wgsl",
    "common/rotation.wgsl",
    "common/rotation_vector.wgsl",
    "common/side.wgsl",
    "common/swing_twist.wgsl",
    "common/symmetric.wgsl",
    "common/touching.wgsl",
    "common/tree.wgsl",
    "common/trigonometry.wgsl",
    "ch06_balls.wgsl",
    "ch06_bounce.wgsl",
    "ch06_cells.wgsl",
    "ch06_integrate.wgsl",
    "ch06_limits.wgsl",
    "ch06_loops.wgsl",
    "ch06_neighbours.wgsl",
    "ch06_pair_advance.wgsl",
    "ch06_pair_cells.wgsl",
    "ch06_pair_find.wgsl",
    "ch06_pair_kick.wgsl",
    "ch06_pair_large.wgsl",
    "ch06_pair_list.wgsl",
    "ch06_pair_meet.wgsl",
    "ch06_pair_solve.wgsl",
    "ch06_pair_sort.wgsl",
    "ch06_pair_start.wgsl",
    "ch06_pair_state.wgsl",
    "ch06_pull.wgsl",
    "ch06_state.wgsl",
    "ch06_scan.wgsl",
    "ch06_scatter.wgsl",
    "ch06_sort.wgsl",
    "ch06_tree.wgsl",
];

// ANCHOR: source
/// The text of a shader, behind the texts that it needs: `source("ch06_integrate")`.
///
/// # Errors
/// [`StreamError::UnknownShader`].
pub fn source(name: &str) -> Result<String, StreamError> {
    behind_needs(&text(name)?)
}

/// A shader's text, behind the texts that it needs.
///
/// # Errors
/// [`StreamError::UnknownShader`].
pub fn behind_needs(text: &str) -> Result<String, StreamError> {
    let needed = needs(text).into_iter().map(self::text);
    let mut whole = needed.collect::<Result<Vec<_>, _>>()?;
    whole.push(text.to_owned());
    Ok(whole.join("\n"))
}
// ANCHOR_END: source

/// The names of all shaders that lie in files.
pub fn names() -> impl Iterator<Item = &'static str> {
    SHADERS.iter().map(|(file, _)| name_of(file))
}

/// WGSL that is generated: `rows`, `advance`, and `tables/bodies` for chapter 5's table `bodies`.
#[must_use]
pub fn generated(name: &str) -> Option<String> {
    match name.strip_prefix("tables/") {
        Some(table) => table_wgsl(&Data::default(), table).ok(),
        None if name == "rows" => Some(rows::wgsl()),
        None if name == "advance" => Some(rows::declaration::<Advance>()),
        None => None,
    }
}

/// A text by its name, without those that it needs.
fn text(name: &str) -> Result<String, StreamError> {
    let found = SHADERS.iter().find(|(file, _)| name_of(file) == name);
    let text = match found {
        Some((_, text)) => Some((*text).to_owned()),
        None => generated(name),
    };
    text.ok_or_else(|| StreamError::UnknownShader {
        shader: name.to_owned(),
        known: listed(names().chain(["rows", "advance"])),
    })
}

fn name_of(file: &str) -> &str {
    file.trim_end_matches(".wgsl")
}

/// The names after `Needs` in a shader's first comment.
fn needs(text: &str) -> Vec<&str> {
    let comment = text.lines().map_while(|line| line.strip_prefix("//"));
    let words = comment.flat_map(str::split_whitespace);
    let mut needed = Vec::new();
    for word in words.skip_while(|word| *word != "Needs").skip(1) {
        let name = word.trim_end_matches([',', '.']);
        if name != "and" {
            needed.push(name);
        }
        if word.ends_with('.') {
            break;
        }
    }
    needed
}

#[cfg(test)]
mod tests {
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    use super::*;

    #[test]
    fn what_a_shader_needs_stands_in_its_first_comment() {
        let text = "// Turns.\n// Needs common/a, b\n// and rows. More.\n\n// Needs c.\nfn f() {}";
        assert_eq!(needs(text), ["common/a", "b", "rows"]);
        assert_eq!(needs("fn f() {}"), [""; 0]);
    }

    #[test]
    fn every_shader_is_valid_behind_what_it_needs() {
        for name in names() {
            let source = source(name).unwrap_or_else(|error| panic!("{name}: {error}"));
            let module = naga::front::wgsl::parse_str(&source)
                .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&source)));
            Validator::new(ValidationFlags::all(), Capabilities::default())
                .validate(&module)
                .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&source)));
        }
    }

    #[test]
    fn an_unknown_shader_is_named_with_those_that_there_are() {
        let error = source("ch06_dream")
            .expect_err("no such shader")
            .to_string();
        assert!(
            error.contains("ch06_dream") && error.contains("common/rotation"),
            "{error}"
        );
    }
}
