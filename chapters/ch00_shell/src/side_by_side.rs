//! Several runs of one scene side by side in the window, under one clock and one camera; and what a
//! program may add to the left panel to start them.
//!
//! The shell steps, draws and resets them; what runs, what is measured of it and what stands in
//! the panels is up to whoever brings them (`ch07_findings::race`).

use egui::{Rect, Ui, pos2, vec2};

use crate::Session;
use crate::camera::{Camera, Viewport};
use crate::gpu::Gpu;

/// Runs that are shown together.
pub trait SideBySide {
    /// Each of them, in the order of the views.
    fn views(&self) -> Vec<View<'_>>;

    /// Size of a step, s; the same for all.
    fn dt(&self) -> f64;

    /// What the last step of all of them took, s.
    fn cost(&self) -> f64;

    /// Makes a step of each of them.
    fn step(&mut self);

    /// Called once a frame, after its steps: the place for what costs time and is no step.
    fn end_frame(&mut self);

    /// Starts all of them again.
    fn reset(&mut self);

    /// The window draws with this device from now on.
    fn move_to(&mut self, gpu: &Gpu);

    /// From where they are seen at the start; none for a look at all of the scene.
    fn sight(&self) -> Option<Sight> {
        None
    }

    /// Shows what stands in the left panel, under the buttons that stop and start them.
    fn show_panel(&mut self, ui: &mut Ui);

    /// Shows what stands under the views.
    fn show_plots(&mut self, ui: &mut Ui);
}

/// What is worth seeing of a scene, and from where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// The lowest corner of a box that fills the picture, m.
    pub low: [f32; 3],
    /// Its highest corner, m.
    pub high: [f32; 3],
    /// Angle about the vertical, rad; 0 looks along −z.
    pub yaw: f32,
    /// Angle above the horizontal, rad.
    pub pitch: f32,
}

impl Sight {
    /// Puts a camera there.
    pub(crate) fn place(&self, camera: &mut Camera, viewport: Viewport) {
        (camera.yaw, camera.pitch) = (self.yaw, self.pitch);
        camera.frame(self.low.into(), self.high.into(), viewport);
    }
}

/// One of the runs, as it is shown.
pub struct View<'a> {
    /// What runs.
    pub name: String,
    /// Its colour: red, green, blue.
    pub color: [u8; 3],
    /// Its numbers.
    pub text: String,
    /// Why nothing is to be seen, or nothing moves any more.
    pub trouble: Option<String>,
    /// The bodies; none if there is no run.
    pub session: Option<&'a Session>,
}

/// Runs that are to be shown, and a session of their scene that the window goes back to when they
/// are closed.
pub struct Opening {
    /// The runs.
    pub runs: Box<dyn SideBySide>,
    /// Their scene at its start.
    pub session: Session,
}

/// A section that a program adds to the left panel.
pub trait Menu {
    /// Its headline.
    fn name(&self) -> &'static str;

    /// Shows it; `session` is what runs in the window. Gives what its user wants to be shown side by side.
    fn show(&mut self, ui: &mut Ui, session: &Session) -> Option<Opening>;
}

/// What a program adds to its chapter's window.
#[derive(Default)]
pub struct Extras {
    /// Sections of the left panel.
    pub menus: Vec<Box<dyn Menu>>,
    /// What is shown at the start in place of the session.
    pub runs: Option<Box<dyn SideBySide>>,
}

/// Between two views, points.
const GAP: f32 = 2.0;

/// Width of a view over its height that is best.
const BEST_ASPECT: f32 = 1.25;

/// Where so many views are in a rectangle: in rows of as many as makes them largest, with no place left
/// empty.
#[must_use]
pub fn arrange(room: Rect, count: usize) -> Vec<Rect> {
    let cell = |columns: usize| {
        let rows = count.div_ceil(columns);
        let room = room.size() - GAP * vec2((columns - 1) as f32, (rows - 1) as f32);
        // Whole points, so that all pictures have the same size.
        vec2(room.x / columns as f32, room.y / rows as f32).floor()
    };
    let width = |columns: usize| {
        let cell = cell(columns);
        cell.x.min(BEST_ASPECT * cell.y)
    };
    let full = (1..=count).filter(|columns| count.is_multiple_of(*columns));
    let best = full.max_by(|&one, &two| width(one).total_cmp(&width(two)));
    let columns = best.unwrap_or(1);
    let size = cell(columns);
    let place = |i: usize| {
        let (row, column) = (i / columns, i % columns);
        let corner = vec2(column as f32, row as f32) * (size + vec2(GAP, GAP));
        Rect::from_min_size(room.min + corner, size.max(vec2(1.0, 1.0)))
    };
    (0..count).map(place).collect()
}

/// A whole picture as a rectangle, a pixel a point.
#[must_use]
pub fn whole([width, height]: [u32; 2]) -> Rect {
    Rect::from_min_size(pos2(0.0, 0.0), vec2(width as f32, height as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_fill_the_room_without_overlap() {
        for size in [[1280, 540], [970, 540], [300, 900]] {
            for count in 1..=4 {
                let room = whole(size);
                let places = arrange(room, count);
                assert_eq!(places.len(), count);
                for (i, place) in places.iter().enumerate() {
                    assert!(room.expand(0.01).contains_rect(*place), "{place}");
                    let apart = |other: &Rect| !place.shrink(0.01).intersects(*other);
                    assert!(places[..i].iter().all(apart));
                }
            }
        }
    }

    #[test]
    fn two_or_three_stand_beside_each_other_and_four_in_a_square() {
        let room = whole([1280, 540]);
        let corners = |count| {
            let places = arrange(room, count);
            let is_left = |place: &&Rect| place.min.x < 1.0;
            places.iter().filter(is_left).count()
        };
        assert_eq!([2, 3, 4].map(corners), [1, 1, 2]);
    }
}
