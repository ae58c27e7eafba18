//! Energy, momentum and angular momentum, and how far they are from the start.

use glam::DVec3;

use crate::{Body, Force, Pole, Scene, State};

/// What nature keeps where nothing takes it away. Static bodies add nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Conserved {
    /// Translation and rotation, J.
    pub kinetic_energy: f64,
    /// Of weight, above y = 0, of magnets, against poles infinitely far apart, and −F · x of constant forces, J.
    pub potential_energy: f64,
    /// Σ m v, N s.
    pub momentum: DVec3,
    /// About the world's origin, Σ m x × v + R I Rᵀ ω, N m s.
    pub angular_momentum: DVec3,
    /// Σ |m v|, N s: what an error of momentum is compared with.
    pub momentum_sum: f64,
    /// Σ of the bodies' own |angular momentum|, N m s: what an error is compared with.
    pub angular_momentum_sum: f64,
}

impl Conserved {
    /// Sums over the bodies of `state`; cost grows with their number alone, apart from
    /// magnets, whose poles are taken pair by pair.
    #[must_use]
    pub fn of(scene: &Scene, state: &State) -> Self {
        let mut sum = Self::default();
        for (i, body) in scene.bodies.iter().enumerate() {
            if !body.is_static() {
                sum.add(scene, body, state, i);
            }
        }
        sum.potential_energy += magnet_energy(scene, state) - work(scene, state);
        sum
    }

    /// Kinetic plus potential energy, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.kinetic_energy + self.potential_energy
    }

    fn add(&mut self, scene: &Scene, body: &Body, state: &State, i: usize) {
        let x = state.position[i];
        let p = body.mass * state.linear_velocity[i];
        let spin = spin_momentum(body, state, i);
        let l = x.cross(p) + spin;
        self.kinetic_energy += kinetic_energy_of(body, state, i);
        self.potential_energy -= body.mass * scene.gravity.dot(x);
        self.momentum += p;
        self.angular_momentum += l;
        self.momentum_sum += p.length();
        self.angular_momentum_sum += l.length();
    }
}

/// Kinetic energy of body `i`, ½ m v² + ½ ω · I ω, J.
#[must_use]
pub fn kinetic_energy_of(body: &Body, state: &State, i: usize) -> f64 {
    let v2 = state.linear_velocity[i].length_squared();
    let spin = spin_momentum(body, state, i);
    0.5 * (body.mass * v2 + state.angular_velocity[i].dot(spin))
}

/// Angular momentum about the body's own centre, R I Rᵀ ω: the moments of inertia belong
/// to the body's axes.
fn spin_momentum(body: &Body, state: &State, i: usize) -> DVec3 {
    let q = state.orientation[i];
    q * (body.shape.inertia(body.mass) * (q.conjugate() * state.angular_velocity[i]))
}

/// Potential energy of all magnets, J, zero when all poles are infinitely far apart.
///
/// The force s₁s₂/(d² + ε²) along the line, integrated from d to infinity:
/// U = s₁s₂/ε · (π/2 − arctan(d/ε)) = s₁s₂/ε · atan2(ε, d). Like poles: U > 0.
#[must_use]
pub fn magnet_energy(scene: &Scene, state: &State) -> f64 {
    let magnets = scene.forces.iter().filter_map(|force| match force {
        Force::Magnets { poles, softening } => Some((poles, *softening)),
        Force::FixedPoint { .. } | Force::Constant { .. } => None,
    });
    magnets
        .map(|(poles, softening)| pole_energy(poles, softening, state))
        .sum()
}

/// What constant forces have done on the way from the origin, J.
fn work(scene: &Scene, state: &State) -> f64 {
    let done = |force: &Force| match *force {
        Force::Constant { body, force } => force.dot(state.position[body]),
        Force::Magnets { .. } | Force::FixedPoint { .. } => 0.0,
    };
    scene.forces.iter().map(done).sum()
}

fn pole_energy(poles: &[Pole], softening: f64, state: &State) -> f64 {
    let place =
        |pole: &Pole| state.position[pole.body] + state.orientation[pole.body] * pole.position;
    let mut energy = 0.0;
    for (i, a) in poles.iter().enumerate() {
        for b in poles[i + 1..].iter().filter(|b| b.body != a.body) {
            let d = place(a).distance(place(b));
            energy += a.strength * b.strength / softening * softening.atan2(d);
        }
    }
    energy
}

/// The start, with which later states are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// The sums at the start.
    pub start: Conserved,
    has_energy: bool,
    has_momentum: bool,
}

