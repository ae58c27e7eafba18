//! Trees against a dense solve, and scenes whose only forces are gravity and joints.

mod dense;
mod graph;
mod kernels;
mod scenes;
mod widths;
mod world;

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Body, Joint, Scene, Shape};
use glam::DVec3;

use super::*;
use dense::Dense;
use world::World;

/// Bodies of all sorts, each joined to one before it by a joint of some kind, or the first one to a
/// static body; the joints are up to two centimetres out of place, and everything moves.
fn random_tree(seed: u64, count: usize, is_held: bool) -> Scene {
    let mut random = SplitMix64::new(seed);
    let mut scene = Scene::new("tree");
    let post = Shape::Box {
        half_extents: DVec3::ONE,
    };
    scene.bodies.push(Body::new(post, 0.0, random.vector(1.0)));
    for i in 1..=count {
        let half_extents = DVec3::new(0.1, 0.2, 0.3);
        let mass = random.between(0.5, 5.0);
        let body = Body {
            orientation: random.rotation(),
            linear_velocity: random.vector(3.0),
            angular_velocity: random.vector(5.0),
            ..Body::new(Shape::Box { half_extents }, mass, random.vector(1.0))
        };
        scene.bodies.push(body);
        if i > 1 || is_held {
            let parent = if i == 1 {
                0
            } else {
                1 + random.next_u64() as usize % (i - 1)
            };
            add_joint(&mut scene, parent, i, &mut random);
        }
    }
    scene
}

fn add_joint(scene: &mut Scene, a: usize, b: usize, random: &mut SplitMix64) {
    let (anchor_a, anchor_b) = (random.vector(0.5), random.vector(0.5));
    let hook = scene.bodies[a].position + scene.bodies[a].orientation * anchor_a;
    let arm = scene.bodies[b].orientation * anchor_b;
    scene.bodies[b].position = hook - arm + random.vector(0.01);
    let axis = random.vector(1.0).normalize();
    let turned = |body: usize| scene.bodies[body].orientation.conjugate() * axis;
    let axes = [turned(a), turned(b) + random.vector(0.01)];
    let kind = random.next_u64();
    let mut rod = |scene: &mut Scene, anchor_a| {
        let length = random.between(0.99, 1.01);
        scene.joints.push(Joint::Distance {
            a,
            b,
            anchor_a,
            anchor_b,
            length,
        });
    };
    match kind % if a == 0 { 4 } else { 3 } {
        0 => scene.joints.push(Joint::pin(a, b, anchor_a, anchor_b)),
        1 => scene.joints.push(Joint::Hinge {
            a,
            b,
            anchor_a,
            anchor_b,
            axis_a: axes[0],
            axis_b: axes[1],
            range: None,
        }),
        kind => {
            scene.bodies[b].position += DVec3::X;
            rod(scene, anchor_a);
            if kind == 3 {
                rod(scene, anchor_a + DVec3::new(1.0, 0.0, 1.0));
            }
        }
    }
}

/// A world in which the last substep's impulses, what has been given of them, and pushes are anything.
fn random_world(scene: &Scene, seed: u64) -> World {
    let mut random = SplitMix64::new(seed);
    let mut world = World::of(scene, 1);
    for node in &mut world.trees.nodes {
        node.impulse = random.vector(1.0).as_vec3();
        node.turning = random.vector(1.0).as_vec3();
    }
    for row in 1..scene.bodies.len() {
        world.bodies.push[row].velocity = random.vector(1.0).as_vec3();
        world.bodies.push[row].angular_velocity = random.vector(1.0).as_vec3();
        world.joined[row].linear = random.vector(1.0).as_vec3();
        world.joined[row].angular = random.vector(1.0).as_vec3();
    }
    world.read_impulses();
    world
}

#[test]
fn a_tree_is_solved_as_a_dense_solve_of_all_its_joints_does() {
    for seed in 0..40 {
        let scene = random_tree(seed, 2 + seed as usize % 12, seed % 3 == 0);
        let mut world = random_world(&scene, seed);
        let dense = Dense::of(&world);
        world.solve_trees();
        let lacks = dense.lacks(&world);
        assert!(
            lacks < 3e-5,
            "tree {seed}: a joint's speed is off by {lacks} m/s"
        );
        let [moved, pushed] = dense.after();
        for row in 1..scene.bodies.len() {
            let off = [
                world.bodies.motion[row].velocity.as_dvec3() - moved[row].0,
                world.bodies.spin[row].angular_velocity.as_dvec3() - moved[row].1,
                world.bodies.push[row].velocity.as_dvec3() - pushed[row].0,
                world.bodies.push[row].angular_velocity.as_dvec3() - pushed[row].1,
            ];
            for off in off {
                // They turn at up to 60 rad/s.
                assert!(off.length() < 5e-4, "tree {seed}, body {row}: {off}");
            }
        }
    }
}

#[test]
fn a_tree_that_is_solved_is_left_alone() {
    let scene = random_tree(3, 12, false);
    let mut world = random_world(&scene, 3);
    world.solve_trees();
    let once = world.bodies.clone();
    world.joined.fill(Held::default());
    world.solve_trees();
    for row in 1..scene.bodies.len() {
        let twice = world.bodies.motion[row].velocity;
        assert!((twice - once.motion[row].velocity).length() < 1e-4, "{row}");
    }
}

#[test]
fn a_free_tree_keeps_its_momentum() {
    for seed in 0..20 {
        let scene = random_tree(seed, 12, false);
        let mut world = random_world(&scene, seed);
        // What the bodies have been given already is no impulse of the joints'; and a pull that
        // stiffens them is none either, but tilts the scales a little.
        world.joined.fill(Held::default());
        world.trees.forget();
        world.read_impulses();
        let before = world.momentum();
        world.solve_trees();
        let after = world.momentum();
        assert!((after.0 - before.0).length() < 1e-4, "{before:?} {after:?}");
        assert!((after.1 - before.1).length() < 3e-4, "{before:?} {after:?}");
    }
}

/// A chain whose last body is far heavier than the links, its links thin.
fn thin_chain(links: usize, radius: f64, mass: f64) -> Scene {
    let mut scene = Scene::new("thin");
    scene
        .bodies
        .push(Body::new(Shape::Sphere { radius: 0.1 }, 0.0, DVec3::ZERO));
    for k in 1..=links {
        let shape = Shape::Capsule {
            radius,
            half_height: 0.125 - radius,
        };
        let position = DVec3::new(0.0, -0.25 * k as f64 + 0.125, 0.0);
        scene.joints.push(Joint::pin(
            k - 1,
            k,
            DVec3::Y * if k == 1 { 0.0 } else { -0.125 },
            DVec3::Y * 0.125,
        ));
        scene.bodies.push(Body::new(
            shape,
            if k == links { mass } else { 1.0 },
            position,
        ));
    }
    scene
}

#[test]
fn a_needle_that_carries_ten_tonnes_spins_no_faster_than_it_should() {
    let scene = thin_chain(8, 0.002, 10_000.0);
    let mut world = World::of(&scene, 16);
    for _ in 0..60 {
        world.step();
    }
    for row in 1..=8 {
        let spin = world.bodies.spin[row].angular_velocity;
        assert!(spin.length() < 0.1, "{row}: {spin}");
    }
}
