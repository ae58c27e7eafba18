//! What a chart's measurement leaves: the files, and which charts there are.

use std::fs;
use std::path::{Path, PathBuf};

use crate::chart::Chart;
use crate::errata::ERRATA;
use crate::{FindingsError, bounce, draw, sweeps, table1};

/// Where a measurement tells how far it is.
pub type Say<'a> = &'a mut dyn FnMut(&str);

/// What was measured, ready to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// The picture.
    pub chart: Chart,
    /// The numbers.
    pub csv: String,
    /// The numbers as the book includes them, in Markdown, but not a page of its own: hence the ending
    /// `txt`. None where the picture says it all.
    pub page: Option<String>,
}

/// A chart that can be asked for.
#[derive(Clone, Debug)]
pub struct Known {
    /// As `chart NAME` says it.
    pub name: String,
    /// In a few words.
    pub about: &'static str,
    make: Make,
}

#[derive(Clone, Copy, Debug)]
enum Make {
    Measure(fn(bool, Say) -> Result<Product, FindingsError>),
    Calculate(fn() -> Chart),
}

/// All charts, in the order in which they are made.
#[must_use]
pub fn known() -> Vec<Known> {
    let measured = [
        Known {
            name: "table1".to_owned(),
            about: "the report's Table 1 again: frame rates of bouncing balls",
            make: Make::Measure(table1::product),
        },
        Known {
            name: "bounce".to_owned(),
            about: "error of a bouncing ball against the step",
            make: Make::Measure(bounce::product),
        },
        Known {
            name: "sweeps".to_owned(),
            about: "overlap of a settled pile against the number of sweeps",
            make: Make::Measure(sweeps::product),
        },
    ];
    let errata = ERRATA.iter().map(|erratum| Known {
        name: format!("erratum_{:02}", erratum.number),
        about: erratum.title,
        make: Make::Calculate(erratum.chart),
    });
    measured.into_iter().chain(errata).collect()
}

impl Known {
    /// Measures it; `quick` leaves out what takes long.
    ///
    /// # Errors
    /// [`FindingsError`] where a scene can't be loaded.
    pub fn make(&self, quick: bool, say: Say) -> Result<Product, FindingsError> {
        match self.make {
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
            chart,
            page: None,
        }
    }

    /// Writes the files into a folder; gives their paths.
    ///
    /// # Errors
    /// [`FindingsError::Write`] that names the file, [`FindingsError::Draw`].
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, FindingsError> {
        let svg = draw::svg(&self.chart)?;
        let files = [
            ("svg", Some(&svg)),
            ("csv", Some(&self.csv)),
            ("txt", self.page.as_ref()),
        ];
        let mut written = Vec::new();
        for (ending, text) in files {
            let Some(text) = text else { continue };
            let path = folder.join(format!("{}.{ending}", self.chart.name));
            fs::write(&path, text).map_err(|source| FindingsError::Write {
                path: path.clone(),
                source,
            })?;
            written.push(path);
        }
        Ok(written)
    }
}
