//! Maps in small panels, three in a row: coloured cells, and the line that theory draws among them. All panels
//! have the same axes; numbers stand at the left and under the lowest only.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn, Lettering, Point};
use super::frame::{grid, thinned};
use super::legend::Legend;
use super::scale::{Place, Scale, Tick};
use super::text::{self, BOLD, GREY, LABEL, NUMBER, TITLE};
use super::{MARGIN, WIDTH, draw_head, file, marks};
use crate::chart::{Class, Maps, Panel, Style};
use crate::error::FindingsError;

/// Panels in a row.
const ACROSS: usize = 3;
/// Between two panels, pixels.
const BETWEEN: f64 = 14.0;
/// What a panel's name takes, pixels.
const HEADING: f64 = 22.0;
/// Height of a line of text at an axis, and between a number and its axis, pixels.
const LINE: f64 = 18.0;
const GAP: f64 = 7.0;

/// The maps as an SVG file.
pub fn svg(maps: &Maps) -> Result<String, FindingsError> {
    let plot = Plot::new(maps);
    file((maps.name, &maps.title), plot.height(), |canvas| {
        plot.draw(canvas)
    })
}

/// Panels, placed on the page.
struct Plot<'a> {
    maps: &'a Maps,
    title: Vec<String>,
    legend: Legend,
    x: Scale,
    y: Scale,
    x_ticks: Vec<Tick>,
    y_ticks: Vec<Tick>,
    left: f64,
    top: f64,
    /// Width and height of a panel.
    side: f64,
}

impl<'a> Plot<'a> {
    fn new(maps: &'a Maps) -> Self {
        let room = WIDTH - 2.0 * MARGIN;
        let title = text::wrapped(&maps.title, BOLD * TITLE, room);
        let legend = Legend::of_maps(&maps.classes, &maps.theory, room);
        let x = Scale::of(&maps.x, spanned(maps, |&(x, _)| x));
        let y = Scale::of(&maps.y, spanned(maps, |&(_, y)| y));
        let y_ticks = y.ticks(6);
        let widths = y_ticks.iter().map(|tick| text::width(&tick.label, NUMBER));
        let left = MARGIN + LINE + widths.fold(0.0, f64::max) + GAP;
        let gaps = BETWEEN * (ACROSS - 1) as f64;
        let side = (WIDTH - MARGIN - left - gaps) / ACROSS as f64;
        Self {
            maps,
            top: MARGIN + 1.35 * TITLE * title.len() as f64 + legend.height(),
            title,
            legend,
            x_ticks: within(thinned(x.ticks(5), side), side),
            x,
            y,
            y_ticks,
            left,
            side,
        }
    }

    fn rows(&self) -> usize {
        self.maps.panels.len().div_ceil(ACROSS)
    }

    fn height(&self) -> f64 {
        self.top + self.rows() as f64 * (HEADING + self.side) + 2.0 * LINE + MARGIN
    }

    /// Upper left corner of a panel's plot.
    fn corner(&self, panel: usize) -> Point {
        let (row, column) = ((panel / ACROSS) as f64, (panel % ACROSS) as f64);
        let x = self.left + column * (self.side + BETWEEN);
        (x, self.top + row * (HEADING + self.side) + HEADING)
    }

    fn draw(&self, canvas: &mut Canvas) -> Drawn {
        draw_head(canvas, &self.title, Some(&self.legend))?;
        for (number, panel) in self.maps.panels.iter().enumerate() {
            self.draw_panel(canvas, number, panel)?;
        }
        self.draw_labels(canvas)
    }

    fn draw_labels(&self, canvas: &mut Canvas) -> Drawn {
        let right = self.left + self.side * ACROSS as f64 + BETWEEN * (ACROSS - 1) as f64;
        let below = self.top + self.rows() as f64 * (HEADING + self.side);
        let middle = 0.5 * (self.left + right);
        let y = below + 1.5 * LINE + 2.0;
        canvas.text(&self.maps.x.label, middle, y, &text::label(HPos::Center))?;
        let upwards = Lettering {
            upwards: true,
            ..text::label(HPos::Center)
        };
        let middle = 0.5 * (self.top + below);
        canvas.text(&self.maps.y.label, MARGIN + 0.4 * LINE, middle, &upwards)
    }

