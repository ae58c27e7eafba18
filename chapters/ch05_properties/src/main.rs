//! Chapter 5's demo: any scene on columns, with its property tables and its plan.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch05_properties",
        title: "5. Properties",
        about: "The same engine on one container of columns: any scene, its tables and its plan.",
        engines: &[ch05_properties::ENGINE],
        default_scene: "ragdolls",
        scenes: ch00_scenes::builtin::NAMES,
    })
}
