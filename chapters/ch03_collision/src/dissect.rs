//! The narrow phase of one pair, taken apart for the overlay: what GJK and EPA looked at in each
//! of their iterations, and the touch that comes of it.
//!
//! The engine asks no more than it needs: pairs with a closed form never reach GJK, and solids
//! with sharp edges meet rounded first, which mostly settles it. Here all of it is shown, and the
//! words say where the engine stops.

mod figures;
mod surface;

use ch00_maths::f32::shape::Shape;
use ch00_scenes::{Dissection, Drawing, Phase, SurfacePoint, palette};
use glam::Vec3;

use crate::narrow::epa;
use crate::narrow::gjk::{self, Gjk};
use crate::narrow::simplex::Simplex;
use crate::narrow::support_point::{Core, Vertex, separation};
use crate::narrow::{Placed, Touch, touch};
use figures::{draw_gjk, draw_held, draw_polytope, draw_touch};
use surface::{edges, surface};

const EPA: &str = "EPA";
const ROUNDED: &str = "GJK, rounded";

/// The share of a sharp solid that is rounded off, as in `shortest_way`.
const SKIN: f32 = 0.1;

/// What one iteration looked at. Kept, where the watched algorithms only lend it.
enum Look {
    /// GJK: the simplex, the next vertex, and how far apart the cores are at least, m.
    Gjk {
        simplex: Simplex,
        support: Vertex,
        at_least: f32,
        is_last: bool,
    },
    /// GJK's end where the simplex holds the origin.
    Held { simplex: Simplex },
    /// EPA: the polytope, the place of its nearest face, and the support point along its normal.
    Epa {
        vertices: Vec<Vertex>,
        faces: Vec<epa::Face>,
        nearest: usize,
        support: Vertex,
        is_last: bool,
    },
    /// What comes of it, and how the engine gets there.
    Touch {
        touch: Option<Touch>,
        way: &'static str,
    },
}

/// An algorithm's run on two cores.
struct Run {
    name: &'static str,
    a: Core,
    b: Core,
    looks: Vec<Look>,
    /// After each of them, between which numbers the distance of the solids is, m.
    bounds: Vec<[f32; 2]>,
}

impl Run {
    fn new(name: &'static str, a: Core, b: Core) -> Self {
        Self {
            name,
            a,
            b,
            looks: Vec::new(),
            bounds: Vec::new(),
        }
    }

    /// The letters of a vertex: A is the first that GJK found.
    fn letter(&self, vertex: &Vertex) -> String {
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
    fn radii(&self) -> f32 {
        self.a.radius + self.b.radius
    }

    /// Adds what an iteration looked at. Bounds only ever close in.
    fn push(&mut self, look: Look, [low, high]: [f32; 2]) {
        let [low, high] = [low, high].map(|bound| bound - self.radii());
        let [last_low, last_high] = self.bounds.last().copied().unwrap_or([low, high]);
        self.looks.push(look);
        self.bounds.push([low.max(last_low), high.min(last_high)]);
    }
}

/// What the narrow phase does with two solids, after its iteration `step`; past the last, that
/// one.
#[must_use]
pub fn dissect(a: &Placed, b: &Placed, step: usize) -> Dissection {
    let runs = runs_of(a, b);
    let phases: Vec<Phase> = runs
        .iter()
        .map(|run| Phase {
            name: run.name,
            steps: run.looks.len(),
        })
        .collect();
    let count: usize = phases.iter().map(|phase| phase.steps).sum();
    let step = step.min(count.saturating_sub(1));
    let (mut run, mut place) = (&runs[0], step);
    for next in &runs {
        run = next;
        if place < next.looks.len() {
            break;
        }
        place -= next.looks.len();
    }
    let mut shown = Shown::new(run, b.p);
    shown.draw(place);
    Dissection {
        step,
        title: match run.looks.len() {
            1 => run.name.to_owned(),
            steps => format!("{}, iteration {} of {steps}", run.name, place + 1),
        },
        text: shown.text,
        bounds: runs.iter().flat_map(|run| run.bounds.clone()).collect(),
        surface: shown.surface,
        core: shown.core,
        difference: shown.difference,
        world: shown.world,
        phases,
    }
}

/// All algorithms that have a say, in order.
fn runs_of(a: &Placed, b: &Placed) -> Vec<Run> {
    let (core_a, core_b) = Core::pair(a, b);
    let mut runs = Vec::new();
    if core_a.radius + core_b.radius == 0.0 {
        let (in_a, in_b) = (core_a.shrunk(SKIN), core_b.shrunk(SKIN));
        runs.push(gjk_run(ROUNDED, in_a, in_b).0);
    }
    let (run, end) = gjk_run("GJK", core_a, core_b);
    runs.push(run);
    if let Gjk::Overlapping(simplex) = end {
        runs.push(epa_run(core_a, core_b, &simplex));
    }
    let touch = touch(a, b, f32::INFINITY);
    runs.push(touch_run(touch, way_of(a, b, touch, &runs), core_a, core_b));
    runs
}

/// Which way the engine takes for this pair.
fn way_of(a: &Placed, b: &Placed, touch: Option<Touch>, runs: &[Run]) -> &'static str {
    use Shape::{Capsule, Sphere};
    let (last, first) = (&runs[runs.len() - 1], &runs[0]);
    match (a.shape, b.shape) {
        (Sphere { .. }, _) | (_, Sphere { .. }) | (Capsule { .. }, Capsule { .. }) => {
            "by the closed form of these shapes, without GJK"
        }
        _ if runs.len() == 1 => "by GJK alone",
        _ => {
            let size = last.a.reach().min(last.b.reach());
            let rounded = first.bounds.last().map_or(f32::INFINITY, |bounds| bounds[1]);
            let found = touch.map_or(0.0, |touch| separation(&last.a, &last.b, touch.normal));
            if first.radii() > last.radii() && found >= rounded - 1e-4 * size {
                "by GJK on the rounded solids: their faces are as far apart as these are"
            } else if last.name == EPA {
                "by EPA"
            } else {
                "by GJK on the sharp solids"
            }
        }
    }
}

