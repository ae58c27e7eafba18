//! The section of the left panel that starts races: who takes part in the scene that is shown, or a race
//! of the gallery.

use ch00_scenes::{EngineEntry, Settings};
use ch00_shell::{Menu, Opening, Session};
use egui::{ComboBox, RichText, Ui};

use super::contender::{FEWEST, MOST};
use super::gallery::{GALLERY, Setup};
use super::{Contender, Race, of_gallery, opening};
use crate::{CHAPTER, FindingsError};

/// What can be chosen for substeps.
const SUBSTEPS: [u32; 9] = [1, 2, 4, 8, 10, 16, 20, 32, 64];

/// Who takes part unless one chooses.
const FIRST: [&str; FEWEST] = ["properties", "lanes"];

/// What its user has chosen so far.
pub struct RaceMenu {
    contenders: Vec<Contender>,
    /// The set-up of the gallery that was started last.
    setup: Option<&'static Setup>,
    /// Why the last race could not start.
    why_not: Option<String>,
}

impl Default for RaceMenu {
    fn default() -> Self {
        let wanted = |entry: &&EngineEntry| FIRST.contains(&entry.name);
        let engines = CHAPTER.engines.iter().filter(wanted);
        Self {
            contenders: engines.map(|entry| Contender::of(*entry)).collect(),
            setup: None,
            why_not: None,
        }
    }
}

impl RaceMenu {
    /// With those of a race that the window starts with.
    #[must_use]
    pub fn of(race: &Race) -> Self {
        Self {
            contenders: race.contenders(),
            setup: race.setup,
            why_not: None,
        }
    }
}

impl Menu for RaceMenu {
    fn name(&self) -> &'static str {
        "Race"
    }

    fn show(&mut self, ui: &mut Ui, session: &Session) -> Option<Opening> {
        ui.weak(format!(
            "{}, on two to four engines or methods:",
            session.scene().name
        ));
        self.choose(ui);
        let starts = ui.button("Start the race").clicked();
        ui.add_space(4.0);
        ui.label(RichText::new("Gallery").strong());
        let chosen = self.choose_setup(ui);
        if let Some(why) = &self.why_not {
            ui.colored_label(ui.visuals().warn_fg_color, why);
        }
        let race = match (starts, chosen) {
            (true, _) => self.race_in(session),
            (false, Some(setup)) => self.race_of(setup),
            (false, None) => return None,
        };
        self.open(race)
    }
}

impl RaceMenu {
    /// A race in this session's scene, as it started.
    fn race_in(&self, session: &Session) -> Result<Race, FindingsError> {
        let scene = session.scene_at_start();
        let setup = self.setup.filter(|setup| setup.scene == scene.name);
        let race = Race::new(scene, self.contenders.clone())?;
        Ok(setup.into_iter().fold(race, Race::to_watch))
    }

    /// A race of the gallery, whose contenders can then be changed.
    fn race_of(&mut self, setup: &'static Setup) -> Result<Race, FindingsError> {
        let race = of_gallery(setup)?;
        self.contenders = race.contenders();
        Ok(race)
    }

    fn open(&mut self, race: Result<Race, FindingsError>) -> Option<Opening> {
        let opened = race.and_then(|race| Ok(opening(race)?));
        match opened {
            Ok(opening) => {
                self.why_not = None;
                Some(opening)
            }
            Err(error) => {
                self.why_not = Some(error.to_string());
                None
            }
        }
    }

    /// A line a contender, and what adds one or takes one away.
    fn choose(&mut self, ui: &mut Ui) {
        let mut removed = None;
        let can_remove = self.contenders.len() > FEWEST;
        for (i, contender) in self.contenders.iter_mut().enumerate() {
            ui.horizontal(|ui| {
                choose_contender(ui, i, contender);
                let button = egui::Button::new("–").small();
                if ui.add_enabled(can_remove, button).clicked() {
                    removed = Some(i);
                }
            });
        }
        if let Some(i) = removed {
            self.contenders.remove(i);
        }
        if self.contenders.len() < MOST && ui.small_button("+ contender").clicked() {
            let last = self.contenders.last().cloned();
            self.contenders
                .extend(last.or(Some(Contender::of(CHAPTER.engines[0]))));
        }
    }

    /// The gallery; gives the set-up that was chosen.
    fn choose_setup(&mut self, ui: &mut Ui) -> Option<&'static Setup> {
        let mut chosen = None;
        ui.horizontal_wrapped(|ui| {
            for setup in GALLERY {
                let is_shown = self.setup == Some(setup);
                let response = ui.selectable_label(is_shown, setup.name);
                if response.on_hover_text(setup.watch).clicked() {
                    chosen = Some(setup);
                }
            }
        });
        self.setup = chosen.or(self.setup);
        chosen
    }
}

/// Lists of engines, methods and substeps.
fn choose_contender(ui: &mut Ui, i: usize, contender: &mut Contender) {
    let engines = CHAPTER.engines.iter();
    let entry = choose(
        ui,
        ("engine", i),
        88.0,
        contender.entry.name,
        engines,
        |entry| entry.name,
    );
    if let Some(entry) = entry {
        *contender = Contender::of(*entry);
    }
    let EngineEntry { methods, .. } = contender.entry;
    let Settings {
        method, substeps, ..
    } = &mut contender.settings;
    let now = method.clone().unwrap_or_else(|| methods[0].name.to_owned());
    if let Some(chosen) = choose(ui, ("method", i), 84.0, &now, methods, |method| method.name) {
        *method = Some(chosen.name.to_owned());
    }
    let now = substeps.map_or_else(|| "usual".to_owned(), |substeps| format!("@{substeps}"));
    ComboBox::from_id_salt(("substeps", i))
        .width(44.0)
        .selected_text(now)
        .show_ui(ui, |ui| {
            ui.selectable_value(substeps, None, "as the method has them");
            for count in SUBSTEPS {
                ui.selectable_value(substeps, Some(count), format!("@{count} substeps"));
            }
        })
        .response
        .on_hover_text("substeps; without a number, as the method has them");
}

