//! What the panels say of a run on a device, read off them without a window.

use egui::{RawInput, Rect, pos2, vec2};

use super::Panels;
use super::properties::tests::desk::collect;
use crate::clock::Pace;
use crate::guides::Guides;
use crate::show::Show;
use crate::stage::Stage;
use crate::test_engine::{CHAPTER, Falls, GLANCES, balls, lose_device, resident_balls};
use crate::{Chapter, Session};

/// Frames with a step each, then so many without; what the panels say at the end.
fn said(session: Session, frames_after: u32) -> String {
    let mut stage = Stage::new(CHAPTER, session, Pace::Fixed, Show::default());
    for _ in 0..5 {
        stage.advance(stage.session().dt());
    }
    stage.is_paused = true;
    for _ in 0..frames_after {
        stage.advance(0.0);
    }
    read(&mut stage)
}

fn read(stage: &mut Stage) -> String {
    let mut panels = Panels::default();
    let mut texts = Vec::new();
    for _ in 0..3 {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 3000.0))),
            ..RawInput::default()
        };
        let guides = Guides::default();
        let mut layout = panels.lay_out(input, [1280, 3000], stage, &guides);
        layout.output.textures_delta.clear(); // nothing is painted
        texts.clear();
        for clipped in &layout.output.shapes {
            collect(&clipped.shape, clipped.clip_rect, &mut texts);
        }
    }
    let texts: Vec<&str> = texts.iter().map(|text| text.text.as_str()).collect();
    texts.join("\n")
}

#[test]
fn numbers_that_come_back_late_say_how_late_they_are() {
    let late = said(resident_balls(2), 0);
    assert!(late.contains("measured\n4 frames ago"), "{late}");
    assert!(late.contains("counted\n4 frames ago"), "{late}");
    assert!(late.contains("step handed over"), "{late}");
    let settled = said(resident_balls(2), 2 * GLANCES + 2);
    assert!(settled.contains("measured\nnow"), "{settled}");
}

#[test]
fn numbers_that_are_never_late_say_nothing_of_it() {
    let text = said(balls(2), 0);
    assert!(
        !text.contains("ago") && !text.contains("measured"),
        "{text}"
    );
}

#[test]
fn many_bodies_are_measured_less_often_and_the_panel_says_so() {
    let text = said(balls(15_000), 0);
    assert!(text.contains("measured\nevery 2nd step"), "{text}");
}

#[test]
fn a_lost_device_is_said_and_the_window_goes_on() {
    let chapter = Chapter {
        engines: &[crate::test_engine::RESIDENT, crate::test_engine::FALLING],
        ..CHAPTER
    };
    let session = resident_balls(2).with_fallbacks(chapter.engines);
    let mut stage = Stage::new(chapter, session, Pace::Fixed, Show::default());
    stage.advance(0.25);
    lose_device();
    stage.advance(0.25);
    let text = read(&mut stage);
    assert!(text.contains("`resident` failed"), "{text}");
    assert!(text.contains("`falling` goes on after step 0"), "{text}");
    assert!(!stage.is_paused && stage.session().steps() == 1);
}

#[test]
fn a_lost_device_without_another_engine_stops_the_scene() {
    let mut stage = Stage::new(CHAPTER, resident_balls(2), Pace::Fixed, Show::default());
    lose_device();
    stage.advance(0.25);
    let text = read(&mut stage);
    assert!(text.contains("No other engine can go on here"), "{text}");
    assert!(stage.is_paused);
}

#[test]
fn runs_side_by_side_have_their_names_their_troubles_and_their_plots() {
    let mut stage = Stage::new(CHAPTER, balls(2), Pace::Fixed, Show::default());
    stage.open_beside(Falls::opening(2));
    stage.step_once();
    let text = read(&mut stage);
    for words in ["who falls", "how far", "no fall", "it floats", "Close"] {
        assert!(text.contains(words), "`{words}` isn't in: {text}");
    }
    assert_eq!(text.matches("step 1").count(), 2, "{text}");
    assert!(!text.contains("Throw"), "{text}");
    stage.close_beside();
    let text = read(&mut stage);
    assert!(text.contains("Throw") && !text.contains("a fall"), "{text}");
}
