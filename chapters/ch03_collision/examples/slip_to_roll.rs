//! Exercise 1 of the page on friction: a ball, a cylinder and a capsule are set down on the floor at
//! 4 m/s without spin. Which share of the speed is left when they roll?
//!
//! `cargo run --release -p ch03_collision --no-default-features --example slip_to_roll`

use ch00_maths::f64::shape::Shape as Solid;
use ch00_scenes::{Body, Scene, Settings, Shape};
use glam::{DQuat, DVec3};

/// m.
const RADIUS: f64 = 0.5;
/// m/s.
const SPEED: f64 = 4.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (radius, half_height) = (RADIUS, 0.4);
    let bodies = [
        ("ball", Shape::Sphere { radius }, Solid::Sphere { radius }),
        (
            "cylinder",
            Shape::Cylinder {
                radius,
                half_height,
            },
            Solid::Cylinder {
                radius,
                half_height,
            },
        ),
        (
            "capsule",
            Shape::Capsule {
                radius,
                half_height,
            },
            Solid::Capsule {
                radius,
                half_height,
            },
        ),
    ];
    println!("           1/(1 + I/mr²)   left, engine   ωr/v");
    for (name, shape, solid) in bodies {
        // About the axis, which is the body's y.
        let inertia = solid.inertia(1.0).y;
        let share = 1.0 / (1.0 + inertia / (RADIUS * RADIUS));
        let (left, rolls) = after_a_second(shape)?;
        println!("{name:<10} {share:13.4}   {left:12.4}   {rolls:.4}");
    }
    Ok(())
}

/// v over the speed at the start, and ωr over v.
fn after_a_second(shape: Shape) -> Result<(f64, f64), Box<dyn std::error::Error>> {
    let mut scene = Scene::new("slip to roll");
    let half_extents = DVec3::new(20.0, 0.5, 2.0);
    let floor = Body::new(Shape::Box { half_extents }, 0.0, DVec3::NEG_Y * 0.5);
    let body = Body {
        linear_velocity: DVec3::X * SPEED,
        orientation: DQuat::from_rotation_x(std::f64::consts::FRAC_PI_2),
        ..Body::new(shape, 1.0, DVec3::Y * RADIUS)
    };
    scene.bodies = vec![floor, body];
    for body in &mut scene.bodies {
        (body.restitution, body.friction) = (0.0, 0.3);
    }
    let state = ch03_collision::ENGINE.run(&scene, &Settings::defaults(), 60)?;
    let v = state.linear_velocity[1].x;
    Ok((v / SPEED, -state.angular_velocity[1].z * RADIUS / v))
}
