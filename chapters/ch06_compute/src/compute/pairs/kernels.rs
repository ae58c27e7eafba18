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
        let make = Making { gpu, plan };
        let scan = |names| Scanning::of(gpu, names);
        let lists = |kernel: Kernel| Sided::of(&kernel, name_lists);
        Ok(Self {
            cells: make.kernel("cells", "ch06_pair_cells", "pair_cells")?,
            scan_cells: scan(["cell_scan", "counts", "starts"])?,
            scatter: make.kernel("scatter", "ch06_pair_sort", "pair_scatter")?,
            sort: make.kernel("sort", "ch06_pair_sort", "pair_sort")?,
            find: lists(make.kernel("find", "ch06_pair_find", "pair_find")?)?,
            scan_pairs: scan(["pair_scan", "pair_counts", "pair_starts"])?,
            plan: make.kernel("plan", "ch06_pair_list", "pair_plan")?,
            list: lists(make.kernel("list", "ch06_pair_list", "pair_list")?)?,
            meet: make.meet()?,
            large: some(!plan.larges.is_empty(), || {
                make.kernel("large", "ch06_pair_large", "pair_large")
            })?,
            start: lists(make.kernel("start", "ch06_pair_start", "pair_start")?)?,
            loops: some(plan.joints.loops > 0, || make.loops())?,
            solve: make.solve(false)?,
            solve_last: make.solve(true)?,
            advance: some(plan.loose, || make.advance("advance", "pair_advance"))?,
            trees: some(plan.joints.any, || make.advance("trees", "pair_trees"))?,
            restore: some(plan.bounces, || make.restore())?,
            kick: some(plan.poles > 0, || {
                make.kernel("kick", "ch06_pair_kick", "pair_kick")
            })?,
            state: make.kernel("state", "ch06_pair_state", "pair_state")?,
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

/// Compiles kernels for a plan.
struct Making<'a> {
    gpu: &'a Gpu,
    plan: &'a Plan,
}

impl Making<'_> {
    /// An entry point of a shader.
    fn kernel(&self, name: &'static str, file: &str, entry: &str) -> Result<Kernel, StreamError> {
        self.in_substep(name, file, entry, false)
    }

    /// The same for the last substep, or for those before it.
    fn in_substep(
        &self,
        name: &'static str,
        file: &str,
        entry: &str,
        last: bool,
    ) -> Result<Kernel, StreamError> {
        compiled(
            self.gpu,
            name,
            &source(file)?,
            entry,
            &constants(self.plan, last),
        )
    }

    /// The narrow phase of each kind of pair.
    fn meet(&self) -> Result<Vec<Sided>, StreamError> {
        let text = source("ch06_pair_meet")?;
        let of_kind = |(slot, &kind): (usize, &u32)| {
            let mut all = constants(self.plan, false);
            all.extend([("PAIR_KIND", f64::from(kind)), ("SLOT", slot as f64)]);
            let text = with_spots(&text, MOST_SPOTS[kind as usize]);
            let kernel = compiled(self.gpu, "meet", &text, "pair_meet", &all)?;
            Sided::of(&kernel, name_meet)
        };
        self.plan.kinds.iter().enumerate().map(of_kind).collect()
    }

    fn solve(&self, last: bool) -> Result<Sided, StreamError> {
        let solve = self.in_substep("solve", "ch06_pair_solve", "pair_solve", last)?;
        Sided::of(&solve, name_solve)
    }

    /// Joints that close loops.
    fn loops(&self) -> Result<Kernel, StreamError> {
        let loops = self.kernel("loops", "ch06_loops", "solve_loops")?;
        loops.renamed(&[("loop_presses", "presses")])
    }

    /// What moves bodies, in a substep and in the last.
    fn advance(&self, name: &'static str, entry: &str) -> Result<[Kernel; 2], StreamError> {
        let make = |last| self.in_substep(name, "ch06_pair_advance", entry, last);
        Ok([make(false)?, make(true)?])
    }

    /// Restitution, at the end of a step: by pair, and by body.
    fn restore(&self) -> Result<(Sided, Kernel), StreamError> {
        let restore = self.in_substep("restore", "ch06_pair_solve", "pair_restore", true)?;
        let rebound = self.in_substep("rebound", "ch06_pair_advance", "pair_rebound", true)?;
        Ok((Sided::of(&restore, name_solve)?, rebound))
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
