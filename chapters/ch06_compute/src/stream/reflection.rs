//! What a kernel's WGSL says of itself: how large its workgroups are and what it binds.

use naga::back::PipelineConstants;
use naga::back::pipeline_constants::process_overrides;
use naga::proc::Layouter;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{AddressSpace, ArraySize, Handle, Module, ShaderStage, StorageAccess, Type, TypeInner};

/// A kernel, as its text says.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reflection {
    /// Invocations of a workgroup.
    pub(super) workgroup: u32,
    /// What it reads and writes, in order of number.
    pub(super) bindings: Vec<Binding>,
}

/// A `@group(0) @binding(n) var<…> name`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Binding {
    pub(super) number: u32,
    /// The name of the column that is bound to it.
    pub(super) name: String,
    pub(super) access: Access,
    /// Fewest bytes that it can be.
    pub(super) least_bytes: u64,
    pub(super) rows: Rows,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Access {
    Uniform,
    Read,
    Write,
}

/// What WGSL takes a column's rows for.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Rows {
    /// `array<f32>`, `array<u32>`, `array<atomic<u32>>`: any rows, number by number.
    Numbers,
    /// `array<T>`, or one T: rows of T's name, if it is a struct, and size.
    Of(Option<String>, u64),
}

// ANCHOR: reflect
/// Reads a kernel's text. Only what its entry point can reach is bound.
pub(super) fn reflect(
    source: &str,
    entry: &str,
    constants: &[(&str, f64)],
) -> Result<Reflection, String> {
    let module = naga::front::wgsl::parse_str(source).map_err(|e| e.emit_to_string(source))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::all())
        .validate(&module)
        .map_err(|e| e.emit_to_string(source))?;
    let known: Vec<_> = module
        .entry_points
        .iter()
        .map(|p| p.name.as_str())
        .collect();
    if !known.contains(&entry) {
        return Err(format!(
            "no entry point `{entry}`; there are: {}",
            known.join(", ")
        ));
    }
    let mut values = PipelineConstants::default();
    values.extend(
        constants
            .iter()
            .map(|&(name, value)| (name.to_owned(), value)),
    );
    let stage = Some((ShaderStage::Compute, entry));
    let (module, info) =
        process_overrides(&module, &info, stage, &values).map_err(|e| e.to_string())?;
    let mut points = module.entry_points.iter();
    let place = points
        .position(|point| point.name == entry && point.stage == ShaderStage::Compute)
        .ok_or_else(|| format!("entry point `{entry}` doesn't compute"))?;
    let used = info.get_entry_point(place);
    let mut layouter = Layouter::default();
    layouter
        .update(module.to_ctx())
        .map_err(|e| e.to_string())?;
    let variables = module.global_variables.iter();
    let mut bindings: Vec<_> = variables
        .filter(|(handle, _)| !used[*handle].is_empty())
        .filter_map(|(_, variable)| binding(&module, &layouter, variable))
        .collect::<Result<_, _>>()?;
    bindings.sort_by_key(|binding| binding.number);
    Ok(Reflection {
        workgroup: module.entry_points[place].workgroup_size.iter().product(),
        bindings,
    })
}
// ANCHOR_END: reflect

/// A variable that is bound; None if it isn't.
fn binding(
    module: &Module,
    layouter: &Layouter,
    variable: &naga::GlobalVariable,
) -> Option<Result<Binding, String>> {
    let at = variable.binding.as_ref()?;
    let name = variable.name.clone().unwrap_or_default();
    let access = match variable.space {
        AddressSpace::Uniform => Access::Uniform,
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => Access::Write,
        AddressSpace::Storage { .. } => Access::Read,
        _ => return Some(Err(format!("`{name}` is neither a column nor a uniform"))),
    };
    if at.group != 0 {
        return Some(Err(format!("`{name}` is in group {}, not 0", at.group)));
    }
    Some(Ok(Binding {
        number: at.binding,
        name,
        access,
        least_bytes: u64::from(layouter[variable.ty].size),
        rows: rows(module, layouter, variable.ty),
    }))
}

/// What a bound variable's type takes the rows for.
fn rows(module: &Module, layouter: &Layouter, ty: Handle<Type>) -> Rows {
    let found = &module.types[ty];
    match found.inner {
        TypeInner::Array {
            base,
            size: ArraySize::Dynamic,
            stride,
        } => match module.types[base].inner {
            TypeInner::Scalar(_) | TypeInner::Atomic(_) => Rows::Numbers,
            TypeInner::Struct { .. } => {
                Rows::Of(module.types[base].name.clone(), u64::from(stride))
            }
            _ => Rows::Of(None, u64::from(stride)),
        },
        TypeInner::Array { .. } => Rows::Numbers,
        TypeInner::Struct { .. } => Rows::Of(found.name.clone(), u64::from(layouter[ty].size)),
        _ => Rows::Of(None, u64::from(layouter[ty].size)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "
        struct Place { position: vec3f, reach: f32, }
        struct Step { dt: f32, rows: u32, }
        override WIDTH: u32 = 64;
        @group(0) @binding(7) var<uniform> step: Step;
        @group(0) @binding(1) var<storage, read> places: array<Place>;
        @group(0) @binding(0) var<storage, read_write> speeds: array<f32>;
        @group(0) @binding(3) var<storage, read> unused: array<vec4f>;
        fn reach(row: u32) -> f32 { return places[row].reach * step.dt; }
        @compute @workgroup_size(WIDTH)
        fn main(@builtin(global_invocation_id) id: vec3u) { speeds[id.x] = reach(id.x); }
        @compute @workgroup_size(8, 4)
        fn other() {}
    ";

    #[test]
    fn what_an_entry_point_reaches_is_bound_in_order_of_number() {
        let found = reflect(SOURCE, "main", &[]).expect("a kernel");
        let names: Vec<_> = found.bindings.iter().map(|b| b.name.as_str()).collect();
        assert_eq!(names, ["speeds", "places", "step"]);
        let access: Vec<_> = found.bindings.iter().map(|b| b.access).collect();
        assert_eq!(access, [Access::Write, Access::Read, Access::Uniform]);
        assert_eq!(found.bindings[0].rows, Rows::Numbers);
        let place = Rows::Of(Some("Place".to_owned()), 16);
        assert_eq!(found.bindings[1].rows, place);
        assert_eq!(found.bindings[2].least_bytes, 8);
    }

    #[test]
    fn constants_set_the_size_of_workgroups() {
        let width = |entry, constants: &[(&str, f64)]| {
            reflect(SOURCE, entry, constants).map(|found| found.workgroup)
        };
        assert_eq!(width("main", &[]), Ok(64));
        assert_eq!(width("main", &[("WIDTH", 128.0)]), Ok(128));
        assert_eq!(width("other", &[]), Ok(32));
        let error = width("main", &[("DEPTH", 1.0)]).expect_err("no such constant");
        assert!(error.contains("DEPTH"), "{error}");
    }

    #[test]
    fn what_is_wrong_with_a_kernel_is_said_with_its_line() {
        let error = reflect("fn main() {\n  let x = y;\n}", "main", &[]).expect_err("no y");
        assert!(error.contains("wgsl:2:11"), "{error}");
        let error = reflect(SOURCE, "mian", &[]).expect_err("no mian");
        assert!(error.contains("main, other"), "{error}");
    }
}
