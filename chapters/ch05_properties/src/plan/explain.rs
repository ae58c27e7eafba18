//! The plan in words: what `--explain` and the overlay show.

use std::fmt::Write;

use ch00_scenes::Scene;

use super::systems::expand;
use crate::columns::AnyTable;
use crate::world::World;

/// Systems in order, columns, bytes a body, and what was left out and why.
#[must_use]
pub fn explain(scene: &Scene, world: &World) -> String {
    let mut text = String::new();
    let method = world.surroundings.method.name();
    let moving = scene.dynamic_count();
    let still = scene.bodies.len() - moving;
    let _ = writeln!(
        text,
        "scene `{}` as properties, method {method}: {moving} bodies that move, {still} that don't, {} joints",
        scene.name,
        scene.joints.len()
    );
    write_systems(&mut text, world);
    write_columns(&mut text, world);
    write_left_out(&mut text, world);
    text
}

/// The systems that run, with the columns that they write.
fn write_systems(text: &mut String, world: &World) {
    let _ = writeln!(
        text,
        "\nSystems, in order, with the columns that they write:"
    );
    for (number, system) in world.plan.systems().enumerate() {
        let _ = writeln!(
            text,
            "{:>3}. {:<20} {}",
            number + 1,
            system.name,
            system.about
        );
        let kept = |&(table, column): &(&'static str, &'static str)| {
            column == "*" || world.plan.why_left_out(table, column).is_none()
        };
        let written = system.writes.iter().flat_map(|names| expand(names));
        let written: Vec<String> = written
            .filter(kept)
            .map(|(table, column)| format!("{table}.{column}"))
            .collect();
        for line in wrapped(&written) {
            let _ = writeln!(text, "       {line}");
        }
    }
}

/// The columns that there are, a table a line, with the bytes of a row.
fn write_columns(text: &mut String, world: &World) {
    let _ = writeln!(text, "\nColumns, with the bytes of a row:");
    for table in world.data.tables() {
        let kept = table.specs().iter().enumerate();
        let names: Vec<String> = kept
            .filter(|(place, _)| table.column(*place).is_kept())
            .map(|(_, spec)| format!("{} {}", spec.name, spec.kind.size()))
            .collect();
        if names.is_empty() {
            continue;
        }
        let _ = writeln!(
            text,
            "     {:<13}{:>4} bytes a row, {} rows",
            table.name(),
            table.row_bytes(),
            table.rows()
        );
        for line in wrapped(&names) {
            let _ = writeln!(text, "       {line}");
        }
    }
    let bodies = world.data.bodies.row_bytes();
    let motions = world.data.motions.row_bytes();
    let boxes = size_of::<ch03_collision::aabb::Aabb>();
    let _ = writeln!(
        text,
        "A body has {bodies} bytes of state, and {motions} of notes while it is resolved; its box in the \
         broad phase has {boxes}."
    );
}

/// What the method has and this scene doesn't need.
fn write_left_out(text: &mut String, world: &World) {
    let _ = writeln!(text, "\nLeft out:");
    for part in world.plan.left_out() {
        let _ = writeln!(text, "     {:<34} {}", part.name(), part.why_not());
    }
    let columns: Vec<String> = world
        .data
        .tables()
        .into_iter()
        .map(|table| (table, left_out_of(table)))
        .filter(|(_, names)| !names.is_empty())
        .map(|(table, names)| format!("{}: {}", table.name(), names.join(", ")))
        .collect();
    for table in columns {
        for line in wrapped(&table.split(' ').map(str::to_owned).collect::<Vec<_>>()) {
            let _ = writeln!(text, "       {}", line.replace(",,", ","));
        }
    }
}

/// The columns of a table that the plan left out.
fn left_out_of(table: &dyn AnyTable) -> Vec<&'static str> {
    let specs = table.specs().iter().enumerate();
    specs
        .filter(|(place, _)| !table.column(*place).is_kept())
        .map(|(_, spec)| spec.name)
        .collect()
}

/// Words in lines of at most 100 characters, with commas between them.
fn wrapped(words: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (place, word) in words.iter().enumerate() {
        let comma = if place + 1 < words.len() && !word.ends_with([',', ':']) {
            ","
        } else {
            ""
        };
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < 98 => {
                let _ = write!(line, " {word}{comma}");
            }
            _ => lines.push(format!("{word}{comma}")),
        }
    }
    lines
}
