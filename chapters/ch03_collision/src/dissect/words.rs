//! What an iteration did, in two or three lines with its numbers.

use super::{ROUNDED, Run};
use crate::narrow::Touch;
use crate::narrow::simplex::Simplex;

/// A length in millimetres, or in metres if it is long.
fn mm(length: f32) -> String {
    if length.abs() < 1.0 {
        format!("{:.2} mm", 1e3 * length)
    } else {
        format!("{length:.3} m")
    }
}

/// GJK, where the solids are between `low` and `high` apart so far.
pub fn gjk_words(
    simplex: &Simplex,
    at_least: f32,
    is_last: bool,
    [low, high]: [f32; 2],
    run: &Run,
) -> String {
    let carrier = match simplex.vertices().len() {
        1 => "a vertex",
        2 => "an edge",
        _ => "a triangle",
    };
    let distance = mm(simplex.nearest().length());
    let bound = if at_least > 0.0 {
        let at_least = mm(at_least);
        format!("The plane through w tells that nothing is nearer than {at_least}.")
    } else {
        "w lies beyond the origin: the two may well overlap.".to_owned()
    };
    let next = if is_last {
        format!(
            "So v is the nearest point, and GJK ends: {}",
            gjk_answer(high, run)
        )
    } else {
        format!("Still unknown: {}. w joins the simplex.", mm(high - low))
    };
    format!("v, on {carrier} of the simplex, is {distance} from the origin. {bound}\n{next}")
}

/// What follows for the solids, which reach beyond their cores.
fn gjk_answer(distance: f32, run: &Run) -> String {
    let (radii, apart) = (mm(run.radii()), mm(distance));
    if run.name == ROUNDED {
        format!(
            "less skins of {radii}, the rounded solids have a distance of {apart}. The sharp ones \
             have no more."
        )
    } else if run.radii() == 0.0 {
        format!("the solids are {apart} apart.")
    } else if distance < 0.0 {
        let depth = mm(-distance);
        format!("less radii of {radii}, the solids overlap by {depth}. No need for EPA.")
    } else {
        format!("less radii of {radii}, the solids are {apart} apart.")
    }
}

/// GJK's end in the origin.
pub fn held_words(simplex: &Simplex, run: &Run) -> String {
    let held = match simplex.vertices().len() {
        4 => "The tetrahedron holds the origin",
        _ => "The simplex passes through the origin",
    };
    let next = if run.name == ROUNDED {
        "Even without their skins the two overlap. Next: the sharp solids."
    } else {
        "GJK can't say how deep; EPA goes on from this simplex."
    };
    format!("{held}: some point of a is a point of b, so the two overlap.\n{next}")
}

/// EPA, whose nearest face is at `distance` and its support point at `found`, m.
pub fn epa_words(faces: usize, distance: f32, found: f32, is_last: bool) -> String {
    let next = if is_last {
        "No further: this face is on the surface, and its normal is the shortest way apart."
    } else {
        "The faces that see w go, and their rim is joined to w."
    };
    format!(
        "The polytope has {faces} faces; the nearest is {} from the origin. The support point w \
         along its normal is {} out: {} further.\n{next}",
        mm(distance),
        mm(found),
        mm((found - distance).max(0.0))
    )
}

/// The answer, and which way the engine takes to it.
pub fn touch_words(touch: Option<&Touch>, way: &str) -> String {
    let Some(touch) = touch else {
        return "The two are too far apart for a touch.".to_owned();
    };
    let [x, y, z] = touch.normal.to_array();
    let count = touch.spots().len();
    let depth = touch.depth();
    let deep = match (depth < 0.0, count) {
        (true, 1) => format!("a gap of {}", mm(-depth)),
        (true, _) => format!("the least gap {}", mm(-depth)),
        (false, 1) => format!("{} deep", mm(depth)),
        (false, _) => format!("the deepest {} deep", mm(depth)),
    };
    let points = if count == 1 { "point" } else { "points" };
    format!(
        "Normal ({x:.3}, {y:.3}, {z:.3}), from b to a; {count} contact {points}, {deep}.\n\
         The engine gets here {way}."
    )
}
