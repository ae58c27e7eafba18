//! A screen without a window: the overlay's tables laid out frame by frame, and someone who reads
//! what is written on it, clicks and types.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, Shape, pos2, vec2};

use crate::overlay::properties::Properties;
use crate::overlay::{Section, style, transport};
use crate::stage::Stage;

/// How long a frame takes, s.
const FRAME: f64 = 0.02;

/// Longer than what makes two clicks a double click, s.
const PATIENCE: f64 = 2.0;

/// A text on the screen.
#[derive(Clone, Debug)]
pub struct Text {
    pub text: String,
    pub place: Rect,
}

pub struct Desk {
    pub stage: Stage,
    pub properties: Properties,
    context: egui::Context,
    time: f64,
    texts: Vec<Text>,
}

impl Desk {
    pub fn new(stage: Stage) -> Self {
        let context = egui::Context::default();
        style::apply(&context, stage.theme);
        let mut desk = Self {
            stage,
            properties: Properties::default(),
            context,
            time: 0.0,
            texts: Vec::new(),
        };
        desk.settle();
        desk
    }

    /// Lays out a frame with these events.
    fn frame(&mut self, events: Vec<Event>) {
        self.time += FRAME;
        self.stage.advance(0.0);
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 720.0))),
            time: Some(self.time),
            events,
            ..RawInput::default()
        };
        let (properties, stage) = (&mut self.properties, &mut self.stage);
        let mut output = self.context.run_ui(input, |ui| {
            egui::Panel::left("left")
                .default_size(304.0)
                .show(ui, |ui| {
                    transport::show(ui, stage);
                    properties.show(ui, stage);
                });
            if properties.is_table_shown() {
                properties.show_table(ui, stage);
            }
        });
        output.textures_delta.clear(); // nothing is painted
        self.texts.clear();
        for clipped in output.shapes {
            collect(&clipped.shape, clipped.clip_rect, &mut self.texts);
        }
    }

    /// Frames until everything has its place.
    pub fn settle(&mut self) {
        for _ in 0..4 {
            self.frame(Vec::new());
        }
    }

    /// Everything that is written on the screen, from above to below.
    pub fn texts(&self) -> Vec<String> {
        self.texts.iter().map(|text| text.text.clone()).collect()
    }

    /// Whether this is written somewhere, alone or as a part.
    pub fn says(&self, part: &str) -> bool {
        self.texts.iter().any(|text| text.text.contains(part))
    }

    /// The IDs in the table's first column, from above to below.
    pub fn ids(&self) -> Vec<String> {
        let header = self
            .texts
            .iter()
            .find(|text| text.text.starts_with("ID ") || text.text == "ID");
        let Some(header) = header else {
            return Vec::new();
        };
        let is_below = |text: &&Text| {
            let across = text.place.left() - header.place.left();
            across.abs() < 2.0 && text.place.top() > header.place.bottom()
        };
        let mut found: Vec<&Text> = self.texts.iter().filter(is_below).collect();
        found.sort_by(|a, b| a.place.top().total_cmp(&b.place.top()));
        found.into_iter().map(|text| text.text.clone()).collect()
    }

    fn place(&self, wanted: &str) -> Pos2 {
        let found = self.texts.iter().find(|text| text.text == wanted);
        let found = found.unwrap_or_else(|| panic!("no `{wanted}` among {:#?}", self.texts()));
        found.place.center()
    }

    /// Clicks on a text.
    pub fn click(&mut self, text: &str) {
        self.click_at(self.place(text), 1);
    }

    /// Clicks on a text twice.
    pub fn double_click(&mut self, text: &str) {
        self.click_at(self.place(text), 2);
    }

    fn click_at(&mut self, pos: Pos2, times: usize) {
        self.time += PATIENCE;
        self.frame(vec![Event::PointerMoved(pos)]);
        for _ in 0..times {
            for pressed in [true, false] {
                self.frame(vec![Event::PointerButton {
                    pos,
                    button: PointerButton::Primary,
                    pressed,
                    modifiers: Modifiers::NONE,
                }]);
            }
        }
        self.frame(vec![Event::PointerMoved(pos2(700.0, 100.0))]);
        self.settle();
    }

    /// Moves the pointer onto a text and waits until its tip is shown.
    pub fn hover(&mut self, text: &str) {
        let pos = self.place(text);
        self.frame(vec![Event::PointerMoved(pos)]);
        for _ in 0..8 {
            self.time += PATIENCE;
            self.frame(Vec::new());
        }
    }

    /// Types into the field that has the keyboard.
    pub fn write(&mut self, text: &str) {
        self.frame(vec![Event::Text(text.to_owned())]);
        self.settle();
    }

    /// Chooses all that is in the field, so that typing replaces it.
    pub fn choose_all(&mut self) {
        self.key(Key::A, Modifiers::COMMAND);
    }

    pub fn press(&mut self, key: Key) {
        self.key(key, Modifiers::NONE);
    }

    fn key(&mut self, key: Key, modifiers: Modifiers) {
        for pressed in [true, false] {
            self.frame(vec![Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers,
            }]);
        }
        self.settle();
    }
}

/// The texts of a shape that can be seen.
pub fn collect(shape: &Shape, clip: Rect, texts: &mut Vec<Text>) {
    match shape {
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, texts)),
        Shape::Text(shape) => {
            let place = shape.galley.rect.translate(shape.pos.to_vec2());
            if clip.intersects(place) {
                let text = shape.galley.text().to_owned();
                texts.push(Text { text, place });
            }
        }
        _ => {}
    }
}