/// A list; gives what was chosen, if something was.
fn choose<'a, T>(
    ui: &mut Ui,
    id: (&str, usize),
    width: f32,
    now: &str,
    choices: impl IntoIterator<Item = &'a T>,
    name: impl Fn(&T) -> &'static str,
) -> Option<&'a T> {
    let mut chosen = None;
    ComboBox::from_id_salt(id)
        .width(width)
        .selected_text(now)
        .show_ui(ui, |ui| {
            for choice in choices {
                let name = name(choice);
                if ui.selectable_label(name == now, name).clicked() && name != now {
                    chosen = Some(choice);
                }
            }
        });
    chosen
}

#[cfg(test)]
mod tests {
    use ch00_scenes::Scene;
    use egui::{Event, Modifiers, PointerButton, Pos2, RawInput, Rect, Shape, vec2};

    use super::*;

    /// The menu on a screen of its own.
    struct Screen {
        menu: RaceMenu,
        session: Session,
        context: egui::Context,
        texts: Vec<(String, Pos2)>,
    }

    impl Screen {
        fn new() -> Self {
            let scene = Scene::open("pair", None, None).expect("a built-in");
            let contender = Contender::parse("objects").expect("it is one");
            let settings = contender.settings;
            let mut screen = Self {
                menu: RaceMenu::default(),
                session: Session::new(scene, contender.entry, settings).expect("it runs"),
                context: egui::Context::default(),
                texts: Vec::new(),
            };
            screen.frame(Vec::new());
            screen.frame(Vec::new());
            screen
        }

        fn frame(&mut self, events: Vec<Event>) -> Option<Opening> {
            let input = RawInput {
                screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(304.0, 900.0))),
                events,
                ..RawInput::default()
            };
            let mut opening = None;
            let mut output = self.context.run_ui(input, |ui| {
                let wanted = self.menu.show(ui, &self.session);
                opening = opening.take().or(wanted);
            });
            output.textures_delta.clear(); // nothing is painted
            self.texts.clear();
            for clipped in &output.shapes {
                collect(&clipped.shape, &mut self.texts);
            }
            opening
        }

        fn says(&self, words: &str) -> bool {
            self.texts.iter().any(|(text, _)| text.contains(words))
        }

        fn click(&mut self, words: &str) -> Option<Opening> {
            let found = self.texts.iter().find(|(text, _)| text == words);
            let pos = found.unwrap_or_else(|| panic!("no `{words}`")).1;
            let press = |pressed| Event::PointerButton {
                pos,
                button: PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            };
            self.frame(vec![Event::PointerMoved(pos)]);
            let down = self.frame(vec![press(true)]);
            let up = self.frame(vec![press(false)]);
            self.frame(Vec::new());
            down.or(up)
        }
    }

    fn collect(shape: &Shape, texts: &mut Vec<(String, Pos2)>) {
        match shape {
            Shape::Text(text) => {
                let middle = text.visual_bounding_rect().center();
                texts.push((text.galley.text().to_owned(), middle));
            }
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, texts)),
            _ => {}
        }
    }

    fn names(opening: &Opening) -> Vec<String> {
        let views = opening.runs.views();
        views.into_iter().map(|view| view.name).collect()
    }

    #[test]
    fn a_race_in_the_scene_that_is_shown_starts_with_who_was_chosen() {
        let mut screen = Screen::new();
        assert!(screen.says("pair, on two to four"));
        assert!(screen.click("+ contender").is_none());
        let opening = screen.click("Start the race").expect("all of them can");
        assert_eq!(opening.session.scene().name, "pair");
        let names = names(&opening);
        assert_eq!(names.len(), 3);
        assert!(names[1].starts_with("lanes · own-row"), "{names:?}");
    }

    #[test]
    fn there_are_two_to_four_contenders() {
        let mut screen = Screen::new();
        screen.click("+ contender");
        screen.click("+ contender");
        assert!(!screen.says("+ contender"));
        for _ in 0..9 {
            screen.click("–");
        }
        assert_eq!(screen.menu.contenders.len(), FEWEST);
    }

    #[test]
    fn a_race_of_the_gallery_can_be_started_and_then_changed() {
        let mut screen = Screen::new();
        let opening = screen.click("cradle").expect("it can be run");
        assert_eq!(opening.session.scene().name, "cradle");
        let four = names(&opening);
        assert_eq!(four.len(), 4);
        screen.session = opening.session;
        let again = screen.click("Start the race").expect("all of them can");
        assert_eq!(names(&again), four);
        assert!(again.runs.sight().is_some());
    }

    #[test]
    fn a_race_that_nobody_can_run_does_not_start_and_says_why() {
        let mut screen = Screen::new();
        screen.menu.contenders = ["objects@4", "properties@4"]
            .map(|text| Contender::parse(text).expect("it is one"))
            .to_vec();
        assert!(screen.click("Start the race").is_none());
        assert!(screen.says("makes whole steps"));
    }
}
