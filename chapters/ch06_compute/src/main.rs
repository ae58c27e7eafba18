//! Chapter 6's demo: the own-row step on the CPU and on the GPU.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch06_compute",
        title: "6. Compute",
        about: "The whole step on the GPU, where every row writes only itself; and its twin on the CPU.",
        engines: &[ch06_compute::COMPUTE, ch06_compute::LANES],
        default_scene: "pile",
        scenes: ch00_scenes::builtin::NAMES,
    })
}
