//! The window, for real: the top binary on a virtual X display and the software device. Keys
//! are pressed, pictures of the screen are taken, and what should be in them is looked for.

mod desktop;
mod picture;

use std::process::Command;
use std::time::Duration;

use desktop::{Desktop, HEIGHT, WIDTH, top_binary};
use picture::{Area, Picture};

/// Left of this the overlay's panel lies at the start, pixels.
const PANEL: u32 = 300;

/// Well inside the panel.
const IN_PANEL: Area = Area::new(4, 4, PANEL - 8, HEIGHT - 8);

/// The scene with the box of balls in its middle.
const SCENE: Area = Area::new(PANEL + 10, 0, WIDTH - PANEL - 10, HEIGHT);

/// Well inside the panel that shows the narrow phase of a pair.
const NARROW: Area = Area::new(WIDTH - 390, 60, 380, HEIGHT - 80);

/// The floor beside the box, in front.
const FLOOR: Area = Area::new(WIDTH - 250, HEIGHT - 150, 240, 140);

fn pause() {
    std::thread::sleep(Duration::from_millis(700));
}

/// How often one looks whether a key has been seen: a software device draws few frames a second, and it has other
/// things to do.
const LOOKS: u32 = 8;

/// The screen once more than so many pixels of a part differ from an earlier picture, or as it is in the end.
fn changed(desktop: &mut Desktop, before: &Picture, part: Area, pixels: usize) -> Picture {
    let mut now = desktop.screenshot();
    for _ in 0..LOOKS {
        pause();
        now = desktop.screenshot();
        if before.differences(&now, part) > pixels {
            break;
        }
    }
    now
}

/// The screen once the scene stands still.
fn still(desktop: &mut Desktop, key: &str) -> Picture {
    let mut last = desktop.screenshot();
    let mut moved = 0;
    for _ in 0..LOOKS {
        pause();
        let now = desktop.screenshot();
        moved = last.differences(&now, SCENE);
        if moved == 0 {
            return now;
        }
        last = now;
    }
    panic!("{key} doesn't stop it: {moved} pixels changed");
}

#[test]
fn balls_floor_and_overlay_are_there_and_the_balls_move() {
    let mut desktop = Desktop::with_window(&[]);
    let first = desktop.screenshot();
    pause();
    let second = desktop.screenshot();

    assert!(first.brightness() > 20.0, "the screen is black");
    let colors = first.colors(SCENE);
    assert!(colors > 500, "only {colors} colours: where is the scene?");
    let hues = first.hues(SCENE);
    assert!(
        hues >= 4,
        "balls have seven hues, but only {hues} are there"
    );
    assert_floor(&first);
    assert_panel(&first);
    let moved = first.differences(&second, SCENE);
    assert!(moved > 1000, "only {moved} pixels changed: nothing moves");
}

#[test]
fn keys_pause_step_throw_reset_and_hide_the_panel() {
    let mut desktop = Desktop::with_window(&[]);
    desktop.press("space");
    let paused = still(&mut desktop, "Space");

    desktop.press("period");
    let stepped = changed(&mut desktop, &paused, SCENE, 100);
    let moved = paused.differences(&stepped, SCENE);
    assert!(moved > 100, "`.` makes no step: {moved} pixels changed");

    desktop.press("f");
    let thrown = changed(&mut desktop, &stepped, SCENE, 100);
    let moved = stepped.differences(&thrown, SCENE);
    assert!(moved > 100, "F throws no ball: {moved} pixels changed");

    desktop.press("r");
    let reset = changed(&mut desktop, &thrown, SCENE, 1000);
    let moved = thrown.differences(&reset, SCENE);
    assert!(moved > 1000, "R resets nothing: {moved} pixels changed");

    desktop.press("h");
    let hidden = changed(&mut desktop, &reset, IN_PANEL, 10_000);
    let share = hidden.share_of_commonest(IN_PANEL);
    assert!(
        share < 0.5,
        "H leaves the panel: {share:.2} of it is one colour"
    );
}

#[test]
fn a_key_pressed_elsewhere_and_held_while_the_window_gets_the_keyboard_does_nothing() {
    let mut desktop = Desktop::with_window(&[]);
    desktop.hide();
    desktop.show_without_keyboard();
    desktop.focus_with_a_key_held("space");
    let first = desktop.screenshot();
    pause();
    let second = desktop.screenshot();
    let moved = first.differences(&second, SCENE);
    assert!(moved > 1000, "Space stops it: {moved} pixels changed");
}

#[test]
fn resizing_and_hiding_are_survived_and_closing_ends_with_status_0() {
    let mut desktop = Desktop::with_window(&["--count", "10"]);
    desktop.resize(800, 500);
    pause();
    let small = desktop.screenshot();
    let inside = small.colors(Area::new(PANEL + 10, 0, 780 - PANEL, 490));
    let outside = small.colors(Area::new(810, 0, WIDTH - 810, HEIGHT));
    assert!(inside > 200, "only {inside} colours in the smaller window");
    assert_eq!(
        outside, 1,
        "something is drawn outside of the smaller window"
    );

    desktop.hide();
    pause();
    desktop.show();
    pause();
    desktop.resize(WIDTH, HEIGHT);
    pause();
    let back = desktop.screenshot();
    assert_floor(&back);
    assert_panel(&back);
    assert!(desktop.close().success(), "the program ended with an error");
}

