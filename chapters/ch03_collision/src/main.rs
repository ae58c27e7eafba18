//! Chapter 3's demo: bouncing balls.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch00_shell::main(&ch00_shell::Chapter {
        name: "ch03_collision",
        title: "3. Collision",
        about: "Bouncing balls: the report's first demo. Stacks, slopes, and solids of every shape.",
        engines: &[ch03_collision::ENGINE],
        default_scene: "balls",
        scenes: &[
            "balls",
            "smooth_balls",
            "pile",
            "mixed",
            "stack",
            "heavy_on_light",
            "slip_to_roll",
            "slopes",
            "incline",
            "slide",
            "oblique",
            "tunnelling",
            "pair",
            "bounce",
            "bounce_half",
            "tops",
            "magnets",
            "magnets_on_a_table",
            "orrery",
        ],
    })
}
