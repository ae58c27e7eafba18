//! The values of flags: how each is read, and what is answered where it can't be.

use ch00_scenes::Layer;
use glam::Vec2;

use crate::show::Dissect;

/// 0 or more.
pub fn whole_number(text: &str) -> Result<u64, String> {
    text.parse()
        .map_err(|_| "it must be a whole number, 0 or more".to_owned())
}

/// So many steps.
pub fn step_count(text: &str) -> Result<u32, String> {
    text.parse()
        .map_err(|_| format!("it must be a whole number from 0 to {}", u32::MAX))
}

/// 1 or more.
pub fn at_least_one(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(format!("it must be a whole number from 1 to {}", u32::MAX)),
    }
}

/// A step in seconds.
pub fn step_size(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(dt) if (SHORTEST_STEP..=LONGEST_STEP).contains(&dt) => Ok(dt),
        _ => Err(format!(
            "it must be a number of seconds from {SHORTEST_STEP} to {LONGEST_STEP}"
        )),
    }
}

/// A layer by its flag.
pub fn layer(text: &str) -> Result<Layer, String> {
    let found = Layer::ALL.into_iter().find(|layer| layer.flag() == text);
    found.ok_or_else(|| {
        let flags = Layer::ALL.map(Layer::flag).join(", ");
        format!("it must be one of: {flags}")
    })
}

/// `A,B`, `A,B,STEP`, `deepest` or `deepest,STEP`.
pub fn dissect(text: &str) -> Result<Dissect, String> {
    let help = || "it must be A,B or A,B,STEP or deepest or deepest,STEP: two bodies from 0, an iteration from 1";
    let words: Vec<&str> = text.split(',').collect();
    let (bodies, rest) = match words[..] {
        ["deepest", ref rest @ ..] => (None, rest),
        [a, b, ref rest @ ..] => {
            let index = |word: &str| word.parse().map_err(|_| help());
            (Some([index(a)?, index(b)?]), rest)
        }
        _ => return Err(help().to_owned()),
    };
    let step = match *rest {
        [] => None,
        [step] => Some(
            step.parse()
                .ok()
                .filter(|&step| step > 0)
                .ok_or_else(help)?,
        ),
        _ => return Err(help().to_owned()),
    };
    Ok(Dissect { bodies, step })
}

/// `YAW,PITCH` or `YAW,PITCH,ZOOM`, in degrees; gives rad.
pub fn view_angles(text: &str) -> Result<(Vec2, f32), String> {
    let help = "it must be YAW,PITCH or YAW,PITCH,ZOOM: degrees, PITCH from -11 to 88, ZOOM from 0.1 to 100";
    let numbers: Result<Vec<f32>, _> = text.split(',').map(str::parse).collect();
    match numbers.as_deref() {
        Ok(&[yaw, pitch, ref zoom @ ..])
            if yaw.is_finite()
                && (-11.0..=88.0).contains(&pitch)
                && zoom.len() < 2
                && zoom.iter().all(|zoom| (0.1..=100.0).contains(zoom)) =>
        {
            let angles = Vec2::new(yaw.to_radians(), pitch.to_radians());
            Ok((angles, zoom.first().copied().unwrap_or(1.0)))
        }
        _ => Err(help.to_owned()),
    }
}

/// s. Engines work with dt² in f32.
const SHORTEST_STEP: f64 = 1e-6;

/// s. Far past where any method holds.
const LONGEST_STEP: f64 = 10.0;

#[cfg(test)]
mod tests {
    use super::super::tests::{args, parse};
    use super::*;

    #[test]
    fn numbers_out_of_range_are_answered_with_the_range() {
        for (flags, words) in [
            (["--count", "-1"], "0 or more"),
            (["--seed", "1.5"], "0 or more"),
            (["--dt", "0"], "number of seconds"),
            (["--dt", "-1"], "number of seconds"),
            (["--dt", "nan"], "number of seconds"),
            (["--sweeps", "0"], "from 1"),
            (["--threads", "-2"], "from 1"),
            (["--steps", "5000000000"], "from 0"),
        ] {
            let error = parse(&flags).expect_err("it is out of range");
            assert_eq!(error.exit_code(), 2);
            assert!(error.to_string().contains(words), "{error}");
        }
    }

    #[test]
    fn layers_and_pairs_are_read_and_what_they_are_not_is_said() {
        let flags = ["--layers", "contacts,joint-frames", "--dissect", "3,5,2"];
        let wish = args(&flags).wish();
        assert_eq!(wish.layers, [Layer::Contacts, Layer::JointFrames]);
        let (bodies, step) = (Some([3, 5]), Some(2));
        assert_eq!(wish.dissect, Some(Dissect { bodies, step }));
        let deepest = args(&["--dissect", "deepest"]).dissect;
        let (bodies, step) = (None, None);
        assert_eq!(deepest, Some(Dissect { bodies, step }));
        for (flag, value, words) in [
            ("--layers", "contact", "aabbs, cells"),
            ("--dissect", "3", "two bodies"),
            ("--dissect", "3,4,0", "from 1"),
            ("--dissect", "3,4,1,1", "two bodies"),
            ("--dissect", "deepest,x", "from 1"),
            ("--dissect", "-1,2", "two bodies"),
        ] {
            let error = parse(&[&format!("{flag}={value}")]).expect_err("it is wrong");
            assert_eq!(error.exit_code(), 2);
            assert!(error.to_string().contains(words), "{error}");
        }
    }

    #[test]
    fn a_view_is_two_angles_and_a_zoom_of_a_picture() {
        let picture = ["--screenshot", "a.png", "--view", "90,-10,2.5"];
        let (angles, zoom) = args(&picture).view.expect("it was given");
        assert!((angles.x - std::f32::consts::FRAC_PI_2).abs() < 1e-6);
        assert!((angles.y + 10.0_f32.to_radians()).abs() < 1e-6);
        assert_eq!(zoom, 2.5);
        assert!(parse(&["--view", "90,10"]).is_err(), "no picture");
        for wrong in ["90", "90,89", "90,10,0", "90,10,1,1", "x,y", "nan,1"] {
            let flags = ["--screenshot", "a.png", "--view", wrong];
            assert!(parse(&flags).is_err(), "{wrong}");
        }
    }
}