    fn draw_panel(&self, canvas: &mut Canvas, number: usize, panel: &Panel) -> Drawn {
        let (left, top) = self.corner(number);
        let heading = Lettering {
            bold: true,
            ..text::label(HPos::Left)
        };
        let room = self.side / BOLD;
        let size = if text::width(&panel.name, LABEL) > room {
            text::number(HPos::Left)
        } else {
            heading
        };
        canvas.text(&panel.name, left, top - 0.45 * HEADING, &size)?;
        for (from, to, class) in runs(&panel.cells) {
            let columns = edges(&self.x, panel.cells.iter().map(|cell| cell.0), from.0);
            let low = edges(&self.y, panel.cells.iter().map(|cell| cell.1), from.1);
            let high = edges(&self.y, panel.cells.iter().map(|cell| cell.1), to);
            let x = |at: f64| left + at * self.side;
            let y = |at: f64| top + (1.0 - at) * self.side;
            let corners = ([x(columns[0]), y(high[1])], [x(columns[1]), y(low[0])]);
            marks::cell(canvas, class, corners.0, corners.1)?;
        }
        self.draw_grid(canvas, number)?;
        for curve in &panel.curves {
            let inside = |part: &Vec<Point>| part.len() > 1;
            let place = |&(x, y): &Point| self.place((left, top), x, y);
            let points: Vec<Option<Point>> = curve.points.iter().map(place).collect();
            if curve.style == Style::Theory {
                let parts = points.split(Option::is_none);
                let parts = parts.map(|part| part.iter().flatten().copied().collect());
                for part in parts.filter(inside) {
                    marks::law(canvas, &part)?;
                }
            } else {
                for point in points.into_iter().flatten() {
                    marks::mark(canvas, curve.style, point)?;
                }
            }
        }
        Ok(())
    }

    /// Lines across, and numbers where the panel is at the edge.
    fn draw_grid(&self, canvas: &mut Canvas, number: usize) -> Drawn {
        let (left, top) = self.corner(number);
        let (right, bottom) = (left + self.side, top + self.side);
        let is_lowest = number + ACROSS >= self.maps.panels.len();
        for tick in &self.x_ticks {
            let x = left + tick.at * self.side;
            canvas.line(&[(x, top), (x, bottom)], grid(tick), 1.0)?;
            if is_lowest {
                let y = bottom + 0.5 * LINE + 1.0;
                canvas.text(&tick.label, x, y, &text::number(HPos::Center))?;
            }
        }
        for tick in &self.y_ticks {
            let y = bottom - tick.at * self.side;
            canvas.line(&[(left, y), (right, y)], grid(tick), 1.0)?;
            if number.is_multiple_of(ACROSS) {
                canvas.text(&tick.label, left - GAP, y, &text::number(HPos::Right))?;
            }
        }
        canvas.line(&[(left, top), (left, bottom), (right, bottom)], GREY, 1.2)
    }

    /// Where a point falls in the panel with this corner; None outside of it.
    fn place(&self, (left, top): Point, x: f64, y: f64) -> Option<Point> {
        let (Place::On(x), Place::On(y)) = (self.x.place(x), self.y.place(y)) else {
            return None;
        };
        let inside = [x, y].iter().all(|at| (0.0..=1.0).contains(at));
        inside.then_some((left + x * self.side, top + (1.0 - y) * self.side))
    }
}

/// Takes back labels that would reach into the next panel.
fn within(mut ticks: Vec<Tick>, side: f64) -> Vec<Tick> {
    for tick in &mut ticks {
        let half = 0.5 * text::width(&tick.label, NUMBER);
        if half - 0.5 * BETWEEN > side * tick.at.min(1.0 - tick.at) {
            tick.label.clear();
        }
    }
    ticks
}

/// What the axes must hold: the cells; where there are none, the curves.
fn spanned<'a>(maps: &'a Maps, of: impl Fn(&Point) -> f64 + 'a) -> impl Iterator<Item = f64> + 'a {
    let panels = || maps.panels.iter();
    let cells = panels().flat_map(|panel| panel.cells.iter().map(|&(x, y, _)| (x, y)));
    let has_cells = panels().any(|panel| !panel.cells.is_empty());
    let curves = panels().flat_map(|panel| &panel.curves);
    let points = curves.flat_map(|curve| curve.points.iter().copied());
    let points = points.filter(move |_| !has_cells);
    cells.chain(points).map(move |point| of(&point))
}

