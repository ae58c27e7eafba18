//! The formulas against exact solutions and against integrals over the solid.

use ch00_maths::f32 as single;
use ch00_maths::f64::impulse::{self, Mass, Velocity, coulomb};
use ch00_maths::f64::{drag, free_rotation, inertia, rotation, shape::Shape, verlet};
use glam::{DQuat, DVec3};

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

/// Whether a point, in the body's axes, is inside.
fn holds(shape: &Shape, p: DVec3) -> bool {
    match *shape {
        Shape::Sphere { radius } => p.length() <= radius,
        Shape::Box { half_extents: h } => p.abs().cmple(h).all(),
        Shape::Cylinder {
            radius,
            half_height,
        } => p.y.abs() <= half_height && p.x.hypot(p.z) <= radius,
        Shape::Capsule {
            radius,
            half_height,
        } => {
            let on_axis = DVec3::Y * p.y.clamp(-half_height, half_height);
            (p - on_axis).length() <= radius
        }
    }
}

/// Volume and moments of inertia for unit density, by midpoints of cells. Cells that the surface
/// cuts are halved in each direction, as often as `depth` says.
fn integrate(shape: &Shape, centre: DVec3, half: DVec3, depth: u32, sums: &mut [f64; 4]) {
    let mut inside = 0;
    let corners = [-1.0, 1.0];
    for x in corners {
        for y in corners {
            for z in corners {
                inside += u32::from(holds(shape, centre + half * DVec3::new(x, y, z)));
            }
        }
    }
    let whole = inside == 8;
    let reach = shape.bounding_radius();
    let coarse = half.max_element() > reach / 8.0;
    if depth > 0 && (coarse || (inside > 0 && !whole)) {
        for x in corners {
            for y in corners {
                for z in corners {
                    let step = 0.5 * half;
                    let next = centre + step * DVec3::new(x, y, z);
                    integrate(shape, next, step, depth - 1, sums);
                }
            }
        }
    } else if whole || holds(shape, centre) {
        let volume = 8.0 * half.x * half.y * half.z;
        // A cell is a small box: its own moments are exact, so only the cut cells err.
        let own = half * half / 3.0;
        let square = centre * centre + own;
        sums[0] += volume;
        sums[1] += volume * (square.y + square.z);
        sums[2] += volume * (square.z + square.x);
        sums[3] += volume * (square.x + square.y);
    }
}

#[test]
fn moments_and_volumes_equal_the_integrals_over_the_solids() {
    let shapes = [
        Shape::Sphere { radius: 0.7 },
        Shape::Box {
            half_extents: DVec3::new(0.3, 0.2, 0.5),
        },
        Shape::Cylinder {
            radius: 0.4,
            half_height: 0.3,
        },
        Shape::Capsule {
            radius: 0.3,
            half_height: 0.5,
        },
    ];
    for shape in shapes {
        let reach = match shape {
            Shape::Sphere { radius } => DVec3::splat(radius),
            Shape::Box { half_extents } => half_extents,
            Shape::Cylinder {
                radius,
                half_height,
            } => DVec3::new(radius, half_height, radius),
            Shape::Capsule {
                radius,
                half_height,
            } => DVec3::new(radius, half_height + radius, radius),
        };
        let mut sums = [0.0; 4];
        integrate(&shape, DVec3::ZERO, reach, 9, &mut sums);
        let [volume, x, y, z] = sums;
        near(shape.volume() / volume, 1.0, 1e-4);
        // The mass of a solid of unit density is its volume.
        let moments = shape.inertia(volume);
        near(moments.x / x, 1.0, 1e-4);
        near(moments.y / y, 1.0, 1e-4);
        near(moments.z / z, 1.0, 1e-4);
    }
}

#[test]
fn exp_and_log_are_inverse_down_to_the_smallest_turns() {
    for angle in [
        0.0, 1e-300, 1e-12, 1e-6, 0.01, 0.019, 0.021, 1.0, 3.0, 3.1405,
    ] {
        let theta = DVec3::new(1.0, -2.0, 2.0) / 3.0 * angle;
        let back = rotation::log(rotation::exp(theta));
        near((back - theta).length(), 0.0, 4e-16 + 1e-14 * angle);
        near(rotation::exp(theta).length(), 1.0, 1e-15);
    }
}

#[test]
fn the_log_of_minus_q_is_that_of_q() {
    let q = rotation::exp(DVec3::new(0.3, 0.4, -0.5));
    near((rotation::log(-q) - rotation::log(q)).length(), 0.0, 1e-15);
}

