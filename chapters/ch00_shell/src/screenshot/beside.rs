//! A picture of several runs side by side, with their captions and plots.

use std::path::Path;

use super::{FORMAT, SIZE, View, camera, keep, read_back, texture};
use crate::ShellError;
use crate::gpu::Gpu;
use crate::overlay::{Canvas, Still};
use crate::render::{Picture, Quality, Several, Surroundings};
use crate::show::Show;
use crate::side_by_side::SideBySide;

/// Draws the last states of several runs and what they plot, and writes a PNG. Gives the name of the
/// adapter that drew it.
///
/// # Errors
/// As [`super::save`] has.
pub fn save_beside(
    runs: &mut dyn SideBySide,
    view: View,
    path: &Path,
) -> Result<String, ShellError> {
    let gpu = Gpu::shared()?;
    let pixels = draw_beside(&gpu, runs, view)?;
    keep(path, &pixels)?;
    Ok(gpu.name.clone())
}

/// The pixels of a picture of several runs.
fn draw_beside(gpu: &Gpu, runs: &mut dyn SideBySide, view: View) -> Result<Vec<u8>, ShellError> {
    let texture = texture(gpu);
    let mut still = Still::new(gpu, FORMAT, SIZE, view.theme);
    // Panels have their places from the second time on.
    still.lay_out_beside(runs);
    let places = still.lay_out_beside(runs);
    let views = runs.views();
    let first = views.iter().find_map(|view| view.session);
    let (Some(session), Some(place)) = (first, places.first()) else {
        return Err(ShellError::Graphics("there is no run to draw".to_owned()));
    };
    let surroundings = Surroundings::of(session.scene());
    let mut camera = camera(session, &Show::default(), view, &surroundings, *place);
    if let Some(sight) = runs.sight().filter(|_| view.angles_and_zoom.is_none()) {
        sight.place(&mut camera, *place);
    }
    let picture = Picture {
        session,
        alpha: 1.0,
        camera: &camera,
        viewport: *place,
        scale: 1.0,
        theme: view.theme,
        margin: still.background(),
        picked: None,
        pair: None,
        is_glass: false,
        strokes: &[],
        faces: &[],
        is_as_read: false,
    };
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let target = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let pictures = picture.of_each(&views, &places);
    let mut several = Several::new(FORMAT, Quality::CARD);
    several.draw(gpu, &mut encoder, (&target, SIZE), &surroundings, &pictures);
    let canvas = Canvas {
        texture: &texture,
        view: &target,
    };
    still.paint(gpu, &mut encoder, &canvas);
    read_back(gpu, encoder, &texture)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{differences, look_the_same};
    use super::*;
    use crate::camera::Viewport;
    use crate::test_engine::Falls;

    #[test]
    fn equal_runs_side_by_side_look_the_same_each_in_its_place() {
        let gpu = Gpu::shared().expect("a Vulkan device, such as that of mesa-vulkan-drivers");
        let mut runs = Falls::new(2);
        let view = View::default();
        let mut still = Still::new(&gpu, FORMAT, SIZE, view.theme);
        still.lay_out_beside(&mut runs);
        let places = still.lay_out_beside(&mut runs);
        assert_eq!(places.len(), 2, "of the third run there is nothing to see");
        let mut drawn = || draw_beside(&gpu, &mut runs, view).expect("it can be drawn");
        let start = drawn();
        let [left, right] = [0, 1].map(|i| part(&start, places[i]));
        look_the_same(&left, &right);
        let colors: std::collections::BTreeSet<_> = left.chunks_exact(4).collect();
        assert!(colors.len() > 100, "only {} colours", colors.len());
        runs.sessions[1].step_by(0.7);
        let drawn = draw_beside(&gpu, &mut runs, view).expect("it can be drawn");
        look_the_same(&left, &part(&drawn, places[0]));
        assert!(differences(&right, &part(&drawn, places[1])) > 50);
    }

    /// The pixels of a part of a picture.
    fn part(pixels: &[u8], place: Viewport) -> Vec<u8> {
        let [x, y, width, height] = [place.origin.x, place.origin.y, place.size.x, place.size.y]
            .map(|side| side.round() as usize);
        let row = SIZE[0] as usize * 4;
        let rows = pixels.chunks_exact(row).skip(y).take(height);
        rows.flat_map(|row| &row[4 * x..4 * (x + width)])
            .copied()
            .collect()
    }
}
