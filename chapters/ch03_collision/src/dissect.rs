//! The narrow phase of one pair, taken apart for the overlay: what each of its parts looked at in
//! each of its iterations, and the touch that comes of it.
//!
//! The parts are shown in the engine's order, as far as it goes for this pair: the leading face,
//! GJK, GJK under the skin, EPA. Pairs with a closed form never get there; GJK is shown for them
//! all the same, and the words say so.

mod figures;
mod runs;
mod surface;
mod words;

use ch00_scenes::{Dissection, Drawing, Phase, SurfacePoint, palette};
use glam::Vec3;

use crate::narrow::Placed;
use figures::{draw_faces, draw_gjk, draw_held, draw_polytope, draw_touch};
use runs::{Aim, Look, Part, Run, runs_of};
use surface::{edges, surface};
use words::{epa_words, faces_words, gjk_words, held_words, touch_words};

/// The first part of pairs with a closed form.
const STUDY: Part = Part::Gjk(Aim::Study);

/// What the narrow phase does with two solids, after its iteration `step`; past the last, that
/// one.
#[must_use]
pub fn dissect(a: &Placed, b: &Placed, step: usize) -> Dissection {
    let runs = runs_of(a, b);
    let phases: Vec<Phase> = runs
        .iter()
        .map(|run| Phase {
            name: run.name(),
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
        title: title(run, place, runs[0].part == STUDY),
        text: shown.text,
        bounds: runs.iter().flat_map(|run| run.bounds.clone()).collect(),
        surface: shown.surface,
        core: shown.core,
        difference: shown.difference,
        world: shown.world,
        phases,
    }
}

/// Such as `GJK, iteration 3 of 5`.
fn title(run: &Run, place: usize, study: bool) -> String {
    let name = match run.part {
        Part::Faces => "The leading face".to_owned(),
        Part::Touch => return "Touch".to_owned(),
        _ if study => format!("{} for study", run.name()),
        _ => run.name().to_owned(),
    };
    match run.looks.len() {
        1 => name,
        steps => format!("{name}, iteration {} of {steps}", place + 1),
    }
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
            Look::Faces { face, support } => {
                draw_faces(self, face, support);
                self.text = faces_words(face);
            }
            Look::Gjk {
                simplex,
                support,
                at_least,
                end,
            } => {
                draw_gjk(self, simplex, support, *at_least);
                self.text = gjk_words(simplex, *at_least, *end, bounds, self.run);
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
                gone,
                end,
            } => {
                draw_polytope(self, vertices, faces, *nearest, support, gone);
                let face = &faces[*nearest];
                let reach = [face.distance, support.point.dot(face.normal)];
                self.text = epa_words(faces.len(), gone.len(), reach, end.as_ref());
            }
            Look::Touch {
                touch,
                decision,
                leading,
            } => {
                if let Some(touch) = touch {
                    draw_touch(self, touch);
                }
                self.text = touch_words(touch.as_ref(), decision, *leading);
            }
        }
    }
}

#[cfg(test)]
mod tests;
