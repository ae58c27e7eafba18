//! The frame of a chart: its axes with ticks and labels, its bands, and where a point of a
//! curve falls on the page.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn, Lettering, Point};
use super::scale::{Place, Scale, Tick};
use super::text::{self, GREY, LABEL, NUMBER};
use super::{MARGIN, PLOT_HEIGHT, WIDTH};
use crate::chart::Chart;

/// Between a number and its axis, pixels.
const GAP: f64 = 7.0;
/// Height of a line of text at an axis, pixels.
const LINE: f64 = 18.0;
/// Width of the band beside a horizontal axis, pixels.
const SIDE_BAND: f64 = 34.0;
/// What each curve takes of a band's height, and what is left free, pixels.
const LANE: f64 = 10.0;

/// Axes, placed on the page.
pub struct Frame {
    x: Scale,
    y: Scale,
    x_ticks: Vec<Tick>,
    y_ticks: Vec<Tick>,
    /// Lines of the labels.
    x_label: Vec<String>,
    y_label: Vec<String>,
    /// The curves that have points on a band, by number: each has its own height there.
    lanes: Vec<usize>,
    /// The whole plot with its bands.
    outer: Sides,
    /// Where numbers stand, without the bands.
    inner: Sides,
}

/// Edges of a rectangle, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sides {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// Which part of the plot a point is in: points of different parts aren't joined by a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// −1 on the left or lower band, 1 on the right or upper band, 0 between.
    pub across: i8,
    /// The same upwards.
    pub up: i8,
}

impl Frame {
    /// Places the axes of a chart under what ends at `top`.
    pub fn new(chart: &Chart, top: f64) -> Self {
        let points = || chart.series.iter().flat_map(|series| &series.points);
        let x = Scale::of(&chart.x, points().map(|point| point.0));
        let bars = || chart.series.iter().flat_map(|series| &series.bars);
        let heights = points().map(|point| point.1);
        let y = Scale::of(
            &chart.y,
            heights.chain(bars().flat_map(|&(low, high)| [low, high])),
        );
        let y_ticks = y.ticks(7);
        let y_label = text::wrapped(&chart.y.label, LABEL, PLOT_HEIGHT);
        let bands = [y.below, y.beyond].into_iter().flatten();
        let numbers = y_ticks.iter().map(|tick| tick.label.as_str()).chain(bands);
        let widest = numbers
            .map(|label| text::width(label, NUMBER))
            .fold(0.0, f64::max);
        let left = MARGIN + LINE * y_label.len() as f64 + widest + GAP;
        let outer = Sides {
            left,
            right: WIDTH - 2.0 * MARGIN,
            top,
            bottom: top + PLOT_HEIGHT,
        };
        let lanes = lanes(chart, &y);
        let lane = 10.0 + LANE * lanes.len().min(6) as f64;
        let room = |band: Option<_>, room| if band.is_some() { room } else { 0.0 };
        let inner = Sides {
            left: outer.left + room(x.below, SIDE_BAND),
            right: outer.right - room(x.beyond, SIDE_BAND),
            top: outer.top + room(y.beyond, lane),
            bottom: outer.bottom - room(y.below, lane),
        };
        let x_ticks = thinned(x.ticks(9), inner.right - inner.left);
        let x_label = text::wrapped(&chart.x.label, LABEL, outer.right - outer.left);
        Self {
            x,
            y,
            x_ticks,
            y_ticks,
            x_label,
            y_label,
            lanes,
            outer,
            inner,
        }
    }

    /// Height of the whole chart, pixels.
    pub fn bottom(&self) -> f64 {
        self.outer.bottom + LINE * (1 + self.x_label.len()) as f64 + MARGIN
    }

    /// Where a point of curve number `curve` falls, and in which part.
    pub fn locate(&self, (x, y): Point, curve: usize) -> (Point, Part) {
        let Sides {
            left,
            right,
            top,
            bottom,
        } = self.inner;
        let lane = self.lanes.iter().position(|&other| other == curve);
        let share = (lane.unwrap_or(0) as f64 + 0.5) / self.lanes.len().max(1) as f64;
        let within = |from: f64, to: f64| from + 5.0 + share * (to - from - 10.0);
        let (px, across) = match self.x.place(x) {
            Place::Below => (0.5 * (self.outer.left + left), -1),
            Place::On(at) => (left + at * (right - left), 0),
            Place::Beyond => (0.5 * (right + self.outer.right), 1),
        };
        let (py, up) = match self.y.place(y) {
            Place::Below => (within(bottom, self.outer.bottom), -1),
            Place::On(at) => (bottom - at * (bottom - top), 0),
            Place::Beyond => (within(self.outer.top, top), 1),
        };
        ((px, py), Part { across, up })
    }

    /// The left and the right end of the plot, pixels.
    pub fn sides(&self) -> [f64; 2] {
        [self.outer.left, self.outer.right]
    }

