//! Chapter 2's demo: spinning tops and magnets.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch02_rigid_bodies",
        title: "2. Rigid bodies",
        about: "Spinning tops and magnets: bodies that fly, turn and pull each other.",
        engines: &[ch02_rigid_bodies::ENGINE],
        default_scene: "tops",
        scenes: &["tops", "magnets", "orrery"],
    })
}
