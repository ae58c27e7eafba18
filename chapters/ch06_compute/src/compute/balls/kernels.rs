//! The kernels of a step of balls, each compiled once and bound to the columns between which the state
//! goes back and forth.

use std::collections::VecDeque;

use super::super::scan::Scanning;
use super::sides::{
    Names, Naming, Sides, name_bounce, name_cells, name_meet, name_solve, name_sort, name_state,
};
use crate::stream::{Gpu, Kernel, Passes, StreamError, source};

/// Invocations of a workgroup of the kernels that have teams. On an H200 128 and 256 are no faster.
const GROUP: f64 = 64.0;

/// A kernel bound in all ways in which sides can stand.
#[derive(Debug)]
struct Bound(Vec<Kernel>);

impl Bound {
    fn at(&self, sides: Sides) -> &Kernel {
        &self.0[sides.number()]
    }
}

/// All kernels of a step.
#[derive(Debug)]
pub struct BallKernels {
    cells: Bound,
    scan: Scanning,
    scatter: Kernel,
    sort: Bound,
    meet: Bound,
    solve: Bound,
    solve_last: Bound,
    bounce: Option<Bound>,
    state: Bound,
    pull: Bound,
    /// Invocations that solve a ball together.
    team: usize,
    sides: Sides,
    /// Of the steps that may still turn out to have had no room: their length, s, and how the sides stood
    /// after the rows were sorted.
    waiting: VecDeque<(f32, Sides)>,
}

/// How much a step has to do.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sizes {
    /// How many balls there are.
    pub rows: usize,
    /// How many starts of slots.
    pub starts: usize,
    /// Parts of a step.
    pub substeps: u32,
    /// Length of the step, s.
    pub dt: f32,
    /// Whether rows are written for drawing.
    pub draws: bool,
    /// Whether the mouse pulls.
    pub pulls: bool,
}

impl BallKernels {
    /// Compiles them for a plan: whether all surfaces are alike, and whether any bounces.
    ///
    /// # Errors
    /// [`StreamError::Kernel`].
    pub fn of(gpu: &Gpu, rows: usize, alike: bool, bounces: bool) -> Result<Self, StreamError> {
        let team = team_for(gpu, rows);
        let sums = if team > 1 { GROUP } else { 1.0 };
        let plan = |last: bool| {
            let flag = |on: bool| f64::from(u8::from(on));
            [
                ("ALIKE", flag(alike)),
                ("BOUNCES", flag(bounces)),
                ("LAST", flag(last)),
                ("TEAM", team as f64),
                ("SUMS", sums),
            ]
        };
        Ok(Self {
            cells: bound(gpu, "cells", "ch06_cells", "cells", &[], name_cells)?,
            scan: Scanning::of(gpu, ["scan", "counts", "starts"])?,
            scatter: plain(gpu, "scatter", "ch06_scatter", "scatter")?,
            sort: bound(gpu, "sort", "ch06_sort", "sort", &[], name_sort)?,
            meet: bound(
                gpu,
                "meet",
                "ch06_neighbours",
                "meet",
                &[("TEAM", team as f64), ("SUMS", sums)],
                name_meet,
            )?,
            solve: bound(
                gpu,
                "solve",
                "ch06_balls",
                "solve",
                &plan(false),
                name_solve,
            )?,
            solve_last: bound(gpu, "solve", "ch06_balls", "solve", &plan(true), name_solve)?,
            bounce: if bounces {
                Some(bound(
                    gpu,
                    "bounce",
                    "ch06_bounce",
                    "bounce",
                    &[],
                    name_bounce,
                )?)
            } else {
                None
            },
            state: bound(gpu, "state", "ch06_state", "state", &[], name_state)?,
            pull: bound(gpu, "pull", "ch06_pull", "pull", &[], name_state)?,
            team,
            sides: Sides::default(),
            waiting: VecDeque::new(),
        })
    }

    /// The columns that hold the state now.
    #[must_use]
    pub fn current(&self) -> Names {
        self.sides.names()
    }