    /// Draws everything but the curves.
    pub fn draw(&self, canvas: &mut Canvas) -> Drawn {
        self.draw_bands(canvas)?;
        self.draw_x(canvas)?;
        self.draw_y(canvas)?;
        let Sides {
            left,
            right,
            top,
            bottom,
        } = self.outer;
        canvas.line(&[(left, top), (left, bottom), (right, bottom)], GREY, 1.2)
    }

    fn draw_bands(&self, canvas: &mut Canvas) -> Drawn {
        let (outer, inner) = (self.outer, self.inner);
        let bands = [
            (
                Sides {
                    top: inner.bottom,
                    ..outer
                },
                self.y.below,
                true,
            ),
            (
                Sides {
                    bottom: inner.top,
                    ..outer
                },
                self.y.beyond,
                true,
            ),
            (
                Sides {
                    right: inner.left,
                    ..outer
                },
                self.x.below,
                false,
            ),
            (
                Sides {
                    left: inner.right,
                    ..outer
                },
                self.x.beyond,
                false,
            ),
        ];
        for (band, label, is_flat) in bands {
            let Some(label) = label else { continue };
            canvas.polygon(&band.corners(), GREY.faint(0.13))?;
            let (x, y, lettering) = if is_flat {
                let middle = 0.5 * (band.top + band.bottom);
                (outer.left - GAP, middle, text::number(HPos::Right))
            } else {
                let middle = 0.5 * (band.left + band.right);
                (
                    middle,
                    outer.bottom + 0.5 * LINE,
                    text::number(HPos::Center),
                )
            };
            canvas.text(label, x, y, &lettering)?;
        }
        Ok(())
    }

    fn draw_x(&self, canvas: &mut Canvas) -> Drawn {
        let Sides { left, right, .. } = self.inner;
        let Sides { top, bottom, .. } = self.outer;
        for tick in &self.x_ticks {
            let x = left + tick.at * (right - left);
            canvas.line(&[(x, top), (x, bottom)], grid(tick), 1.0)?;
            let y = bottom + 0.5 * LINE + 1.0;
            canvas.text(&tick.label, x, y, &text::number(HPos::Center))?;
        }
        let middle = 0.5 * (self.outer.left + self.outer.right);
        for (k, line) in self.x_label.iter().enumerate() {
            let y = bottom + LINE * (1.5 + k as f64) + 2.0;
            canvas.text(line, middle, y, &text::label(HPos::Center))?;
        }
        Ok(())
    }

    fn draw_y(&self, canvas: &mut Canvas) -> Drawn {
        let Sides { top, bottom, .. } = self.inner;
        let Sides { left, right, .. } = self.outer;
        for tick in &self.y_ticks {
            let y = bottom - tick.at * (bottom - top);
            canvas.line(&[(left, y), (right, y)], grid(tick), 1.0)?;
            canvas.text(&tick.label, left - GAP, y, &text::number(HPos::Right))?;
        }
        let upwards = Lettering {
            upwards: true,
            ..text::label(HPos::Center)
        };
        let middle = 0.5 * (self.outer.top + self.outer.bottom);
        for (k, line) in self.y_label.iter().enumerate() {
            let x = MARGIN + LINE * (0.4 + k as f64);
            canvas.text(line, x, middle, &upwards)?;
        }
        Ok(())
    }
}

impl Sides {
    fn corners(self) -> [Point; 4] {
        [
            (self.left, self.top),
            (self.right, self.top),
            (self.right, self.bottom),
            (self.left, self.bottom),
        ]
    }
}

/// The curves that have points on a band of the vertical axis, by number.
fn lanes(chart: &Chart, y: &Scale) -> Vec<usize> {
    let is_off = |point: &Point| !matches!(y.place(point.1), Place::On(_));
    let curves = chart.series.iter().enumerate();
    curves
        .filter(|(_, series)| series.points.iter().any(is_off))
        .map(|(number, _)| number)
        .collect()
}

/// Lines with a number are stronger than those between.
pub fn grid(tick: &Tick) -> super::canvas::Ink {
    GREY.faint(if tick.label.is_empty() { 0.12 } else { 0.3 })
}

/// Takes back labels that would touch others, on an axis of so many pixels: those of powers of ten last.
pub fn thinned(mut ticks: Vec<Tick>, length: f64) -> Vec<Tick> {
    let mut order: Vec<usize> = (0..ticks.len()).collect();
    order.sort_by_key(|&k| !is_decade(&ticks[k].label));
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for k in order {
        let tick = &mut ticks[k];
        if tick.label.is_empty() {
            continue;
        }
        let half = 0.5 * text::width(&tick.label, NUMBER);
        let ends = [tick.at * length - half, tick.at * length + half];
        let touches = |other: &[f64; 2]| ends[0] < other[1] + 4.0 && other[0] < ends[1] + 4.0;
        if taken.iter().any(touches) {
            tick.label.clear();
        } else {
            taken.push(ends);
        }
    }
    ticks
}

/// Whether a label is that of a power of ten, from 10 on.
fn is_decade(label: &str) -> bool {
    let rest = label.strip_prefix('1');
    rest.is_some_and(|rest| !rest.is_empty() && rest.chars().all(|c| c == '0' || c == ','))
}
