//! Scenes whose only forces are gravity and joints.

use ch00_scenes::measures::{hinge_misalignment, joint_separation, limit_excess};
use ch00_scenes::{Scene, builtin};

use super::*;

fn scene(name: &str, count: Option<u64>) -> Scene {
    builtin::build(name, count, None).expect("a built-in scene")
}

#[test]
fn print_all() {
    for limits in [true, false] {
        let mut scene = scene("ragdolls", Some(1));
        scene.gravity = DVec3::ZERO;
        scene.bodies.drain(0..5);
        for j in &mut scene.joints {
            if let Joint::Ball { a, b, .. } = j {
                *a -= 5;
                *b -= 5;
            }
        }
        let mut random = SplitMix64::new(8);
        let c = scene.bodies[0].position;
        for b in &mut scene.bodies {
            b.linear_velocity = DVec3::new(1.0, 4.0, -2.0).cross(b.position - c) + DVec3::new(0.5, 0.25, 0.125);
            b.angular_velocity = DVec3::new(1.0, 4.0, -2.0) + random.vector(3.0);
        }
        for n in [10, 16] {
            let mut world = World::of(&scene, n);
            if !limits {
                world.trees.limits.clear();
                world.turned.clear();
                world.trees.limit_ends = Ends::of(12, &[]);
            }
            let m0 = world.momentum();
            let mut text = String::new();
            let mut most = 0.0_f64;
            let mut excess = 0.0_f64;
            let e0 = ch00_scenes::measures::Conserved::of(&scene, &world.state()).energy();
            for step in 0..600 {
                world.step();
                most = most.max(joint_separation(&scene, &world.state()).unwrap_or(0.0));
                excess = excess.max(limit_excess(&scene, &world.state()).unwrap_or(0.0));
                if step % 120 == 119 {
                    let m = world.momentum();
                    let e = ch00_scenes::measures::Conserved::of(&scene, &world.state()).energy();
                    text += &format!(" gap {most:.1e} limit {excess:.3} dP {:.1e} dL {:.1e} of {:.1} E {:.3};", (m.0 - m0.0).length(), (m.1 - m0.1).length(), m0.1.length(), e / e0);
                    most = 0.0;
                    excess = 0.0;
                }
            }
            println!("  limits {limits} n {n}: {text}");
        }
    }
}
