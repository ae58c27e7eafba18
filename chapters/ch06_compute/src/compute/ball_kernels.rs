//! The kernels of a step of balls, each compiled once and bound to the columns between which the state
//! goes back and forth.

use crate::stream::{Gpu, Kernel, Passes, StreamError, source};

/// Counts in a block of the scan: `ch06_scan.wgsl` has it too.
pub const PER_BLOCK: usize = 2048;

/// Which of two columns holds what is true now.
#[derive(Clone, Copy, Debug, Default)]
struct Sides {
    places: usize,
    movers: usize,
    /// Attitudes, what stays with a ball, and the lists of neighbours: they change once a step.
    step: usize,
}

/// The names of the columns that hold the state now.
#[derive(Clone, Copy, Debug)]
pub struct Names {
    /// Where balls are.
    pub places: &'static str,
    /// How they move.
    pub movers: &'static str,
    /// How they are turned.
    pub attitudes: &'static str,
    /// What stays with them.
    pub balls: &'static str,
}

const PLACES: [&str; 2] = ["places_a", "places_b"];
const MOVERS: [&str; 2] = ["movers_a", "movers_b"];
const ATTITUDES: [&str; 2] = ["attitudes_a", "attitudes_b"];
const BALLS: [&str; 2] = ["balls_a", "balls_b"];
const COUNTS: [&str; 2] = ["neighbour_counts_a", "neighbour_counts_b"];
const NEIGHBOURS: [&str; 2] = ["neighbours_a", "neighbours_b"];
const IMPULSES: [&str; 2] = ["impulses_a", "impulses_b"];

/// A kernel bound in all ways in which sides can stand.
#[derive(Debug)]
struct Bound(Vec<Kernel>);

impl Bound {
    fn at(&self, sides: Sides) -> &Kernel {
        &self.0[4 * sides.places + 2 * sides.movers + sides.step]
    }
}

/// All kernels of a step.
#[derive(Debug)]
pub struct BallKernels {
    cells: Bound,
    scan: [Kernel; 3],
    scatter: Kernel,
    sort: Bound,
    meet: Bound,
    halt: Kernel,
    solve: Bound,
    solve_last: Bound,
    bounce: Option<Bound>,
    sides: Sides,
}

/// The columns that a kernel binds, given how the sides stand.
type Naming = fn(Sides) -> Vec<(&'static str, &'static str)>;

impl BallKernels {
    /// Compiles them for a plan: whether all surfaces are alike, and whether any bounces.
    ///
    /// # Errors
    /// [`StreamError::Kernel`].
    pub fn of(gpu: &Gpu, alike: bool, bounces: bool) -> Result<Self, StreamError> {
        let plan = |last: bool| {
            let flag = |on: bool| f64::from(u8::from(on));
            [
                ("ALIKE", flag(alike)),
                ("BOUNCES", flag(bounces)),
                ("LAST", flag(last)),
            ]
        };
        let scan = |entry| plain(gpu, "scan", "ch06_scan", entry);
        Ok(Self {
            cells: bound(gpu, "cells", "ch06_cells", "cells", &[], name_cells)?,
            scan: [scan("scan_blocks")?, scan("scan_sums")?, scan("scan_add")?],
            scatter: plain(gpu, "scatter", "ch06_scatter", "scatter")?,
            sort: bound(gpu, "sort", "ch06_sort", "sort", &[], name_sort)?,
            meet: bound(gpu, "meet", "ch06_neighbours", "meet", &[], name_meet)?,
            halt: plain(gpu, "halt", "ch06_neighbours", "halt")?,
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
            sides: Sides::default(),
        })
    }

    /// The columns that hold the state now.
    #[must_use]
    pub fn current(&self) -> Names {
        let Sides {
            places,
            movers,
            step,
        } = self.sides;
        Names {
            places: PLACES[places],
            movers: MOVERS[movers],
            attitudes: ATTITUDES[step],
            balls: BALLS[step],
        }
    }

    // ANCHOR: step
    /// The passes of a step.
    ///
    /// # Errors
    /// What the device can lack.
    pub fn step(
        &mut self,
        passes: &mut Passes<'_>,
        rows: usize,
        starts: usize,
        substeps: u32,
    ) -> Result<(), StreamError> {
        passes.section("grid");
        passes.run(self.cells.at(self.sides), rows)?;
        passes.run_workgroups(&self.scan[0], starts.div_ceil(PER_BLOCK))?;
        passes.run_workgroups(&self.scan[1], 1)?;
        passes.run(&self.scan[2], starts)?;
        passes.run(&self.scatter, rows)?;
        passes.section("sort");
        passes.run(self.sort.at(self.sides), rows)?;
        self.sides.step ^= 1;
        self.flip();
        passes.section("neighbours");
        passes.run(self.meet.at(self.sides), rows)?;
        passes.run_workgroups(&self.halt, 1)?;
        self.flip();
        passes.section("substeps");
        for substep in 1..=substeps {
            let last = substep == substeps;
            let solve = if last { &self.solve_last } else { &self.solve };
            passes.run(solve.at(self.sides), rows)?;
            self.flip();
        }
        passes.section("restitution");
        if let Some(bounce) = &self.bounce {
            passes.run(bounce.at(self.sides), rows)?;
            self.sides.movers ^= 1;
        }
        Ok(())
    }
    // ANCHOR_END: step

    /// What was next is now.
    fn flip(&mut self) {
        self.sides.places ^= 1;
        self.sides.movers ^= 1;
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
    naming: Naming,
) -> Result<Bound, StreamError> {
    let kernel = Kernel::new(gpu, name, &source(file)?, entry, plan)?;
    let all = (0..8).map(|way| {
        let sides = Sides {
            places: way >> 2 & 1,
            movers: way >> 1 & 1,
            step: way & 1,
        };
        kernel.renamed(&naming(sides))
    });
    Ok(Bound(all.collect::<Result<_, _>>()?))
}

fn name_cells(s: Sides) -> Vec<(&'static str, &'static str)> {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
    ]
}

fn name_sort(s: Sides) -> Vec<(&'static str, &'static str)> {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("attitudes", ATTITUDES[s.step]),
        ("balls", BALLS[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
        ("attitudes_next", ATTITUDES[s.step ^ 1]),
        ("balls_next", BALLS[s.step ^ 1]),
    ]
}

fn name_meet(s: Sides) -> Vec<(&'static str, &'static str)> {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("last_counts", COUNTS[s.step ^ 1]),
        ("last_neighbours", NEIGHBOURS[s.step ^ 1]),
        ("last_impulses", IMPULSES[s.step ^ 1]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("impulses", IMPULSES[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
    ]
}

fn name_solve(s: Sides) -> Vec<(&'static str, &'static str)> {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("impulses", IMPULSES[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
        ("attitudes", ATTITUDES[s.step]),
    ]
}

fn name_bounce(s: Sides) -> Vec<(&'static str, &'static str)> {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("movers_next", MOVERS[s.movers ^ 1]),
    ]
}
