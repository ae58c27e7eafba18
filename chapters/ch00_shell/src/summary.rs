//! What a run without a window reports: one line of JSON for programs, a table for people.
//!
//! The keys of the JSON line and their order are fixed. A value that doesn't apply, such as
//! a joint's separation in a scene without joints, is null there and `-` in the table.

use std::fmt;

use serde::Serialize;

use crate::frame_rate::FrameRate;

/// The outcome of a run; the fields are the keys of the JSON line, in their order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Name of the scene.
    pub scene: String,
    /// Architecture that stepped it.
    pub engine: &'static str,
    /// Mathematics that it used.
    pub method: &'static str,
    /// Threads that it used.
    pub threads: u32,
    /// Device that it ran on; `cpu` for the CPU.
    pub device: String,
    /// Bodies, static ones too.
    pub n: usize,
    /// Joints.
    pub joints: usize,
    /// Steps made.
    pub steps: u64,
    /// Size of a step, s; none if it varied.
    pub dt: Option<f64>,
    /// Parts of a step.
    pub substeps: u32,
    /// When the steps were made.
    #[serde(flatten)]
    pub timing: Timing,
    /// Deepest overlap of two bodies after the last step, m.
    pub max_penetration_final_m: Option<f64>,
    /// 99th percentile of the overlaps after the last step, m.
    pub p99_penetration_final_m: Option<f64>,
    /// Deepest overlap after any step that was measured, m.
    pub max_penetration_run_m: Option<f64>,
    /// Widest gap of a joint after the last step, m.
    pub max_joint_separation_final_m: Option<f64>,
    /// Widest gap of a joint after any step that was measured, m.
    pub max_joint_separation_run_m: Option<f64>,
    /// Most bodies that were outside the scene's box at once, after any step; none if the scene
    /// says no box.
    pub escaped: Option<usize>,
    /// Bodies with a number that is not finite.
    pub nan: usize,
    /// Things that a capacity or an iteration limit left undone.
    pub overflow: usize,
    /// J, after the last step.
    pub kinetic_energy_final: Option<f64>,
    /// The run's largest error of momentum, relative; none where walls or weight take it up.
    pub momentum_error: Option<f64>,
    /// Furthest that a joint is beyond its limits after the last step, rad.
    pub max_limit_excess_final_rad: Option<f64>,
}

/// Times of the steps alone, without drawing, writing or measuring, after the first step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Timing {
    /// Half of the steps took no longer, ms.
    pub median_ms: Option<f64>,
    /// 99 of 100 steps took no longer, ms.
    pub p99_ms: Option<f64>,
    /// All steps but the first, s.
    pub total_s: Option<f64>,
    /// Largest ten-step mean, 1/s.
    pub max_fps: Option<f64>,
    /// Smallest ten-step mean, 1/s.
    pub min_fps: Option<f64>,
}

impl Timing {
    /// From the times of the steps after the first.
    #[must_use]
    pub fn of(times: &FrameRate) -> Self {
        let milliseconds = |time: std::time::Duration| time.as_secs_f64() * 1e3;
        let median_ms = times.p50().map(milliseconds);
        Self {
            median_ms,
            p99_ms: times.p99().map(milliseconds),
            total_s: median_ms.map(|_| times.total().as_secs_f64()),
            max_fps: times.max_fps(),
            min_fps: times.min_fps(),
        }
    }
}

impl Summary {
    /// One line of JSON, without a line end.
    ///
    /// # Panics
    /// Never: texts and numbers, even those that are not finite, can always be written.
    #[must_use]
    pub fn json(&self) -> String {
        serde_json::to_string(self).expect("texts and numbers are always JSON")
    }

    /// The lines of the table: what it is, its value, its unit.
    fn rows(&self) -> Vec<Line> {
        let mut rows = self.what_ran();
        rows.extend(self.timing.rows());
        rows.extend(self.what_came_out());
        rows
    }

    /// What ran.
    fn what_ran(&self) -> Vec<Line> {
        vec![
            ("scene", self.scene.clone(), ""),
            ("engine", format!("{}, {}", self.engine, self.method), ""),
            ("device", self.device.clone(), ""),
            ("threads", self.threads.to_string(), ""),
            ("bodies", self.n.to_string(), ""),
            ("joints", self.joints.to_string(), ""),
            ("steps", self.steps.to_string(), ""),
            ("step size", number(self.dt), "s"),
            ("substeps", self.substeps.to_string(), ""),
        ]
    }

