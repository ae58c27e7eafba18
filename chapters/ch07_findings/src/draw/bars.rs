//! Bars in groups, one under the other, from 0 to the right: names before them, notes after them.

use plotters::style::text_anchor::HPos;

use super::canvas::{Canvas, Drawn, Lettering};
use super::frame::grid;
use super::legend::Legend;
use super::scale::{Place, Scale, Tick};
use super::text::{self, BOLD, GREY, NUMBER, TITLE};
use super::{MARGIN, WIDTH, draw_head, file, marks};
use crate::chart::{Axis, Bar, Bars};
use crate::error::FindingsError;

/// From bar to bar, and of a bar itself, pixels.
const ROW: f64 = 19.0;
const HEIGHT: f64 = 13.0;
/// What a group's name takes, pixels.
const HEADING: f64 = 27.0;
/// Between the axis and what stands beside it, pixels.
const GAP: f64 = 7.0;
/// Height of a line of text at the axis, pixels.
const LINE: f64 = 18.0;
/// Half the height of an error bar's ends, pixels.
const END: f64 = 3.5;

/// The bars as an SVG file.
pub fn svg(bars: &Bars) -> Result<String, FindingsError> {
    let plot = Plot::new(bars);
    file((bars.name, &bars.title), plot.height(), |canvas| {
        plot.draw(canvas)
    })
}

