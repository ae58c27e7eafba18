//! What a chart's measurement leaves: the files, and which charts there are.

use std::fs;
use std::path::{Path, PathBuf};

use crate::chart::{Chart, Picture};
use crate::errata::ERRATA;
use crate::laboratory::maps::{self, MAPS, Map};
use crate::laboratory::{self, SCENARIOS, Scenario};
use crate::lanes_kept::{
    beside_rapier, broad_phase as lanes_broad_phase, growth, long_run, rows_and_colours, sleeping,
};
use crate::{
    FindingsError, architecture_method_hardware, balls_on_the_gpu, bounce, broad_phase, chain,
    columns, draw, friction, integrate, lanes_roofline, left_out, limbs, mass_ratio,
    microseconds_per_body, ragdoll_run, report_on_engines, round_trip, stack, substeps_on_the_gpu,
    sweeps, table1, table2, tunnelling,
};

/// Where a measurement tells how far it is.
pub type Say<'a> = &'a mut dyn FnMut(&str);

/// What was measured, ready to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// The pictures, at least one: the first one's name is that of the other files.
    pub charts: Vec<Picture>,
    /// The numbers.
    pub csv: String,
    /// The numbers as the book includes them, in Markdown, but not a page of its own: hence the ending
    /// `txt`. None where the picture says it all.
    pub page: Option<String>,
}

/// A chart that can be asked for.
#[derive(Clone)]
pub struct Known {
    /// As `chart NAME` says it.
    pub name: String,
    /// In a few words.
    pub about: &'static str,
    make: Make,
}

