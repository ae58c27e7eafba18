//! Scenes whose only forces are gravity and joints.

use std::f64::consts::PI;

use ch00_scenes::measures::{Conserved, hinge_misalignment, joint_separation, limit_excess};
use ch00_scenes::{Scene, builtin};

use super::*;

fn scene(name: &str, count: Option<u64>) -> Scene {
    builtin::build(name, count, None).expect("a built-in scene")
}

/// What went wrong most in a run.
#[derive(Default)]
struct Worst {
    /// m.
    gap: f64,
    /// Of a hinge, rad.
    misalignment: f64,
    /// Over a limit, rad.
    excess: f64,
}

fn run(world: &mut World, scene: &Scene, steps: u32) -> Worst {
    let mut worst = Worst::default();
    for _ in 0..steps {
        world.step();
        let state = world.state();
        let most = |old: f64, new: Option<f64>| old.max(new.unwrap_or(0.0));
        worst.gap = most(worst.gap, joint_separation(scene, &state));
        worst.misalignment = most(worst.misalignment, hinge_misalignment(scene, &state));
        worst.excess = most(worst.excess, limit_excess(scene, &state));
    }
    worst
}

fn worst(scene: &Scene, substeps: u32, steps: u32) -> Worst {
    run(&mut World::of(scene, substeps), scene, steps)
}

#[test]
fn a_chain_that_swings_with_a_heavy_ball_stays_in_one_piece() {
    let scene = scene("chain", None);
    // 10 s. Ten substeps part it by ½ h² ω² r in the fastest turns, sixteen by 2.6 times less.
    for (substeps, most) in [(8, 4e-4), (10, 2.5e-4), (16, 1e-4)] {
        let gap = worst(&scene, substeps, 600).gap;
        assert!(gap < most, "{substeps} substeps: {gap} m");
    }
}

#[test]
fn a_chain_swings_with_the_energy_that_it_has() {
    let scene = scene("chain", None);
    let mut world = World::of(&scene, 16);
    let energy = |world: &World| Conserved::of(&scene, &world.state()).energy();
    let before = energy(&world);
    for step in 0..600 {
        world.step();
        let off = energy(&world) / before - 1.0;
        assert!(off.abs() < 1e-3, "step {step}: {off}");
    }
}

#[test]
fn a_chain_that_hangs_hangs_still() {
    let scene = scene("chain_hanging", None);
    let mut world = World::of(&scene, 10);
    let gap = run(&mut world, &scene, 300).gap;
    assert!(gap < 1e-6, "{gap} m");
    for motion in &world.bodies.motion {
        assert!(motion.velocity.length() < 1e-4, "{}", motion.velocity);
    }
}

/// A rod of 1 m that is drawn aside by 60° from where it hangs on its end, and its period: I is that
/// about the pin, T = 2π √(I/(m g ½))/agm(1, cos 30°).
fn pendulum() -> (Scene, f64) {
    let mut scene = Scene::new("pendulum");
    let half_extents = DVec3::new(0.01, 0.5, 0.01);
    let shape = Shape::Box { half_extents };
    let orientation = glam::DQuat::from_rotation_z(PI / 3.0);
    let rod = Body::new(shape, 2.0, orientation * DVec3::NEG_Y * 0.5);
    let inertia = shape.inertia(rod.mass).z + rod.mass * 0.25;
    scene.bodies = vec![
        Body::new(Shape::Sphere { radius: 0.1 }, 0.0, DVec3::ZERO),
        Body { orientation, ..rod },
    ];
    scene.joints = vec![Joint::pin(0, 1, DVec3::ZERO, DVec3::Y * 0.5)];
    let (mut one, mut other) = (1.0, (PI / 6.0).cos());
    for _ in 0..8 {
        (one, other) = (0.5 * (one + other), (one * other).sqrt());
    }
    let slow = (inertia / (2.0 * 9.81 * 0.5)).sqrt();
    (scene, 2.0 * PI * slow / one)
}

/// The mean period of ten swings, from the times at which it hangs lowest and moves to the left, s.
fn measured_period(world: &mut World) -> f64 {
    let (mut passes, mut time, mut last) = (Vec::new(), 0.0, 0.0);
    let h = f64::from(world.h);
    while passes.len() < 11 {
        world.substep();
        let x = f64::from(world.bodies.place[1].position.x);
        if last > 0.0 && x <= 0.0 {
            passes.push(time + h * last / (last - x));
        }
        (time, last) = (time + h, x);
    }
    (passes[10] - passes[0]) / 10.0
}

#[test]
fn a_rod_on_a_pin_keeps_the_time_of_a_pendulum() {
    let (scene, period) = pendulum();
    // Second order: four times the substeps, a sixteenth of the error.
    for (substeps, most) in [(4, 1e-4), (16, 6.5e-6)] {
        let measured = measured_period(&mut World::of(&scene, substeps));
        let off = measured / period - 1.0;
        assert!(off.abs() < most, "{substeps} substeps: {off}");
    }
}

