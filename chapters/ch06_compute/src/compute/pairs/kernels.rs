//! The kernels of a step of pairs, each compiled once, and the order in which they run.

use super::super::scan::Scanning;
use super::plan::{MOST_SPOTS, Plan};
use crate::stream::{Gpu, Kernel, Passes, StreamError, source};

/// Columns that change sides from step to step: what this step writes, the next one looks up.
const PARTNERS: [&str; 2] = ["partners_a", "partners_b"];
const MEMORIES: [&str; 2] = ["memories_a", "memories_b"];

/// A kernel bound to either side.
#[derive(Debug)]
struct Sided([Kernel; 2]);

impl Sided {
    /// Binds a kernel: `naming` says which columns it has on a side.
    fn of(
        kernel: &Kernel,
        naming: impl Fn(usize) -> Vec<(&'static str, &'static str)>,
    ) -> Result<Self, StreamError> {
        Ok(Self([
            kernel.renamed(&naming(0))?,
            kernel.renamed(&naming(1))?,
        ]))
    }
}

/// How many rows and counts the passes run over.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sizes {
    /// Bodies.
    pub rows: usize,
    /// Starts of the grid's slots.
    pub starts: usize,
    /// Counts of pairs by kind and body.
    pub pair_counts: usize,
    /// Large bodies that move.
    pub larges: usize,
    /// Nodes of trees.
    pub nodes: usize,
    /// Parts of a step.
    pub substeps: u32,
    /// Whether anybody draws.
    pub draws: bool,
}

/// All kernels of a step.
#[derive(Debug)]
pub struct PairKernels {
    cells: Kernel,
    scan_cells: Scanning,
    scatter: Kernel,
    sort: Kernel,
    find: Sided,
    scan_pairs: Scanning,
    plan: Kernel,
    list: Sided,
    /// By kind of pair.
    meet: Vec<Sided>,
    large: Option<Kernel>,
    start: Sided,
    solve: Sided,
    solve_last: Sided,
    loops: Option<Kernel>,
    /// Bodies in no tree, and in the last substep.
    advance: Option<[Kernel; 2]>,
    /// Those in trees.
    trees: Option<[Kernel; 2]>,
    restore: Option<(Sided, Kernel)>,
    /// Where what pulls depends on where others are.
    kick: Option<Kernel>,
    state: Kernel,
}

impl PairKernels {
    /// Compiles them for a plan.
    ///
    /// # Errors
    /// [`StreamError::Kernel`].
    pub fn of(gpu: &Gpu, plan: &Plan) -> Result<Self, StreamError> {
        let make = |name, file: &str, entry: &str, last: bool| {
            kernel(gpu, name, file, entry, &constants(plan, last))
        };
        let both = |name, entry| -> Result<_, StreamError> {
            let make = |last| make(name, "ch06_pair_advance", entry, last);
            Ok([make(false)?, make(true)?])
        };
        let solve = |last| -> Result<Sided, StreamError> {
            Sided::of(
                &make("solve", "ch06_pair_solve", "pair_solve", last)?,
                name_solve,
            )
        };
        let meet = |(slot, &kind): (usize, &u32)| {
            let mut all = constants(plan, false);
            all.extend([("PAIR_KIND", f64::from(kind)), ("SLOT", slot as f64)]);
            let text = with_spots(&source("ch06_pair_meet")?, MOST_SPOTS[kind as usize]);
            let kernel = compiled(gpu, "meet", &text, "pair_meet", &all)?;
            Sided::of(&kernel, name_meet)
        };
        let restore = || -> Result<_, StreamError> {
            let restore = make("restore", "ch06_pair_solve", "pair_restore", true)?;
            let rebound = make("rebound", "ch06_pair_advance", "pair_rebound", true)?;
            Ok((Sided::of(&restore, name_solve)?, rebound))
        };
        let scan = |names| Scanning::of(gpu, names);
        let large = || make("large", "ch06_pair_large", "pair_large", false);
        Ok(Self {
            cells: make("cells", "ch06_pair_cells", "pair_cells", false)?,
            scan_cells: scan(["cell_scan", "counts", "starts"])?,
            scatter: make("scatter", "ch06_pair_sort", "pair_scatter", false)?,
            sort: make("sort", "ch06_pair_sort", "pair_sort", false)?,
            find: Sided::of(
                &make("find", "ch06_pair_find", "pair_find", false)?,
                name_lists,
            )?,
            scan_pairs: scan(["pair_scan", "pair_counts", "pair_starts"])?,
            plan: make("plan", "ch06_pair_list", "pair_plan", false)?,
            list: Sided::of(
                &make("list", "ch06_pair_list", "pair_list", false)?,
                name_lists,
            )?,
            meet: plan
                .kinds
                .iter()
                .enumerate()
                .map(meet)
                .collect::<Result<_, _>>()?,
            large: some(!plan.larges.is_empty(), large)?,
            start: Sided::of(
                &make("start", "ch06_pair_start", "pair_start", false)?,
                name_lists,
            )?,
            loops: some(plan.joints.loops > 0, || {
                let loops = make("loops", "ch06_loops", "solve_loops", false)?;
                loops.renamed(&[("loop_presses", "presses")])
            })?,
            solve: solve(false)?,
            solve_last: solve(true)?,
            advance: some(plan.loose, || both("advance", "pair_advance"))?,
            trees: some(plan.joints.any, || both("trees", "pair_trees"))?,
            restore: some(plan.bounces, restore)?,
            kick: some(plan.poles > 0, || {
                make("kick", "ch06_pair_kick", "pair_kick", false)
            })?,
            state: make("state", "ch06_pair_state", "pair_state", false)?,
        })
    }

