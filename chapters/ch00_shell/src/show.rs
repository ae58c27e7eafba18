//! What is shown besides the bodies: layers of the engine's inner state, and a pair of bodies
//! whose narrow phase is looked at, iteration by iteration.

use ch00_scenes::{ContactPoint, Dissection, Layer};
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
    /// Looks at where the narrow phase ends, which takes the smaller index first.
    #[must_use]
    pub fn new([one, two]: [usize; 2]) -> Self {
        Self {
            bodies: [one.min(two), one.max(two)],
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
        let room = 0.05 * (high - low);
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
    neighbours_in(&session.engine().contacts(), session.engine().pairs(), body)
}

fn neighbours_in(
    contacts: &[ContactPoint],
    pairs: &[(usize, usize)],
    body: usize,
) -> Vec<Neighbour> {
    let mut found: Vec<Neighbour> = Vec::new();
    for contact in contacts {
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
    let pressed = |neighbour: &Neighbour| neighbour.impulse.unwrap_or(0.0);
    found.sort_by(|one, two| pressed(two).total_cmp(&pressed(one)));
    for &(a, b) in pairs {
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
    deepest_in(&session.engine().contacts(), session.engine().pairs(), body)
}

fn deepest_in(
    contacts: &[ContactPoint],
    pairs: &[(usize, usize)],
    body: Option<usize>,
) -> Option<[usize; 2]> {
    let fits = |pair: &[usize; 2]| body.is_none_or(|body| pair.contains(&body));
    let deepest = contacts
        .iter()
        .filter(|contact| fits(&[contact.a, contact.b]))
        .max_by(|one, two| one.depth.total_cmp(&two.depth))
        .map(|contact| [contact.a, contact.b]);
    let mut pairs = pairs.iter().map(|&(a, b)| [a, b]);
    deepest.or_else(|| pairs.find(fits))
}

/// The other one of a pair, if this body is in it.
fn other_of([a, b]: [usize; 2], body: usize) -> Option<usize> {
    match body {
        _ if body == a => Some(b),
        _ if body == b => Some(a),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{Drawing, Phase};
    use glam::DVec3;

    use super::*;

    fn contact(a: usize, b: usize, depth: f64, impulse: f64) -> ContactPoint {
        ContactPoint {
            a,
            b,
            point: DVec3::ZERO,
            normal: DVec3::Y,
            depth,
            impulse: impulse * DVec3::Y,
        }
    }

    #[test]
    fn neighbours_are_the_hardest_pressed_first_and_then_the_near_ones() {
        let contacts = [
            contact(1, 2, 0.0, 0.4),
            contact(2, 3, 0.0, 0.3),
            contact(2, 3, 0.0, 0.3),
            contact(4, 5, 0.0, 9.0),
        ];
        let pairs = [(0, 2), (1, 2), (2, 3), (4, 5)];
        let found = neighbours_in(&contacts, &pairs, 2);
        let bodies: Vec<usize> = found.iter().map(|neighbour| neighbour.body).collect();
        assert_eq!(bodies, [3, 1, 0]);
        let impulses: Vec<_> = found.iter().map(|neighbour| neighbour.impulse).collect();
        assert_eq!(impulses, [Some(0.6), Some(0.4), None]);
    }

    #[test]
    fn the_deepest_contact_is_worth_looking_at_or_else_a_near_pair() {
        let contacts = [contact(1, 2, 0.1, 0.0), contact(2, 3, 0.2, 0.0)];
        let pairs = [(0, 1), (1, 2), (2, 3)];
        assert_eq!(deepest_in(&contacts, &pairs, None), Some([2, 3]));
        assert_eq!(deepest_in(&contacts, &pairs, Some(1)), Some([1, 2]));
        assert_eq!(deepest_in(&contacts, &pairs, Some(0)), Some([0, 1]));
        assert_eq!(deepest_in(&contacts, &pairs, Some(7)), None);
    }

    #[test]
    fn a_layer_is_shown_and_taken_away_and_bodies_are_of_glass_meanwhile() {
        let mut show = Show::default();
        assert!(!show.is_any() && !show.is_glass());
        show.toggle(Layer::Contacts);
        assert!(show.is_any() && show.is_glass());
        show.is_see_through = false;
        assert!(!show.is_glass());
        show.toggle(Layer::Contacts);
        assert!(!show.is_any());
    }

    #[test]
    fn steps_stop_at_both_ends_and_the_last_one_stays_the_last() {
        let at = |step| Dissection {
            phases: vec![Phase {
                name: "GJK",
                steps: 4,
            }],
            step,
            title: String::new(),
            text: String::new(),
            bounds: Vec::new(),
            surface: Vec::new(),
            core: Vec::new(),
            difference: Drawing::default(),
            world: Drawing::default(),
        };
        let mut pair = Pair::new([5, 2]);
        assert_eq!((pair.bodies, pair.step), ([2, 5], None));
        for (by, from, to) in [
            (-1, 3, Some(2)),
            (1, 2, None),
            (isize::MIN, 2, Some(0)),
            (-1, 0, Some(0)),
            (isize::MAX, 0, None),
        ] {
            pair.move_step(by, &at(from));
            assert_eq!(pair.step, to);
        }
    }
}
