//! What an iteration did, in two or three lines with its numbers.

use super::runs::{Aim, Decision, End, Part, Run};
use crate::narrow::Touch;
use crate::narrow::epa::Penetration;
use crate::narrow::shortest_way::{ShortestWay, Side, VAGUE};
use crate::narrow::simplex::Simplex;
use crate::narrow::support_point::extent;

/// A length in millimetres, or in metres if it is long.
fn mm(length: f32) -> String {
    if length.abs() < 1.0 {
        format!("{:.2} mm", 1e3 * length)
    } else {
        format!("{length:.3} m")
    }
}

/// Such as `are 3.00 mm apart`.
fn apart(distance: f32) -> String {
    if distance < 0.0 {
        format!("overlap by {}", mm(-distance))
    } else {
        format!("are {} apart", mm(distance))
    }
}

/// Such as `are at least 3.00 mm apart`.
fn apart_at_least(distance: f32) -> String {
    if distance < 0.0 {
        format!("overlap by at most {}", mm(-distance))
    } else {
        format!("are at least {} apart", mm(distance))
    }
}

/// Such as `are at most 3.00 mm apart`.
fn apart_at_most(distance: f32) -> String {
    if distance < 0.0 {
        format!("overlap by at least {}", mm(-distance))
    } else {
        format!("are at most {} apart", mm(distance))
    }
}

fn name(side: Option<Side>) -> &'static str {
    match side {
        Some(Side::A) => "a",
        Some(Side::B) => "b",
        None => "neither",
    }
}

/// The leading face.
pub fn faces_words(face: &ShortestWay) -> String {
    let side = name(face.face);
    let along = apart(face.separation);
    let next = if face.separation > 0.0 {
        "So they are at least that far apart. If it is more than the engine's margin for the pair, \
         nothing else is computed."
    } else {
        "So they overlap by no more than that. No face keeps them apart: next is GJK."
    };
    format!(
        "The leading face is one of {side}'s: along its normal the two {along}, and along no other \
         face's are they clearly further apart.\n{next}"
    )
}

/// GJK, where the solids are between `low` and `high` apart so far.
pub fn gjk_words(
    simplex: &Simplex,
    at_least: f32,
    end: Option<End>,
    [low, high]: [f32; 2],
    run: &Run,
) -> String {
    let carrier = match simplex.vertices().len() {
        1 => "a vertex",
        2 => "an edge",
        _ => "a triangle",
    };
    let v = simplex.nearest().length();
    let distance = mm(v);
    let bound = if at_least > 0.0 {
        let at_least = mm(at_least);
        format!("The plane through w tells that nothing is nearer than {at_least}.")
    } else {
        "w lies beyond the origin, which may well be inside.".to_owned()
    };
    let next = match (end, run.part) {
        (Some(end), Part::Skin { side, says }) => skin_answer(end, side, says, [at_least, v], run),
        (Some(_), _) => format!(
            "So v is the nearest point. {}",
            gjk_answer(simplex, high, run)
        ),
        (None, Part::Skin { side, .. }) => {
            let (whose, high) = (name(Some(side)), apart_at_most(high));
            format!("With {whose} rounded, the two {high}. w joins the simplex.")
        }
        (None, _) => format!("Still unknown: {}. w joins the simplex.", mm(high - low)),
    };
    format!("v, on {carrier} of the simplex, is {distance} from the origin. {bound}\n{next}")
}

/// What follows for the solids, which reach beyond their cores.
fn gjk_answer(simplex: &Simplex, distance: f32, run: &Run) -> String {
    let found = apart(distance);
    let found = if run.radii() == 0.0 {
        format!("The solids {found}")
    } else {
        format!("Less radii of {}, the solids {found}", mm(run.radii()))
    };
    let is_vague = simplex.nearest().length() <= VAGUE * extent(&run.a, &run.b);
    match run.part {
        Part::Gjk(Aim::Study) => format!("{found}; but the engine has a closed form."),
        _ if is_vague => {
            "That is too little to give v a direction: they are taken for overlapping, and next is the skin."
                .to_owned()
        }
        _ => format!("{found}. That decides: no need for the skin or EPA."),
    }
}

