//! What runs and how: scene, engine, method, step size, sweeps. A new scene starts from its
//! beginning; everything else takes the state over and goes on.

use ch00_scenes::builtin::{self, Scaling};
use ch00_scenes::{EngineEntry, Settings};

use super::Section;
use crate::clock::Pace;
use crate::stage::Stage;

/// The section.
pub struct Setup;

impl Section for Setup {
    fn name(&self) -> &'static str {
        "Scene and engine"
    }

    fn is_open_at_start(&self) -> bool {
        true
    }

    fn show(&mut self, ui: &mut egui::Ui, stage: &mut Stage) {
        egui::Grid::new("setup")
            .num_columns(2)
            .spacing([12.0, 4.0])
            .show(ui, |ui| {
                labelled(ui, "scene", |ui| scene(ui, stage));
                let name = stage.session().scene().name.clone();
                if let Some(scaling) = builtin::scaling(&name) {
                    labelled(ui, scaling.counts, |ui| count(ui, stage, &name, scaling));
                }
                labelled(ui, "engine", |ui| engine(ui, stage));
                labelled(ui, "method", |ui| method(ui, stage));
                labelled(ui, "step", |ui| step_size(ui, stage));
                if stage.session().engine().info().sweeps.is_some() {
                    labelled(ui, "sweeps", |ui| sweeps(ui, stage));
                }
                if stage.session().engine().info().substeps > 1 {
                    labelled(ui, "substeps", |ui| substeps(ui, stage));
                }
            });
        variable_step(ui, stage);
    }
}

fn labelled(ui: &mut egui::Ui, name: &str, add: impl FnOnce(&mut egui::Ui)) {
    ui.weak(name);
    add(ui);
    ui.end_row();
}

/// A list; gives what was chosen if it is not what it was.
fn choose<T: PartialEq + Clone>(
    ui: &mut egui::Ui,
    id: &str,
    now: &T,
    choices: impl IntoIterator<Item = T>,
    name: impl Fn(&T) -> String,
    about: impl Fn(&T) -> String,
) -> Option<T> {
    let mut chosen = now.clone();
    egui::ComboBox::from_id_salt(id)
        .selected_text(name(now))
        .show_ui(ui, |ui| {
            for choice in choices {
                let (text, tip) = (name(&choice), about(&choice));
                let response = ui.selectable_value(&mut chosen, choice, text);
                if !tip.is_empty() {
                    response.on_hover_text(tip);
                }
            }
        });
    (chosen != *now).then_some(chosen)
}

fn scene(ui: &mut egui::Ui, stage: &mut Stage) {
    let now = stage.session().scene().name.clone();
    let built_in = stage.chapter.scenes.iter().map(|&name| name.to_owned());
    let mut choices: Vec<String> = built_in.collect();
    if !choices.iter().any(|name| name == stage.loaded_name()) {
        choices.insert(0, stage.loaded_name().to_owned());
    }
    let about = |name: &String| builtin::about(name).unwrap_or_default().to_owned();
    if let Some(name) = choose(ui, "scene", &now, choices, String::clone, about) {
        stage.change_scene(&name, None);
    }
}

fn count(ui: &mut egui::Ui, stage: &mut Stage, scene: &str, scaling: Scaling) {
    let noted = stage.session().scene().meta.get(builtin::COUNT);
    let Some(now) = noted.and_then(serde_json::Value::as_u64) else {
        ui.weak("as in the file");
        return;
    };
    let steps = [
        0, 1, 2, 5, 8, 10, 20, 30, 40, 50, 60, 80, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000,
        50_000, 100_000, 200_000, 400_000, 1_000_000,
    ];
    let choices = steps
        .into_iter()
        .filter(|count| (scaling.least..=scaling.most).contains(count));
    let chosen = choose(ui, "count", &now, choices, u64::to_string, |_| {
        String::new()
    });
    if let Some(count) = chosen {
        stage.change_scene(scene, Some(count));
    }
}

fn engine(ui: &mut egui::Ui, stage: &mut Stage) {
    let engines: &'static [EngineEntry] = stage.chapter.engines;
    let now = stage.session().entry().name;
    let names = engines.iter().map(|entry| entry.name);
    let chapter_of = |name: &&str| {
        let entry = engines.iter().find(|entry| entry.name == *name);
        entry.map_or_else(String::new, |entry| format!("from {}", entry.chapter))
    };
    let chosen = choose(
        ui,
        "engine",
        &now,
        names,
        |name| (*name).to_owned(),
        chapter_of,
    );
    let found = chosen.and_then(|name| engines.iter().find(|entry| entry.name == name));
    if let Some(entry) = found {
        stage.change_engine(*entry, Settings::defaults());
    }
}

fn method(ui: &mut egui::Ui, stage: &mut Stage) {
    let entry = stage.session().entry();
    let now = stage.session().engine().info().method;
    let names = entry.methods.iter().map(|method| method.name);
    let about = |name: &&str| {
        let method = entry.methods.iter().find(|method| method.name == *name);
        method.map_or_else(String::new, |method| method.about.to_owned())
    };
    if let Some(name) = choose(ui, "method", &now, names, |name| (*name).to_owned(), about) {
        stage.change_engine(entry, Settings::defaults().with_method(name));
    }
}

fn step_size(ui: &mut egui::Ui, stage: &mut Stage) {
    let now = stage.session().dt();
    let choices = [15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0].map(|rate: f64| 1.0 / rate);
    let name = |dt: &f64| {
        let rate = 1.0 / dt;
        if (rate - rate.round()).abs() < 1e-3 * rate {
            format!("1/{rate:.0} s")
        } else {
            format!("{dt} s")
        }
    };
    if let Some(dt) = choose(ui, "step", &now, choices, name, |_| String::new()) {
        stage.set_dt(dt);
    }
}

fn sweeps(ui: &mut egui::Ui, stage: &mut Stage) {
    let now = stage.session().engine().info().sweeps.unwrap_or(1);
    let choices = [1, 2, 3, 4, 6, 8, 10, 15, 20, 30, 50];
    if let Some(sweeps) = choose(ui, "sweeps", &now, choices, u32::to_string, |_| {
        String::new()
    }) {
        change_settings(stage, |settings| settings.sweeps = Some(sweeps));
    }
}

fn substeps(ui: &mut egui::Ui, stage: &mut Stage) {
    let now = stage.session().engine().info().substeps;
    let choices = [1, 2, 4, 8, 10, 16, 20, 32];
    if let Some(substeps) = choose(ui, "substeps", &now, choices, u32::to_string, |_| {
        String::new()
    }) {
        change_settings(stage, |settings| settings.substeps = Some(substeps));
    }
}

fn change_settings(stage: &mut Stage, change: impl FnOnce(&mut Settings)) {
    let mut settings = stage.session().settings().clone();
    change(&mut settings);
    stage.change_engine(stage.session().entry(), settings);
}

fn variable_step(ui: &mut egui::Ui, stage: &mut Stage) {
    let mut is_variable = stage.clock().pace() == Pace::Variable;
    let response = ui
        .checkbox(&mut is_variable, "variable step, as in the report")
        .on_hover_text("one step a frame, as long as the last frame took: slow frames tunnel");
    if response.changed() {
        stage.toggle_pace();
    }
}
