//! The parts of the narrow phase on one pair, in the engine's order, each with what it looked at:
//! the leading face, GJK, GJK under the skin, EPA, and the touch that comes of it.

use ch00_maths::f32::shape::Shape::{Capsule, Sphere};
use glam::Vec3;

use crate::narrow::epa::{self, Hole, Penetration};
use crate::narrow::gjk::{self, Gjk};
use crate::narrow::shortest_way::{
    ShortestWay, Side, VAGUE, leading_face, shortest_way, skinned, under_the_skin,
};
use crate::narrow::simplex::Simplex;
use crate::narrow::support_point::{Core, Vertex, extent, separation};
use crate::narrow::{Placed, Touch, touch};

/// A part of the narrow phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    /// The normals of all flat faces.
    Faces,
    /// GJK on the solids as they are.
    Gjk(Aim),
    /// GJK with one of the solids under its skin; that one's face says that the two are so far
    /// apart, m.
    Skin { side: Side, says: f32 },
    /// EPA.
    Epa,
    /// The touch.
    Touch,
}

/// What GJK runs for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The engine needs its answer.
    Answer,
    /// The engine has a closed form for the pair.
    Study,
}

/// Which part had the last word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Decision {
    /// The closed form of the two shapes: no part at all.
    ClosedForm,
    /// GJK on the solids as they are.
    Gjk(ShortestWay),
    /// GJK under the skin.
    Skin(ShortestWay),
    /// EPA.
    Epa(ShortestWay),
    /// Where a body came from.
    WayBack,
}

/// How GJK ended for two cores that share no point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It knows how far apart they are.
    Apart,
    /// They are further apart than it was to find out.
    Far,
}

/// What one iteration looked at. Kept, where the watched algorithms only lend it.
pub enum Look {
    /// The way along the leading face's normal, and the support point against that.
    Faces { face: ShortestWay, support: Vertex },
    /// GJK: the simplex, the next vertex, how far apart the cores are at least, m, and how it
    /// ended if this is the last iteration.
    Gjk {
        simplex: Simplex,
        support: Vertex,
        at_least: f32,
        end: Option<End>,
    },
    /// GJK's end where the simplex holds the origin.
    Held { simplex: Simplex },
    /// EPA: the polytope, the place of its nearest face, the support point along its normal, and
    /// either the places of the faces that go or what comes out.
    Epa {
        vertices: Vec<Vertex>,
        faces: Vec<epa::Face>,
        nearest: usize,
        support: Vertex,
        gone: Vec<usize>,
        end: Option<Penetration>,
    },
    /// What comes of it, who decided it, and how far apart the two are along the leading face's
    /// normal if that was asked, m.
    Touch {
        touch: Option<Touch>,
        decision: Decision,
        leading: Option<f32>,
    },
}

/// A part's run on two cores.
pub struct Run {
    pub part: Part,
    pub a: Core,
    pub b: Core,
    pub looks: Vec<Look>,
    /// After each of them, between which numbers the distance of the solids is, m.
    pub bounds: Vec<[f32; 2]>,
}

impl Run {
    fn new(part: Part, a: Core, b: Core) -> Self {
        Self {
            part,
            a,
            b,
            looks: Vec::new(),
            bounds: Vec::new(),
        }
    }

    /// As in the book.
    pub fn name(&self) -> &'static str {
        match self.part {
            Part::Faces => "Faces",
            Part::Gjk(_) => "GJK",
            Part::Skin { .. } => "Skin",
            Part::Epa => "EPA",
            Part::Touch => "Touch",
        }
    }

    /// The letters of a vertex: A is the first that GJK found.
    pub fn letter(&self, vertex: &Vertex) -> String {
        let mut arrivals = self.looks.iter().flat_map(|look| match look {
            Look::Gjk {
                simplex, support, ..
            } => [simplex.vertices().first().copied(), Some(*support)],
            _ => [None, None],
        });
        let first = arrivals.next().flatten();
        let mut known: Vec<Vec3> = first.iter().map(|vertex| vertex.point).collect();
        for arrival in arrivals.flatten() {
            if !known.contains(&arrival.point) {
                known.push(arrival.point);
            }
        }
        let place = known.iter().position(|point| *point == vertex.point);
        place.map_or_else(String::new, |place| {
            char::from_u32('A' as u32 + place as u32 % 26).map_or_else(String::new, String::from)
        })
    }

    /// How far the solids reach beyond their cores, m.
    pub fn radii(&self) -> f32 {
        self.a.radius + self.b.radius
    }

    /// Adds what an iteration looked at. The cores' distance is between these bounds; they only
    /// ever close in, and cross by rounding at most.
    fn push(&mut self, look: Look, [low, high]: [f32; 2]) {
        let [low, high] = [low, high].map(|bound| bound - self.radii());
        let [last_low, last_high] = self.bounds.last().copied().unwrap_or([low, high]);
        let low = low.max(last_low);
        self.looks.push(look);
        self.bounds.push([low, high.min(last_high).max(low)]);
    }
}

