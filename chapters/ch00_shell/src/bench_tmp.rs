#![allow(missing_docs, clippy::pedantic, unused)]
use crate::camera::{Camera, Viewport};
use crate::clock::Pace;
use crate::gpu::Gpu;
use crate::guides::Guides;
use crate::overlay::Panels;
use crate::render::{Picture, Quality, Renderer, Surroundings, Theme};
use crate::show::Show;
use crate::stage::Stage;
use crate::test_engine::{CHAPTER, FALLING, RESIDENT};
use crate::Session;
use ch00_scenes::{Scene, Settings};
use glam::DVec3;
use std::time::Instant;

thread_local!{pub static OFF: std::cell::RefCell<String> = Default::default();}
pub fn off(w:&str)->bool{OFF.with(|o|o.borrow().contains(w))}

fn cpu() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap();
    let rest = text.rsplit(')').next().unwrap();
    let f: Vec<&str> = rest.split_whitespace().collect();
    (f[11].parse::<f64>().unwrap() + f[12].parse::<f64>().unwrap()) * 10.0
}

pub fn scene(count: u64) -> Scene {
    let mut scene = Scene::open("balls", Some(count), None).unwrap();
    let mut i = 0;
    let side = (count as f64 / 5.0).sqrt().ceil() as u64;
    let half = scene.meta_pair("inner_half_extents").unwrap()[0] - 0.3;
    for b in scene.bodies.iter_mut().filter(|b| !b.is_static()) {
        let (x, z, y) = (i % side, (i / side) % side, i / side / side);
        let at = |k: u64| -half + 2.0 * half * (k as f64 + 0.5 * (y % 2) as f64) / side as f64;
        b.position = DVec3::new(at(x), 0.25 + 0.4 * y as f64, at(z));
        i += 1;
    }
    scene
}

#[test]
#[ignore]
fn frame_parts() {
    let gpu = Gpu::shared().unwrap();
    let n: u64 = std::env::var("N").map(|n| n.parse().unwrap()).unwrap_or(1000);
    let entry = if std::env::var("RES").is_ok() {RESIDENT} else {FALLING};
    let session = Session::new(scene(n), entry, Settings::defaults()).unwrap();
    let mut stage = Stage::new(CHAPTER, session, Pace::Fixed, Show::default());
    stage.is_paused = true;
    let around = Surroundings::of(stage.session().scene());
    let format = wgpu::TextureFormat::Bgra8Unorm;
    let quality = Quality::of(gpu.is_software, &around);
    let mut renderer = Renderer::new(&gpu, format, quality, around.clone());
    let mut panels = Panels::default();
    let mut painter = crate::overlay::painter::Painter::new(&gpu, format);
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: 1280, height: 720, depth_or_array_layers: 1 },
        mip_level_count: 1, sample_count: 1, dimension: wgpu::TextureDimension::D2, format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::COPY_DST, view_formats: &[],
    });
    let view = texture.create_view(&Default::default());
    let mut guides = Guides::default();
    let mut time = 0.0;
    let mut frame = || {
        stage.frame_rate.record(std::time::Duration::from_millis(20));
        if off("step") { stage.step_once(); }
        stage.advance(0.02);
        guides.collect(&stage);
        time += 0.02;
        let mut marks = vec![];
        let t = Instant::now();
        let input = egui::RawInput { screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(1280.0, 720.0))), time: Some(time), ..Default::default() };
        let layout = (!off("panels")).then(|| panels.lay_out(input, [1280, 720], &mut stage, &guides));
        marks.push(t.elapsed().as_secs_f64()*1e3);
        let viewport = layout.as_ref().map_or(Viewport { origin: glam::Vec2::new(306.0, 0.0), size: glam::Vec2::new(974.0, 720.0) }, |l| l.viewport);
        stage.set_viewport(viewport);
        let picture = Picture {
            session: stage.session(), alpha: 1.0, camera: &stage.camera, viewport, scale: 1.0, theme: Theme::Light,
            margin: wgpu::Color::WHITE, picked: None, pair: None, is_glass: false, strokes: &guides.strokes, faces: &[], is_as_read: false,
        };
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        renderer.draw(&gpu, &mut encoder, &view, [1280, 720], &picture);
        marks.push(t.elapsed().as_secs_f64()*1e3);
        if let Some(layout) = layout { if !off("paint") { panels.bench_paint(&mut painter, &gpu, &mut encoder, &crate::overlay::Canvas{texture:&texture,view:&view}, layout); } }
        marks.push(t.elapsed().as_secs_f64()*1e3);
        gpu.queue.submit([encoder.finish()]);
        gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        marks.push(t.elapsed().as_secs_f64()*1e3);
        marks
    };
    for off in std::env::var("OFF").unwrap_or_default().split(';') {
        OFF.with(|o| *o.borrow_mut() = off.to_owned());
        for _ in 0..3 { frame(); }
        let (t, c) = (Instant::now(), cpu());
        let k = 40;
        let mut sum = vec![0.0; 4];
        for _ in 0..k { for (s, m) in sum.iter_mut().zip(frame()) { *s += m / k as f64; } }
        println!("without [{off:20}] wall {:.2} ms cpu {:.2} ms  marks {sum:.2?}", t.elapsed().as_secs_f64() * 1e3 / k as f64, (cpu() - c) / k as f64);
        if let Ok(dir) = std::env::var("SHOT") { shot(&gpu, &texture, &format!("{dir}/{}.png", off.replace(' ', "_"))); }
    }
}

fn shot(gpu: &Gpu, texture: &wgpu::Texture, path: &str) {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor { label: None, size: 1280 * 720 * 4, usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ, mapped_at_creation: false });
    encoder.copy_texture_to_buffer(texture.as_image_copy(), wgpu::TexelCopyBufferInfo { buffer: &buffer, layout: wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(5120), rows_per_image: None } }, wgpu::Extent3d { width: 1280, height: 720, depth_or_array_layers: 1 });
    gpu.queue.submit([encoder.finish()]);
    buffer.slice(..).map_async(wgpu::MapMode::Read, |_| {});
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    let data: Vec<u8> = buffer.slice(..).get_mapped_range().unwrap().chunks(4).flat_map(|p| [p[2], p[1], p[0]]).collect();
    let mut e = png::Encoder::new(std::io::BufWriter::new(std::fs::File::create(path).unwrap()), 1280, 720);
    e.set_color(png::ColorType::Rgb);
    e.write_header().unwrap().write_image_data(&data).unwrap();
}