    // ANCHOR: step
    /// The passes of a step, by the numbers of which every second one has the same side.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(
        &self,
        passes: &mut Passes<'_>,
        sizes: &Sizes,
        number: u32,
    ) -> Result<(), StreamError> {
        let side = number as usize & 1;
        self.find(passes, sizes, side)?;
        passes.section("narrow phase");
        for (slot, meet) in self.meet.iter().enumerate() {
            passes.run_indirect(&meet.0[side], "groups", slot + 1)?;
        }
        passes.section("substeps");
        self.add_large(passes, sizes)?;
        passes.run(&self.start.0[side], sizes.rows)?;
        self.kick(passes, sizes)?;
        for substep in 1..=sizes.substeps {
            let is_last = substep == sizes.substeps;
            let solve = if is_last {
                &self.solve_last
            } else {
                &self.solve
            };
            passes.run_indirect(&solve.0[side], "groups", 0)?;
            if let Some(loops) = &self.loops {
                passes.run_indirect(loops, "groups", self.meet.len() + 1)?;
            }
            self.add_large(passes, sizes)?;
            if let Some(advance) = &self.advance {
                passes.run(&advance[usize::from(is_last)], sizes.rows)?;
            }
            if let Some(trees) = &self.trees {
                passes.run(&trees[usize::from(is_last)], sizes.nodes)?;
            }
            if !is_last {
                self.kick(passes, sizes)?;
            }
        }
        if let Some((restore, rebound)) = &self.restore {
            passes.section("restitution");
            passes.run_indirect(&restore.0[side], "groups", 0)?;
            self.add_large(passes, sizes)?;
            passes.run(rebound, sizes.rows)?;
        }
        if sizes.draws {
            passes.run(&self.state, sizes.rows)?;
        }
        Ok(())
    }
    // ANCHOR_END: step

    /// The names of the passes in the order of a step, those of the substeps once.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        let mut names = vec![
            "cells", "scan", "scatter", "sort", "find", "scan", "plan", "list", "meet", "start",
            "solve",
        ];
        names.extend(self.loops.iter().map(|_| "loops"));
        names.extend(self.advance.iter().map(|_| "advance"));
        names.extend(self.trees.iter().map(|_| "trees"));
        if self.kick.is_some() {
            names.push("kick");
        }
        if self.restore.is_some() {
            names.extend(["restore", "rebound"]);
        }
        names
    }

    /// The broad phase.
    fn find(&self, passes: &mut Passes<'_>, sizes: &Sizes, side: usize) -> Result<(), StreamError> {
        passes.section("broad phase");
        passes.run(&self.cells, sizes.rows)?;
        self.scan_cells.run(passes, sizes.starts)?;
        passes.run(&self.scatter, sizes.rows)?;
        passes.run(&self.sort, sizes.rows)?;
        passes.run(&self.find.0[side], sizes.rows)?;
        self.scan_pairs.run(passes, sizes.pair_counts)?;
        passes.run_workgroups(&self.plan, 1)?;
        passes.run(&self.list.0[side], sizes.rows)
    }

    /// What pulls, where it is summed in a pass of its own.
    fn kick(&self, passes: &mut Passes<'_>, sizes: &Sizes) -> Result<(), StreamError> {
        match &self.kick {
            Some(kick) => passes.run(kick, sizes.rows),
            None => Ok(()),
        }
    }

    /// What pairs did to large bodies that move.
    fn add_large(&self, passes: &mut Passes<'_>, sizes: &Sizes) -> Result<(), StreamError> {
        match &self.large {
            Some(large) => passes.run_workgroups(large, sizes.larges),
            None => Ok(()),
        }
    }
}

