//! A picture without a window: draws a session into a texture, with what a window would show
//! besides its panels, reads it back, writes a PNG.

mod beside;

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use glam::{Vec2, Vec3};

use crate::camera::{Camera, Viewport};
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::overlay::{Canvas, Still};
use crate::render::{Picture, Quality, Renderer, Surroundings, Theme};
use crate::show::Show;
use crate::{Session, ShellError};

pub use beside::save_beside;

/// Width and height of the picture, pixels.
pub const SIZE: [u32; 2] = [1280, 720];

/// What the picture is drawn in and PNG stores: red, green, blue, opacity, a byte each.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const BYTES_PER_PIXEL: u32 = 4;

/// From where a picture is drawn, and in which colours.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Angles about the vertical and above the horizontal, rad, and how much closer than needed
    /// to see all bodies that move; where the window's camera would start if there are none.
    pub angles_and_zoom: Option<(Vec2, f32)>,
    /// Dusk or a bright room.
    pub theme: Theme,
}

/// Draws the session's last state and writes a PNG. Gives the name of the adapter that drew it.
///
/// # Errors
/// [`ShellError::NoAdapter`] or [`ShellError::Graphics`] where it can't be drawn,
/// [`ShellError::Write`] where it can't be written.
pub fn save(session: &Session, show: &Show, view: View, path: &Path) -> Result<String, ShellError> {
    let gpu = Gpu::shared()?;
    let pixels = draw(&gpu, session, show, view, 1.0)?;
    keep(path, &pixels)?;
    Ok(gpu.name.clone())
}

fn keep(path: &Path, pixels: &[u8]) -> Result<(), ShellError> {
    write_png(path, pixels).map_err(|source| ShellError::Write {
        file: path.to_owned(),
        source,
    })
}

/// What a picture is drawn into.
fn texture(gpu: &Gpu) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("screenshot"),
        size: extent(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The picture's pixels, row by row from the top; bodies are `alpha` of the way from the last state but
/// one to the last.
fn draw(
    gpu: &Gpu,
    session: &Session,
    show: &Show,
    view: View,
    alpha: f64,
) -> Result<Vec<u8>, ShellError> {
    let texture = texture(gpu);
    let guides = Guides::of_picture(session, show, view.theme);
    let surroundings = Surroundings::of(session.scene());
    let mut still = Still::new(gpu, FORMAT, SIZE, view.theme);
    let mut viewport = Viewport::whole(SIZE);
    let mut camera = camera(session, show, view, &surroundings, viewport);
    if show.is_any() {
        // The panel's place is known only when it has been laid out.
        viewport = still.lay_out(session, show, &guides, &camera);
        camera = self::camera(session, show, view, &surroundings, viewport);
        still.lay_out(session, show, &guides, &camera);
    }
    let mut renderer = Renderer::new(gpu, FORMAT, Quality::CARD, surroundings);
    let picture = Picture {
        session,
        alpha,
        camera: &camera,
        viewport,
        scale: 1.0,
        theme: view.theme,
        margin: still.background(),
        picked: None,
        pair: show.pair.map(|pair| pair.bodies),
        is_glass: show.is_glass(),
        strokes: &guides.strokes,
        faces: &guides.faces,
        is_as_read: show.is_any(),
    };
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let target = texture.create_view(&wgpu::TextureViewDescriptor::default());
    renderer.draw(gpu, &mut encoder, &target, SIZE, &picture);
    if show.is_any() {
        let canvas = Canvas {
            texture: &texture,
            view: &target,
        };
        still.paint(gpu, &mut encoder, &canvas);
    }
    read_back(gpu, encoder, &texture)
}

/// Where the window's camera would start, or close to the pair that is looked at; turned and
/// moved as the view says.
fn camera(
    session: &Session,
    show: &Show,
    view: View,
    surroundings: &Surroundings,
    viewport: Viewport,
) -> Camera {
    let mut camera = Camera::framing(surroundings, viewport);
    if let Some((angles, _)) = view.angles_and_zoom {
        (camera.yaw, camera.pitch) = angles.into();
    }
    let (low, high) = match (&show.pair, view.angles_and_zoom) {
        (Some(pair), _) => pair.corners(session),
        (None, Some(_)) => {
            corners_of_moving(session).unwrap_or((surroundings.low, surroundings.high))
        }
        (None, None) => (surroundings.low, surroundings.high),
    };
    camera.frame(low, high, viewport);
    camera.distance /= view.angles_and_zoom.map_or(1.0, |(_, zoom)| zoom);
    camera
}

/// Corners of the box about all bodies that can move where they are now, if there are any, m.
fn corners_of_moving(session: &Session) -> Option<(Vec3, Vec3)> {
    let bodies = session
        .scene()
        .bodies
        .iter()
        .zip(&session.state_now().position);
    let boxes = bodies
        .filter(|(body, _)| !body.is_static())
        .map(|(body, position)| {
            let radius = body.shape.bounding_radius();
            (
                (*position - radius).as_vec3(),
                (*position + radius).as_vec3(),
            )
        });
    boxes.reduce(|one, two| (one.0.min(two.0), one.1.max(two.1)))
}

/// Submits the commands, waits for them and copies the texture into memory.
fn read_back(
    gpu: &Gpu,
    mut encoder: wgpu::CommandEncoder,
    texture: &wgpu::Texture,
) -> Result<Vec<u8>, ShellError> {
    let row = SIZE[0] * BYTES_PER_PIXEL;
    let padded_row = row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("screenshot"),
        size: u64::from(padded_row) * u64::from(SIZE[1]),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(padded_row),
        rows_per_image: None,
    };
    let target = wgpu::TexelCopyBufferInfo {
        buffer: &buffer,
        layout,
    };
    encoder.copy_texture_to_buffer(texture.as_image_copy(), target, extent());
    gpu.queue.submit([encoder.finish()]);
    let failed = |what: String| ShellError::Graphics(gpu.failure().unwrap_or(what));
    // What went wrong, if anything did, shows when the range is asked for.
    buffer.slice(..).map_async(wgpu::MapMode::Read, |_| {});
    gpu.device
        .poll(wgpu::PollType::wait_indefinitely())
        .map_err(|error| failed(error.to_string()))?;
    let mapped = buffer
        .slice(..)
        .get_mapped_range()
        .map_err(|error| failed(error.to_string()))?;
    let rows = mapped.chunks_exact(padded_row as usize);
    let pixels = rows.flat_map(|bytes| &bytes[..row as usize]).copied();
    let pixels = pixels.collect();
    match gpu.failure() {
        Some(what) => Err(ShellError::Graphics(what)),
        None => Ok(pixels),
    }
}