/// All parts that have a say, in the engine's order. It stops earlier where a bound says that the
/// two are further apart than its margin for the pair; here nothing is too far.
pub fn runs_of(a: &Placed, b: &Placed) -> Vec<Run> {
    let (core_a, core_b) = Core::pair(a, b);
    let touch = touch(a, b, f32::INFINITY);
    if let (Sphere { .. }, _) | (_, Sphere { .. }) | (Capsule { .. }, Capsule { .. }) =
        (a.shape, b.shape)
    {
        let mut runs = for_study(core_a, core_b);
        let decision = Decision::ClosedForm;
        runs.push(touch_run(touch, decision, None, core_a, core_b));
        return runs;
    }
    let face = leading_face(&core_a, &core_b);
    let mut runs = vec![faces_run(face, core_a, core_b)];
    let decide = as_the_engine_does(face, core_a, core_b, &mut runs);
    let way = shortest_way(&core_a, &core_b, f32::INFINITY).unwrap_or(face);
    let went_back = touch.is_some_and(|touch| touch.normal != way.normal);
    let decision = if went_back {
        Decision::WayBack
    } else {
        decide(way)
    };
    let leading = Some(face.separation);
    runs.push(touch_run(touch, decision, leading, core_a, core_b));
    runs
}

/// What GJK and EPA would do where the engine doesn't ask them.
fn for_study(a: Core, b: Core) -> Vec<Run> {
    let (run, end) = gjk_run(Part::Gjk(Aim::Study), a, b, f32::INFINITY);
    let mut runs = vec![run];
    if let Gjk::Overlapping(simplex) = end {
        runs.push(epa_run(a, b, &simplex));
    }
    runs
}

/// Adds the parts from GJK on that `shortest_way` needs, and tells which of them decides.
fn as_the_engine_does(
    face: ShortestWay,
    a: Core,
    b: Core,
    runs: &mut Vec<Run>,
) -> fn(ShortestWay) -> Decision {
    let (run, end) = gjk_run(Part::Gjk(Aim::Answer), a, b, f32::INFINITY);
    runs.push(run);
    let simplex = match end {
        Gjk::Apart(apart) if apart.distance <= VAGUE * extent(&a, &b) => apart.simplex,
        Gjk::Overlapping(simplex) => simplex,
        Gjk::Apart(_) | Gjk::Far => return Decision::Gjk,
    };
    if let (Some(side), Some((in_a, in_b, limit))) = (face.face, skinned(&a, &b, face)) {
        let says = face.separation;
        runs.push(gjk_run(Part::Skin { side, says }, in_a, in_b, limit).0);
    }
    if under_the_skin(&a, &b, face).is_some() {
        return Decision::Skin;
    }
    runs.push(epa_run(a, b, &simplex));
    Decision::Epa
}

/// The solids are at least as far apart as along the face's normal, and at most as far as their
/// centres.
fn faces_run(face: ShortestWay, a: Core, b: Core) -> Run {
    let mut run = Run::new(Part::Faces, a, b);
    let support = Vertex::support(&a, &b, -face.normal);
    let centres = a.centre.distance(b.centre);
    let bounds = [face.separation + run.radii(), centres];
    run.push(Look::Faces { face, support }, bounds);
    run
}

fn gjk_run(part: Part, a: Core, b: Core, limit: f32) -> (Run, Gjk) {
    let mut run = Run::new(part, a, b);
    // The sharp solids may be nearer to each other than the rounded ones, so the lower bound isn't
    // theirs. But the face's is.
    let known = match part {
        Part::Skin { says, .. } => Some(says + run.radii()),
        _ => None,
    };
    let result = gjk::watched(&a, &b, limit, |step| {
        let look = Look::Gjk {
            simplex: *step.simplex,
            support: step.support,
            at_least: step.at_least,
            end: None,
        };
        let high = step.simplex.nearest().length();
        run.push(look, [known.unwrap_or(step.at_least), high]);
    });
    match result {
        Gjk::Overlapping(simplex) => {
            let low = known.unwrap_or(f32::NEG_INFINITY);
            let last = run.bounds.last().map_or(low, |bounds| bounds[0]);
            run.push(Look::Held { simplex }, [low.max(last), 0.0]);
        }
        Gjk::Apart(_) | Gjk::Far => {
            if let Some(Look::Gjk { end, .. }) = run.looks.last_mut() {
                *end = Some(match result {
                    Gjk::Far => End::Far,
                    _ => End::Apart,
                });
            }
        }
    }
    (run, result)
}

fn epa_run(a: Core, b: Core, simplex: &Simplex) -> Run {
    let mut run = Run::new(Part::Epa, a, b);
    let found = epa::watched(&a, &b, simplex, |step| {
        let face = &step.faces[step.nearest];
        let hole = Hole::new(step.faces, step.nearest, &step.support, extent(&a, &b));
        let goes = |place: &usize| hole.has(&step.faces[*place]);
        let look = Look::Epa {
            vertices: step.vertices.to_vec(),
            faces: step.faces.to_vec(),
            nearest: step.nearest,
            support: step.support,
            gone: (0..step.faces.len()).filter(goes).collect(),
            end: None,
        };
        let depth = step.support.point.dot(face.normal);
        run.push(look, [-depth, -face.distance]);
    });
    if let Some(Look::Epa { gone, end, .. }) = run.looks.last_mut() {
        gone.clear();
        *end = Some(found);
    }
    run
}

/// What the engine itself answers, whatever way it takes.
fn touch_run(
    touch: Option<Touch>,
    decision: Decision,
    leading: Option<f32>,
    a: Core,
    b: Core,
) -> Run {
    let mut run = Run::new(Part::Touch, a, b);
    let distance = touch.map_or(f32::INFINITY, |touch| {
        separation(&a, &b, touch.normal) + run.radii()
    });
    let look = Look::Touch {
        touch,
        decision,
        leading,
    };
    run.push(look, [distance; 2]);
    run
}
