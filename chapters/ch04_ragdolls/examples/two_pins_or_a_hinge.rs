//! Exercise 4 of chapter 4: the door on a true hinge, and on two pins that come nearer and nearer to
//! each other. How well does each hold?
//!
//! `cargo run --release -p ch04_ragdolls --no-default-features --example two_pins_or_a_hinge`

use std::error::Error;

use ch00_scenes::measures::joint_separation;
use ch00_scenes::{Joint, Scene, Settings, State};
use glam::DVec3;

/// What five seconds of the door show.
struct Seen {
    /// Turn about the hinge's line after 1 s, rad.
    turned: f64,
    /// Largest angle between the door's edge and the line, rad.
    tilted: f64,
    /// Widest gap of a pin, m.
    gap: f64,
}

fn watch(scene: &Scene) -> Result<Seen, Box<dyn Error>> {
    let mut engine = (ch04_ragdolls::ENGINE.load)(scene, &Settings::defaults())?;
    let mut state = State::start_of(scene);
    let mut seen = Seen {
        turned: 0.0,
        tilted: 0.0,
        gap: 0.0,
    };
    for step in 1..=scene.steps {
        engine.step(scene.dt as f32);
        engine.read_state(&mut state);
        let (front, edge) = (
            state.orientation[1] * DVec3::X,
            state.orientation[1] * DVec3::Y,
        );
        if step == 60 {
            seen.turned = (-front.z).atan2(front.x);
        }
        seen.tilted = seen.tilted.max(edge.cross(DVec3::Y).length().atan2(edge.y));
        seen.gap = seen.gap.max(joint_separation(scene, &state).unwrap_or(0.0));
    }
    Ok(seen)
}

/// The door on pins this far from each other, m.
fn on_pins(apart: f64) -> Result<Scene, Box<dyn Error>> {
    let mut scene = Scene::open("door_pins", None, None)?;
    for joint in &mut scene.joints {
        if let Joint::Ball {
            anchor_a, anchor_b, ..
        } = joint
        {
            for anchor in [anchor_a, anchor_b] {
                anchor.y = anchor.y.signum() * 0.5 * apart;
            }
        }
    }
    Ok(scene)
}

fn row(name: &str, scene: &Scene) -> Result<(), Box<dyn Error>> {
    let Seen {
        turned,
        tilted,
        gap,
    } = watch(scene)?;
    println!(
        "{name:<22} {turned:8.3} rad  {:10.2} mrad  {:8.2} mm",
        1e3 * tilted,
        1e3 * gap
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("the door is held by    open at 1 s  tilts at most  gap at most");
    row("a hinge", &Scene::open("door", None, None)?)?;
    for apart in [1.6, 0.4, 0.1, 0.02] {
        row(&format!("pins {apart:.2} m apart"), &on_pins(apart)?)?;
    }
    Ok(())
}
