//! The kernels against the functions that they are named after, on whatever device there is.

use glam::Vec3;

use super::*;
use crate::rows::{Held, Limit, Node, Press, Pressed, Push, Rigid, Step, Turned};
use crate::stream::{Columns, Gpu, Kernel, Passes, source};

/// A world's rows on the device.
struct Device {
    columns: Columns,
}

impl Device {
    fn of(world: &World) -> Self {
        let gpu = Gpu::open().expect("a graphics device; lavapipe or llvmpipe will do");
        let mut columns = Columns::new(&gpu);
        let step = Step {
            h: world.h,
            ..Step::default()
        };
        columns.add_uniform("step", &step).expect("room");
        let mut device = Self { columns };
        let rows = 0..world.bodies.rows();
        let rigids: Vec<Rigid> = rows.map(|row| rigid_of(world, row)).collect();
        device.add("rigids", &rigids);
        device.add("pushes", &world.bodies.push);
        device.add("joined", &world.joined);
        device.add("nodes", &world.trees.nodes);
        device.add("limits", &world.trees.limits);
        device.add("turned", &world.limits.turned);
        device.add("loops", &world.trees.loops);
        let presses: Vec<Pressed> = world.pressed.iter().map(pressed_of).collect();
        device.add("loop_presses", &presses);
        device
    }

    fn add<R: bytemuck::Pod>(&mut self, name: &str, rows: &[R]) {
        self.columns.add::<R>(name, rows.len()).expect("room");
        self.columns.write(name, rows).expect("room");
    }

    fn run(&self, shader: &'static str, entry: &str, rows: usize) {
        let text = source(shader).expect("a shader");
        let kernel = Kernel::new(self.columns.gpu(), shader, &text, entry, &[]);
        let kernel = kernel.unwrap_or_else(|error| panic!("{error}"));
        let mut passes = Passes::new(&self.columns);
        passes.run(&kernel, rows).expect("columns");
        passes.submit().expect("a device");
    }

    fn read<R: bytemuck::Pod>(&self, name: &str) -> Vec<R> {
        self.columns.read(name).expect("a column")
    }
}

fn rigid_of(world: &World, row: usize) -> Rigid {
    let bodies = &world.bodies;
    Rigid {
        position: bodies.place[row].position,
        attitude: bodies.attitude[row],
        velocity: bodies.motion[row].velocity,
        shares: bodies.motion[row].shares,
        angular_velocity: bodies.spin[row].angular_velocity,
        inverse_mass: bodies.spin[row].inverse_mass,
        inverse_inertia: bodies.solid[row].inverse_inertia,
        ..Rigid::default()
    }
}

fn pressed_of(press: &Press) -> Pressed {
    let turning = [press.angular_a, press.push_a, press.angular_b, press.push_b];
    Pressed {
        linear: press.linear,
        counts: press.counts,
        push: press.push,
        turning: turning.map(|turning| turning.extend(0.0)),
        ..Pressed::default()
    }
}

#[track_caller]
fn assert_near(what: &str, row: usize, one: Vec3, other: Vec3, most: f32) {
    let size = one.length().max(other.length()).max(1.0);
    let off = (one - other).length() / size;
    assert!(off < most, "{what} {row}: {one} and {other}");
}

/// Compares a solve of all trees.
fn compare_trees(scene: &Scene, seed: u64, most: f32) {
    let mut world = random_world(scene, seed);
    let device = Device::of(&world);
    device.run("ch06_tree", "tree", world.trees.nodes.len());
    world.solve_trees();
    let (rigids, pushes) = (
        device.read::<Rigid>("rigids"),
        device.read::<Push>("pushes"),
    );
    let joined = device.read::<Held>("joined");
    for (row, rigid) in rigids.iter().enumerate() {
        let bodies = &world.bodies;
        let (motion, spin, push) = (&bodies.motion[row], &bodies.spin[row], &bodies.push[row]);
        assert_near("velocity", row, rigid.velocity, motion.velocity, most);
        assert_near(
            "spin",
            row,
            rigid.angular_velocity,
            spin.angular_velocity,
            most,
        );
        assert_near("push", row, pushes[row].velocity, push.velocity, most);
        assert_near(
            "turning push",
            row,
            pushes[row].angular_velocity,
            push.angular_velocity,
            most,
        );
        assert_near(
            "impulse",
            row,
            joined[row].linear,
            world.joined[row].linear,
            most,
        );
        assert_near(
            "turning",
            row,
            joined[row].angular,
            world.joined[row].angular,
            most,
        );
    }
    for (row, node) in device.read::<Node>("nodes").iter().enumerate() {
        if node.kind != crate::rows::EMPTY {
            let impulse = world.trees.nodes[row].impulse;
            assert_near("node", row, node.impulse, impulse, most);
        }
    }
}

#[test]
fn the_kernel_solves_trees_of_all_joints_as_the_function_does() {
    for seed in 0..12 {
        let scene = random_tree(seed, 2 + 5 * seed as usize, seed % 3 == 0);
        compare_trees(&scene, seed, 1e-4);
    }
}

#[test]
fn the_kernel_solves_several_trees_in_one_workgroup_and_more_in_the_next() {
    let mut scene = builtin_scene("ragdolls", Some(13));
    for body in &mut scene.bodies[5..] {
        body.angular_velocity = DVec3::new(1.0, 2.0, 3.0);
    }
    compare_trees(&scene, 4, 1e-4);
}

