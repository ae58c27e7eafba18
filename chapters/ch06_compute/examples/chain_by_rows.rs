//! A chain with a heavy ball at its end, all joints of it solved at once by the two walks along its tree,
//! and joint by joint with shares of the masses, as contacts are. How fast do its joints part after a
//! substep of gravity, and after how many passes no more? The answer to an exercise of the page on ragdolls.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example chain_by_rows -- [LINKS]`

use ch00_scenes::Scene;
use ch06_compute::bodies::Bodies;
use ch06_compute::own_row::body::Gathered;
use ch06_compute::own_row::loops::solve_loop;
use ch06_compute::own_row::side::Side;
use ch06_compute::own_row::tree::{Batches, Trees};
use ch06_compute::rows::{Held, NONE, Node, Press};
use glam::Vec3;

/// Of a substep, s.
const H: f32 = 1.0 / 600.0;
/// After so many passes the joints are looked at.
const SHOWN: [u32; 6] = [0, 1, 10, 100, 1000, 10_000];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let links = std::env::args()
        .nth(1)
        .map_or(Ok(10), |count| count.parse())?;
    let scene = Scene::open("chain_hanging", Some(links), None)?;
    let trees = Trees::of(&scene);
    let joints: Vec<Node> = trees
        .nodes
        .iter()
        .filter(|node| is_joint(node))
        .copied()
        .collect();
    println!("{links} links of 1 kg and a ball of 672 kg, after 1/600 s of gravity");

    let mut bodies = kicked(&scene);
    let mut joined = vec![Held::default(); bodies.rows()];
    let mut batches = Batches::<f32>::of(&trees, &bodies);
    batches.solve(&bodies, &joined, H);
    batches.apply(&mut bodies, &mut joined);
    println!(
        "along the tree, once: joints part by {:.1e} m/s",
        parting(&joints, &bodies)
    );

    let mut chain = Chain::new(&scene, joints);
    println!("joint by joint:");
    for pass in 0..=SHOWN[SHOWN.len() - 1] {
        if SHOWN.contains(&pass) {
            let parts = parting(&chain.joints, &chain.bodies);
            println!("{pass:>9} passes: joints part by {parts:.1e} m/s");
        }
        chain.pass();
    }
    Ok(())
}

fn is_joint(node: &Node) -> bool {
    node.parent_body != NONE && node.kind != ch06_compute::rows::EMPTY
}

/// The bodies after a substep's gravity.
fn kicked(scene: &Scene) -> Bodies {
    let mut bodies = Bodies::of(scene);
    for row in 0..bodies.rows() {
        if !bodies.is_static(row) {
            bodies.motion[row].velocity = H * scene.gravity.as_vec3();
        }
    }
    bodies
}

/// How fast the two points of a joint part, m/s, where that is fastest.
fn parting(joints: &[Node], bodies: &Bodies) -> f32 {
    let of = |body: u32, anchor: Vec3| {
        let row = body as usize;
        bodies.velocity_at(row, bodies.attitude[row] * anchor)
    };
    let parts = joints.iter().map(|joint| {
        let (child, parent) = (
            of(joint.body, joint.anchor),
            of(joint.parent_body, joint.parent_anchor),
        );
        (child - parent).length()
    });
    parts.fold(0.0, f32::max)
}

/// A chain whose joints are rows by themselves.
struct Chain {
    bodies: Bodies,
    joints: Vec<Node>,
    /// What each joint gave its bodies.
    given: Vec<Press>,
}

impl Chain {
    fn new(scene: &Scene, joints: Vec<Node>) -> Self {
        let mut bodies = kicked(scene);
        for row in 0..bodies.rows() {
            let ends = joints
                .iter()
                .filter(|joint| joint.body as usize == row || joint.parent_body as usize == row);
            bodies.motion[row].shares = (ends.count() as f32).max(1.0);
        }
        let given = vec![Press::default(); joints.len()];
        Self {
            bodies,
            joints,
            given,
        }
    }

    // ANCHOR: pass
    /// Every joint writes its own impulses; then every body puts the new ones in the place of the old.
    fn pass(&mut self) {
        let old = self.given.clone();
        for (joint, given) in self.joints.iter_mut().zip(&mut self.given) {
            let sides = [joint.parent_body, joint.body].map(|row| Side::of(&self.bodies, &[row]));
            *given = solve_loop(joint, given, sides, H);
        }
        for row in 0..self.bodies.rows() {
            let (new, old) = (self.gathered(row, &self.given), self.gathered(row, &old));
            let turned = self.bodies.turned_by(row, new.angular - old.angular);
            let inverse_mass = self.bodies.spin[row].inverse_mass;
            self.bodies.motion[row].velocity += (new.linear - old.linear) * inverse_mass;
            self.bodies.spin[row].angular_velocity += turned;
        }
    }
    // ANCHOR_END: pass

    /// What all joints of a body did to it.
    fn gathered(&self, row: usize, given: &[Press]) -> Held {
        let mut sum = Gathered::default();
        for (joint, given) in self.joints.iter().zip(given) {
            if joint.body as usize == row {
                sum.add(given, true);
            }
            if joint.parent_body as usize == row {
                sum.add(given, false);
            }
        }
        sum.held
    }
}
