//! The top binary: every engine and every scene of the book, and its charts.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch07_findings",
        title: "From Objects to Shaders",
        about: "Bouncing balls: the report's first demo.",
        engines: &[ch03_collision::ENGINE],
        default_scene: "balls",
        scenes: &["balls", "pair", "bounce", "bounce_half", "tops", "orrery"],
    })
}
