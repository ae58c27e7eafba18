//! Joints of the object engine against exact solutions: `tests/reference` has the numbers. Every
//! tolerance says what it comes from.

use std::f64::consts::{PI, TAU};

use ch00_scenes::builtin::ragdolls::{BONES, body};
use ch00_scenes::measures::{Conserved, joint_separation, limit_excess};
use ch00_scenes::{Body, Engine, Joint, Scene, Settings, Shape, State};
use glam::{DQuat, DVec3};

const G: f64 = 9.81;

fn load(scene: &Scene) -> Box<dyn Engine> {
    (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults()).expect("the scene is supported")
}

/// Steps a scene and shows every state, the start first, with the number of steps made.
fn watch(scene: &Scene, steps: u32, mut look: impl FnMut(u32, &State)) {
    let mut engine = load(scene);
    let mut state = State::start_of(scene);
    look(0, &state);
    for step in 1..=steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        look(step, &state);
    }
    assert_eq!(state.not_finite(), 0);
}

fn built_in(name: &str, count: Option<u64>) -> Scene {
    Scene::open(name, count, None).expect("a built-in")
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

fn separation(scene: &Scene, state: &State) -> f64 {
    joint_separation(scene, state).expect("there are joints")
}

fn excess(scene: &Scene, state: &State) -> f64 {
    limit_excess(scene, state).unwrap_or(0.0)
}

/// A body that nothing moves, to hang others on.
fn hook(position: DVec3) -> Body {
    let half_extents = DVec3::splat(0.05);
    Body::new(Shape::Box { half_extents }, 0.0, position)
}

fn rod(length: f64, thickness: f64) -> Shape {
    let half_extents = DVec3::new(thickness, length, thickness) / 2.0;
    Shape::Box { half_extents }
}

// Scenario 9: the pendulum.

/// A pendulum, and the length of a simple one that swings alike, m.
struct Pendulum {
    scene: Scene,
    length: f64,
}

/// A body on a pin at the origin, `arm` above its centre, drawn aside by `theta`.
fn on_a_pin(shape: Shape, arm: f64, theta: f64) -> Pendulum {
    let mut scene = Scene::new("pendulum");
    let tilt = DQuat::from_rotation_z(theta);
    scene.bodies = vec![
        hook(DVec3::ZERO),
        Body {
            orientation: tilt,
            ..Body::new(shape, 1.0, tilt * DVec3::Y * -arm)
        },
    ];
    scene.joints = vec![Joint::pin(0, 1, DVec3::ZERO, DVec3::Y * arm)];
    let about_pin = shape.inertia(1.0).z + arm * arm;
    Pendulum {
        scene,
        length: about_pin / arm,
    }
}

/// A ball on a thread of 1 m, which keeps its centre at its distance and lets it turn.
fn on_a_thread(theta: f64) -> Pendulum {
    let ball = Shape::Sphere { radius: 0.05 };
    let mut scene = on_a_pin(ball, 1.0, theta).scene;
    scene.joints = vec![Joint::Distance {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: DVec3::ZERO,
        length: 1.0,
    }];
    Pendulum { scene, length: 1.0 }
}

/// Three that swing as one of 1 m does, with names.
fn pendulums(theta: f64) -> [(&'static str, Pendulum); 3] {
    let ball = Shape::Sphere { radius: 0.05 };
    [
        ("rod", on_a_pin(rod(1.5, 0.04), 0.75, theta)),
        ("ball", on_a_pin(ball, 1.0, theta)),
        ("thread", on_a_thread(theta)),
    ]
}

/// A box on a pin in its middle's upper face: one that swings as a pendulum of 0.44 m does.
fn short_pendulum(theta: f64, steps_per_second: f64) -> Pendulum {
    let half_extents = DVec3::new(0.3, 0.2, 0.1);
    let mut pendulum = on_a_pin(Shape::Box { half_extents }, 0.3, theta);
    pendulum.scene.dt = 1.0 / steps_per_second;
    pendulum
}

/// Arithmetic-geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// T = 2π √(l/g) / agm(1, cos ½θ₀).
fn exact_period(length: f64, theta: f64) -> f64 {
    TAU * (length / G).sqrt() / agm(1.0, (0.5 * theta).cos())
}

/// What ten swings show.
struct Swings {
    /// Mean of ten, over the exact one.
    period: f64,
    /// Largest angle of the last half swing, rad.
    amplitude: f64,
    /// Largest gap at the pin, or stretch, m.
    stretch: f64,
}

fn swings(pendulum: &Pendulum, theta: f64) -> Swings {
    let Pendulum { scene, length } = pendulum;
    let exact = exact_period(*length, theta);
    let (mut crossings, mut amplitude, mut top) = (Vec::new(), 0.0_f64, 0.0);
    let (mut last, mut stretch) = (theta, 0.0_f64);
    let steps = (10.6 * exact / scene.dt) as u32;
    watch(scene, steps, |step, state| {
        let arm = state.position[1];
        let angle = arm.x.atan2(-arm.y);
        if last.signum() != angle.signum() {
            crossings.push((f64::from(step) - 1.0 + last / (last - angle)) * scene.dt);
            (top, amplitude) = (amplitude, 0.0);
        }
        last = angle;
        amplitude = amplitude.max(angle.abs());
        stretch = stretch.max(separation(scene, state));
    });
    Swings {
        period: (crossings[20] - crossings[0]) / 10.0 / exact,
        amplitude: top,
        stretch,
    }
}

#[test]
fn the_period_of_the_reference_is_that_of_the_formula() {
    for (theta, period) in [
        (0.1, 2.007_321_191),
        (1.0, 2.139_137_601),
        (2.0, 2.665_870_943),
        (3.0, 5.158_066_754),
    ] {
        near(exact_period(1.0, theta), period, 1e-9);
    }
}

#[test]
fn a_pendulum_takes_the_time_that_the_elliptic_integral_says() {
    for theta in [0.1, 1.0, 2.0] {
        for (name, pendulum) in pendulums(theta) {
            let period = swings(&pendulum, theta).period;
            // The reference's bar.
            assert!(
                (period - 1.0).abs() <= 1e-3,
                "{name}, {theta} rad: {period}"
            );
        }
    }
}

#[test]
fn a_pendulum_swings_on_as_wide_as_it_was_drawn_aside() {
    for theta in [0.1, 1.0, 2.0] {
        for (name, pendulum) in pendulums(theta) {
            // What is lost in ten swings at 2 rad; smaller swings lose less.
            let amplitude = swings(&pendulum, theta).amplitude / theta;
            assert!(
                (amplitude - 1.0).abs() <= 3e-3,
                "{name}, {theta} rad: {amplitude}"
            );
        }
    }
}

#[test]
fn a_pendulum_does_not_stretch() {
    for (name, pendulum) in pendulums(2.0) {
        // A gap of 1e-6 m counts as closed, and is measured to the rounding of 1 m.
        let stretch = swings(&pendulum, 2.0).stretch;
        assert!(stretch <= 1.5e-6, "{name}: {stretch}");
    }
}

#[test]
fn a_short_wide_pendulum_keeps_its_period_too() {
    // At 2 rad it turns by 0.14 rad a step. Put back along directions that have turned meanwhile, it
    // would be off by 0.25 %.
    for theta in [0.1, 1.0, 2.0] {
        let off = swings(&short_pendulum(theta, 60.0), theta).period - 1.0;
        assert!(off.abs() <= 1e-3, "{theta} rad: {off}");
    }
}

// Scenario 10: the hanging chain.

const LINKS: usize = 10;
const LINK: f64 = 0.1;

/// Frequency of the first mode, rad/s, of thin links of mass 1 with these moments about their
/// middles, and its angles, the largest of them 1.
///
/// With the angles a of the links, ½ ȧ·M ȧ is the kinetic and ½ a·K a the potential energy. K is
/// diagonal, so a ← K⁻¹ M a finds the slowest mode.
fn first_mode(moment: f64) -> (f64, [f64; LINKS]) {
    // How far the middle of link i moves sideways by a unit angle of link j.
    let moves = |i: usize, j: usize| match j.cmp(&i) {
        std::cmp::Ordering::Less => LINK,
        std::cmp::Ordering::Equal => 0.5 * LINK,
        std::cmp::Ordering::Greater => 0.0,
    };
    let m = |j: usize, k: usize| {
        let sum: f64 = (0..LINKS).map(|i| moves(i, j) * moves(i, k)).sum();
        sum + if j == k { moment } else { 0.0 }
    };
    let stiffness = |j: usize| G * (0..LINKS).map(|i| moves(i, j)).sum::<f64>();
    let (mut a, mut size) = ([1.0; LINKS], 0.0);
    for _ in 0..200 {
        let next: [f64; LINKS] =
            std::array::from_fn(|j| (0..LINKS).map(|k| m(j, k) * a[k]).sum::<f64>() / stiffness(j));
        size = next.iter().fold(0.0, |most, x| x.max(most));
        a = next.map(|x| x / size);
    }
    (1.0 / size.sqrt(), a)
}

#[test]
fn the_first_mode_of_thin_rods_is_that_of_the_reference() {
    let (omega, _) = first_mode(LINK * LINK / 12.0);
    near(omega, 3.767_208_518, 1e-8);
}

/// The chain in its first mode, at 0.01 rad, under a hook at the origin; and its frequency.
fn chain_in_first_mode() -> (Scene, f64) {
    let mut scene = Scene::new("chain in its first mode");
    let link = rod(LINK, 0.01);
    let (omega, angles) = first_mode(link.inertia(1.0).z);
    scene.bodies.push(hook(DVec3::ZERO));
    let mut end = DVec3::ZERO;
    for (i, angle) in angles.into_iter().enumerate() {
        let tilt = DQuat::from_rotation_z(0.01 * angle);
        let half = tilt * DVec3::Y * (0.5 * LINK);
        scene.bodies.push(Body {
            orientation: tilt,
            ..Body::new(link, 1.0, end - half)
        });
        end -= 2.0 * half;
        let of_parent = if i == 0 { 0.0 } else { -0.5 * LINK };
        scene.joints.push(Joint::pin(
            i,
            i + 1,
            DVec3::Y * of_parent,
            DVec3::Y * (0.5 * LINK),
        ));
    }
    (scene, omega)
}

/// Where the lower end of the chain is.
fn end_of_chain(state: &State) -> DVec3 {
    state.position[LINKS] + state.orientation[LINKS] * DVec3::Y * (-0.5 * LINK)
}

/// Times at which the chain's end passes the middle, s, and largest stretch, m, after the first half
/// second and before.
fn swings_of_chain(scene: &Scene, seconds: f64) -> (Vec<f64>, f64, f64) {
    let (mut crossings, mut last) = (Vec::new(), 0.0);
    let (mut later, mut at_first) = (0.0_f64, 0.0_f64);
    watch(scene, (seconds / scene.dt) as u32, |step, state| {
        let end = end_of_chain(state);
        if last * end.x < 0.0 {
            crossings.push((f64::from(step) - 1.0 + last / (last - end.x)) * scene.dt);
        }
        last = end.x;
        let stretch = end.length() - LINK * LINKS as f64;
        let largest = if step > 30 { &mut later } else { &mut at_first };
        *largest = largest.max(stretch);
    });
    (crossings, later, at_first)
}

#[test]
fn a_hanging_chain_swings_in_its_first_mode() {
    let (scene, omega) = chain_in_first_mode();
    let exact = TAU / omega;
    let (crossings, stretch, at_first) = swings_of_chain(&scene, 5.6 * exact);
    let period = (crossings[10] - crossings[0]) / 5.0;
    near(period / exact, 1.0, 1e-3);
    // Eleven gaps that are closed to 1e-6 m each.
    assert!(stretch <= 1.1e-5, "{stretch}");
    // The sums begin at zero, and eight sweeps a step carry the weight up to the hook only slowly.
    assert!(at_first <= 5e-3, "{at_first}");
}

// Scenario 24: a ragdoll before it touches anything.

/// A ragdoll in the air, every bone of it thrown another way: the limbs strain at their pins and run
/// into their limits.
fn thrown_ragdoll() -> Scene {
    let mut scene = built_in("ragdolls", Some(1));
    // In the void.
    scene.drag = 0.0;
    scene.bodies.drain(..body(0, 0));
    for joint in &mut scene.joints {
        if let Joint::Ball { a, b, .. } = joint {
            *a -= body(0, 0);
            *b -= body(0, 0);
        }
    }
    scene.meta.clear();
    let middle = centre_of_mass(&scene, &State::start_of(&scene));
    let spin = DVec3::new(1.5, 0.5, -1.0);
    for (i, bone) in scene.bodies.iter_mut().enumerate() {
        let k = i as f64;
        bone.position -= middle;
        bone.linear_velocity = spin.cross(bone.position);
        bone.angular_velocity = spin + 3.0 * DVec3::new(k.sin(), (2.0 * k).cos(), (3.0 * k).sin());
    }
    scene
}

fn centre_of_mass(scene: &Scene, state: &State) -> DVec3 {
    let mass: f64 = scene.bodies.iter().map(|body| body.mass).sum();
    let sum: DVec3 = scene
        .bodies
        .iter()
        .zip(&state.position)
        .map(|(body, p)| body.mass * *p)
        .sum();
    sum / mass
}

#[test]
fn a_ragdoll_in_the_air_falls_as_a_stone_does() {
    let mut scene = thrown_ragdoll();
    // A step that an f32 holds exactly.
    scene.dt = 1.0 / 64.0;
    assert_eq!(scene.bodies.len(), BONES.len());
    let mass: f64 = scene.bodies.iter().map(|body| body.mass).sum();
    let start = Conserved::of(&scene, &State::start_of(&scene));
    let v0 = start.momentum / mass;
    let turning = |c: &Conserved, x: DVec3| c.angular_momentum - x.cross(c.momentum);
    watch(&scene, 64, |step, state| {
        let t = f64::from(step) * scene.dt;
        let x = centre_of_mass(&scene, state);
        let now = Conserved::of(&scene, state);
        // Rounding: half an ulp of 5 m, 2.4e-7 m, a step, and what it makes of a velocity.
        near(x.distance(v0 * t + 0.5 * scene.gravity * t * t), 0.0, 5e-5);
        let v = v0 + scene.gravity * t;
        near(now.momentum.distance(mass * v) / mass, 0.0, 3e-4);
        // Of 23 N m s; of second order in the step.
        let left = turning(&now, x).distance(turning(&start, DVec3::ZERO));
        near(left / start.angular_momentum.length(), 0.0, 2e-3);
        assert!(separation(&scene, state) <= 2e-5 && excess(&scene, state) <= 2e-5);
    });
}

// Scenario 17: the cradle.

/// Speed that each ball has, or would have, at the bottom of its swing: √(v² + 2 g h).
fn speeds_at_bottom(scene: &Scene, state: &State) -> Vec<f64> {
    (2..7)
        .map(|i| {
            let height = state.position[i].y - scene.bodies[6].position.y;
            let squared = state.linear_velocity[i].length_squared() + 2.0 * G * height;
            squared.max(0.0).sqrt()
        })
        .collect()
}

#[test]
fn a_cradle_hands_its_speed_to_the_last_ball() {
    let scene = built_in("cradle", Some(1));
    watch(&scene, 23, |step, state| {
        if step == 23 {
            for (i, velocity) in state.linear_velocity[2..7].iter().enumerate() {
                near(velocity.x, if i == 4 { 1.0 } else { 0.0 }, 0.01);
            }
        }
    });
}

#[test]
fn two_balls_come_and_two_balls_leave() {
    let scene = built_in("cradle", Some(2));
    watch(&scene, 30, |step, state| {
        if step == 30 {
            let speeds = speeds_at_bottom(&scene, state);
            near(speeds[3], 1.0, 0.01);
            near(speeds[4], 1.0, 0.01);
            // The others rest, but where the overlaps of the impacts have pushed them: up to 24 mm aside.
            assert!(speeds[..3].iter().all(|speed| *speed < 0.12), "{speeds:?}");
        }
    });
}

// The door.

/// How far the door is open, rad.
fn opening(state: &State) -> f64 {
    let front = state.orientation[1] * DVec3::X;
    (-front.z).atan2(front.x)
}

/// The angle between the door's upright edge and the line that it turns about, rad.
fn tilt(state: &State) -> f64 {
    let edge = state.orientation[1] * DVec3::Y;
    edge.cross(DVec3::Y).length().atan2(edge.y)
}

#[test]
fn a_door_keeps_its_line_and_its_stops_whatever_hits_it() {
    for name in ["door", "door_pins"] {
        let scene = built_in(name, None);
        watch(&scene, 300, |_, state| {
            // An angle of 1e-5 rad, a gap of 1e-6 m count as closed.
            assert!(tilt(state) <= 5e-5, "{name}: {}", tilt(state));
            assert!(excess(&scene, state) <= 5e-5, "{name}");
            assert!(separation(&scene, state) <= 5e-6, "{name}");
        });
    }
}

#[test]
fn a_door_on_two_pins_swings_as_one_on_a_hinge_does() {
    let angles = |name| {
        let mut angles = Vec::new();
        watch(&built_in(name, None), 300, |_, state| {
            angles.push(opening(state));
        });
        angles
    };
    let (hinge, pins) = (angles("door"), angles("door_pins"));
    // It has been open as far as it goes, and is closed again.
    near(hinge.iter().copied().fold(0.0, f64::max), 2.0, 1e-3);
    near(hinge[300], 0.0, 1e-3);
    for (step, (a, b)) in hinge.iter().zip(&pins).enumerate() {
        assert!((a - b).abs() <= 2e-3, "step {step}: {a} {b}");
    }
}

// Limits.

/// An upper arm on a joint at the origin, without weight, that turns about it with ω.
fn limb(cone: Option<f64>, twist: Option<[f64; 2]>, omega: DVec3) -> Scene {
    let mut scene = Scene::new("limb");
    scene.gravity = DVec3::ZERO;
    let shape = Shape::Capsule {
        radius: 0.05,
        half_height: 0.11,
    };
    let arm = DVec3::NEG_Y * 0.16;
    scene.bodies = vec![
        hook(DVec3::ZERO),
        Body {
            angular_velocity: omega,
            linear_velocity: omega.cross(arm),
            ..Body::new(shape, 2.0, arm)
        },
    ];
    scene.joints = vec![Joint::Ball {
        a: 0,
        b: 1,
        anchor_a: DVec3::ZERO,
        anchor_b: -arm,
        cone,
        twist,
        limits: None,
        rest: None,
    }];
    scene
}

/// The largest excess over the limits, rad, and the largest energy over its start, in two seconds.
fn thrown(scene: &Scene) -> (f64, f64) {
    let energy = |state: &State| Conserved::of(scene, state).kinetic_energy;
    let start = energy(&State::start_of(scene));
    let (mut beyond, mut most) = (0.0_f64, 0.0_f64);
    watch(scene, 120, |_, state| {
        beyond = beyond.max(excess(scene, state));
        most = most.max(energy(state) / start);
    });
    (beyond, most)
}

#[test]
fn a_limb_that_is_thrown_against_its_cone_stops_within_it() {
    for omega in [
        DVec3::new(3.0, 0.0, 2.0),
        DVec3::new(30.0, 0.0, 20.0),
        DVec3::new(5.0, 4.0, -3.0),
        DVec3::new(15.0, 14.0, -13.0),
    ] {
        for twist in [None, Some([-0.3, 0.3])] {
            let (beyond, most) = thrown(&limb(Some(1.0), twist, omega));
            // An angle of 1e-5 rad counts as none; a limit takes energy and gives none.
            assert!(beyond <= 2e-5 && most <= 1.001, "{omega}: {beyond} {most}");
        }
    }
}

#[test]
fn a_cone_just_under_pi_is_a_limit_like_any_other() {
    for omega in [DVec3::new(6.0, 1.0, 0.0), DVec3::new(30.0, 2.0, 10.0)] {
        for twist in [None, Some([-0.3, 0.3])] {
            let (beyond, most) = thrown(&limb(Some(PI - 1e-3), twist, omega));
            assert!(beyond <= 2e-5 && most <= 1.005, "{omega}: {beyond} {most}");
        }
    }
}

#[test]
fn a_limb_may_swing_through_the_singular_direction() {
    for omega in [
        DVec3::X * 15.0,
        DVec3::new(15.0, 0.1, 0.05),
        DVec3::new(15.0, 1.0, 0.0),
    ] {
        // No cone: once round in less than half a second, past where the twist has no value.
        let (_, most) = thrown(&limb(None, Some([-0.3, 0.3]), omega));
        assert!(most <= 1.01, "{omega}: {most}");
    }
}