impl Reference {
    /// The start of `scene`, and which sums its physics keeps.
    ///
    /// Energy is compared in every scene that has no prescribed motions (losses at
    /// impacts and by drag show as such). Momentum is compared where all that acts is
    /// between the bodies: no static bodies, no gravity, no drag, no fixed points, no
    /// constant forces, no prescribed motions. Magnets are allowed: their forces come in opposite pairs.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let has_energy = scene.orbits.is_empty();
        let from_outside = |force: &Force| !matches!(force, Force::Magnets { .. });
        Self {
            start: Conserved::of(scene, &State::start_of(scene)),
            has_energy,
            has_momentum: has_energy
                && scene.gravity == DVec3::ZERO
                && scene.drag == 0.0
                && scene.dynamic_count() == scene.bodies.len()
                && !scene.forces.iter().any(from_outside),
        }
    }

    /// (E − E₀) / (K₀ + |U₀|): above 0 where the run gained energy. `None` where bodies are
    /// moved by prescription.
    #[must_use]
    pub fn energy_error(&self, now: &Conserved) -> Option<f64> {
        let scale = self.start.kinetic_energy + self.start.potential_energy.abs();
        let gained = now.energy() - self.start.energy();
        self.has_energy.then(|| gained / scale.max(SMALLEST_SCALE))
    }

    /// |P − P₀| / Σ|m v|, the sum taken at the start or now, whichever is larger (a scene
    /// may start at rest). `None` where momentum is not kept.
    #[must_use]
    pub fn momentum_error(&self, now: &Conserved) -> Option<f64> {
        let scale = self.start.momentum_sum.max(now.momentum_sum);
        let off = now.momentum.distance(self.start.momentum);
        self.has_momentum.then(|| off / scale.max(SMALLEST_SCALE))
    }

    /// The same of angular momentum about the world's origin.
    #[must_use]
    pub fn angular_momentum_error(&self, now: &Conserved) -> Option<f64> {
        let scale = self
            .start
            .angular_momentum_sum
            .max(now.angular_momentum_sum);
        let off = now.angular_momentum.distance(self.start.angular_momentum);
        self.has_momentum.then(|| off / scale.max(SMALLEST_SCALE))
    }
}