#[test]
fn a_door_swings_on_a_hinge_and_on_two_pins_alike() {
    let [hinge, pins] = ["door", "door_pins"].map(|name| {
        let scene = scene(name, None);
        let mut world = World::of(&scene, 10);
        let first = run(&mut world, &scene, 60);
        let angle = 2.0 * libm_atan2(world.bodies.attitude[1].y, world.bodies.attitude[1].w);
        assert!(
            (angle - 0.8).abs() < 1e-4,
            "{name}: 1 s at 0.8 rad/s: {angle}"
        );
        let worst = run(&mut world, &scene, 120);
        assert!(worst.gap.max(first.gap) < 2e-6, "{name}: {} m", worst.gap);
        assert!(
            worst.misalignment < 1e-6,
            "{name}: {} rad",
            worst.misalignment
        );
        // It came to its stop at 2 rad after 2.5 s.
        assert!(worst.excess < 1e-3, "{name}: {} rad", worst.excess);
        let spin = world.bodies.spin[1].angular_velocity.length();
        assert!(spin < 1e-3, "{name}: {spin} rad/s");
        world.bodies.attitude[1]
    });
    assert!((hinge - pins).length() < 1e-6, "{hinge} {pins}");
}

fn libm_atan2(y: f32, x: f32) -> f32 {
    ch00_maths::f32::real::atan2(y, x)
}

#[test]
fn the_balls_of_a_cradle_stay_on_their_threads_and_in_their_plane() {
    let scene = scene("cradle", None);
    let mut world = World::of(&scene, 16);
    let gap = run(&mut world, &scene, 600).gap;
    assert!(gap < 2e-6, "{gap} m");
    for ball in 2..7 {
        let z = world.bodies.place[ball].position.z;
        assert!(z.abs() < 1e-6, "ball {ball}: {z} m");
    }
}

/// Nothing but a ragdoll, which turns as a whole at up to `whirl` rad/s about each axis, and its bones
/// besides.
fn tumbling(seed: u64, whirl: f64) -> Scene {
    let mut scene = scene("ragdolls", Some(1));
    scene.gravity = DVec3::ZERO;
    scene.bodies.drain(0..5);
    for joint in &mut scene.joints {
        if let Joint::Ball { a, b, .. } = joint {
            *a -= 5;
            *b -= 5;
        }
    }
    let mut random = SplitMix64::new(seed);
    let turn = random.vector(whirl);
    let hips = scene.bodies[0].position;
    for body in &mut scene.bodies {
        body.linear_velocity = turn.cross(body.position - hips);
        body.angular_velocity = turn + random.vector(whirl);
    }
    scene
}

#[test]
fn a_ragdoll_that_tumbles_in_space_keeps_its_momentum_and_its_limits() {
    for seed in 0..4 {
        let scene = tumbling(seed, 5.0);
        let mut world = World::of(&scene, 16);
        let before = world.momentum();
        let worst = run(&mut world, &scene, 300);
        let after = world.momentum();
        let (linear, angular) = (after.0 - before.0, after.1 - before.1);
        // 63 kg, and 10 to 100 kg m²/s. Pushes, which move bodies without a momentum, cost some of it.
        assert!(linear.length() < 2e-4, "seed {seed}: {linear} kg m/s");
        let off = angular.length() / before.1.length();
        assert!(off < 1e-3, "seed {seed}: {off} of the angular momentum");
        assert!(worst.gap < 1e-4, "seed {seed}: {} m", worst.gap);
        assert!(worst.excess < 0.02, "seed {seed}: {} rad", worst.excess);
    }
}

#[test]
fn limits_hold_in_a_whirl_and_what_is_beyond_comes_back() {
    for seed in 0..4 {
        let scene = tumbling(seed, 20.0);
        let mut world = World::of(&scene, 16);
        let worst = run(&mut world, &scene, 120);
        assert!(worst.excess < 0.25, "seed {seed}: {} rad", worst.excess);
        run(&mut world, &scene, 240);
        let later = run(&mut world, &scene, 60).excess;
        assert!(later < 0.02, "seed {seed}: {later} rad");
    }
}

/// A chain of eight links and a ring of four, each closed by a joint that no tree holds.
fn closed() -> [Scene; 2] {
    let link = Shape::Box {
        half_extents: DVec3::new(0.5, 0.05, 0.05),
    };
    let mut bridge = Scene::new("bridge");
    for i in 0..10 {
        let mass = if i % 9 == 0 { 0.0 } else { 1.0 };
        bridge
            .bodies
            .push(Body::new(link, mass, DVec3::X * f64::from(i)));
    }
    for i in 0..9 {
        bridge
            .joints
            .push(Joint::pin(i, i + 1, DVec3::X * 0.5, DVec3::X * -0.5));
    }
    let mut ring = Scene::new("ring");
    let turns = [0.0, 0.5, 1.0, 1.5].map(|half| glam::DQuat::from_rotation_z(half * PI));
    for orientation in turns {
        let position = orientation * DVec3::new(0.0, -0.5, 0.0);
        ring.bodies.push(Body {
            orientation,
            ..Body::new(link, 1.0, position)
        });
    }
    ring.bodies[0].mass = 0.0;
    for i in 0..4 {
        ring.joints.push(Joint::Hinge {
            a: i,
            b: (i + 1) % 4,
            anchor_a: DVec3::X * 0.5,
            anchor_b: DVec3::X * -0.5,
            axis_a: DVec3::Z,
            axis_b: DVec3::Z,
            range: None,
        });
    }
    [bridge, ring]
}

#[test]
fn loops_stay_closed() {
    let [bridge, ring] = closed();
    for (scene, most) in [(bridge, 5e-3), (ring, 1e-6)] {
        let mut world = World::of(&scene, 16);
        assert_eq!(world.trees.loops.len(), 1, "{}", scene.name);
        let worst = run(&mut world, &scene, 300);
        assert!(worst.gap < most, "{}: {} m", scene.name, worst.gap);
        assert!(
            worst.misalignment < 1e-5,
            "{}: {} rad",
            scene.name,
            worst.misalignment
        );
    }
}