#[derive(Clone, Copy)]
enum Make {
    Measure(Measure),
    Calculate(fn() -> Chart),
    Laboratory,
    Scenario(&'static Scenario),
    Maps,
    Map(&'static Map),
    Bodies,
}

/// A chart's measurement; `true` leaves out what takes long.
type Measure = fn(bool, Say) -> Result<Product, FindingsError>;

/// The charts that take measuring: name, in a few words, how.
const MEASURED: [(&str, &str, Measure); 31] = [
    (
        "table1",
        "the report's Table 1 again: frame rates of bouncing balls",
        table1::product,
    ),
    (
        "table2",
        "the report's Table 2 again: frame rates of stacked ragdolls",
        table2::product,
    ),
    (
        "report_on_engines",
        "both of the report's tables on every engine, beside the report's own frames",
        report_on_engines::product,
    ),
    (
        "bounce",
        "error of a bouncing ball against the step",
        bounce::product,
    ),
    (
        "friction",
        "errors of sliding, rolling and oblique impact against the step",
        friction::product,
    ),
    (
        "sweeps",
        "overlap of a settled pile against the number of sweeps",
        sweeps::product,
    ),
    (
        "broad_phase",
        "time to find pairs by brute force, KD-tree and grid",
        broad_phase::product,
    ),
    (
        "stack",
        "how many boxes stand on each other, against sweeps",
        stack::product,
    ),
    (
        "mass_ratio",
        "a heavy box on a light one, against sweeps",
        mass_ratio::product,
    ),
    (
        "chain",
        "stretch of a chain with a heavy ball, against sweeps, mass and links",
        chain::product,
    ),
    (
        "tunnelling",
        "share of balls that get through a thin wall, against speed",
        tunnelling::product,
    ),
    (
        "limbs",
        "ragdolls at low frame rates: limbs through the floor",
        limbs::product,
    ),
    (
        "ragdoll_run",
        "joints, limits, overlaps and energy of eight ragdolls against time",
        ragdoll_run::product,
    ),
    (
        "columns",
        "time of a step and of its parts: objects, all columns, and those that a scene needs",
        columns::product,
    ),
    (
        "integrate",
        "time to advance a body: objects and columns beside copying memory",
        integrate::product,
    ),
    (
        "left_out",
        "what each part that a plan leaves out would cost",
        left_out::product,
    ),
    (
        "lanes_left_out",
        "what each part that engine `lanes` leaves out would cost",
        left_out::lanes_product,
    ),
    (
        "architecture_method_hardware",
        "time of a step of a pile: what each of the three brings, on this machine's device",
        architecture_method_hardware::product,
    ),
    (
        "round_trip",
        "a round trip to the GPU in every frame, from tables kept in the book",
        round_trip::product,
    ),
    (
        "balls_on_the_gpu",
        "up to a million balls on the GPU and before it, from a table kept in the book",
        balls_on_the_gpu::product,
    ),
    (
        "drift",
        "energy and angular momentum against time, by every method",
        laboratory::drift::product,
    ),
    (
        "gas",
        "a gas: how often its balls collide, and whether their speeds become Maxwell's",
        laboratory::gas::product,
    ),
    (
        "single_precision",
        "where rounding takes over: methods in single and double precision against the rate",
        laboratory::floor::product,
    ),
    (
        "substeps_on_the_gpu",
        "what a substep costs on the GPU and what it buys, from a table kept in the book",
        substeps_on_the_gpu::product,
    ),
    (
        "lanes_broad_phase",
        "time to find who may touch by engine `lanes`, from a table kept in the book",
        lanes_broad_phase::product,
    ),
    (
        "lanes_beside_rapier",
        "lanes and rapier3d: time against depth, from a table kept in the book",
        beside_rapier::product,
    ),
    (
        "rows_and_colours",
        "own rows and colours: depth against work, from a table kept in the book",
        rows_and_colours::product,
    ),
    (
        "sleeping",
        "a pile awake and asleep, from a table kept in the book",
        sleeping::product,
    ),
    (
        "long_run",
        "a million steps, from a table kept in the book",
        long_run::product,
    ),
    (
        "lanes_roofline",
        "what a thread can do, and how near to it lanes come, from a table kept in the book",
        lanes_roofline::product,
    ),
    (
        "lanes_growth",
        "how a step of lanes grows with the bodies, and what a second thread brings, from a table kept in the book",
        growth::product,
    ),
];

/// All charts, in the order in which they are made.
#[must_use]
pub fn known() -> Vec<Known> {
    let measured = MEASURED.iter().map(|&(name, about, make)| Known {
        name: name.to_owned(),
        about,
        make: Make::Measure(make),
    });
    let errata = ERRATA.iter().map(|erratum| Known {
        name: format!("erratum_{:02}", erratum.number),
        about: erratum.title,
        make: Make::Calculate(erratum.chart),
    });
    let all = Known {
        name: "laboratory".to_owned(),
        about: "every scenario by every method: work against precision; goes on with the folder's laboratory.csv",
        make: Make::Laboratory,
    };
    let scenarios = SCENARIOS.iter().map(|scenario| Known {
        name: format!("scenario_{}", scenario.name),
        about: scenario.title,
        make: Make::Scenario(scenario),
    });
    let all_maps = Known {
        name: "failure_maps".to_owned(),
        about: "where methods fail, with theory's line over it; goes on with the folder's failure_maps.csv",
        make: Make::Maps,
    };
    let maps = MAPS.iter().map(|map| Known {
        name: format!("failure_{}", map.name),
        about: map.title,
        make: Make::Map(map),
    });
    let bodies = Known {
        name: "microseconds_per_body".to_owned(),
        about: "time of a step a body against the number of bodies, on every engine, and where they cross",
        make: Make::Bodies,
    };
    measured
        .chain([bodies])
        .chain(errata)
        .chain([all])
        .chain(scenarios)
        .chain([all_maps])
        .chain(maps)
        .collect()
}

impl std::fmt::Debug for Known {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Known").field(&self.name).finish()
    }
}

impl Known {
    /// Measures it; `quick` leaves out what takes long. The laboratory keeps its table in `folder`.
    ///
    /// # Errors
    /// [`FindingsError`] where a scene can't be loaded.
    pub fn make(&self, quick: bool, folder: &Path, say: Say) -> Result<Product, FindingsError> {
        match self.make {
            Make::Laboratory => laboratory::charts::product(quick, folder, say),
            Make::Scenario(scenario) => {
                laboratory::charts::product_of(scenario, quick, folder, say)
            }
            Make::Bodies => microseconds_per_body::product(quick, folder, say),
            Make::Maps => maps::product(quick, folder, say),
            Make::Map(map) => maps::product_of(map, quick, folder, say),
            Make::Measure(measure) => measure(quick, say),
            Make::Calculate(calculate) => Ok(Product::of(calculate())),
        }
    }
}

impl Product {
    /// A chart whose points are all there is to write.
    #[must_use]
    pub fn of(chart: Chart) -> Self {
        Self {
            csv: draw::csv(&chart),
            charts: vec![chart.into()],
            page: None,
        }
    }

    /// Writes the files into a folder; gives their paths.
    ///
    /// # Errors
    /// [`FindingsError::Write`] that names the file, [`FindingsError::Draw`].
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, FindingsError> {
        let mut files = Vec::new();
        for chart in &self.charts {
            files.push((format!("{}.svg", chart.name()), draw::picture(chart)?));
        }
        let name = self.charts.first().map_or("", Picture::name);
        files.push((format!("{name}.csv"), self.csv.clone()));
        files.extend(self.page.clone().map(|page| (format!("{name}.txt"), page)));
        let mut written = Vec::new();
        for (name, text) in files {
            let path = folder.join(name);
            fs::write(&path, text).map_err(|source| FindingsError::Write {
                path: path.clone(),
                source,
            })?;
            written.push(path);
        }
        Ok(written)
    }
}
