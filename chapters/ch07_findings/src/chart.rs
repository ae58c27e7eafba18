//! A chart as data: what was measured, before anyone draws it. `draw` turns it into SVG and
//! CSV, tests look at the numbers.

/// A picture of one kind or the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Picture {
    /// Curves over a pair of axes.
    Curves(Chart),
    /// Bars along one axis.
    Bars(Bars),
    /// Maps side by side over the same axes.
    Maps(Maps),
    /// Rows of marks along one axis.
    Dots(Dots),
}

/// A chart: curves over a common pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// File name without ending, and what `chart NAME` says.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// The curves.
    pub series: Vec<Series>,
}

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// How it is divided.
    pub scale: Scale,
    /// What a number that is not finite means: stands beside the band for those.
    pub lost: &'static str,
    /// Numbers that it has room for in any case, as where two charts have the same axis.
    pub reaches: Vec<f64>,
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By powers of ten. A value of 0 or less is drawn on a labelled band below the axis.
    Log,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// As the legend calls it; empty for a curve that another one's name includes.
    pub name: String,
    /// How it is drawn.
    pub style: Style,
    /// x and y. A y that is not finite is a failure and is drawn on a labelled band at the edge.
    pub points: Vec<(f64, f64)>,
    /// The ends of each point's error bar; empty where there are none.
    pub bars: Vec<(f64, f64)>,
    /// What stands beside each point; empty where nothing does.
    pub notes: Vec<String>,
    /// Points with a ring about their marks, by number.
    pub ringed: Vec<usize>,
}

/// What a curve is, which decides how it is drawn; the same on all charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// The report's formula as printed.
    Printed,
    /// The formula with its erratum mended.
    Corrected,
    /// What theory predicts: a thin line without marks.
    Theory,
    /// Something between: by number.
    Other(usize),
    /// The same in dashes.
    Dashed(usize),
    /// Marks alone, without a line, as of [`Style::Other`] of this number.
    Marks(usize),
    /// What others have published: stars without a line. Each has its name beside it and none in the legend.
    Published,
}

/// A chart of bars: groups of them, one under the other, along a common axis that is evenly divided.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    /// File name without ending, and what `chart NAME` says.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: String,
    /// Quantity and unit of the lengths.
    pub label: String,
    /// Whether lengths are powers of ten, as which the axis tells them.
    pub powers: bool,
    /// What a bar is made of, from 0 outwards. The legend names them, unless it is one.
    pub parts: Vec<&'static str>,
    /// The groups.
    pub groups: Vec<Group>,
}

/// Bars that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Stands above them.
    pub name: String,
    /// The bars.
    pub bars: Vec<Bar>,
}

/// One bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Stands before it.
    pub name: String,
    /// A length a part.
    pub lengths: Vec<f64>,
    /// The ends of its error bar, if it has one.
    pub spread: Option<(f64, f64)>,
    /// Stands after it.
    pub note: String,
}

/// Rows of marks along a common axis: a row a case, a mark a kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    /// File name without ending, and what `chart NAME` says.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: String,
    /// The axis.
    pub x: Axis,
    /// What the marks are, in the order of the legend.
    pub kinds: Vec<(String, Style)>,
    /// The rows.
    pub rows: Vec<DotRow>,
}

/// A row of [`Dots`].
#[derive(Clone, Debug, PartialEq)]
pub struct DotRow {
    /// Stands above it.
    pub name: String,
    /// Stands above its right end.
    pub note: String,
    /// Kinds by number, and where their marks stand.
    pub marks: Vec<(usize, f64)>,
}

/// Small maps side by side, a panel a method, all over the same pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Maps {
    /// File name without ending, and what `chart NAME` says.
    pub name: &'static str,
    /// What it shows, in one line.
    pub title: String,
    /// Horizontal axis of every panel.
    pub x: Axis,
    /// Vertical axis of every panel.
    pub y: Axis,
    /// What the classes mean, in their order.
    pub classes: Vec<String>,
    /// What the curves of theory are, the last entry of the legend.
    pub theory: String,
    /// The panels, a row of three after the other.
    pub panels: Vec<Panel>,
}

/// A panel of [`Maps`].
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Stands above it.
    pub name: String,
    /// Places and what became of them. They need not be all of a grid.
    pub cells: Vec<(f64, f64, Class)>,
    /// Curves over the cells. Their names are not shown.
    pub curves: Vec<Series>,
}

/// What became of a cell, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// As it should be.
    Held,
    /// Not as it should be.
    Worse,
    /// Lost.
    Failed,
}

impl Picture {
    /// File name without ending.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Picture::Curves(chart) => chart.name,
            Picture::Bars(bars) => bars.name,
            Picture::Maps(maps) => maps.name,
            Picture::Dots(dots) => dots.name,
        }
    }
}

impl From<Chart> for Picture {
    fn from(chart: Chart) -> Self {
        Picture::Curves(chart)
    }
}

impl From<Bars> for Picture {
    fn from(bars: Bars) -> Self {
        Picture::Bars(bars)
    }
}

impl From<Dots> for Picture {
    fn from(dots: Dots) -> Self {
        Picture::Dots(dots)
    }
}

impl From<Maps> for Picture {
    fn from(maps: Maps) -> Self {
        Picture::Maps(maps)
    }
}

impl Axis {
    /// An evenly divided axis.
    #[must_use]
    pub fn linear(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            scale: Scale::Linear,
            lost: "lost",
            reaches: Vec::new(),
        }
    }

    /// An axis by powers of ten.
    #[must_use]
    pub fn log(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            scale: Scale::Log,
            lost: "lost",
            reaches: Vec::new(),
        }
    }

    /// The same where what is not finite has another name than `lost`.
    #[must_use]
    pub fn lost(self, lost: &'static str) -> Self {
        Self { lost, ..self }
    }

    /// The same with room for these numbers.
    #[must_use]
    pub fn reaching(self, numbers: impl IntoIterator<Item = f64>) -> Self {
        let finite = numbers.into_iter().filter(|number| number.is_finite());
        let reaches = finite.collect();
        Self { reaches, ..self }
    }
}

impl Series {
    /// A curve through points.
    pub fn new(name: &str, style: Style, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self {
            name: name.to_owned(),
            style,
            points: points.into_iter().collect(),
            bars: Vec::new(),
            notes: Vec::new(),
            ringed: Vec::new(),
        }
    }

    /// A curve of `y(x)` at these places.
    pub fn of(name: &str, style: Style, places: &[f64], y: impl Fn(f64) -> f64) -> Self {
        Self::new(name, style, places.iter().map(|&x| (x, y(x))))
    }

    /// The same with an error bar at each point.
    #[must_use]
    pub fn with_bars(self, bars: Vec<(f64, f64)>) -> Self {
        Self { bars, ..self }
    }

    /// The same with a note beside each point.
    #[must_use]
    pub fn with_notes(self, notes: Vec<String>) -> Self {
        Self { notes, ..self }
    }

    /// The same with a ring about some of its marks.
    #[must_use]
    pub fn with_rings(self, ringed: Vec<usize>) -> Self {
        Self { ringed, ..self }
    }
}
