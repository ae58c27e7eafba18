//! What the program says of itself: `--help` and `--explain`.

use std::fmt::Write as _;

use ch00_scenes::builtin;
use clap::Command;

use super::Args;
use crate::chapter::Chapter;
use crate::session::Session;

/// The chapter's command line.
#[must_use]
pub fn command(chapter: &Chapter) -> Command {
    <Args as clap::Args>::augment_args(Command::new(chapter.name))
        .version(env!("CARGO_PKG_VERSION"))
        .about(format!("{}\n\n{}", chapter.title, chapter.about))
        .after_help(examples(chapter))
}

/// What can be chosen and how, for the end of a chapter's `--help`.
#[must_use]
pub fn examples(chapter: &Chapter) -> String {
    let program = format!("cargo run --release -p {} --", chapter.name);
    let scene = chapter.default_scene;
    let engine = chapter.engines[0].name;
    let mut text = format!("Scenes, `{scene}` unless you say otherwise:\n");
    let widest = chapter.scenes.iter().map(|name| name.len()).max();
    let width = widest.unwrap_or(0).max(12);
    for name in chapter.scenes {
        let about = builtin::about(name).unwrap_or_default();
        let _ = writeln!(text, "  {name:<width$} {about}");
    }
    for engine in chapter.engines {
        let (name, chapter) = (engine.name, engine.chapter);
        let _ = writeln!(
            text,
            "\nMethods of the engine `{name}` ({chapter}), the default first:"
        );
        for method in engine.methods {
            let _ = writeln!(text, "  {:<12} {}", method.name, method.about);
        }
    }
    let _ = write!(
        text,
        "\nExamples:\n  \
         {program}\n      \
         open a window with `{scene}`\n  \
         {program} --scene {scene} --headless\n      \
         run it without one and print a table\n  \
         {program} --scene {scene} --engine {engine} --explain\n      \
         say what the engine does with it, and why\n  \
         {program} --scene my.json --steps 300 --dump my.rbd\n      \
         run a scene file and write its states\n  \
         {program} --scene {scene} --screenshot {scene}.png\n      \
         run it and draw where it ends\n  \
         {program} --scene {scene} --layers contacts --dissect deepest --screenshot pair.png\n      \
         draw its contacts too, and how the narrow phase finds the deepest one"
    );
    text
}

/// What `--explain` prints: who steps, then the engine's own words.
pub(super) fn explain(session: &Session) -> String {
    let info = session.engine().info();
    let sweeps = info
        .sweeps
        .map_or_else(|| "none".to_owned(), |sweeps| sweeps.to_string());
    format!(
        "scene     {scene}: {bodies} bodies ({moving} move), {joints} joints, {steps} steps of {dt:.6} s\n\
         engine    {engine}, method {method}, on {device} with {threads} thread(s)\n\
         substeps  {substeps}\n\
         sweeps    {sweeps}\n\
         threshold impacts below {threshold} m/s don't bounce\n\n\
         {words}\n",
        scene = session.scene().name,
        bodies = session.scene().bodies.len(),
        moving = session.scene().dynamic_count(),
        joints = session.scene().joints.len(),
        steps = session.scene().steps,
        dt = session.dt(),
        engine = info.engine,
        method = info.method,
        device = info.device,
        threads = info.threads,
        substeps = info.substeps,
        threshold = info.restitution_threshold,
        words = session.engine().explain().trim_end(),
    )
}