/// Keeps a relative error finite in a scene in which nothing ever moves.
const SMALLEST_SCALE: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_1_SQRT_2;

    use glam::DQuat;

    use super::*;
    use crate::{Shape, builtin};

    fn close(a: f64, b: f64, tolerance: f64) {
        assert!((a - b).abs() <= tolerance, "{a} is not {b}");
    }

    /// The box of scenario 4, turning as there.
    fn top() -> Scene {
        let half_extents = DVec3::new(0.3, 0.2, 0.1);
        let mut scene = Scene::new("top");
        scene.gravity = DVec3::ZERO;
        scene.bodies = vec![Body {
            angular_velocity: DVec3::new(1.0, 2.0, 3.0),
            ..Body::new(Shape::Box { half_extents }, 1.0, DVec3::ZERO)
        }];
        scene
    }

    fn start(scene: &Scene) -> Conserved {
        Conserved::of(scene, &State::start_of(scene))
    }

    #[test]
    fn the_free_top_has_the_energy_of_the_reference() {
        close(start(&top()).kinetic_energy, 0.27, 1e-15);
    }

    #[test]
    fn the_free_top_has_the_angular_momentum_of_the_reference() {
        let exact = DVec3::new(1.0 / 60.0, 1.0 / 15.0, 0.13);
        close(start(&top()).angular_momentum.distance(exact), 0.0, 1e-15);
    }

    #[test]
    fn inertia_turns_with_the_body() {
        let mut scene = top();
        // A quarter turn about y: the world's x is the body's z.
        scene.bodies[0].orientation = DQuat::from_xyzw(0.0, FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2);
        scene.bodies[0].angular_velocity = DVec3::X;
        close(start(&scene).kinetic_energy, 0.5 * 13.0 / 300.0, 1e-15);
    }

    #[test]
    fn a_ball_at_rest_five_metres_up_has_mgh() {
        let scene = builtin::build("bounce", None, None).unwrap();
        close(start(&scene).energy(), 9.81 * 5.0, 1e-12);
    }

    #[test]
    fn the_pair_has_the_momentum_that_its_page_states() {
        let scene = builtin::build("pair", None, None).unwrap();
        let exact = DVec3::new(3.1, 0.14, 0.0);
        close(start(&scene).momentum.distance(exact), 0.0, 1e-15);
    }

    #[test]
    fn a_body_that_passes_the_origin_at_a_distance_has_angular_momentum() {
        let mut scene = top();
        scene.bodies[0].angular_velocity = DVec3::ZERO;
        scene.bodies[0].position = DVec3::new(0.0, 2.0, 0.0);
        scene.bodies[0].linear_velocity = DVec3::new(3.0, 0.0, 0.0);
        let expected = DVec3::new(0.0, 0.0, -6.0);
        close(
            start(&scene).angular_momentum.distance(expected),
            0.0,
            1e-15,
        );
    }

    fn two_poles(strengths: [f64; 2], softening: f64) -> (Scene, State) {
        let mut scene = Scene::new("poles");
        scene.gravity = DVec3::ZERO;
        let ball = Shape::Sphere { radius: 0.1 };
        scene.bodies = vec![Body::new(ball, 1.0, DVec3::ZERO); 2];
        let poles = strengths
            .into_iter()
            .enumerate()
            .map(|(body, strength)| Pole {
                body,
                position: DVec3::ZERO,
                strength,
            })
            .collect();
        scene.forces = vec![Force::Magnets { poles, softening }];
        let state = State::start_of(&scene);
        (scene, state)
    }

    #[test]
    fn the_slope_of_the_magnets_energy_is_their_force() {
        let (scene, mut state) = two_poles([3.0, -2.0], 0.05);
        let mut energy_at = |d: f64| {
            state.position[1].x = d;
            magnet_energy(&scene, &state)
        };
        for d in [0.01, 0.1, 0.5, 3.0] {
            let step = 1e-5;
            let slope = (energy_at(d + step) - energy_at(d - step)) / (2.0 * step);
            let force = 3.0 * -2.0 / (d * d + 0.05 * 0.05);
            // The difference quotient is off by step²/6 · U‴, below 1e-6 of the force.
            close(-slope / force, 1.0, 1e-6);
        }
    }

    #[test]
    fn what_a_constant_force_does_to_a_body_is_taken_from_its_potential() {
        let (mut scene, mut state) = two_poles([0.0, 0.0], 0.1);
        let force = DVec3::new(3.0, 0.0, 4.0);
        scene.gravity = DVec3::ZERO;
        scene.forces = vec![Force::Constant { body: 1, force }];
        let before = Conserved::of(&scene, &state).potential_energy;
        state.position[1] += DVec3::new(0.5, 7.0, 0.25);
        let after = Conserved::of(&scene, &state).potential_energy;
        close(after - before, -2.5, 1e-12);
    }

    #[test]
    fn like_poles_have_energy_to_give_and_far_ones_none() {
        let (scene, mut state) = two_poles([1.0, 1.0], 0.1);
        state.position[1].x = 1.0;
        assert!(magnet_energy(&scene, &state) > 0.0);
        state.position[1].x = 1e9;
        close(magnet_energy(&scene, &state), 0.0, 1e-8);
    }

    #[test]
    fn poles_of_one_body_do_not_act_on_each_other() {
        let (mut scene, state) = two_poles([1.0, 1.0], 0.1);
        let Force::Magnets { poles, .. } = &mut scene.forces[0] else {
            panic!("made above");
        };
        poles[1].body = 0;
        close(magnet_energy(&scene, &state), 0.0, 0.0);
    }

    #[test]
    fn losing_a_tenth_of_the_speed_of_one_ball_is_seen_in_momentum_and_energy() {
        let scene = builtin::build("pair", None, None).unwrap();
        let reference = Reference::of(&scene);
        let mut state = State::start_of(&scene);
        state.linear_velocity[0] *= 0.9;
        let now = Conserved::of(&scene, &state);
        let lost = 0.1 * 2.0 * 1.9;
        let sum = reference.start.momentum_sum;
        close(reference.momentum_error(&now).unwrap(), lost / sum, 1e-15);
        assert!(reference.energy_error(&now).unwrap() < -0.1);
    }

    #[test]
    fn momentum_is_not_judged_under_gravity_or_beside_a_floor() {
        let scene = builtin::build("bounce", None, None).unwrap();
        let reference = Reference::of(&scene);
        assert_eq!(reference.momentum_error(&reference.start), None);
        assert_eq!(reference.energy_error(&reference.start), Some(0.0));
    }

    #[test]
    fn momentum_is_judged_among_free_magnets() {
        let scene = builtin::build("magnets", None, None).unwrap();
        let reference = Reference::of(&scene);
        assert_eq!(reference.momentum_error(&reference.start), Some(0.0));
    }

    #[test]
    fn an_orrery_is_driven_and_keeps_nothing() {
        let scene = builtin::build("orrery", None, None).unwrap();
        let reference = Reference::of(&scene);
        assert_eq!(reference.energy_error(&reference.start), None);
        assert_eq!(reference.momentum_error(&reference.start), None);
    }
}