fn gjk_run(name: &'static str, a: Core, b: Core) -> (Run, Gjk) {
    let mut run = Run::new(name, a, b);
    let end = gjk::watched(&a, &b, f32::INFINITY, |step| {
        let look = Look::Gjk {
            simplex: *step.simplex,
            support: step.support,
            at_least: step.at_least,
            is_last: false,
        };
        run.push(look, [step.at_least, step.simplex.nearest().length()]);
    });
    match end {
        Gjk::Overlapping(simplex) => {
            let low = run.bounds.last().map_or(f32::NEG_INFINITY, |bounds| bounds[0]);
            run.push(Look::Held { simplex }, [low, 0.0]);
        }
        Gjk::Apart(_) | Gjk::Far => {
            if let Some(Look::Gjk { is_last, .. }) = run.looks.last_mut() {
                *is_last = true;
            }
        }
    }
    (run, end)
}

fn epa_run(a: Core, b: Core, simplex: &Simplex) -> Run {
    let mut run = Run::new(EPA, a, b);
    epa::watched(&a, &b, simplex, |step| {
        let face = &step.faces[step.nearest];
        let look = Look::Epa {
            vertices: step.vertices.to_vec(),
            faces: step.faces.to_vec(),
            nearest: step.nearest,
            support: step.support,
            is_last: false,
        };
        let depth = step.support.point.dot(face.normal);
        run.push(look, [-depth, -face.distance]);
    });
    if let Some(Look::Epa { is_last, .. }) = run.looks.last_mut() {
        *is_last = true;
    }
    run
}

/// What the engine itself answers, whatever way it takes.
fn touch_run(touch: Option<Touch>, way: &'static str, core_a: Core, core_b: Core) -> Run {
    let mut run = Run::new("Touch", core_a, core_b);
    let distance = touch.map_or(f32::INFINITY, |touch| {
        separation(&core_a, &core_b, touch.normal) + run.radii()
    });
    run.push(Look::Touch { touch, way }, [distance; 2]);
    run
}

/// A look, drawn and put into words.
struct Shown<'a> {
    run: &'a Run,
    /// Of b: what the cores' coordinates start from, m.
    origin: Vec3,
    text: String,
    surface: Vec<[SurfacePoint; 3]>,
    core: Vec<[SurfacePoint; 3]>,
    difference: Drawing,
    world: Drawing,
}