    /// How good the result is.
    fn what_came_out(&self) -> Vec<Line> {
        vec![
            (
                "deepest overlap, last",
                number(self.max_penetration_final_m),
                "m",
            ),
            (
                "99 % overlap, last",
                number(self.p99_penetration_final_m),
                "m",
            ),
            (
                "deepest overlap, run",
                number(self.max_penetration_run_m),
                "m",
            ),
            (
                "widest joint, last",
                number(self.max_joint_separation_final_m),
                "m",
            ),
            (
                "widest joint, run",
                number(self.max_joint_separation_run_m),
                "m",
            ),
            ("escaped bodies", count(self.escaped), ""),
            ("bodies not finite", self.nan.to_string(), ""),
            ("left undone", self.overflow.to_string(), ""),
            (
                "kinetic energy, last",
                number(self.kinetic_energy_final),
                "J",
            ),
            ("momentum error", number(self.momentum_error), ""),
            (
                "beyond limits, last",
                number(self.max_limit_excess_final_rad),
                "rad",
            ),
        ]
    }
}

impl Timing {
    /// How long it took.
    fn rows(&self) -> Vec<Line> {
        vec![
            ("median step", number(self.median_ms), "ms"),
            ("99 % of steps within", number(self.p99_ms), "ms"),
            ("all steps but the first", number(self.total_s), "s"),
            ("fastest ten steps", number(self.max_fps), "steps/s"),
            ("slowest ten steps", number(self.min_fps), "steps/s"),
        ]
    }
}

/// A line of the table: what it is, its value, its unit.
type Line = (&'static str, String, &'static str);

/// The table for people.
impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (label, value, unit) in self.rows() {
            writeln!(
                f,
                "{}",
                format!("{label:<24} {value:>14} {unit}").trim_end()
            )?;
        }
        Ok(())
    }
}

/// Four digits, with an exponent where the number is small or large.
fn number(value: Option<f64>) -> String {
    match value {
        None => "-".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(value) if (1e-3..1e6).contains(&value.abs()) => {
            let digits_before = value.abs().log10().floor();
            let decimals = (3.0 - digits_before).clamp(0.0, 6.0) as usize;
            format!("{value:.decimals$}")
        }
        Some(value) => format!("{value:.3e}"),
    }
}

fn count(value: Option<usize>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary() -> Summary {
        Summary {
            scene: "pair".to_owned(),
            engine: "objects",
            method: "corrected",
            threads: 1,
            device: "cpu".to_owned(),
            n: 2,
            joints: 0,
            steps: 600,
            dt: Some(0.25),
            substeps: 1,
            timing: Timing::default(),
            max_penetration_final_m: Some(0.0),
            p99_penetration_final_m: Some(1.5e-5),
            max_penetration_run_m: None,
            max_joint_separation_final_m: None,
            max_joint_separation_run_m: None,
            escaped: None,
            nan: 0,
            overflow: 0,
            kinetic_energy_final: Some(12.345_67),
            momentum_error: Some(f64::NAN),
            max_limit_excess_final_rad: Some(0.5),
        }
    }

    #[test]
    fn json_is_one_line_with_the_fixed_keys_in_their_order() {
        assert_eq!(
            summary().json(),
            concat!(
                r#"{"scene":"pair","engine":"objects","method":"corrected","threads":1,"#,
                r#""device":"cpu","n":2,"joints":0,"steps":600,"dt":0.25,"substeps":1,"#,
                r#""median_ms":null,"p99_ms":null,"total_s":null,"max_fps":null,"min_fps":null,"#,
                r#""max_penetration_final_m":0.0,"p99_penetration_final_m":0.000015,"#,
                r#""max_penetration_run_m":null,"max_joint_separation_final_m":null,"#,
                r#""max_joint_separation_run_m":null,"escaped":null,"nan":0,"overflow":0,"#,
                r#""kinetic_energy_final":12.34567,"momentum_error":null,"#,
                r#""max_limit_excess_final_rad":0.5}"#
            )
        );
    }

    #[test]
    fn the_table_has_a_line_for_each_value_and_a_dash_where_there_is_none() {
        let table = summary().to_string();
        assert!(table.contains("deepest overlap, run                  - m\n"));
        assert!(table.contains("kinetic energy, last              12.35 J\n"));
        assert!(table.contains("99 % overlap, last             1.500e-5 m\n"));
    }

    #[test]
    fn a_run_without_a_second_step_has_no_times() {
        assert_eq!(Timing::of(&FrameRate::of_run()), Timing::default());
    }
}
