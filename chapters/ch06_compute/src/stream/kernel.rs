//! A kernel: WGSL, compiled, and bound to the columns that have its bindings' names.

use std::sync::{Arc, Mutex, PoisonError};

use super::columns::layout;
use super::reflection::{Access, Binding, Rows, reflect};
use super::{ColumnInfo, Columns, Gpu, StreamError};

/// How many sets of buffers a kernel remembers: columns that are swapped make two.
const MOST_GROUPS: usize = 8;

/// A compiled kernel.
#[derive(Debug)]
pub struct Kernel {
    name: &'static str,
    compiled: Compiled,
    /// The columns' names, a name a binding.
    columns: Vec<String>,
    groups: Mutex<Vec<Group>>,
}

/// What compiling a text gave. The device keeps it: whoever loads another scene needs it again.
#[derive(Clone, Debug)]
pub(super) struct Compiled {
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    workgroup: u32,
    bindings: Arc<[Binding]>,
}

/// Buffers that the kernel was bound to.
#[derive(Debug)]
struct Group {
    /// The state of the columns at which they were last found.
    stamp: u64,
    buffers: Vec<wgpu::Buffer>,
    bound: wgpu::BindGroup,
}

impl Kernel {
    // ANCHOR: new
    /// Compiles an entry point. `constants` are the values of WGSL's `override`s: what a plan leaves out
    /// is compiled away.
    ///
    /// # Errors
    /// [`StreamError::Kernel`] if it isn't valid here, with the line.
    pub fn new(
        gpu: &Gpu,
        name: &'static str,
        source: &str,
        entry: &str,
        constants: &[(&str, f64)],
    ) -> Result<Self, StreamError> {
        let key = format!("{entry} {constants:?}\n{source}");
        if let Some(compiled) = gpu.compiled(&key) {
            return Ok(Self::of(name, compiled));
        }
        let failed = |why: String| StreamError::Kernel {
            kernel: name.to_owned(),
            why,
        };
        let found = reflect(source, entry, constants).map_err(failed)?;
        fits(gpu, &found.bindings).map_err(failed)?;
        let scope = gpu.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let layout = layout_of(gpu, name, &found.bindings);
        let pipeline = compile(gpu, name, source, entry, constants, &layout);
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(failed(error.to_string()));
        }
        let compiled = Compiled {
            pipeline,
            layout,
            workgroup: found.workgroup,
            bindings: found.bindings.into(),
        };
        gpu.keep_compiled(key, compiled.clone());
        Ok(Self::of(name, compiled))
    }
    // ANCHOR_END: new

    /// Bound to the columns that have its bindings' names.
    fn of(name: &'static str, compiled: Compiled) -> Self {
        Self {
            name,
            columns: compiled.bindings.iter().map(|b| b.name.clone()).collect(),
            compiled,
            groups: Mutex::default(),
        }
    }

    /// The same kernel over other columns: pairs of a binding's name and a column's.
    ///
    /// # Errors
    /// [`StreamError::Kernel`] if it has no such binding.
    pub fn renamed(&self, names: &[(&str, &str)]) -> Result<Self, StreamError> {
        let mut columns = self.columns.clone();
        for &(binding, column) in names {
            let place = self
                .compiled
                .bindings
                .iter()
                .position(|b| b.name == binding);
            let place = place.ok_or_else(|| StreamError::Kernel {
                kernel: self.name.to_owned(),
                why: format!("it has no binding `{binding}`"),
            })?;
            column.clone_into(&mut columns[place]);
        }
        Ok(Self {
            name: self.name,
            compiled: self.compiled.clone(),
            columns,
            groups: Mutex::default(),
        })
    }

    /// Its name, which is also that of its passes.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Invocations of a workgroup.
    #[must_use]
    pub fn workgroup(&self) -> u32 {
        self.compiled.workgroup
    }

    /// The columns that it reads and writes.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(String::as_str)
    }

    /// Bytes of a row in all columns that it touches, taking each to be read or written once: what a
    /// pass moves at least.
    ///
    /// # Errors
    /// [`StreamError::UnknownColumn`].
    pub fn row_bytes(&self, columns: &Columns) -> Result<usize, StreamError> {
        let rows = self.compiled.bindings.iter().zip(&self.columns);
        let rows = rows.filter(|(binding, _)| binding.access != Access::Uniform);
        rows.map(|(_, name)| Ok(columns.info(name)?.row_bytes))
            .sum()
    }

    /// The compiled pipeline.
    pub(super) fn pipeline(&self) -> &wgpu::ComputePipeline {
        &self.compiled.pipeline
    }

    // ANCHOR: group
    /// The buffers behind its names, bound. They are looked up again only when a column has moved.
    pub(super) fn group(&self, columns: &Columns) -> Result<wgpu::BindGroup, StreamError> {
        let mut groups = self.groups.lock().unwrap_or_else(PoisonError::into_inner);
        let stamp = columns.stamp();
        if let Some(known) = groups.iter().find(|known| known.stamp == stamp) {
            return Ok(known.bound.clone());
        }
        let buffers = self.buffers(columns)?;
        if let Some(known) = groups.iter_mut().find(|known| known.buffers == buffers) {
            known.stamp = stamp;
            return Ok(known.bound.clone());
        }
        if groups.len() == MOST_GROUPS {
            groups.remove(0);
        }
        let group = self.bind(columns.gpu(), &buffers);
        groups.push(Group {
            stamp,
            buffers,
            bound: group.clone(),
        });
        Ok(group)
    }
    // ANCHOR_END: group

    /// The buffers behind its names, if they are what it takes them for.
    fn buffers(&self, columns: &Columns) -> Result<Vec<wgpu::Buffer>, StreamError> {
        let pairs = self.compiled.bindings.iter().zip(&self.columns);
        pairs
            .map(|(binding, name)| {
                let buffer = columns.buffer(name)?;
                self.check(binding, columns.info(name)?, buffer)?;
                Ok(buffer.clone())
            })
            .collect()
    }

    /// Whether a column is what a binding takes it for.
    fn check(
        &self,
        binding: &Binding,
        info: &ColumnInfo,
        buffer: &wgpu::Buffer,
    ) -> Result<(), StreamError> {
        let wants = |what: String| {
            Err(layout(
                info,
                format!("{what} as kernel `{}` has it", self.name),
            ))
        };
        if let Rows::Of(row, bytes) = &binding.rows {
            let other_struct = row.as_ref().is_some_and(|row| row != info.row);
            if *bytes != info.row_bytes as u64 || other_struct {
                let row = row.as_deref().unwrap_or("a row");
                return wants(format!("{row} of {bytes} bytes,"));
            }
        }
        if buffer.size() < binding.least_bytes {
            return wants(format!("at least {} bytes in all,", binding.least_bytes));
        }
        let is_uniform = buffer.usage().contains(wgpu::BufferUsages::UNIFORM);
        if is_uniform != (binding.access == Access::Uniform) {
            let kind = if is_uniform { "a column" } else { "a uniform" };
            return wants(format!("{kind},"));
        }
        Ok(())
    }

    fn bind(&self, gpu: &Gpu, buffers: &[wgpu::Buffer]) -> wgpu::BindGroup {
        let pairs = self.compiled.bindings.iter().zip(buffers);
        let entries: Vec<_> = pairs
            .map(|(binding, buffer)| wgpu::BindGroupEntry {
                binding: binding.number,
                resource: buffer.as_entire_binding(),
            })
            .collect();
        gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some(self.name),
            layout: &self.compiled.layout,
            entries: &entries,
        })
    }
}