impl<'a> Shown<'a> {
    fn new(run: &'a Run, origin: Vec3) -> Self {
        let has_core = run.radii() > 0.0;
        Self {
            run,
            origin,
            text: String::new(),
            surface: surface(&run.a, &run.b, run.radii()),
            core: if has_core {
                surface(&run.a, &run.b, 0.0)
            } else {
                Vec::new()
            },
            difference: Drawing::default(),
            world: Drawing::default(),
        }
    }

    /// Radius of the smaller solid: how large figures are drawn on the two, m.
    fn size(&self) -> f32 {
        let [a, b] = self.reaches();
        a.min(b)
    }

    /// About the radius of their difference: how large figures are drawn in it, m.
    fn spread(&self) -> f32 {
        let [a, b] = self.reaches();
        0.6 * (a + b)
    }

    fn reaches(&self) -> [f32; 2] {
        [&self.run.a, &self.run.b].map(|core| core.reach() + core.radius)
    }

    fn draw(&mut self, place: usize) {
        for [from, to] in edges(&self.run.a, &self.run.b) {
            self.difference.line(from, to, 0.7, palette::GREY);
        }
        let bounds = self.run.bounds[place];
        match &self.run.looks[place] {
            Look::Gjk {
                simplex,
                support,
                at_least,
                is_last,
            } => {
                draw_gjk(self, simplex, support, *at_least);
                self.text = gjk_words(simplex, *at_least, *is_last, bounds, self.run);
            }
            Look::Held { simplex } => {
                draw_held(self, simplex);
                self.text = held_words(simplex, self.run);
            }
            Look::Epa {
                vertices,
                faces,
                nearest,
                support,
                is_last,
            } => {
                draw_polytope(self, vertices, faces, *nearest, support);
                let face = &faces[*nearest];
                let found = support.point.dot(face.normal);
                self.text = epa_words(faces.len(), face.distance, found, *is_last);
            }
            Look::Touch { touch, way } => {
                if let Some(touch) = touch {
                    draw_touch(self, touch);
                }
                self.text = touch_words(touch.as_ref(), way);
            }
        }
    }
}

/// A length in millimetres, or in metres if it is long.
fn mm(length: f32) -> String {
    if length.abs() < 1.0 {
        format!("{:.2} mm", 1e3 * length)
    } else {
        format!("{length:.3} m")
    }
}

fn gjk_words(
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
    let distance = simplex.nearest().length();
    let mut text = format!("v, on {carrier} of the simplex, is {} from the origin. ", mm(distance));
    text += &if at_least > 0.0 {
        format!("The plane through w tells that nothing is nearer than {}.", mm(at_least))
    } else {
        "w lies beyond the origin: the two may well overlap.".to_owned()
    };
    if is_last {
        text += "\nSo v is the nearest point, and GJK ends";
        text += &match run.radii() {
            0.0 => format!(": the solids are {} apart.", mm(high)),
            skins if run.name == ROUNDED => format!(
                ": less skins of {}, the rounded solids have a distance of {}. The sharp ones \
                 have no more.",
                mm(skins),
                mm(high)
            ),
            radii if high < 0.0 => format!(
                ": less radii of {}, the solids overlap by {}. No need for EPA.",
                mm(radii),
                mm(-high)
            ),
            radii => format!(
                ": less radii of {}, the solids are {} apart.",
                mm(radii),
                mm(high)
            ),
        };
    } else {
        text += &format!("\nStill unknown: {}. w joins the simplex.", mm(high - low));
    }
    text
}

fn held_words(simplex: &Simplex, run: &Run) -> String {
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

fn epa_words(faces: usize, distance: f32, found: f32, is_last: bool) -> String {
    let mut text = format!(
        "The polytope has {faces} faces; the nearest is {} from the origin. The support point w \
         along its normal is {} out: {} further.",
        mm(distance),
        mm(found),
        mm((found - distance).max(0.0))
    );
    text += if is_last {
        "\nNo further: this face is on the surface, and its normal is the shortest way apart."
    } else {
        "\nThe faces that see w go, and their rim is joined to w."
    };
    text
}

fn touch_words(touch: Option<&Touch>, way: &str) -> String {
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
        "Normal ({x:.3}, {y:.3}, {z:.3}), from b to a; {count} contact {points}, \
         {deep}.\nThe engine gets here {way}."
    )
}
