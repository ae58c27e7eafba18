//! The narrow phase of one pair, taken apart for the overlay: what GJK and EPA looked at in each
//! of their iterations, and the touch that comes of it.
//!
//! The engine asks no more than it needs: pairs with a closed form never reach GJK, and solids
//! with sharp edges meet rounded first, which mostly settles it. Here all of it is shown, and the
//! words say where the engine stops.

mod figures;
mod surface;
mod words;

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
use words::{epa_words, gjk_words, held_words, touch_words};

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
            let rounded = first
                .bounds
                .last()
                .map_or(f32::INFINITY, |bounds| bounds[1]);
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
            let low = run
                .bounds
                .last()
                .map_or(f32::NEG_INFINITY, |bounds| bounds[0]);
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

#[cfg(test)]
mod tests {
    use glam::Quat;

    use super::*;

    const CUBE: Shape = Shape::Box {
        half_extents: Vec3::splat(0.5),
    };
    const CAPSULE: Shape = Shape::Capsule {
        radius: 0.2,
        half_height: 0.5,
    };

    /// The two shapes, the first one this far above the second and turned a little.
    fn above(one: &Shape, two: &Shape, height: f32, step: usize) -> Dissection {
        let p = Vec3::new(0.0, height, 0.0);
        let a = Placed {
            shape: one,
            p,
            q: Quat::from_rotation_z(0.3),
            p_before: p,
        };
        let b = Placed {
            shape: two,
            p: Vec3::ZERO,
            q: Quat::from_rotation_x(0.2),
            p_before: Vec3::ZERO,
        };
        dissect(&a, &b, step)
    }

    fn names(dissection: &Dissection) -> Vec<&'static str> {
        dissection.phases.iter().map(|phase| phase.name).collect()
    }

    #[test]
    fn sharp_solids_meet_rounded_first_and_epa_says_how_deep_they_are() {
        let end = above(&CUBE, &CUBE, 0.8, usize::MAX);
        assert_eq!(names(&end), [ROUNDED, "GJK", EPA, "Touch"]);
        assert_eq!(end.bounds.len(), end.steps());
        let [low, high] = end.bounds[end.steps() - 1];
        assert!(low == high && low < -0.1, "{low} … {high}");
        let epa = end.bounds[end.steps() - 2];
        assert!((epa[0] - low).abs() < 1e-3 && (epa[1] - low).abs() < 1e-3);
    }

    #[test]
    fn solids_that_are_apart_need_no_epa() {
        let end = above(&CUBE, &CUBE, 2.0, usize::MAX);
        assert_eq!(names(&end), [ROUNDED, "GJK", "Touch"]);
        let [low, high] = end.bounds[end.steps() - 2];
        assert!(low > 0.3 && high - low < 1e-4, "{low} … {high}");
    }

    #[test]
    fn capsules_overlap_without_their_cores_meeting() {
        let end = above(&CAPSULE, &CAPSULE, 1.3, usize::MAX);
        assert_eq!(names(&end), ["GJK", "Touch"]);
        assert!(end.bounds[end.steps() - 1][1] < 0.0);
        let last = above(&CAPSULE, &CAPSULE, 1.3, end.steps() - 2);
        assert!(last.text.contains("No need for EPA"), "{}", last.text);
        assert!(!last.core.is_empty() && !last.surface.is_empty());
    }

    #[test]
    fn every_iteration_has_a_title_words_and_a_drawing() {
        for (one, two, height) in [(CUBE, CUBE, 0.8), (CAPSULE, CUBE, 0.9), (CUBE, CUBE, 3.0)] {
            let steps = above(&one, &two, height, 0).steps();
            for step in 0..steps {
                let shown = above(&one, &two, height, step);
                assert_eq!(shown.step, step);
                assert!(!shown.text.is_empty() && !shown.difference.key.is_empty());
                assert!(!shown.world.marks.is_empty(), "{}", shown.title);
            }
            assert_eq!(above(&one, &two, height, usize::MAX).step, steps - 1);
        }
    }

    #[test]
    fn bounds_only_close_in_while_an_algorithm_runs() {
        let end = above(&CUBE, &CUBE, 0.8, 0);
        let mut first = 0;
        for phase in &end.phases {
            let run = &end.bounds[first..first + phase.steps];
            assert!(run.iter().all(|[low, high]| low <= high));
            assert!(
                run.windows(2)
                    .all(|b| b[0][0] <= b[1][0] && b[1][1] <= b[0][1])
            );
            first += phase.steps;
        }
    }

    #[test]
    fn vertices_have_the_letters_of_their_arrival() {
        let shown = above(&CUBE, &CUBE, 0.8, 0);
        let marks: Vec<&str> = shown
            .difference
            .marks
            .iter()
            .map(|m| m.text.as_str())
            .collect();
        assert_eq!(marks, ["A", "v", "w = B"]);
    }
}