#[test]
fn the_kernel_swings_a_chain_as_the_function_does() {
    let scene = builtin_scene("chain", None);
    let mut world = World::of(&scene, 16);
    for _ in 0..30 {
        world.step();
    }
    let device = Device::of(&world);
    let before = world.bodies.clone();
    device.run("ch06_tree", "tree", world.trees.nodes.len());
    world.solve_trees();
    for (row, rigid) in device.read::<Rigid>("rigids").iter().enumerate() {
        let velocity = world.bodies.motion[row].velocity;
        // The ball weighs as much as 672 links: rounding is that much larger for a link.
        assert_near("velocity", row, rigid.velocity, velocity, 1e-4);
        assert!((velocity - before.motion[row].velocity).length() < 0.1);
    }
}

/// Joints with all sorts of limits, between bodies that turn beyond them.
fn limited() -> Scene {
    let mut scene = random_tree(9, 40, true);
    let mut random = SplitMix64::new(77);
    for (j, joint) in scene.joints.iter_mut().enumerate() {
        let (a, b) = joint.bodies();
        let (anchor_a, anchor_b) = joint.anchors();
        let range = [-0.1 * random.unit(), 0.1 * random.unit()];
        *joint = Joint::pin(a, b, anchor_a, anchor_b);
        if let Joint::Ball {
            cone,
            twist,
            limits,
            rest,
            ..
        } = joint
        {
            let about = glam::DQuat::from_scaled_axis(random.vector(0.15));
            *rest =
                Some(scene.bodies[a].orientation.conjugate() * scene.bodies[b].orientation * about);
            match j % 4 {
                0 => *cone = Some(0.1),
                1 => *twist = Some(range),
                2 => (*cone, *twist) = (Some(0.05), Some([0.05, 0.05])),
                _ => {
                    *limits = Some(ch00_scenes::EulerLimits {
                        pitch: range,
                        yaw: [0.02, 0.3],
                        roll: [-0.3, -0.02],
                    });
                }
            }
        }
    }
    scene
}

#[test]
fn the_kernel_solves_limits_as_the_function_does() {
    let scene = limited();
    let mut world = random_world(&scene, 9);
    let mut random = SplitMix64::new(78);
    for row in 0..world.trees.limits.len() {
        let limit = &mut world.trees.limits[row];
        limit.impulses = random.vector(0.5).as_vec3();
        world.limits.turned[row].counts = 1.0;
        world.limits.turned[row].turning = random.vector(0.2).as_vec3();
    }
    for motion in &mut world.bodies.motion {
        motion.shares = 2.0;
    }
    world.read_impulses();
    let device = Device::of(&world);
    device.run("ch06_limits", "solve_limits", world.trees.limits.len());
    world.solve_rows();
    let mut active = 0;
    for (row, limit) in device.read::<Limit>("limits").iter().enumerate() {
        assert_near(
            "impulses",
            row,
            limit.impulses,
            world.trees.limits[row].impulses,
            1e-4,
        );
    }
    for (row, turned) in device.read::<Turned>("turned").iter().enumerate() {
        assert_near(
            "turning",
            row,
            turned.turning,
            world.limits.turned[row].turning,
            1e-4,
        );
        assert_near(
            "push",
            row,
            turned.push,
            world.limits.turned[row].push,
            1e-4,
        );
        assert_eq!(turned.counts, world.limits.turned[row].counts, "{row}");
        active += u32::from(turned.turning != Vec3::ZERO);
    }
    assert!(active > 10, "{active} limits hold");
}

#[test]
fn the_kernel_solves_loops_as_the_function_does() {
    let mut scene = random_tree(21, 40, true);
    let more = random_tree(21, 40, true).joints.split_off(1);
    // Each joint a second time, turned about, so that no row of a tree could hold both.
    for mut joint in more {
        if let Joint::Ball { anchor_b, .. } | Joint::Distance { anchor_b, .. } = &mut joint {
            *anchor_b += DVec3::new(0.01, 0.2, 0.3);
        }
        if let Joint::Hinge {
            anchor_b, axis_b, ..
        } = &mut joint
        {
            *anchor_b += DVec3::new(0.02, 0.2, 0.3);
            *axis_b += DVec3::new(0.3, 0.1, 0.0);
        }
        scene.joints.push(joint);
    }
    let mut world = random_world(&scene, 21);
    assert!(world.trees.loops.len() > 30, "{}", world.trees.loops.len());
    let mut random = SplitMix64::new(79);
    for row in 0..world.trees.loops.len() {
        world.trees.loops[row].impulse = random.vector(0.5).as_vec3();
        world.trees.loops[row].turning = random.vector(0.5).as_vec3();
        world.pressed[row].linear = random.vector(0.5).as_vec3();
        world.pressed[row].angular_a = random.vector(0.5).as_vec3();
        world.pressed[row].angular_b = random.vector(0.5).as_vec3();
    }
    let device = Device::of(&world);
    device.run("ch06_loops", "solve_loops", world.trees.loops.len());
    world.solve_rows();
    for (row, pressed) in device.read::<Pressed>("loop_presses").iter().enumerate() {
        let expected = pressed_of(&world.pressed[row]);
        assert_near("linear", row, pressed.linear, expected.linear, 1e-4);
        assert_near("push", row, pressed.push, expected.push, 1e-4);
        for (one, other) in pressed.turning.iter().zip(expected.turning) {
            assert_near("turning", row, one.truncate(), other.truncate(), 1e-4);
        }
    }
}

fn builtin_scene(name: &str, count: Option<u64>) -> Scene {
    ch00_scenes::builtin::build(name, count, None).expect("a built-in scene")
}
