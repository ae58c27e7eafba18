//! Keys and mouse: dragging a body pulls it, dragging anything else turns the camera, clicking
//! a body with Shift looks at it and the one picked before.

use ch00_scenes::Layer;
use glam::Vec2;
use winit::event::{ElementState, KeyEvent, MouseButton, MouseScrollDelta, WindowEvent};
use winit::keyboard::{Key, ModifiersState, NamedKey};

use crate::render::Theme;
use crate::stage::Stage;

/// Pixels of a touch pad that count as a notch of a wheel.
const PIXELS_PER_NOTCH: f64 = 40.0;

/// A drag shorter than so many pixels is a click.
const CLICK: f32 = 4.0;

/// What the mouse is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Drag {
    #[default]
    None,
    /// Turns the camera.
    Orbit,
    /// Moves the camera.
    Pan,
    /// Pulls a body, in the plane at this distance along the line of sight, m.
    Pull { depth: f32 },
}

/// The mouse's and the keyboard's state.
#[derive(Debug, Default)]
pub struct Input {
    pointer: Vec2,
    modifiers: ModifiersState,
    drag: Drag,
    /// Where a button went down with Shift.
    shift_press: Option<Vec2>,
    /// Whether the user wants to close the window.
    pub wants_to_quit: bool,
}

impl Input {
    /// Takes an event of the window; one that is the overlay's begins nothing here.
    pub fn on_event(&mut self, stage: &mut Stage, event: &WindowEvent, is_for_overlay: bool) {
        let is_on_scene = !is_for_overlay && stage.is_scene_at(self.pointer);
        match event {
            WindowEvent::ModifiersChanged(modifiers) => self.modifiers = modifiers.state(),
            // A synthetic press is a key that was down already when the window got the keyboard.
            WindowEvent::KeyboardInput {
                event,
                is_synthetic: false,
                ..
            } if !is_for_overlay => self.on_key(stage, event),
            WindowEvent::MouseInput { state, button, .. } => match state {
                ElementState::Pressed if is_on_scene => self.press(stage, *button),
                ElementState::Pressed => {}
                ElementState::Released => self.release(stage),
            },
            WindowEvent::CursorMoved { position, .. } => {
                let position: [f32; 2] = (*position).into();
                self.move_to(stage, Vec2::from(position));
            }
            WindowEvent::MouseWheel { delta, .. } if is_on_scene => {
                stage.camera_to_move().zoom(notches(*delta));
            }
            WindowEvent::Focused(false) => {
                self.shift_press = None;
                self.release(stage);
            }
            _ => {}
        }
    }

    /// What a key does; the overlay's list says the same.
    fn on_key(&mut self, stage: &mut Stage, event: &KeyEvent) {
        if event.state == ElementState::Released {
            return;
        }
        let key = event.logical_key.as_ref();
        if self.modifiers.control_key() {
            self.wants_to_quit |= matches!(key, Key::Character("q" | "Q"));
            if stage.beside.is_none() {
                act_with_control(stage, &key, self.modifiers.shift_key());
            }
            return;
        }
        // Only stepping goes on while a key is held.
        let is_step = matches!(
            key,
            Key::Character("." | "n" | "N")
                | Key::Named(NamedKey::ArrowLeft | NamedKey::ArrowRight)
        );
        if !event.repeat || is_step {
            act(stage, &key);
        }
    }

    fn press(&mut self, stage: &mut Stage, button: MouseButton) {
        self.drag = match button {
            MouseButton::Left if self.modifiers.shift_key() => {
                self.shift_press = Some(self.pointer);
                Drag::Pan
            }
            MouseButton::Left if stage.grab(stage.sight(self.pointer)) => pulling(stage),
            MouseButton::Left => {
                stage.picked = None;
                Drag::Orbit
            }
            MouseButton::Middle | MouseButton::Right => Drag::Pan,
            _ => self.drag,
        };
    }

    fn release(&mut self, stage: &mut Stage) {
        stage.let_go();
        self.drag = Drag::None;
        let press = self.shift_press.take();
        if press.is_some_and(|press| press.distance(self.pointer) < CLICK) {
            stage.pick_partner(stage.sight(self.pointer));
        }
    }

    fn move_to(&mut self, stage: &mut Stage, pointer: Vec2) {
        let moved = pointer - self.pointer;
        self.pointer = pointer;
        match self.drag {
            Drag::None => {}
            Drag::Orbit => stage.camera_to_move().orbit(moved),
            Drag::Pan => {
                let viewport = stage.viewport();
                stage.camera_to_move().pan(moved, viewport);
            }
            Drag::Pull { depth } => {
                let sight = stage.sight(pointer);
                let distance = depth / sight.direction.dot(stage.camera.forward());
                stage.pull_to(sight.at(distance).as_dvec3());
            }
        }
    }
}

/// A drag of the body that was just grabbed.
fn pulling(stage: &Stage) -> Drag {
    let camera = &stage.camera;
    stage.pulled().map_or(Drag::None, |pull| {
        let to_body = pull.target.as_vec3() - camera.position();
        Drag::Pull {
            depth: to_body.dot(camera.forward()),
        }
    })
}

/// What a key does that is pressed with Ctrl. A held key goes on.
fn act_with_control(stage: &mut Stage, key: &Key<&str>, has_shift: bool) {
    match key {
        Key::Character("z" | "Z") if !has_shift => stage.undo(),
        Key::Character("z" | "Z" | "y" | "Y") => stage.redo(),
        _ => {}
    }
}

