//! What is shown besides the bodies: layers of the engine's inner state, and a pair of bodies
//! whose narrow phase is looked at, iteration by iteration.

use ch00_scenes::{Dissection, Layer};
use glam::{Vec2, Vec3};

use crate::{Session, ShellError};

/// What is shown besides the bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Show {
    /// The layers.
    pub layers: Vec<Layer>,
    /// Whether bodies are of glass while layers or a pair are shown.
    pub is_see_through: bool,
    /// The pair whose narrow phase is looked at.
    pub pair: Option<Pair>,
}

impl Default for Show {
    fn default() -> Self {
        Self {
            layers: Vec::new(),
            is_see_through: true,
            pair: None,
        }
    }
}

impl Show {
    /// Whether anything is shown.
    #[must_use]
    pub fn is_any(&self) -> bool {
        !self.layers.is_empty() || self.pair.is_some()
    }

    /// Whether bodies are drawn as glass.
    #[must_use]
    pub fn is_glass(&self) -> bool {
        self.is_see_through && self.is_any()
    }

    /// Shows a layer or takes it away.
    pub fn toggle(&mut self, layer: Layer) {
        if let Some(i) = self.layers.iter().position(|&shown| shown == layer) {
            self.layers.remove(i);
        } else {
            self.layers.push(layer);
        }
    }

    /// Forgets what this session can't show.
    pub fn keep_possible(&mut self, session: &Session) {
        let possible = session.engine().layers();
        self.layers.retain(|layer| possible.contains(layer));
        let count = session.scene().bodies.len();
        self.pair = self
            .pair
            .take()
            .filter(|pair| pair.bodies.iter().all(|&i| i < count));
    }
}

/// What the command line wants to be shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wish {
    /// The layers.
    pub layers: Vec<Layer>,
    /// Whether bodies stay solid meanwhile.
    pub is_solid: bool,
    /// The pair to look into.
    pub dissect: Option<Dissect>,
}

/// A pair to look into, as `--dissect` names it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dissect {
    /// The two bodies; none for those of the deepest contact when it is drawn.
    pub bodies: Option<[usize; 2]>,
    /// The iteration, from 1; none for the last.
    pub step: Option<usize>,
}

impl Wish {
    /// Whether this session can show it.
    ///
    /// # Errors
    /// [`ShellError::Layer`] or [`ShellError::Pair`] that says what it can.
    pub fn check(&self, session: &Session) -> Result<(), ShellError> {
        let possible = session.engine().layers();
        if let Some(layer) = self.layers.iter().find(|layer| !possible.contains(layer)) {
            let flags: Vec<_> = possible.iter().map(|layer| layer.flag()).collect();
            return Err(ShellError::Layer {
                layer: layer.flag(),
                engine: session.entry().name,
                known: flags.join(", "),
            });
        }
        match self.dissect.and_then(|dissect| dissect.bodies) {
            Some(bodies) => check_pair(session, bodies).map_err(ShellError::Pair),
            None => Ok(()),
        }
    }

    /// It, in a session that can show it; no pair where no two bodies are near each other.
    #[must_use]
    pub fn show(&self, session: &Session) -> Show {
        let pair_of = |dissect: Dissect| {
            let bodies = dissect.bodies.or_else(|| worth_looking_at(session, None))?;
            Some(Pair {
                step: dissect.step.map(|step| step.saturating_sub(1)),
                ..Pair::new(bodies)
            })
        };
        Show {
            layers: self.layers.clone(),
            is_see_through: !self.is_solid,
            pair: self.dissect.and_then(pair_of),
        }
    }
}

/// Why a pair can't be looked at.
fn check_pair(session: &Session, [a, b]: [usize; 2]) -> Result<(), String> {
    let last = session.scene().bodies.len().saturating_sub(1);
    if a.max(b) > last {
        return Err(format!("the scene has bodies 0 to {last}"));
    }
    if a == b {
        return Err(format!("body {a} is no pair with itself"));
    }
    let engine = session.entry().name;
    match session.engine().dissect(a, b, 0) {
        Some(_) => Ok(()),
        None => Err(format!(
            "the engine `{engine}` has no narrow phase to look into for this pair"
        )),
    }
}

