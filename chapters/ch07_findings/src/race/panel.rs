//! A race as the shell shows it: a view a contender, what to watch in the left panel, and plots under the
//! views.

use ch00_shell::{Gpu, SideBySide, Sight, View};
use egui::{RichText, Ui};

use super::gallery::Setup;
use super::runner::Runner;
use super::{Race, plots};

impl SideBySide for Race {
    fn views(&self) -> Vec<View<'_>> {
        self.runners.iter().map(view).collect()
    }

    fn dt(&self) -> f64 {
        self.scene().dt
    }

    fn cost(&self) -> f64 {
        self.cost_of_step()
    }

    fn step(&mut self) {
        self.step_all();
    }

    fn end_frame(&mut self) {
        self.measure_now_and_then();
    }

    fn reset(&mut self) {
        self.start_again();
    }

    fn move_to(&mut self, gpu: &Gpu) {
        for runner in &mut self.runners {
            runner.move_to(gpu);
        }
    }

    fn sight(&self) -> Option<Sight> {
        self.setup?.sight
    }

    fn show_panel(&mut self, ui: &mut Ui) {
        let scene = self.scene();
        let time = self.steps() as f64 * scene.dt;
        let bodies = scene.bodies.len();
        ui.label(RichText::new(format!("Race: {}", scene.name)).strong());
        ui.weak(format!(
            "{bodies} bodies, t = {time:.2} s, step {} of 1/{:.0} s",
            self.steps(),
            1.0 / scene.dt
        ));
        if let Some(setup) = self.setup {
            what_to_watch(ui, setup);
        }
        ui.weak("All make the same steps from the same start; the slowest sets the pace.");
    }

    fn show_plots(&mut self, ui: &mut Ui) {
        plots::show(ui, self);
    }
}

/// What to watch, and where the book explains it.
pub fn what_to_watch(ui: &mut Ui, setup: &Setup) {
    let (page, title) = setup.page;
    ui.label(setup.watch);
    ui.horizontal_wrapped(|ui| {
        ui.weak("in the book:");
        ui.label(RichText::new(title).italics())
            .on_hover_text(format!("book/src/{page}.md, or `mdbook serve book --open`"));
        ui.weak(format!("({page})"));
    });
}

fn view(runner: &Runner) -> View<'_> {
    View {
        name: runner.name(),
        color: runner.color,
        text: numbers(runner),
        trouble: runner.trouble(),
        session: runner.session.as_ref().ok(),
    }
}

/// What was measured of it last.
fn numbers(runner: &Runner) -> String {
    let Some(last) = runner.curve.last() else {
        return String::new();
    };
    let mut lines = vec![match runner.recent_ms() {
        Some(ms) => format!("{ms:.3} ms/step"),
        None => "–".to_owned(),
    }];
    if let Some(error) = last.energy_error {
        lines.push(format!("energy {error:+.1e}"));
    }
    if let (Some(deepest), Some(p99)) = (last.deepest, last.p99) {
        let [deepest, p99] = [deepest, p99].map(length);
        lines.push(format!("overlap {deepest} (p99 {p99})"));
    }
    if let Some(joint) = last.joint {
        lines.push(format!("joints {}", length(joint)));
    }
    lines.join("     ")
}

/// A length in m with a unit that suits it.
fn length(metres: f64) -> String {
    match metres.abs() {
        0.0 => "0".to_owned(),
        size if size < 0.9e-3 => format!("{:.1} µm", 1e6 * metres),
        size if size < 0.1 => format!("{:.2} mm", 1e3 * metres),
        _ => format!("{metres:.3} m"),
    }
}