    // ANCHOR: step
    /// The passes of a step.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(&mut self, passes: &mut Passes<'_>, sizes: &Sizes) -> Result<(), StreamError> {
        self.sort(passes, sizes)?;
        self.waiting.push_back((sizes.dt, self.sides));
        self.rest(passes, sizes)
    }

    /// Its first half: rows move into grid order.
    fn sort(&mut self, passes: &mut Passes<'_>, sizes: &Sizes) -> Result<(), StreamError> {
        let (rows, starts) = (sizes.rows, sizes.starts);
        passes.section("grid");
        passes.run(self.cells.at(self.sides), rows)?;
        self.scan.run(passes, starts)?;
        passes.run(&self.scatter, rows)?;
        passes.section("sort");
        passes.run(self.sort.at(self.sides), rows)?;
        self.sides.step ^= 1;
        self.sides.flip();
        Ok(())
    }

    /// Its second half: neighbours, substeps, restitution. It is made again if neighbours had no room.
    fn rest(&mut self, passes: &mut Passes<'_>, sizes: &Sizes) -> Result<(), StreamError> {
        let rows = sizes.rows;
        passes.section("neighbours");
        if sizes.pulls {
            passes.run(self.pull.at(self.sides), rows)?;
        }
        passes.run(self.meet.at(self.sides), rows * self.team)?;
        self.sides.flip();
        passes.section("substeps");
        for substep in 1..=sizes.substeps {
            let last = substep == sizes.substeps;
            let solve = if last { &self.solve_last } else { &self.solve };
            passes.run(solve.at(self.sides), rows * self.team)?;
            self.sides.flip();
        }
        passes.section("restitution");
        if let Some(bounce) = &self.bounce {
            passes.run(bounce.at(self.sides), rows)?;
            self.sides.movers ^= 1;
        }
        if sizes.draws {
            passes.section("state");
            passes.run(self.state.at(self.sides), rows)?;
        }
        Ok(())
    }
    // ANCHOR_END: step

    /// Invocations that solve a ball together.
    #[must_use]
    pub fn team(&self) -> usize {
        self.team
    }

    /// The passes of a step by name, each once.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        let mut names = vec![
            "cells",
            "scan",
            "scatter",
            "sort",
            "meet",
            "solve (each substep)",
        ];
        names.extend(self.bounce.as_ref().map(|_| "bounce"));
        names
    }

    /// Steps that may still turn out to have had no room.
    #[must_use]
    pub fn waiting(&self) -> usize {
        self.waiting.len()
    }

    /// All but the last so many steps were made.
    pub fn made_but(&mut self, missing: usize) {
        let made = self.waiting.len().saturating_sub(missing);
        self.waiting.drain(..made);
    }

    /// The steps that weren't made, to be made again.
    pub fn take_waiting(&mut self) -> VecDeque<(f32, Sides)> {
        std::mem::take(&mut self.waiting)
    }

    // ANCHOR: again
    /// Makes the first step again that wasn't made, since neighbours had no room: its rows are sorted
    /// already, and nothing else has been written.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn again(
        &mut self,
        passes: &mut Passes<'_>,
        sizes: &Sizes,
        sides: Sides,
    ) -> Result<(), StreamError> {
        self.sides = sides;
        self.waiting.push_back((sizes.dt, sides));
        self.rest(passes, sizes)
    }
    // ANCHOR_END: again

    /// Writes rows for drawing without a step.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn draw(&self, passes: &mut Passes<'_>, rows: usize) -> Result<(), StreamError> {
        passes.run(self.state.at(self.sides), rows)
    }
}

/// How many invocations solve a ball together. Where there are few balls most of a device has nothing to do,
/// and what counts is how long a ball takes; where there are many, each has enough with one.
fn team_for(gpu: &Gpu, rows: usize) -> usize {
    match rows {
        _ if gpu.is_software => 1,
        0..16_000 => 8,
        16_000..60_000 => 4,
        _ => 1,
    }
}

fn plain(gpu: &Gpu, name: &'static str, file: &str, entry: &str) -> Result<Kernel, StreamError> {
    Kernel::new(gpu, name, &source(file)?, entry, &[])
}

fn bound(
    gpu: &Gpu,
    name: &'static str,
    file: &str,
    entry: &str,
    plan: &[(&str, f64)],
    naming: impl Fn(Sides) -> Naming,
) -> Result<Bound, StreamError> {
    let kernel = Kernel::new(gpu, name, &source(file)?, entry, plan)?;
    let all = Sides::all().map(|sides| kernel.renamed(&naming(sides)));
    Ok(Bound(all.collect::<Result<_, _>>()?))
}