fn extent() -> wgpu::Extent3d {
    wgpu::Extent3d {
        width: SIZE[0],
        height: SIZE[1],
        depth_or_array_layers: 1,
    }
}

fn write_png(path: &Path, pixels: &[u8]) -> std::io::Result<()> {
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(file, SIZE[0], SIZE[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    Ok(writer.finish()?)
}

#[cfg(test)]
mod tests {
    use ch00_scenes::{EngineEntry, Layer, Scene, Settings};

    use super::*;
    use crate::test_engine::{FALLING, RESIDENT, ball};

    /// A built-in scene after two steps, to be drawn as a window would.
    fn session(scene: &str, entry: EngineEntry) -> Session {
        let scene = Scene::open(scene, None, None).expect("a built-in");
        let session = Session::new(scene, entry, Settings::defaults()).expect("it falls");
        let mut session = session.in_window();
        session.set_dt(0.1);
        session.step();
        session.step();
        session
    }

    fn picture(session: &Session, alpha: f64) -> Vec<u8> {
        let gpu = Gpu::shared().expect("a Vulkan device, such as that of mesa-vulkan-drivers");
        draw(&gpu, session, &Show::default(), View::default(), alpha).expect("it can be drawn")
    }

    /// How many pixels differ visibly.
    pub(super) fn differences(one: &[u8], two: &[u8]) -> usize {
        let pixels = one.chunks_exact(4).zip(two.chunks_exact(4));
        let differs = |(one, two): &(&[u8], &[u8])| (0..3).any(|i| one[i].abs_diff(two[i]) > 8);
        pixels.filter(differs).count()
    }

    #[track_caller]
    pub(super) fn look_the_same(one: &[u8], two: &[u8]) {
        let odd = differences(one, two);
        assert!(odd < 50, "{odd} pixels differ");
    }

    #[test]
    fn bodies_on_the_device_are_drawn_where_those_of_other_engines_are() {
        // All shapes, and rods between bodies.
        for scene in ["mixed", "cradle"] {
            let [here, there] = [FALLING, RESIDENT].map(|entry| session(scene, entry));
            assert!(there.frames_late() > 0 && here.frames_late() == 0);
            for alpha in [0.0, 0.5, 1.0] {
                look_the_same(&picture(&here, alpha), &picture(&there, alpha));
            }
            let moved = differences(&picture(&there, 0.0), &picture(&there, 0.5));
            assert!(moved > 1000, "only {moved} pixels of {scene} move");
        }
    }

    #[test]
    fn bodies_that_come_and_go_are_drawn_from_the_device_too() {
        let [here, there] = [FALLING, RESIDENT].map(|entry| {
            let mut session = session("mixed", entry);
            session.remove_body(7).expect("nothing holds it");
            session.add_body(ball(0.0)).expect("there is room");
            session.step();
            picture(&session, 0.5)
        });
        look_the_same(&here, &there);
    }

    #[test]
    fn with_layers_bodies_are_drawn_as_late_as_these_are() {
        let gpu = Gpu::shared().expect("a Vulkan device, such as that of mesa-vulkan-drivers");
        let show = Show {
            layers: vec![Layer::Aabbs],
            is_see_through: false,
            pair: None,
        };
        let mut late = session("mixed", RESIDENT);
        let drawn = |session: &Session| {
            draw(&gpu, session, &show, View::default(), 1.0).expect("it can be drawn")
        };
        let start = drawn(&late);
        assert!(differences(&start, &picture(&late, 1.0)) > 1000);
        late.reset().expect("it was loaded before");
        look_the_same(&start, &picture(&late, 1.0));
    }
}