/// Whether a key does the same where several runs are side by side.
fn is_for_all(key: &Key<&str>) -> bool {
    match key {
        Key::Character(letter) => ".nNrRcChHlL".contains(letter),
        Key::Named(name) => matches!(name, NamedKey::Space | NamedKey::F1 | NamedKey::Escape),
        _ => false,
    }
}

/// What a key without modifiers does.
fn act(stage: &mut Stage, key: &Key<&str>) {
    if stage.beside.is_some() && !is_for_all(key) {
        return;
    }
    match key {
        Key::Named(NamedKey::Escape) if stage.beside.is_some() => stage.close_beside(),
        Key::Named(NamedKey::Space) => stage.toggle_pause(),
        Key::Named(NamedKey::F1) | Key::Character("h" | "H") => {
            stage.shows_overlay = !stage.shows_overlay;
        }
        Key::Character("." | "n" | "N") => stage.step_once(),
        Key::Character("r" | "R") => stage.reset(),
        Key::Character("f" | "F" | "t" | "T") => stage.throw_ball(),
        Key::Character("v" | "V") => stage.toggle_pace(),
        Key::Character("c" | "C") => stage.move_camera_home(),
        Key::Character("g" | "G") => stage.toggle_pair(),
        Key::Character("b" | "B") => stage.move_camera_near(),
        Key::Named(NamedKey::Delete) => stage.remove_picked(),
        Key::Named(NamedKey::ArrowLeft) => stage.move_step(-1),
        Key::Named(NamedKey::ArrowRight) => stage.move_step(1),
        Key::Named(NamedKey::Home) => stage.move_step(isize::MIN),
        Key::Named(NamedKey::End) => stage.move_step(isize::MAX),
        Key::Character("x" | "X") => stage.show.is_see_through = !stage.show.is_see_through,
        Key::Character(digit) if let Some(layer) = layer_of(digit) => stage.toggle_layer(layer),
        Key::Character("l" | "L") => {
            stage.theme = match stage.theme {
                Theme::Light => Theme::Dark,
                Theme::Dark => Theme::Light,
            };
        }
        _ => {}
    }
}

/// The layer that a digit stands for: its place in the overlay's list, from 1.
fn layer_of(digit: &str) -> Option<Layer> {
    let place = digit.parse::<usize>().ok()?.checked_sub(1)?;
    Layer::ALL.get(place).copied()
}

/// Turns of the wheel, towards the user if negative.
fn notches(delta: MouseScrollDelta) -> f32 {
    match delta {
        MouseScrollDelta::LineDelta(_, lines) => lines,
        #[expect(clippy::cast_possible_truncation, reason = "a few notches")]
        MouseScrollDelta::PixelDelta(pixels) => (pixels.y / PIXELS_PER_NOTCH) as f32,
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{BODIES, Cell, Edit, RowId};

    use super::*;
    use crate::clock::Pace;
    use crate::show::Show;
    use crate::test_engine::{CHAPTER, Falls, balls};

    #[test]
    fn delete_removes_the_picked_body() {
        let mut stage = Stage::new(CHAPTER, balls(2), Pace::Fixed, Show::default());
        stage.picked = Some(0);
        act(&mut stage, &Key::Named(NamedKey::Delete));
        assert_eq!(stage.session().scene().bodies.len(), 1);
    }

    #[test]
    fn control_with_z_undoes_and_with_shift_or_y_redoes() {
        let mut stage = Stage::new(CHAPTER, balls(1), Pace::Fixed, Show::default());
        stage.toggle_pause();
        let edit = Edit {
            table: BODIES.to_owned(),
            column: "position".to_owned(),
            row: RowId::first(0),
            value: Cell::Vector([0.0, 20.0, 0.0]),
        };
        stage.edit(edit).expect("it is paused");
        let mut press = |key, has_shift| {
            act_with_control(&mut stage, &Key::Character(key), has_shift);
            stage.session().state_now().position[0].y
        };
        assert_eq!((press("z", false), press("Z", true)), (10.0, 20.0));
        assert_eq!((press("z", false), press("y", false)), (10.0, 20.0));
        assert_eq!(press("x", false), 20.0);
    }

    #[test]
    fn where_runs_are_side_by_side_keys_of_one_scene_do_nothing_and_escape_closes_them() {
        let mut stage = Stage::new(CHAPTER, balls(2), Pace::Fixed, Show::default());
        stage.open_beside(Falls::opening(2));
        for key in ["t", "g", "1", "v"] {
            act(&mut stage, &Key::Character(key));
        }
        act(&mut stage, &Key::Named(NamedKey::Delete));
        assert_eq!(stage.session().scene().bodies.len(), 2);
        assert_eq!(
            (stage.clock().pace(), stage.show.is_any()),
            (Pace::Fixed, false)
        );
        act(&mut stage, &Key::Named(NamedKey::Space));
        assert!(stage.is_paused);
        act(&mut stage, &Key::Named(NamedKey::Escape));
        assert!(stage.beside.is_none());
    }

    #[test]
    fn digits_are_layers_in_the_order_of_the_list() {
        assert_eq!(layer_of("1"), Some(Layer::Aabbs));
        assert_eq!(layer_of("3"), Some(Layer::Contacts));
        assert_eq!(layer_of("6"), Some(Layer::Limits));
        assert_eq!(
            (layer_of("0"), layer_of("7"), layer_of("x")),
            (None, None, None)
        );
    }
}
