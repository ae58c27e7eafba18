//! Chapter 4's demo: ragdolls.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch04_ragdolls",
        title: "4. Ragdolls",
        about: "Stacked ragdolls: the report's second demo. A door, a chain and a cradle.",
        engines: &[ch04_ragdolls::ENGINE],
        default_scene: "ragdolls",
        scenes: ch00_scenes::builtin::NAMES,
    })
}
