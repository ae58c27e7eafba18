//! A chain that hangs by one end, and one that hangs by both. Along a tree joints don't part; the one that
//! closes a loop is a row with shares, and gives way a little. The answer to an exercise of the page on
//! ragdolls.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example closed_loop -- [LINKS]`

use ch00_scenes::{Body, Joint, Scene, Settings, Shape, State};
use ch06_compute::lanes::Lanes;
use ch06_compute::own_row::tree::Trees;
use ch06_compute::rules::Rules;
use glam::DVec3;

type Problem = Box<dyn std::error::Error>;

/// From pin to pin, m.
const LINK: f64 = 0.25;
/// Five seconds.
const STEPS: u32 = 300;

fn main() -> Result<(), Problem> {
    let links = std::env::args()
        .nth(1)
        .map_or(Ok(12), |count| count.parse())?;
    println!("{links} links of 1 kg and 0.25 m, after 5 s");
    println!("hangs by    substeps  joints in trees  widest, mm  joints in loops  widest, mm");
    for ends in [1, 2] {
        let scene = chain(links, ends);
        let loops = Trees::of(&scene).loops.len();
        for substeps in [4, 10, 20] {
            let gaps = gaps(&scene, substeps)?;
            // The joint that closes the loop is the last one.
            let (tree, closing) = gaps.split_at(gaps.len() - loops);
            let widest = |gaps: &[f64]| 1e3 * gaps.iter().copied().fold(0.0, f64::max);
            println!(
                "{ends} end(s){substeps:>12}{:>17}{:>12.4}{:>17}{:>12.4}",
                tree.len(),
                widest(tree),
                closing.len(),
                widest(closing)
            );
        }
    }
    Ok(())
}

/// A chain that starts in a half circle between its hooks; the second may be left out.
fn chain(links: usize, ends: usize) -> Scene {
    let mut scene = Scene::new("chain");
    let hook = Shape::Sphere { radius: 0.02 };
    let link = Shape::Capsule {
        radius: 0.02,
        half_height: 0.5 * LINK - 0.02,
    };
    let turn = std::f64::consts::PI / links as f64;
    let mut end = DVec3::ZERO;
    scene.bodies.push(Body::new(hook, 0.0, end));
    for k in 0..links {
        // A link's y axis points back to the link before.
        let tilt = glam::DQuat::from_rotation_z((k as f64 + 0.5) * turn);
        let half = tilt * DVec3::Y * (0.5 * LINK);
        scene.bodies.push(Body {
            orientation: tilt,
            ..Body::new(link, 1.0, end - half)
        });
        end -= 2.0 * half;
        let of_parent = if k == 0 { 0.0 } else { -0.5 * LINK };
        let (at_parent, at_link) = (DVec3::Y * of_parent, DVec3::Y * (0.5 * LINK));
        scene.joints.push(Joint::pin(k, k + 1, at_parent, at_link));
    }
    if ends == 2 {
        scene.bodies.push(Body::new(hook, 0.0, end));
        let at_link = DVec3::Y * (-0.5 * LINK);
        scene
            .joints
            .push(Joint::pin(links, links + 1, at_link, DVec3::ZERO));
    }
    scene
}

/// How far the points of each joint are apart, m.
fn gaps(scene: &Scene, substeps: u32) -> Result<Vec<f64>, Problem> {
    let settings = Settings {
        substeps: Some(substeps),
        ..Settings::defaults()
    };
    let rules = Rules::of(scene, &settings)?;
    let mut lanes =
        <Lanes>::of(scene, rules).map_err(|(why, body)| format!("body {body}: {why}"))?;
    for _ in 0..STEPS {
        lanes.step(scene.dt as f32, |_| {});
    }
    let mut state = State::default();
    lanes.bodies.read(&mut state);
    let place =
        |body: usize, anchor: DVec3| state.position[body] + state.orientation[body] * anchor;
    let gap = |joint: &Joint| {
        let ((a, b), (at_a, at_b)) = (joint.bodies(), joint.anchors());
        place(a, at_a).distance(place(b, at_b))
    };
    Ok(scene.joints.iter().map(gap).collect())
}