#[test]
fn the_velocity_that_is_set_is_the_velocity_that_is_read() {
    let (p, v, a) = (
        DVec3::new(1.0, 2.0, 3.0),
        DVec3::new(-4.0, 5.0, 0.5),
        DVec3::new(0.0, -9.81, 0.0),
    );
    let p_last = verlet::last_position(p, v, a, 0.02);
    near(
        (verlet::velocity_now(p, p_last, a, 0.02) - v).length(),
        0.0,
        1e-13,
    );
}

#[test]
fn drag_keeps_the_same_share_in_one_step_or_many() {
    near(
        drag::kept(0.25, 1.0),
        drag::kept(0.25, 0.01).powi(100),
        1e-14,
    );
}

#[test]
fn a_free_box_flips_when_dzhanibekov_says() {
    let moments = inertia::ori_box(1.0, DVec3::new(0.3, 0.2, 0.1));
    let momentum = moments * DVec3::new(0.05, 5.0, 0.05);
    let dt = 1.0 / 60.0;
    let mut q = DQuat::IDENTITY;
    let omega_2 = |q: DQuat| (q.conjugate() * momentum).y / moments.y;
    let mut crossings = Vec::new();
    let mut before = omega_2(q);
    for step in 0..3600 {
        q = free_rotation::attitude_after(q, moments, momentum, dt);
        let now = omega_2(q);
        if before * now < 0.0 {
            crossings.push((f64::from(step) + before / (before - now)) * dt);
        }
        before = now;
    }
    // Scenario 5: first at 3.013185259 s, then every 5.110152307 s; ten flips in the rest of a minute.
    near(crossings[0], 3.013_185_259, 3e-3 * 3.0);
    assert_eq!(crossings.len(), 12);
    let mean = (crossings[11] - crossings[0]) / 11.0;
    near(mean / 5.110_152_307, 1.0, 1e-3);
}

