//! 24: three ragdolls fall on each other, in steps down to ten a second.

use ch00_scenes::measures::{Conserved, joint_separation};
use ch00_scenes::{Scene, State, builtin};

use crate::lab::Moment;
use crate::laboratory::scenario::{Scenario, Verdict, Watch, timed};

const SECONDS: f64 = 10.0;

pub const SCENARIO: Scenario = Scenario {
    number: 24,
    name: "ragdoll_pile",
    title: "Three ragdolls fall on each other",
    watch: "At low rates joints part, limbs are swung round, and energy comes from nowhere.",
    error: "widest joint in the last second",
    unit: "m",
    one_percent: 0.0183,
    scale: "of a ragdoll's height",
    pass: 0.02,
    fails: "torn: a joint is open by more than 0.18 m at any time; gained energy: more than 1 J; escaped: a limb is outside of the box in the last second",
    rates: &[10, 15, 30, 60, 120, 240],
    scenes: |rate, quick| {
        let scenes = (1..=if quick { 1 } else { 3 }).map(|seed| {
            let scene = builtin::build("ragdolls", Some(3), Some(seed))?;
            Ok(timed(scene, rate, SECONDS))
        });
        scenes.collect()
    },
    watcher: |scene| Box::new(Survival::of(scene)),
    steps: None,
    page: "ch04_ragdolls",
};

/// Every second one step takes a tenth of a second, as if something else had stopped the program.
pub const HITCHES: Scenario = Scenario {
    name: "ragdoll_hitches",
    title: "Three ragdolls, and a hitch of 100 ms every second",
    watch: "A long step among short ones hits a solver that stores impulses, and one that stores places, where they least expect it.",
    steps: Some(hitched),
    ..SCENARIO
};

/// Ten seconds of equal steps, the last of each second but the tenth 100 ms long.
fn hitched(rate: u32) -> Vec<f64> {
    let dt = f64::from(rate).recip();
    let usual = vec![dt; (0.9 * f64::from(rate)).round() as usize];
    let second = [usual, vec![0.1]].concat();
    let mut steps = second.repeat(SECONDS as usize - 1);
    steps.extend(vec![dt; rate as usize]);
    steps
}

struct Survival {
    scene: Scene,
    /// At the start, J.
    energy: f64,
    widest: f64,
    failed: Option<&'static str>,
}

impl Survival {
    fn of(scene: &Scene) -> Self {
        Self {
            energy: energy(scene, &State::start_of(scene)),
            scene: scene.clone(),
            widest: 0.0,
            failed: None,
        }
    }
}

fn energy(scene: &Scene, state: &State) -> f64 {
    Conserved::of(scene, state).energy()
}

impl Watch for Survival {
    fn see(&mut self, now: &Moment) {
        let apart = joint_separation(&self.scene, now.state).unwrap_or(0.0);
        if apart > 0.18 {
            self.failed.get_or_insert("torn");
        }
        if energy(&self.scene, now.state) > self.energy + 1.0 {
            self.failed.get_or_insert("gained energy");
        }
        if now.time > SECONDS - 1.0 {
            self.widest = self.widest.max(apart);
        }
        let out = ch00_scenes::measures::escaped(&self.scene, now.state);
        if out.is_some_and(|out| out > 0) && now.time > SECONDS - 1.0 {
            self.failed.get_or_insert("escaped");
        }
    }

    fn verdict(&self) -> Verdict {
        Verdict {
            error: self.widest,
            failed: self.failed,
        }
    }
}