/// Where the cell at `here` ends on both sides, 0 to 1: half way to its neighbours.
fn edges(scale: &Scale, all: impl Iterator<Item = f64>, here: f64) -> [f64; 2] {
    let on = |number: f64| match scale.place(number) {
        Place::On(at) => Some(at),
        _ => None,
    };
    let Some(here) = on(here) else {
        return [0.0, 0.0];
    };
    let (mut before, mut after) = (f64::NEG_INFINITY, f64::INFINITY);
    for at in all.filter_map(on) {
        if at < here - 1e-9 {
            before = before.max(at);
        } else if at > here + 1e-9 {
            after = after.min(at);
        }
    }
    let (low, high) = (0.5 * (before + here), 0.5 * (here + after));
    // The outermost are as wide on both sides, as far as there is room.
    match (low.is_finite(), high.is_finite()) {
        (true, true) => [low, high],
        (true, false) => [low, (2.0 * here - low).min(1.0)],
        (false, true) => [(2.0 * here - high).max(0.0), high],
        (false, false) => [0.0, 1.0],
    }
}

/// Cells of a class one above the other are one: its lowest place, its highest y, its class.
fn runs(cells: &[(f64, f64, Class)]) -> Vec<(Point, f64, Class)> {
    let mut sorted = cells.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut runs: Vec<(Point, f64, Class)> = Vec::new();
    for (x, y, class) in sorted {
        match runs.last_mut() {
            Some((from, to, last)) if from.0 == x && *last == class => *to = y,
            _ => runs.push(((x, y), y, class)),
        }
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::{Axis, Series};

    #[test]
    fn cells_of_a_class_in_a_column_are_one_and_others_are_not() {
        use Class::{Failed, Held};
        let cells = [
            (1.0, 2.0, Held),
            (1.0, 1.0, Held),
            (1.0, 3.0, Failed),
            (2.0, 1.0, Failed),
        ];
        let found = runs(&cells);
        assert_eq!(
            found,
            [
                ((1.0, 1.0), 2.0, Held),
                ((1.0, 3.0), 3.0, Failed),
                ((2.0, 1.0), 1.0, Failed),
            ]
        );
    }

    #[test]
    fn a_cell_ends_half_way_to_its_neighbours() {
        let scale = Scale::of(&Axis::linear("x"), [0.0, 1.0, 3.0].into_iter());
        let at = |number| match scale.place(number) {
            Place::On(at) => at,
            _ => f64::NAN,
        };
        let [low, high] = edges(&scale, [0.0, 1.0, 3.0].into_iter(), 1.0);
        assert!((low - at(0.5)).abs() < 1e-12 && (high - at(2.0)).abs() < 1e-12);
    }

    #[test]
    fn every_panel_has_its_name_and_theory_lies_over_the_cells() {
        let panel = |name: &str| Panel {
            name: name.to_owned(),
            cells: vec![(1.0, 1.0, Class::Held), (2.0, 2.0, Class::Failed)],
            curves: vec![Series::new("", Style::Theory, [(1.0, 1.0), (2.0, 2.0)])],
        };
        let maps = Maps {
            name: "any",
            title: "Maps & more".to_owned(),
            x: Axis::linear("v (m/s)"),
            y: Axis::log("rate (1/s)"),
            classes: ["held", "worse", "lost"].map(str::to_owned).to_vec(),
            theory: "P₁".to_owned(),
            panels: vec![panel("own-row"), panel("xpbd")],
        };
        let drawn = svg(&maps).expect("it can be drawn");
        for text in [
            "Maps &amp; more",
            "own-row",
            "xpbd",
            "lost",
            "P₁",
            "v (m/s)",
        ] {
            assert!(drawn.contains(text), "{text:?} isn't in:\n{drawn}");
        }
        // Two cells a panel, and three samples.
        assert_eq!(drawn.matches("<polygon ").count(), 7);
    }
}