#[test]
fn the_splitting_keeps_angular_momentum_and_bounds_the_energy() {
    let moments = inertia::ori_box(1.0, DVec3::new(0.3, 0.2, 0.1));
    let momentum = moments * DVec3::new(1.0, 2.0, 3.0);
    let mut q = DQuat::IDENTITY;
    let energy = |q: DQuat| {
        let pi = q.conjugate() * momentum;
        0.5 * pi.dot(pi / moments)
    };
    let mut worst: f64 = 0.0;
    for _ in 0..60_000 {
        q = free_rotation::attitude_after(q, moments, momentum, 1.0 / 60.0);
        worst = worst.max((energy(q) / 0.27 - 1.0).abs());
    }
    // 1000 s: the error of the energy oscillates and does not grow. T = 0.27 J at the start.
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn a_turn_back_undoes_a_turn() {
    let moments = DVec3::new(0.1, 0.5, 0.45);
    let momentum = DVec3::new(1.0, -2.0, 0.7);
    let q = rotation::exp(DVec3::new(0.4, 0.1, -0.9));
    let there = free_rotation::attitude_after(q, moments, momentum, 0.05);
    let back = free_rotation::attitude_after(there, moments, momentum, -0.05);
    near((back - q).length(), 0.0, 1e-15);
}

#[test]
fn momentum_is_read_from_a_turn_of_up_to_a_radian_whatever_the_shape() {
    let shapes = [
        DVec3::new(0.05, 0.02, 0.05),
        DVec3::new(0.01, 0.5, 0.5),
        DVec3::new(0.1, 0.2, 0.3),
        DVec3::splat(0.4),
    ];
    for moments in shapes {
        for omega in [1e-9, 0.1, 10.0, 60.0] {
            let momentum = moments * DVec3::new(0.3, 0.8, 0.5) * omega;
            let q = DQuat::IDENTITY;
            let last = free_rotation::attitude_after(q, moments, momentum, -1.0 / 60.0);
            let read = free_rotation::momentum_of_turn(last, q, moments, 1.0 / 60.0);
            let read = read.expect("well below half a revolution");
            near((read - momentum).length() / momentum.length(), 0.0, 1e-6);
        }
    }
}

#[test]
fn a_turn_near_half_a_revolution_is_not_read() {
    let moments = DVec3::new(0.01, 0.5, 0.5);
    let momentum = moments * DVec3::new(54.0, 144.0, 90.0);
    let last = free_rotation::attitude_after(DQuat::IDENTITY, moments, momentum, -1.0 / 60.0);
    let read = free_rotation::momentum_of_turn(last, DQuat::IDENTITY, moments, 1.0 / 60.0);
    assert!(read.is_none());
}

#[test]
fn the_width_of_a_number_is_the_only_difference_between_the_two_modules() {
    let a = free_rotation::attitude_after(
        DQuat::IDENTITY,
        DVec3::new(0.1, 0.2, 0.3),
        DVec3::new(1.0, 2.0, 3.0),
        0.1,
    );
    let b = single::free_rotation::attitude_after(
        glam::Quat::IDENTITY,
        glam::Vec3::new(0.1, 0.2, 0.3),
        glam::Vec3::new(1.0, 2.0, 3.0),
        0.1,
    );
    near((a - b.as_dquat()).length(), 0.0, 1e-6);
}

/// Scenario 16: two balls of 1 and 2 kg that meet obliquely. Returns (v₁, ω₁, v₂, ω₂) after.
fn oblique(v1: DVec3, omega_1: DVec3, mu: f64) -> [Velocity; 2] {
    let masses = [(1.0, 0.1), (2.0, 0.2)]
        .map(|(m, r)| Mass::new(1.0 / m, inertia::sphere(m, r).recip(), DQuat::IDENTITY));
    let moving = [
        Velocity {
            v: v1,
            omega: omega_1,
        },
        Velocity {
            v: DVec3::NEG_X,
            omega: DVec3::ZERO,
        },
    ];
    // The reference's normal points from 1 to 2, ours from 2 to 1.
    let n = DVec3::NEG_X;
    let (r1, r2) = (-0.1 * n, 0.2 * n);
    let v_r = impulse::relative_velocity(moving[0], r1, moving[1], r2);
    let approach = v_r.dot(n);
    let normal = impulse::magnitude(
        approach,
        0.8,
        impulse::response(&masses[0], r1, &masses[1], r2, n),
    );
    let across = impulse::response(&masses[0], r1, &masses[1], r2, DVec3::Y);
    let friction = coulomb(-(v_r - approach * n) / across, normal, mu, mu);
    let c = normal * n + friction;
    [
        impulse::applied(moving[0], &masses[0], r1, c),
        impulse::applied(moving[1], &masses[1], r2, -c),
    ]
}

#[test]
fn an_oblique_impact_that_sticks_is_the_closed_form() {
    let [one, two] = oblique(DVec3::new(3.0, 1.0, 0.0), DVec3::new(0.0, 0.0, 5.0), 0.5);
    near(
        (one.v - DVec3::new(-1.8, 0.714_285_714_285_714_3, 0.0)).length(),
        0.0,
        1e-14,
    );
    near(
        (two.v - DVec3::new(1.4, 0.142_857_142_857_142_85, 0.0)).length(),
        0.0,
        1e-14,
    );
    near(one.omega.z, -2.142_857_142_857_143, 1e-13);
    near(two.omega.z, -1.785_714_285_714_285_8, 1e-13);
}

#[test]
fn an_oblique_impact_that_slips_is_the_closed_form() {
    let [one, two] = oblique(DVec3::new(3.0, 4.0, 1.0), DVec3::new(0.0, 10.0, 5.0), 0.1);
    near((one.v - DVec3::new(-1.8, 3.52, 1.0)).length(), 0.0, 1e-14);
    near((two.v - DVec3::new(1.4, 0.24, 0.0)).length(), 0.0, 1e-14);
    near(
        (one.omega - DVec3::new(0.0, 10.0, -7.0)).length(),
        0.0,
        1e-13,
    );
    near(
        (two.omega - DVec3::new(0.0, 0.0, -3.0)).length(),
        0.0,
        1e-13,
    );
}

#[test]
fn the_response_is_what_a_unit_impulse_changes() {
    let q = rotation::exp(DVec3::new(0.3, -0.2, 0.9));
    let one = Mass::new(0.5, DVec3::new(1.0, 2.0, 3.0), q);
    let two = Mass::new(2.0, DVec3::new(4.0, 1.0, 0.5), q.conjugate());
    let (r1, r2) = (DVec3::new(0.1, 0.4, -0.2), DVec3::new(-0.3, 0.2, 0.5));
    let u = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let still = Velocity::default();
    let one_after = impulse::applied(still, &one, r1, u);
    let two_after = impulse::applied(still, &two, r2, -u);
    let change = impulse::relative_velocity(one_after, r1, two_after, r2).dot(u);
    near(impulse::response(&one, r1, &two, r2, u), change, 1e-14);
}

#[test]
fn static_friction_holds_more_than_kinetic_friction_gives() {
    let wanted = DVec3::X * 0.55;
    assert_eq!(coulomb(wanted, 1.0, 0.6, 0.5), wanted);
    near(coulomb(DVec3::X * 0.65, 1.0, 0.6, 0.5).x, 0.5, 1e-15);
}

#[test]
fn a_body_that_rested_has_no_speed_at_the_surface() {
    // From rest on the floor, a step of free fall: speed g Δt at the depth ½ g Δt².
    let (g, dt) = (9.81, 1.0 / 60.0);
    near(
        impulse::surface_speed(g * dt, g, 0.5 * g * dt * dt),
        0.0,
        1e-8,
    );
}
