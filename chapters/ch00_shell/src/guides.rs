//! What explains a picture: the layers that are shown, the pair that is looked at, the circles on which
//! bodies are moved, and the mouse's spring.

use std::f64::consts::TAU;

use ch00_scenes::{ContactPoint, Dissection, Drawing, Face, Key, Layer, Line, Mark, Scene, orbits};
use glam::DVec3;

use crate::Session;
use crate::render::Theme;
use crate::render::lines::{Stroke, stroke_between, stroke_of};
use crate::show::Show;
use crate::stage::Stage;

const SPRING: [u8; 4] = [255, 190, 60, 255];
const ORBIT: [u8; 4] = [120, 135, 155, 150];

/// Straight pieces of a circle.
const PIECES: u32 = 72;

/// What is drawn over the bodies of a frame. Kept over frames for its memory.
#[derive(Debug, Default)]
pub struct Guides {
    /// Lines.
    pub strokes: Vec<Stroke>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Dots with letters.
    pub marks: Vec<Mark>,
    /// What colours mean.
    pub key: Vec<Key>,
    /// Contacts that tell their numbers when pointed at.
    pub contacts: Vec<ContactPoint>,
    /// The narrow phase of the pair that is looked at.
    pub dissection: Option<Dissection>,
}

impl Guides {
    /// Collects those of a window's frame.
    pub fn collect(&mut self, stage: &Stage) {
        let session = stage.session();
        self.collect_shown(session, &stage.show, stage.theme);
        add_carriers(session, stage.alpha(), &mut self.strokes);
        if let Some(pull) = stage.pulled() {
            let (position, orientation) = session.pose(pull.body, stage.alpha());
            let held = position + orientation * pull.anchor;
            self.strokes.push(line(held, pull.target, 3.0, SPRING));
        }
    }

    /// Collects those of a picture of the last state.
    #[must_use]
    pub fn of_picture(session: &Session, show: &Show, theme: Theme) -> Self {
        let mut guides = Self::default();
        guides.collect_shown(session, show, theme);
        add_carriers(session, 1.0, &mut guides.strokes);
        guides
    }

    /// Layers and pair.
    fn collect_shown(&mut self, session: &Session, show: &Show, theme: Theme) {
        self.strokes.clear();
        self.faces.clear();
        self.marks.clear();
        self.key.clear();
        self.contacts.clear();
        for layer in Layer::ALL {
            if show.layers.contains(&layer) {
                self.add(&session.engine().layer(layer), theme);
            }
        }
        if show.layers.contains(&Layer::Contacts) {
            self.contacts = session.engine().contacts();
        }
        self.dissection = show.pair.and_then(|pair| pair.dissect(session));
        if let Some(dissection) = self.dissection.take() {
            self.add(&dissection.world, theme);
            self.dissection = Some(dissection);
        }
    }

    fn add(&mut self, drawing: &Drawing, theme: Theme) {
        self.strokes.extend(drawing.lines.iter().map(|line| {
            let color = theme.standing_out(line.color);
            stroke_of(&Line { color, ..*line })
        }));
        self.faces.extend(drawing.faces.iter().map(|face| {
            let [r, g, b, opacity] = face.color;
            let [r, g, b] = theme.standing_out([r, g, b]);
            let color = [r, g, b, opacity];
            Face { color, ..*face }
        }));
        self.marks.extend_from_slice(&drawing.marks);
        self.key.extend_from_slice(&drawing.key);
    }
}

/// The orbits that carry bodies, as they are between the last two steps at `alpha`.
fn add_carriers(session: &Session, alpha: f64, strokes: &mut Vec<Stroke>) {
    let shown_time = session.time() - (1.0 - alpha) * session.dt();
    add_orbits(session.scene(), shown_time, strokes);
}

/// The circles of all orbits at this time: where each body would be at other phases.
fn add_orbits(scene: &Scene, time: f64, strokes: &mut Vec<Stroke>) {
    if scene.orbits.is_empty() {
        return;
    }
    let mut turned = scene.clone();
    for (i, orbit) in scene.orbits.iter().enumerate() {
        let mut at = |piece: u32| {
            let angle = TAU * f64::from(piece) / f64::from(PIECES);
            turned.orbits[i].phase = orbit.phase + angle;
            orbits::state_at(&turned, time).position[orbit.body]
        };
        let points: Vec<DVec3> = (0..=PIECES).map(&mut at).collect();
        strokes.extend(points.windows(2).map(|p| line(p[0], p[1], 1.0, ORBIT)));
        turned.orbits[i].phase = orbit.phase;
    }
}

fn line(from: DVec3, to: DVec3, width: f32, color: [u8; 4]) -> Stroke {
    stroke_between(from.as_vec3(), to.as_vec3(), width, color)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_orbits_circle_is_closed_and_passes_through_its_body() {
        let scene = Scene::open("orrery", None, None).expect("`orrery` is built in");
        let mut strokes = Vec::new();
        add_orbits(&scene, 0.0, &mut strokes);
        let circle = &strokes[PIECES as usize..2 * PIECES as usize];
        let first = circle[0].from;
        assert_eq!(first, scene.bodies[1].position.as_vec3().to_array());
        let gap = glam::Vec3::from(first).distance(circle[circle.len() - 1].to.into());
        assert!(gap < 1e-5, "{gap}");
    }
}