/// What GJK under the skin of one side says about its face.
fn skin_answer(end: End, side: Side, says: f32, [at_least, v]: [f32; 2], run: &Run) -> String {
    let whose = name(Some(side));
    let says = apart(says);
    match end {
        End::Far => format!(
            "With {whose} rounded, the two {}; by {whose}'s face they {says}. So another normal may \
             do better: EPA must tell.",
            apart_at_least(at_least - run.radii())
        ),
        End::Apart => format!(
            "With {whose} rounded, the two {}; by {whose}'s face they {says}. These agree, and that \
             decides: no need for EPA.",
            apart(v - run.radii())
        ),
    }
}

/// GJK's end in the origin.
pub fn held_words(simplex: &Simplex, run: &Run) -> String {
    let held = match simplex.vertices().len() {
        4 => "The tetrahedron holds the origin",
        _ => "The simplex passes through the origin",
    };
    if let Part::Skin { side, .. } = run.part {
        let whose = name(Some(side));
        return format!(
            "{held}: even without the skin, what is left of {whose} overlaps the other one.\nThe \
             skin can't say how deep; EPA must tell, on the sharp solids."
        );
    }
    let next = match run.part {
        Part::Gjk(Aim::Study) => {
            "EPA goes on from this simplex, but only for study: the engine has a closed form."
        }
        _ => "Next is the skin, of the solid whose face leads.",
    };
    format!(
        "{held}: some point of a is a point of b, so the two overlap.\nGJK can't say how deep. \
         {next}"
    )
}

/// EPA, whose nearest face is at `distance` and its support point at `found`, m; of its faces
/// `gone` go.
pub fn epa_words(
    faces: usize,
    gone: usize,
    [distance, found]: [f32; 2],
    end: Option<&Penetration>,
) -> String {
    let next = match end {
        None if gone == 1 => "That face goes, and its three edges are joined to w.".to_owned(),
        None => {
            let others = match gone - 1 {
                1 => "one that hangs together with it and sees".to_owned(),
                others => format!("{others} that hang together with it and see"),
            };
            format!("That face goes, with {others} w, and the rim of the hole is joined to w.")
        }
        Some(end) if !end.converged => format!(
            "There is no room for another corner. From the best face so far the normal walks \
             downhill, to a depth of {}.",
            mm(end.depth)
        ),
        Some(end) if end.depth < found => format!(
            "No further: w is a corner already. The shortest way out that was met is {}.",
            mm(end.depth)
        ),
        Some(_) => "No further: this face is on the surface, and its normal is the shortest way \
                    apart."
            .to_owned(),
    };
    format!(
        "The polytope has {faces} faces; the nearest is {} from the origin. The support point w \
         along its normal is {} out: {} further.\n{next}",
        mm(distance),
        mm(found),
        mm((found - distance).max(0.0))
    )
}

/// The answer, who decided it, and whether the engine would have stopped earlier.
pub fn touch_words(touch: Option<&Touch>, decision: &Decision, leading: Option<f32>) -> String {
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
    let early = match leading {
        Some(leading) if leading > 0.0 => format!(
            " If the engine's margin is less than {}, the faces alone end it.",
            mm(leading)
        ),
        _ => String::new(),
    };
    format!(
        "Normal ({x:.3}, {y:.3}, {z:.3}), from b to a; {count} contact {points}, {deep}.\n\
         {}{early}",
        decided(decision)
    )
}

fn decided(decision: &Decision) -> String {
    match decision {
        Decision::ClosedForm => {
            "The engine takes the closed form of these two shapes; GJK is shown for study."
                .to_owned()
        }
        Decision::Gjk(way) => format!("GJK decided{}", normal_of(way)),
        Decision::Skin(way) => {
            let side = name(way.face);
            format!("The skin decided: the normal is that of {side}'s leading face.")
        }
        Decision::Epa(way) => format!("EPA decided{}", normal_of(way)),
        Decision::WayBack => "The way back decided: in this step a centre went in through a face \
                              and past the middle, and goes back through it."
            .to_owned(),
    }
}

/// Whose normal was taken in the end.
fn normal_of(way: &ShortestWay) -> String {
    match way.face {
        Some(side) => {
            let side = name(Some(side));
            format!(", and found the normal of {side}'s leading face, which is taken exactly.")
        }
        None => ": the normal isn't the leading face's.".to_owned(),
    }
}