/// Something that a plan has or not.
fn some<T>(has: bool, make: impl Fn() -> Result<T, StreamError>) -> Result<Option<T>, StreamError> {
    if has { make().map(Some) } else { Ok(None) }
}

/// The constants of a plan; each kernel takes those that it has.
fn constants(plan: &Plan, last: bool) -> Vec<(&'static str, f64)> {
    let flag = |on: bool| f64::from(u8::from(on));
    vec![
        ("POINTS", f64::from(plan.points)),
        ("BOUNCES", flag(plan.bounces)),
        ("IGNORES", flag(plan.joints.any)),
        ("JOINTS", flag(plan.joints.any)),
        ("HINGES", flag(plan.joints.hinges > 0)),
        ("RODS", flag(plan.joints.rods > 0)),
        ("LIMITS", flag(plan.joints.limits > 0)),
        ("EULER_LIMITS", flag(plan.joints.euler > 0)),
        ("MOVING_LARGE", flag(!plan.larges.is_empty())),
        ("PIVOTS", flag(plan.pivots)),
        ("PULLS", flag(plan.poles > 0)),
        ("LAST", flag(last)),
    ]
}

/// A narrow phase with memory for so many points before four are chosen. An invocation has it to itself, and
/// the more it has, the fewer of them a device runs at once.
fn with_spots(text: &str, most: usize) -> String {
    text.replace(
        "const MOST_SPOTS: u32 = 20u;",
        &format!("const MOST_SPOTS: u32 = {most}u;"),
    )
}

/// Compiles an entry point of a shader.
fn kernel(
    gpu: &Gpu,
    name: &'static str,
    file: &str,
    entry: &str,
    constants: &[(&'static str, f64)],
) -> Result<Kernel, StreamError> {
    compiled(gpu, name, &source(file)?, entry, constants)
}

/// Compiles an entry point with those of the constants that its text has.
fn compiled(
    gpu: &Gpu,
    name: &'static str,
    text: &str,
    entry: &str,
    constants: &[(&'static str, f64)],
) -> Result<Kernel, StreamError> {
    let has = |(constant, _): &&(&str, f64)| text.contains(&format!("override {constant}:"));
    let known: Vec<_> = constants.iter().filter(has).copied().collect();
    Kernel::new(gpu, name, text, entry, &known)
}

fn name_lists(side: usize) -> Vec<(&'static str, &'static str)> {
    vec![("partners", PARTNERS[side])]
}

fn name_meet(side: usize) -> Vec<(&'static str, &'static str)> {
    vec![
        ("last_partners", PARTNERS[side ^ 1]),
        ("last_memories", MEMORIES[side ^ 1]),
        ("memories", MEMORIES[side]),
    ]
}

fn name_solve(side: usize) -> Vec<(&'static str, &'static str)> {
    vec![("memories", MEMORIES[side])]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_narrow_phase_gets_memory_for_as_many_points_as_its_kind_needs() {
        let text = source("ch06_pair_meet").expect("a shader");
        assert!(with_spots(&text, 2).contains("MOST_SPOTS: u32 = 2u;"));
    }
}
