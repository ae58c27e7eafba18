//! 22: how often a second a chain has to be solved. A method that pushes places once a substep of h s from joint
//! to joint leaves a joint of a link of mass m open by T h²/m, as far as what pulls the next one, the tension T,
//! moves the link.

use ch00_scenes::{Scene, builtin, measures::joint_separation};

use super::{Map, Who, thinned};
use crate::chart::{Axis, Class};
use crate::lab::Moment;
use crate::laboratory::scenario::{Verdict, Watch, timed};
use crate::laboratory::scenarios::G;

/// Of the ball and of a link, kg.
const BALL: f64 = 672.0;
const LINK: f64 = 1.0;
/// 1 % of a link, m.
const HELD: f64 = 2.5e-3;
/// The length of a link, m.
const TORN: f64 = 0.25;
/// For so long it hangs, s.
const SECONDS: f64 = 3.0;
/// Substeps of `xpbd`.
const PARTS: f64 = 20.0;

pub const MAP: Map = Map {
    number: "22",
    name: "chain",
    title: "Which chains hold a ball of 672 kg for 3 s",
    value: "widest joint, the mean of the third second (m)",
    axes: || [Axis::log("links"), Axis::log("steps a second (1/s)")],
    grid: |quick| {
        let links = [1, 2, 3, 5, 7, 10, 14, 20, 28, 40, 56, 80].map(f64::from);
        let rates = [
            20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 120.0, 160.0, 240.0, 480.0,
        ];
        [links.to_vec(), rates.to_vec()].map(|all| thinned(all, quick))
    },
    bounds: [HELD, TORN],
    classes: [
        "joints hold within 1 % of a link",
        "they open further",
        "by more than a link",
    ],
    better_upwards: true,
    theory: "the widest joint, T h²/m, is 1 % of a link",
    who: || {
        let mut all: Vec<Who> = Who::all(["xpbd"])
            .map(|who| who.law(Class::Held, opens))
            .collect();
        let names = [
            "printed",
            "corrected",
            "sequential-impulses",
            "soft-step",
            "rapier",
            "rapier tuned",
            "own-row",
            "coloured",
        ];
        all.extend(Who::all(names));
        all
    },
    scene: |links, rate, quick| {
        let mut scene = builtin::build("chain_hanging", Some(links as u64), None)?;
        // The floor would stop a ball that sinks.
        scene.bodies.pop();
        let seconds = if quick { 2.0 } else { SECONDS };
        Ok(timed(scene, rate as u32, seconds))
    },
    watcher: |scene, _, _| {
        Box::new(Hangs {
            from: f64::from(scene.steps) * scene.dt - 1.0,
            scene: scene.clone(),
            sum: 0.0,
            steps: 0,
            torn: false,
        })
    },
};

/// The widest joint, the mean of the last second: it swings up and down at first, twice as far.
struct Hangs {
    scene: Scene,
    /// When the last second begins, s.
    from: f64,
    sum: f64,
    steps: u32,
    torn: bool,
}

impl Watch for Hangs {
    fn see(&mut self, now: &Moment) {
        let widest = joint_separation(&self.scene, now.state).unwrap_or(f64::NAN);
        self.torn |= widest > TORN;
        if now.time > self.from {
            self.sum += widest;
            self.steps += 1;
        }
    }

    fn verdict(&self) -> Verdict {
        if self.torn {
            return Verdict::failed("torn");
        }
        Verdict::of(self.sum / f64::from(self.steps))
    }
}

/// The rate from which on the widest joint of `xpbd` is 1 % of a link: T h²/m, by the tension at the top.
fn opens(links: f64) -> f64 {
    let tension = G * (BALL + LINK * (links - 1.0));
    let h = (HELD * LINK / tension).sqrt();
    (PARTS * h).recip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forty_links_pull_at_the_hook_as_in_the_reference() {
        // The link below the hook carries what hangs below it, 6984.72 N with its own weight.
        let h = (20.0 * opens(40.0)).recip();
        let tension = HELD * LINK / (h * h);
        assert!((tension + G * LINK - 6984.72).abs() < 1e-6, "{tension}");
    }
}
