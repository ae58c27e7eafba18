//! The panels as they were painted last. Letters cost a software device as much as a scene of balls, so it paints
//! the panels a few times a second, and in between copies them from a sheet. What reaches over
//! the scene is painted in every frame.

use glam::Vec2;

use crate::camera::Viewport;
use crate::gpu::Gpu;

/// Panels that nobody touches are painted this often, s.
const EVERY: f64 = 0.25;

/// A texture with the panels on it, of the picture's size.
pub struct Sheet {
    texture: wgpu::Texture,
    /// To paint on.
    pub view: wgpu::TextureView,
    /// What the scene left of the picture to the panels.
    room: Viewport,
    painted: f64,
}

impl Sheet {
    /// Whether pictures of this device are better painted with a sheet, and can be.
    pub fn suits(gpu: &Gpu, picture: &wgpu::Texture) -> bool {
        gpu.is_software && picture.usage().contains(wgpu::TextureUsages::COPY_DST)
    }

    /// For pictures like this one, with the scene in this part of them.
    pub fn new(gpu: &Gpu, picture: &wgpu::Texture, room: Viewport, now: f64) -> Self {
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("panels"),
            size: picture.size(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: picture.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        Self {
            view: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            texture,
            room,
            painted: now,
        }
    }

    /// Whether it can go on being copied into such a picture.
    pub fn fits(&self, picture: &wgpu::Texture, room: Viewport) -> bool {
        self.texture.size() == picture.size() && self.room == room
    }

    /// Whether the panels are to be painted again, which then counts as done.
    pub fn is_due(&mut self, now: f64, is_touched: bool) -> bool {
        let is_due = is_touched || now >= self.painted + EVERY;
        if is_due {
            self.painted = now;
        }
        is_due
    }

    /// Copies the panels into the picture, all around the scene.
    pub fn copy(&self, encoder: &mut wgpu::CommandEncoder, picture: &wgpu::Texture) {
        let size = [picture.width(), picture.height()];
        for ([x, y], [width, height]) in around(self.room, size) {
            let origin = wgpu::Origin3d { x, y, z: 0 };
            let place = |texture| wgpu::TexelCopyTextureInfo {
                texture,
                mip_level: 0,
                origin,
                aspect: wgpu::TextureAspect::All,
            };
            let extent = wgpu::Extent3d {
                width,
                height,
                depth_or_array_layers: 1,
            };
            encoder.copy_texture_to_texture(place(&self.texture), place(picture), extent);
        }
    }
}

/// The rectangles around a part of a picture, each with its corner and its size, pixels.
fn around(room: Viewport, [width, height]: [u32; 2]) -> Vec<([u32; 2], [u32; 2])> {
    let whole = |corner: Vec2| {
        let [x, y] = corner.to_array().map(|part| part.round() as u32);
        [x.min(width), y.min(height)]
    };
    let ([left, top], [right, bottom]) = (whole(room.origin), whole(room.origin + room.size));
    let all = [
        ([0, 0], [left, height]),
        ([right, 0], [width - right, height]),
        ([left, 0], [right - left, top]),
        ([left, bottom], [right - left, height - bottom]),
    ];
    let is_any = |(_, [width, height]): &([u32; 2], [u32; 2])| width * height > 0;
    all.into_iter().filter(is_any).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn room(x: f32, y: f32, width: f32, height: f32) -> Viewport {
        Viewport {
            origin: Vec2::new(x, y),
            size: Vec2::new(width, height),
        }
    }

    #[test]
    fn what_lies_around_the_scene_is_all_of_the_picture_but_the_scene() {
        let rooms = [
            room(0.0, 0.0, 100.0, 50.0),
            room(30.0, 0.0, 70.0, 50.0),
            room(30.0, 0.0, 40.0, 35.0),
            room(30.0, 5.0, 40.0, 35.0),
        ];
        for (room, count) in rooms.into_iter().zip([0, 1, 3, 4]) {
            let parts = around(room, [100, 50]);
            let areas = parts.iter().map(|(_, [width, height])| width * height);
            let rest = 5000 - (room.size.x * room.size.y) as u32;
            assert_eq!((parts.len(), areas.sum::<u32>()), (count, rest));
        }
    }

    #[test]
    fn panels_are_painted_when_they_are_touched_and_now_and_then() {
        let gpu = Gpu::shared().expect("a Vulkan device, such as that of mesa-vulkan-drivers");
        let picture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d::default(),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let mut sheet = Sheet::new(&gpu, &picture, room(0.0, 0.0, 1.0, 1.0), 1.0);
        assert!(!sheet.is_due(1.1, false));
        assert!(sheet.is_due(1.2, true));
        assert!(!sheet.is_due(1.4, false));
        assert!(sheet.is_due(1.5, false));
    }
}