/// A pair of bodies whose narrow phase is looked at, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Indices of bodies a and b.
    pub bodies: [usize; 2],
    /// The iteration, from 0; none for the last, however many there are.
    pub step: Option<usize>,
    /// How the view of the differences is turned against the camera: about the vertical and
    /// above the horizontal, rad.
    pub turn: Vec2,
    /// How much closer than needed to see all differences.
    pub zoom: f32,
}

impl Pair {
    /// Looks at where the narrow phase ends.
    #[must_use]
    pub fn new(bodies: [usize; 2]) -> Self {
        Self {
            bodies,
            step: None,
            turn: Vec2::ZERO,
            zoom: 1.0,
        }
    }

    /// What the engine says of it.
    #[must_use]
    pub fn dissect(&self, session: &Session) -> Option<Dissection> {
        let [a, b] = self.bodies;
        let last = usize::MAX;
        session.engine().dissect(a, b, self.step.unwrap_or(last))
    }

    /// Corners of a box about the smaller one and as much of the other one as is near it, m.
    #[must_use]
    pub fn corners(&self, session: &Session) -> (Vec3, Vec3) {
        let sphere = |i: usize| {
            let radius = session.scene().bodies[i].shape.bounding_radius();
            (session.state_now().position[i], radius)
        };
        let [mut small, mut large] = self.bodies.map(sphere);
        if small.1 > large.1 {
            std::mem::swap(&mut small, &mut large);
        }
        let (mut low, mut high) = (small.0 - small.1, small.0 + small.1);
        if large.1 < 4.0 * small.1 {
            low = low.min(large.0 - large.1);
            high = high.max(large.0 + large.1);
        }
        let room = 0.25 * (high - low);
        ((low - room).as_vec3(), (high + room).as_vec3())
    }

    /// Goes so many iterations on, or back; from the last one it stays with the last.
    pub fn move_step(&mut self, by: isize, dissection: &Dissection) {
        let last = dissection.steps().saturating_sub(1);
        let step = dissection.step.saturating_add_signed(by).min(last);
        self.step = (step < last).then_some(step);
    }
}

/// A body that another one may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neighbour {
    /// Its index.
    pub body: usize,
    /// The size of all impulses between the two in the last step, N s; none where they don't
    /// touch.
    pub impulse: Option<f64>,
}

/// The bodies that this one touches, the hardest pressed first, then those that only their
/// bounding boxes bring near.
#[must_use]
pub fn neighbours(session: &Session, body: usize) -> Vec<Neighbour> {
    let mut found: Vec<Neighbour> = Vec::new();
    for contact in session.engine().contacts() {
        let Some(other) = other_of([contact.a, contact.b], body) else {
            continue;
        };
        let size = contact.impulse.length();
        match found.iter_mut().find(|known| known.body == other) {
            Some(known) => known.impulse = known.impulse.map(|sum| sum + size),
            None => found.push(Neighbour {
                body: other,
                impulse: Some(size),
            }),
        }
    }
    found.sort_by(|one, two| two.impulse.unwrap_or(0.0).total_cmp(&one.impulse.unwrap_or(0.0)));
    for &(a, b) in session.engine().pairs() {
        if let Some(other) = other_of([a, b], body)
            && found.iter().all(|known| known.body != other)
        {
            found.push(Neighbour {
                body: other,
                impulse: None,
            });
        }
    }
    found
}

/// A pair worth looking at: that of the deepest contact, with this body if one is named;
/// without contacts, the first pair that the broad phase found.
#[must_use]
pub fn worth_looking_at(session: &Session, body: Option<usize>) -> Option<[usize; 2]> {
    let fits = |pair: &[usize; 2]| body.is_none_or(|body| pair.contains(&body));
    let contacts = session.engine().contacts();
    let deepest = contacts
        .iter()
        .filter(|contact| fits(&[contact.a, contact.b]))
        .max_by(|one, two| one.depth.total_cmp(&two.depth));
    let mut pairs = session.engine().pairs().iter().map(|&(a, b)| [a, b]);
    deepest
        .map(|contact| [contact.a, contact.b])
        .or_else(|| pairs.find(fits))
}

/// The other one of a pair, if this body is in it.
fn other_of([a, b]: [usize; 2], body: usize) -> Option<usize> {
    match body {
        _ if body == a => Some(b),
        _ if body == b => Some(a),
        _ => None,
    }
}
