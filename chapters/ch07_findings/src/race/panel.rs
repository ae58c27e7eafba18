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
fn what_to_watch(ui: &mut Ui, setup: &Setup) {
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
        let error = match error {
            0.0 => "0".to_owned(),
            error => format!("{error:+.1e}"),
        };
        lines.push(format!("energy {error}"));
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

#[cfg(test)]
mod tests {
    use super::super::{gallery, of_gallery};
    use super::*;

    /// What the panel says.
    fn said(race: &mut Race) -> String {
        let context = egui::Context::default();
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            race.show_panel(ui);
        });
        output.textures_delta.clear(); // nothing is painted
        let text = |clipped: &egui::epaint::ClippedShape| match &clipped.shape {
            egui::Shape::Text(text) => text.galley.text().to_owned(),
            _ => String::new(),
        };
        output
            .shapes
            .iter()
            .map(text)
            .collect::<Vec<_>>()
            .join("\n")
    }

    #[test]
    fn the_panel_says_what_to_watch_and_where_to_read() {
        let setup = gallery::find("cradle").expect("it is there");
        let mut race = of_gallery(setup).expect("it can be run");
        race.step_all();
        let text = said(&mut race);
        for words in [
            "Race: cradle",
            "step 1 of 1/60 s",
            setup.watch,
            "ch04_ragdolls",
        ] {
            assert!(text.contains(words), "`{words}` isn't in: {text}");
        }
    }

    #[test]
    fn a_view_says_its_times_and_errors_once_they_are_known() {
        let setup = gallery::find("cradle").expect("it is there");
        let mut race = of_gallery(setup).expect("it can be run");
        let first = |race: &Race| race.views()[0].text.clone();
        assert!(first(&race).starts_with('–') && first(&race).contains("energy 0"));
        for _ in 0..3 {
            race.step_all();
        }
        race.measure();
        let text = first(&race);
        for words in [" ms/step", "energy ", "overlap ", "(p99 ", "joints "] {
            assert!(text.contains(words), "`{words}` isn't in: {text}");
        }
    }
}