/// Bars, placed on the page.
struct Plot<'a> {
    bars: &'a Bars,
    title: Vec<String>,
    legend: Option<Legend>,
    scale: Scale,
    ticks: Vec<Tick>,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl<'a> Plot<'a> {
    fn new(bars: &'a Bars) -> Self {
        let room = WIDTH - 2.0 * MARGIN;
        let title = text::wrapped(&bars.title, BOLD * TITLE, room);
        let legend = (bars.parts.len() > 1).then(|| Legend::of_parts(&bars.parts, room));
        let all = || bars.groups.iter().flat_map(|group| &group.bars);
        let widest = |of: fn(&Bar) -> &str| {
            let widths = all().map(|bar| text::width(of(bar), NUMBER));
            widths.fold(0.0, f64::max)
        };
        let ends = all().flat_map(|bar| {
            let (low, high) = bar.spread.unwrap_or_default();
            [bar.lengths.iter().sum(), low, high]
        });
        let scale = Scale::of(&Axis::linear(&bars.label), ends.chain([0.0]));
        let top = MARGIN
            + 1.35 * TITLE * title.len() as f64
            + legend.as_ref().map_or(0.0, Legend::height);
        let rows = all().count() as f64 * ROW + bars.groups.len() as f64 * HEADING;
        Self {
            bars,
            title,
            legend,
            ticks: if bars.powers {
                scale.powers()
            } else {
                scale.ticks(6)
            },
            scale,
            left: MARGIN + widest(|bar| &bar.name) + GAP,
            right: WIDTH - MARGIN - widest(|bar| &bar.note) - GAP,
            top,
            bottom: top + rows + 0.5 * (ROW - HEIGHT),
        }
    }

    fn height(&self) -> f64 {
        self.bottom + 2.0 * LINE + MARGIN
    }

    /// Where a length ends; None for what no axis can hold.
    fn x(&self, length: f64) -> Option<f64> {
        match self.scale.place(length) {
            Place::On(at) => Some(self.left + at * (self.right - self.left)),
            Place::Below | Place::Beyond => None,
        }
    }

    fn draw(&self, canvas: &mut Canvas) -> Drawn {
        draw_head(canvas, &self.title, self.legend.as_ref())?;
        self.draw_axis(canvas)?;
        let heading = Lettering {
            bold: true,
            ..text::label(HPos::Left)
        };
        let mut y = self.top;
        for group in &self.bars.groups {
            canvas.text(&group.name, MARGIN, y + 0.58 * HEADING, &heading)?;
            y += HEADING;
            for bar in &group.bars {
                self.draw_bar(canvas, bar, y + 0.5 * ROW)?;
                y += ROW;
            }
        }
        Ok(())
    }

    /// Lines across all bars, broken where a group's name stands.
    fn draw_axis(&self, canvas: &mut Canvas) -> Drawn {
        for tick in &self.ticks {
            let x = self.left + tick.at * (self.right - self.left);
            self.draw_upright(canvas, x, |canvas, ends| canvas.line(ends, grid(tick), 1.0))?;
            let y = self.bottom + 0.5 * LINE + 1.0;
            canvas.text(&tick.label, x, y, &text::number(HPos::Center))?;
        }
        if let Some(zero) = self.x(0.0) {
            self.draw_upright(canvas, zero, |canvas, ends| canvas.line(ends, GREY, 1.2))?;
        }
        let middle = 0.5 * (self.left + self.right);
        let y = self.bottom + 1.5 * LINE + 2.0;
        canvas.text(&self.bars.label, middle, y, &text::label(HPos::Center))
    }

    /// A line beside the bars of each group.
    fn draw_upright(
        &self,
        canvas: &mut Canvas,
        x: f64,
        line: impl Fn(&mut Canvas, &[(f64, f64)]) -> Drawn,
    ) -> Drawn {
        let mut y = self.top;
        for group in &self.bars.groups {
            let from = y + HEADING;
            y = from + ROW * group.bars.len() as f64;
            line(canvas, &[(x, from), (x, y)])?;
        }
        Ok(())
    }

    /// A bar about the height `y`, with all that belongs to it.
    fn draw_bar(&self, canvas: &mut Canvas, bar: &Bar, y: f64) -> Drawn {
        let before = self.left - GAP;
        canvas.text(&bar.name, before, y, &text::number(HPos::Right))?;
        let mut sum = 0.0;
        let mut end = self.x(0.0).unwrap_or(self.left);
        for (number, length) in bar.lengths.iter().enumerate() {
            let from = self.x(sum);
            sum += length;
            if let (Some(from), Some(to)) = (from, self.x(sum)) {
                let ends = [from.min(to), from.max(to)];
                let ink = match bar.spread {
                    None => marks::ink_of_part(number),
                    // The error bar lies over it.
                    Some(_) => marks::ink_of_part(number).faint(0.4),
                };
                marks::part(canvas, ink, ends, y, HEIGHT)?;
                end = end.max(to);
            }
        }
        if let Some((low, high)) = bar.spread
            && let (Some(low), Some(high)) = (self.x(low), self.x(high))
        {
            let ink = marks::ink_of_part(0);
            canvas.line(&[(low, y), (high, y)], ink, 1.5)?;
            for x in [low, high] {
                canvas.line(&[(x, y - END), (x, y + END)], ink, 1.5)?;
            }
            end = end.max(high);
        }
        canvas.text(&bar.note, end + GAP, y, &text::number(HPos::Left))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::Group;

    fn bars(lengths: Vec<f64>, spread: Option<(f64, f64)>) -> Bars {
        let bar = Bar {
            name: "planned".to_owned(),
            lengths,
            spread,
            note: "3 ms".to_owned(),
        };
        Bars {
            name: "any",
            title: "Bars & more".to_owned(),
            label: "time (ms)".to_owned(),
            powers: false,
            parts: vec!["update", "resolve"],
            groups: vec![Group {
                name: "balls".to_owned(),
                bars: vec![bar.clone(), bar],
            }],
        }
    }

    fn count(svg: &str, element: &str) -> usize {
        svg.matches(&format!("<{element} ")).count()
    }

    #[test]
    fn every_part_is_drawn_and_everything_has_its_name() {
        let drawn = svg(&bars(vec![1.0, 2.0], None)).expect("it can be drawn");
        for text in ["Bars &amp; more", "planned", "3 ms", "balls", "time (ms)"] {
            assert!(drawn.contains(text), "{text:?} isn't in:\n{drawn}");
        }
        // Two parts of two bars, and their samples in the legend.
        assert_eq!(count(&drawn, "polygon"), 6);
    }

    #[test]
    fn an_error_bar_has_three_lines() {
        let lines = |spread| {
            let drawn = svg(&bars(vec![1.0], spread)).expect("it can be drawn");
            drawn.matches("stroke-width=\"15\"").count()
        };
        assert_eq!(lines(None), 0);
        assert_eq!(lines(Some((0.5, 1.2))), 6);
    }

    #[test]
    fn what_has_no_length_leaves_its_name_and_note() {
        let drawn = svg(&bars(vec![f64::NAN, 1.0], None)).expect("it can be drawn");
        assert!(drawn.contains("planned") && drawn.contains("3 ms"));
        assert_eq!(count(&drawn, "polygon"), 2, "the legend's samples");
    }
}
