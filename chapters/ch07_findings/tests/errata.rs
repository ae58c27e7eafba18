//! The report's errata, each held by numbers: the printed formula fails as predicted, the
//! corrected one holds, or the limit lies where theory puts it. `tests/reference/exact.json`
//! has the exact numbers.

use ch07_findings::errata::first_order::{Update, spin_after_a_second};
use ch07_findings::errata::uneven_steps::{Rule, alternating, errors, hitch};
use ch07_findings::errata::{
    angle_between, contact_arm, drag, first_order, frame_of_turn, gyroscopic, pin, shares, sign,
    spin_alias, stall, start_up,
};
use glam::DQuat;
use serde_json::Value;

/// A scenario of the reference.
fn exact(scenario: &str) -> Value {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/exact.json"
    );
    let text = std::fs::read_to_string(path).expect("the reference is part of the repository");
    let all: Value = serde_json::from_str(&text).expect("the reference is JSON");
    all[scenario]["exact"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[track_caller]
fn near(value: f64, wanted: f64, tolerance: f64) {
    assert!(
        (value - wanted).abs() <= tolerance,
        "{value} is not within {tolerance} of {wanted}"
    );
}

#[test]
fn erratum_01_the_second_arm_decides_how_fast_they_part() {
    near(contact_arm::restitution_reached(0.5, false), 0.5, 1e-12);
    // The printed speed misses the whole 3 rad/s × 0.5 m of the rod's end: it sees 1 m/s of 2.5.
    near(contact_arm::restitution_reached(0.5, true), -0.4, 1e-12);
}

#[test]
fn erratum_02_the_shares_lose_momentum_unless_masses_are_equal() {
    let reference = exact("16_head_on");
    let right = shares::head_on([1.0, 2.0], [3.0, -1.0], 0.8, false);
    near(right.velocities[0], number(&reference["v1"]), 1e-12);
    near(right.velocities[1], number(&reference["v2"]), 1e-12);
    near(right.momentum_error, 0.0, 1e-12);
    // s₁ − s₂ = 1/3 of J = 4.8 N s goes missing, of 5 kg m/s.
    let printed = shares::head_on([1.0, 2.0], [3.0, -1.0], 0.8, true);
    near(printed.momentum_error, 4.8 / 3.0 / 5.0, 1e-12);
}

#[test]
fn erratum_02_at_equal_masses_half_of_the_impulse_arrives() {
    let printed = shares::head_on([1.0, 1.0], [1.0, -1.0], 1.0, true);
    near(printed.momentum_error, 0.0, 1e-12);
    near(printed.velocities[0], 0.0, 1e-12);
}

#[test]
fn erratum_02_the_unequal_pair_of_the_issue_keeps_its_momentum() {
    let right = shares::head_on([2.0, 0.7], [1.0, -2.0], 0.8, false);
    near(right.momentum_error, 0.0, 1e-14);
    assert!(shares::head_on([2.0, 0.7], [1.0, -2.0], 0.8, true).momentum_error > 0.3);
}

#[test]
fn erratum_03_constant_omega_does_not_converge_and_the_splitting_does() {
    let rows = exact("04_free_top")["rows"].clone();
    for row in rows.as_array().expect("rows") {
        let [w, x, y, z] = [0, 1, 2, 3].map(|i| number(&row["quaternion_wxyz"][i]));
        let (t, attitude) = (number(&row["t"]), DQuat::from_xyzw(x, y, z, w));
        let split = angle_between(gyroscopic::splitting(t, 1.0 / 60.0), attitude);
        assert!(split <= 1e-3, "{split} rad after {t} s");
    }
    let error = |q| angle_between(q, gyroscopic::AFTER_10_S);
    near(error(gyroscopic::constant_omega(10.0)), 2.105, 5e-4);
    near(error(gyroscopic::printed(10.0, 1.0 / 60.0)), 1.4965, 5e-4);
    for dt in [1.0 / 120.0, 1.0 / 480.0, 1.0 / 1920.0] {
        assert!(error(gyroscopic::printed(10.0, dt)) > 1.0);
    }
    near(
        error(gyroscopic::splitting(10.0, 1.0 / 60.0)),
        3.145e-4,
        1e-6,
    );
    let order = (error(gyroscopic::splitting(10.0, 1.0 / 60.0))
        / error(gyroscopic::splitting(10.0, 1.0 / 240.0)))
    .log2()
        / 2.0;
    near(order, 2.0, 0.05);
}

#[test]
fn erratum_03_two_attitudes_hold_as_much_as_attitude_and_momentum() {
    let read = gyroscopic::splitting_without_velocity(10.0, 1.0 / 60.0).expect("slow enough");
    near(
        angle_between(read, gyroscopic::splitting(10.0, 1.0 / 60.0)),
        0.0,
        1e-9,
    );
}

#[test]
fn erratum_04_the_printed_axis_is_off_by_the_tilt() {
    for degrees in [30.0_f64, 90.0, 150.0] {
        let tilt = degrees.to_radians();
        near(frame_of_turn::error(tilt, false), 0.0, 1e-12);
        let printed = frame_of_turn::error(tilt, true);
        near(printed, frame_of_turn::predicted(tilt), 1e-4);
        assert!(printed > 0.4);
    }
}

#[test]
fn erratum_05_the_first_order_update_loses_spin_by_its_laws() {
    let reference = exact("06_xpbd_spin");
    let dt = 1.0 / 60.0;
    near(
        spin_after_a_second(Update::FirstOrderChord, dt),
        number(&reference["omega_end"]),
        1e-9,
    );
    near(spin_after_a_second(Update::FirstOrderLog, dt), 8.85, 5e-3);
    near(
        spin_after_a_second(Update::Exponential, dt),
        first_order::OMEGA,
        1e-12,
    );
    let fine = exact("06_xpbd_spin_20_substeps");
    near(
        spin_after_a_second(Update::FirstOrderChord, 1.0 / 1200.0),
        number(&fine["omega_end"]),
        1e-9,
    );
}

#[test]
fn erratum_06_the_printed_pin_does_not_close() {
    for degrees in [15.0_f64, 45.0, 90.0] {
        let angle = degrees.to_radians();
        assert!(pin::gap_left(angle, 20, false) < 1e-4, "{degrees}°");
        // Printed, the ends of the rods are flung apart: by more than 5 gaps at the first correction.
        assert!(pin::gap_left(angle, 1, true) > 5.0, "{degrees}°");
        assert!(pin::gap_left(angle, 20, true) > 5.0, "{degrees}°");
    }
}

#[test]
fn erratum_07_with_the_listed_sign_they_go_on_into_each_other() {
    for ratio in [0.25, 1.0, 4.0] {
        near(sign::approach_after(ratio, false), -1.6, 1e-12);
        assert!(sign::approach_after(ratio, true) > -1.6 + 0.7);
    }
    // At equal masses the impulse changes both speeds alike, so they approach as fast as before.
    near(sign::approach_after(1.0, true), 2.0, 1e-12);
}

#[test]
fn erratum_08_uneven_steps_end_where_the_reference_says() {
    for (scenario, steps) in [
        ("02_variable_dt_alternating", alternating()),
        ("02_variable_dt_hitch", hitch()),
    ] {
        let reference = exact(scenario);
        for (rule, key) in [
            (Rule::Printed, "uncorrected"),
            (Rule::RatioOnly, "ratio_only"),
            (Rule::Corrected, "exact"),
        ] {
            let (_, error) = *errors(rule, &steps).last().expect("steps were made");
            let wanted = &reference["end_error_xy"][key];
            near(error.x, number(&wanted[0]), 1e-9);
            near(error.y, number(&wanted[1]), 1e-9);
        }
    }
}

#[test]
fn erratum_09_the_printed_start_is_first_order_for_ever() {
    let reference = exact("01_verlet_startup");
    near(
        start_up::error_after_two_seconds(1.0 / 60.0, true),
        number(&reference["plain_start_error"]),
        1e-9,
    );
    for n in [30.0, 240.0, 7680.0] {
        // Rounding, summed twice over 2n steps: about (2n)² ulp(10) at the worst, 4e-7 m at n = 7680.
        let rounding = 4.0 * n * n * 1.8e-15;
        near(
            start_up::error_after_two_seconds(1.0 / n, false),
            0.0,
            rounding,
        );
        near(
            start_up::error_after_two_seconds(1.0 / n, true),
            9.81 / n,
            rounding,
        );
    }
}

#[test]
fn erratum_10_fast_spin_aliases_where_theory_says() {
    let reference = exact("07_omega_alias");
    for row in reference["rows"].as_array().expect("rows") {
        near(
            spin_alias::reading(number(&row["omega"])),
            number(&row["read_back"]),
            1e-7,
        );
    }
    let limit = number(&reference["limit"]);
    assert!(spin_alias::reading(limit - 0.01) > 0.0);
    assert!(spin_alias::reading(limit + 0.01) < 0.0);
}

#[test]
fn erratum_11_corrected_drag_is_the_same_at_any_frame_rate() {
    for frames in [4.0, 60.0, 240.0] {
        let left = drag::left_after_a_second(0.25, frames, false);
        near(left, (-0.25_f64).exp(), 1e-12);
    }
    let printed = |frames| drag::left_after_a_second(0.25, frames, true);
    near(printed(4.0), (1.0 - 0.0625_f64).powi(4), 1e-12);
    assert!((printed(4.0) / printed(240.0) - 1.0).abs() > 0.007);
    // F Δt above 1 turns every velocity round, every frame.
    assert!(ch00_maths::f64::drag::printed::kept(5.0, 0.25) < 0.0);
}

#[test]
fn erratum_12_f32_positions_stall_above_the_predicted_heights() {
    let reference = exact("03_f32_stall");
    for row in reference["rows"].as_array().expect("rows") {
        let substeps = number(&row["substeps"]) as u32;
        let limit = number(&row["stalls_above"]);
        near(stall::stalls_above(substeps), limit, 0.0);
        assert_eq!(stall::fall(limit as f32 * 1.01, substeps), 0.0);
        assert!(stall::fall(limit as f32 * 0.99, substeps) > 0.5);
    }
}