/// Whether the device can bind so many columns at once.
fn fits(gpu: &Gpu, bindings: &[Binding]) -> Result<(), String> {
    let columns = bindings.iter().filter(|b| b.access != Access::Uniform);
    let (columns, most) = (
        columns.count(),
        gpu.limits.max_storage_buffers_per_shader_stage,
    );
    if columns > most as usize {
        return Err(format!(
            "it binds {columns} columns, {} allows {most}",
            gpu.name
        ));
    }
    Ok(())
}

fn layout_of(gpu: &Gpu, name: &str, bindings: &[Binding]) -> wgpu::BindGroupLayout {
    let entries: Vec<_> = bindings.iter().map(layout_entry).collect();
    gpu.device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(name),
            entries: &entries,
        })
}

fn layout_entry(binding: &Binding) -> wgpu::BindGroupLayoutEntry {
    let ty = match binding.access {
        Access::Uniform => wgpu::BufferBindingType::Uniform,
        Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
        Access::Write => wgpu::BufferBindingType::Storage { read_only: false },
    };
    wgpu::BindGroupLayoutEntry {
        binding: binding.number,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty,
            has_dynamic_offset: false,
            min_binding_size: wgpu::BufferSize::new(binding.least_bytes),
        },
        count: None,
    }
}

fn compile(
    gpu: &Gpu,
    name: &str,
    source: &str,
    entry: &str,
    constants: &[(&str, f64)],
    layout: &wgpu::BindGroupLayout,
) -> wgpu::ComputePipeline {
    let module = trusted(gpu, name, source);
    let layout = gpu
        .device
        .create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(name),
            bind_group_layouts: &[Some(layout)],
            immediate_size: 0,
        });
    gpu.device
        .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: Some(&layout),
            module: &module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants,
                zero_initialize_workgroup_memory: false,
            },
            cache: None,
        })
}

// ANCHOR: trusted
/// Compiles our own WGSL without the two checks that cost: a counter in every loop, against those that
/// never end, and a test before every division of whole numbers. Access to buffers stays checked.
#[expect(
    unsafe_code,
    reason = "the kernels are part of this program, and all their loops and divisors are bounded"
)]
fn trusted(gpu: &Gpu, name: &str, source: &str) -> wgpu::ShaderModule {
    let checks = wgpu::ShaderRuntimeChecks {
        force_loop_bounding: false,
        int_div_checks: false,
        ..wgpu::ShaderRuntimeChecks::checked()
    };
    let descriptor = wgpu::ShaderModuleDescriptor {
        label: Some(name),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    };
    // SAFETY: no kernel has a loop without an end or a divisor that can be 0.
    unsafe { gpu.device.create_shader_module_trusted(descriptor, checks) }
}
// ANCHOR_END: trusted
