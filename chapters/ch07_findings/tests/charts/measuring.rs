//! What the charts measure is right.

use ch07_findings::bounce::{CASES, measured};
use ch07_findings::{architecture_method_hardware, friction, limbs, stack, tunnelling};

#[test]
fn what_the_three_bring_is_measured_on_this_machines_device() {
    let sample = architecture_method_hardware::measured(100, 1, 100).expect("all engines can");
    let [objects, properties, lanes, compute] = &sample.runs[..] else {
        panic!("four engines: {sample:?}");
    };
    assert_eq!(
        (objects.p99, objects.deepest),
        (properties.p99, properties.deepest)
    );
    assert_eq!(lanes.device, objects.device);
    assert_ne!(compute.device, lanes.device);
    assert!(sample.runs.iter().all(|run| run.escaped == 0), "{sample:?}");
}

#[test]
fn a_corrected_ball_keeps_its_apexes_within_a_hundredth_at_240_hz() {
    for case in CASES {
        let sample = measured(case, "corrected", 240, &[4.95, 5.0, 5.05]).expect("it loads");
        for run in sample.runs {
            assert!(run.apex < 0.01, "{}: {run:?}", case.scene);
            // The engine learns of the hit at the end of the step in which it happens.
            assert!((-1e-4..1.01 / 240.0).contains(&run.first_hit), "{run:?}");
        }
    }
}

#[test]
fn friction_is_exact_within_a_hundredth_at_60_hz() {
    let rate = 60.0;
    let mut checks = friction::slip_to_roll(rate).expect("it loads").to_vec();
    checks.extend(friction::slopes(rate).expect("it loads"));
    checks.extend(friction::oblique(rate).expect("it loads"));
    for check in checks {
        assert!(check.error < 0.01, "{check:?}");
    }
    for stop in friction::slides(rate).expect("it loads") {
        assert!((stop.distance - 1.0).abs() < 0.01, "{stop:?}");
        assert!(
            stop.sideways.abs() < 0.01 && stop.yaw.abs() < 0.01,
            "{stop:?}"
        );
    }
}

#[test]
fn five_cubes_stand_for_ten_seconds_and_twelve_with_two_sweeps_do_not() {
    let sweeps = ch03_collision::DEFAULT_SWEEPS;
    let five = stack::built("corrected", sweeps, 5, 10.0).expect("it loads");
    assert!(five.stands(), "{five:?}");
    let twelve = stack::built("corrected", 2, 12, 10.0).expect("it loads");
    assert!(!twelve.stands(), "{twelve:?}");
}

#[test]
fn slow_balls_never_get_through_the_wall_and_fast_ones_as_often_as_theory_says() {
    for method in ["printed", "corrected"] {
        for speed in [2.0, 9.0] {
            let slow = tunnelling::shot(method, 60.0, speed, 100).expect("it loads");
            assert_eq!(slow.through, 0, "{slow:?}");
        }
    }
    let fast = tunnelling::shot("printed", 60.0, 60.0, 400).expect("it loads");
    let (low, high) = fast.bar();
    let theory = tunnelling::unseen(60.0, 60.0);
    assert!((low..=high).contains(&theory), "{fast:?}");
}

#[test]
fn at_60_hz_no_limb_gets_through_the_floor() {
    let sample = limbs::dropped("corrected", 60.0, 1).expect("it loads");
    assert_eq!((sample.outside, sample.nowhere), (0, 0), "{sample:?}");
}
