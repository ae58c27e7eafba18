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
        for (table, columns) in by_table(world, system.writes) {
            write_list(text, table, &columns);
        }
    }
}

/// The kept columns that patterns name, by table, in the tables' order.
fn by_table(world: &World, patterns: &[&'static str]) -> Vec<(&'static str, Vec<&'static str>)> {
    let named: Vec<_> = patterns.iter().flat_map(|names| expand(names)).collect();
    let of_table = |table: &dyn AnyTable| {
        let is_named = |column: &&'static str| {
            let is_it =
                |&(of, name): &(&str, &str)| of == table.name() && (name == *column || name == "*");
            named.iter().any(is_it)
        };
        (table.name(), kept_of(table).filter(is_named).collect())
    };
    let tables = world.data.tables().into_iter().map(of_table);
    tables
        .filter(|(_, columns): &(_, Vec<_>)| !columns.is_empty())
        .collect()
}

/// The columns of a table that the plan kept.
fn kept_of(table: &dyn AnyTable) -> impl Iterator<Item = &'static str> {
    let specs = table.specs().iter().enumerate();
    specs
        .filter(|(place, _)| table.column(*place).is_kept())
        .map(|(_, spec)| spec.name)
}

/// The columns that there are, a table a line, with the bytes of a row.
fn write_columns(text: &mut String, world: &World) {
    let _ = writeln!(text, "\nColumns, with the bytes of a row:");
    for table in world.data.tables() {
        let specs = table.specs().iter().enumerate();
        let names: Vec<String> = specs
            .filter(|(place, _)| table.column(*place).is_kept())
            .map(|(_, spec)| format!("{} {}", spec.name, spec.kind.size()))
            .collect();
        if names.is_empty() {
            continue;
        }
        let (bytes, rows) = (table.row_bytes(), table.rows());
        let _ = writeln!(
            text,
            "     {:<13}{bytes:>4} bytes a row, {rows} rows",
            table.name()
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
    let _ = writeln!(text, "\nLeft out, and why:");
    for part in world.plan.left_out() {
        let _ = writeln!(text, "     {:<34} {}", part.name(), part.why_not());
    }
    let idle: Vec<&str> = world
        .plan
        .idle_systems()
        .map(|system| system.name)
        .collect();
    write_list(text, "systems", &idle);
    let (whole, parts): (Vec<_>, Vec<_>) = world
        .data
        .tables()
        .into_iter()
        .partition(|table| kept_of(*table).next().is_none());
    let whole: Vec<&str> = whole.into_iter().map(AnyTable::name).collect();
    write_list(text, "tables", &whole);
    for table in parts {
        write_list(text, table.name(), &left_out_of(table));
    }
}

/// A name and what it has, in lines; nothing of nothing.
fn write_list(text: &mut String, name: &str, items: &[&str]) {
    if items.is_empty() {
        return;
    }
    let items: Vec<String> = items.iter().map(|&item| item.to_owned()).collect();
    for (number, line) in wrapped(&items).into_iter().enumerate() {
        let name = if number == 0 {
            format!("{name}:")
        } else {
            String::new()
        };
        let _ = writeln!(text, "       {name:<13}{line}");
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

/// Words in lines of at most 84 characters, with commas between them.
fn wrapped(words: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (place, word) in words.iter().enumerate() {
        let comma = if place + 1 < words.len() { "," } else { "" };
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < 82 => {
                let _ = write!(line, " {word}{comma}");
            }
            _ => lines.push(format!("{word}{comma}")),
        }
    }
    lines
}
