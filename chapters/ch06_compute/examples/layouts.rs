//! What the GPU makes of our rows and kernels: each property's byte, and what a kernel binds. As naga
//! reads the WGSL, beside what Rust says. The answer to an exercise of the page on columns.
//!
//! `cargo run --release -p ch06_compute --no-default-features --example layouts -- [ROW | SHADER]…`

use std::process::ExitCode;

use ch06_compute::rows::wgsl;
use ch06_compute::stream::{names, source};
use naga::proc::Layouter;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, ArraySize, Handle, Module, StorageAccess, Type, TypeInner};

type Problem = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    if words.is_empty() {
        words = ["Place", "Mover", "ch06_balls"].map(str::to_owned).to_vec();
    }
    for word in words {
        let told = if names().any(|name| name == word) {
            tell_shader(&word)
        } else {
            tell_row(&word)
        };
        if let Err(problem) = told {
            eprintln!("{problem}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// WGSL as naga reads it.
struct Read {
    module: Module,
    info: ModuleInfo,
    layouter: Layouter,
}

fn read(text: &str) -> Result<Read, Problem> {
    let module = naga::front::wgsl::parse_str(text)?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module)?;
    let mut layouter = Layouter::default();
    layouter.update(module.to_ctx())?;
    Ok(Read {
        module,
        info,
        layouter,
    })
}

// ANCHOR: row
/// A row: its size, and where in it each property is.
fn tell_row(name: &str) -> Result<(), Problem> {
    let read = read(&wgsl())?;
    let mut types = read.module.types.iter();
    let found = types.find(|(_, found)| found.name.as_deref() == Some(name));
    let (_, found) = found.ok_or(format!("`{name}` is neither a row nor a shader"))?;
    let TypeInner::Struct { members, span } = &found.inner else {
        return Err(format!("`{name}` is no row").into());
    };
    println!("{name}, {span} bytes a row");
    for member in members {
        let bytes = read.layouter[member.ty].size;
        let field = member.name.as_deref().unwrap_or_default();
        println!("  from {:>3}  {bytes:>2} bytes  {field}", member.offset);
    }
    Ok(())
}
// ANCHOR_END: row

/// A shader: for each of its kernels the size of a workgroup, and what it binds.
fn tell_shader(name: &str) -> Result<(), Problem> {
    let read = read(&source(name)?)?;
    for (place, point) in read.module.entry_points.iter().enumerate() {
        println!("{name}, kernel {}", point.name);
        let used = read.info.get_entry_point(place);
        let variables = read.module.global_variables.iter();
        for (_, bound) in variables.filter(|(handle, _)| !used[*handle].is_empty()) {
            let Some(access) = access(bound.space) else {
                continue;
            };
            let column = bound.name.as_deref().unwrap_or_default();
            println!("  {access:<10} {column:<17} {}", rows(&read, bound.ty));
        }
    }
    Ok(())
}

/// What a kernel may do with a variable; None for what isn't bound.
fn access(space: AddressSpace) -> Option<&'static str> {
    match space {
        AddressSpace::Uniform => Some("uniform"),
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
            Some("read_write")
        }
        AddressSpace::Storage { .. } => Some("read"),
        _ => None,
    }
}

/// Bytes of a row, and its type if that has a name.
fn rows(read: &Read, bound: Handle<Type>) -> String {
    let (row, bytes) = match read.module.types[bound].inner {
        TypeInner::Array {
            base,
            size: ArraySize::Dynamic,
            stride,
        } => (base, stride),
        _ => (bound, read.layouter[bound].size),
    };
    let name = read.module.types[row].name.as_deref();
    let name = name.map_or_else(String::new, |name| format!(", {name}"));
    format!("{bytes:>3} bytes{name}")
}