#[test]
fn keys_show_layers_and_step_through_the_narrow_phase_of_a_pair() {
    let mut desktop = Desktop::with_window(&["--scene", "mixed", "--count", "20"]);
    std::thread::sleep(Duration::from_secs(4)); // until they have fallen
    desktop.press("space");
    let plain = still(&mut desktop, "Space");
    desktop.press("3");
    let contacts = changed(&mut desktop, &plain, SCENE, 1000);
    let drawn = plain.differences(&contacts, SCENE);
    assert!(drawn > 1000, "3 shows no contacts: {drawn} pixels changed");
    desktop.press("x");
    let solid = changed(&mut desktop, &contacts, SCENE, 1000);
    let drawn = contacts.differences(&solid, SCENE);
    assert!(drawn > 1000, "X leaves bodies of glass: {drawn} pixels");

    desktop.press("g");
    changed(&mut desktop, &solid, NARROW, 10_000);
    let end = still(&mut desktop, "G");
    let opened = solid.differences(&end, NARROW);
    assert!(opened > 10_000, "G opens no panel: {opened} pixels changed");
    desktop.press("Left");
    let before = changed(&mut desktop, &end, NARROW, 100);
    let stepped = end.differences(&before, NARROW);
    assert!(stepped > 100, "Left goes nowhere: {stepped} pixels changed");
    desktop.press("End");
    changed(&mut desktop, &before, NARROW, 100);
    let back = still(&mut desktop, "End");
    assert_eq!(end.differences(&back, NARROW), 0, "End isn't where G began");

    for key in ["b", "g", "x", "3"] {
        desktop.press(key);
    }
    pause();
    assert!(desktop.close().success(), "the program ended with an error");
}

/// The views of a race of four.
const VIEWS: [Area; 4] = [
    Area::new(310, 40, 470, 220),
    Area::new(800, 40, 470, 220),
    Area::new(310, 310, 470, 210),
    Area::new(800, 310, 470, 210),
];

/// What is plotted under them.
const PLOTS: Area = Area::new(360, 555, 900, 130);

#[test]
fn a_race_has_four_views_of_one_camera_and_plots_and_escape_ends_it() {
    let mut desktop = Desktop::with_window(&["--race", "balls"]);
    let first = desktop.screenshot();
    std::thread::sleep(Duration::from_secs(3));
    desktop.press("space");
    let paused = still(&mut desktop, "Space");
    for view in VIEWS {
        let colors = paused.colors(view);
        assert!(colors > 200, "only {colors} colours in a view");
        let moved = first.differences(&paused, view);
        assert!(moved > 500, "only {moved} pixels of a view move");
    }
    let drawn = first.differences(&paused, PLOTS);
    assert!(drawn > 500, "only {drawn} pixels of plots");
    assert_panel(&paused);

    desktop.drag([900, 400], [1000, 420]);
    changed(&mut desktop, &paused, VIEWS[3], 5000);
    let turned = still(&mut desktop, "letting go");
    for view in VIEWS {
        let moved = paused.differences(&turned, view);
        assert!(moved > 5000, "a view doesn't turn with the others: {moved}");
    }
    desktop.press("period");
    pause();
    desktop.press("Escape");
    let one = changed(&mut desktop, &turned, SCENE, 10_000);
    assert_panel(&one);
    assert!(one.differences(&turned, SCENE) > 10_000, "Escape leaves it");
    assert!(desktop.close().success(), "the program ended with an error");
}

#[test]
fn a_picture_shows_layers_and_the_narrow_phase_too() {
    let folder = tempfile::tempdir().expect("a folder for pictures");
    let picture = |name: &str, flags: &[&str]| {
        let file = folder.path().join(name);
        let run = Command::new(top_binary())
            .args(["--scene", "mixed", "--count", "20", "--steps", "120"])
            .args(flags)
            .arg("--screenshot")
            .arg(&file)
            .output()
            .expect("the program was found and can be started");
        let said = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success(), "{flags:?}: {said}");
        Picture::load(&file)
    };
    let plain = picture("plain.png", &[]);
    let layers = picture("layers.png", &["--layers", "aabbs,cells,contacts,frames"]);
    let drawn = plain.differences(&layers, Area::new(0, 0, WIDTH, HEIGHT));
    assert!(drawn > 1000, "only {drawn} pixels of layers");
    let first = picture("first.png", &["--dissect", "deepest,1"]);
    let last = picture("last.png", &["--dissect", "deepest"]);
    let stepped = first.differences(&last, NARROW);
    assert!(
        stepped > 1000,
        "all iterations look the same: {stepped} pixels"
    );
    let inset = first.colors(NARROW);
    assert!(
        inset > 100,
        "only {inset} colours in the narrow phase's panel"
    );
}

/// The floor is mostly of few light colours, with the lines of the grid on it.
fn assert_floor(picture: &Picture) {
    let colors = picture.colors(FLOOR);
    assert!(
        colors > 20,
        "only {colors} colours: where is the floor's grid?"
    );
    let light = picture.brightness_of(FLOOR);
    assert!(light > 120.0, "the floor's brightness is {light:.0} of 255");
}

/// The panel is mostly of one colour, with text and widgets on it.
fn assert_panel(picture: &Picture) {
    let share = picture.share_of_commonest(IN_PANEL);
    assert!(
        share > 0.6,
        "no panel: its colour fills {share:.2} of its place"
    );
    let colors = picture.colors(IN_PANEL);
    assert!(colors > 30, "an empty panel: {colors} colours in it");
}
