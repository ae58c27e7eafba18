//! Bodies that stay on the GPU: how an engine there hands them to the renderer.
//!
//! The engine's last kernel of a step writes a row [`Drawn`] a body, and the window draws from these
//! rows: nothing comes down to be drawn. A kernel that keeps the rule of own rows needs no other
//! row for it: what stands in its row as `position` and `orientation` becomes `position_last` and
//! `orientation_last`, and the new place is written over it. After a body was put somewhere by hand
//! (loading, an edit, another engine's state) both places are the new one, as there is nothing to
//! interpolate.
//!
//! ```wgsl
//! struct Drawn {                    // 64 bytes, a row a body in the scene's order
//!     position: vec3f,              //  0  world position of its origin after the last step, m
//!     spare: f32,                   // 12  unused
//!     orientation: vec4f,           // 16  body to world after the last step: x, y, z, w
//!     position_last: vec3f,         // 32  world position of its origin before the last step, m
//!     spare_last: f32,              // 44  unused
//!     orientation_last: vec4f,      // 48  body to world before the last step
//! }
//! ```
//!
//! Size, shape, colour and what is picked are not in it: the window knows them from the scene. The rows
//! of static bodies are written once. Bodies thrown in come after those there are; where one is
//! removed, those after it move up, as in the scene.

use std::rc::Rc;

use crate::gpu::Gpu;

/// Where a body is drawn. The layout of `shaders/ch00_drawn.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Drawn {
    /// World position of the body's origin after the last step, m.
    pub position: [f32; 3],
    /// Unused.
    pub spare: f32,
    /// Body to world after the last step: x, y, z, w.
    pub orientation: [f32; 4],
    /// World position of the body's origin before the last step, m.
    pub position_last: [f32; 3],
    /// Unused.
    pub spare_last: f32,
    /// Body to world before the last step: x, y, z, w.
    pub orientation_last: [f32; 4],
}

/// What [`ch00_scenes::Engine::resident`] of an engine on the GPU gives, for the window to draw from.
#[derive(Clone)]
pub struct Resident {
    /// The device that the rows are on. The window draws from them if it is its own
    /// ([`Gpu::shared`]); otherwise from the state that came back last.
    pub gpu: Rc<Gpu>,
    /// Rows of [`Drawn`], one a body of the scene and in its order, the first at the start; there may be
    /// room for more behind them. Its usage has `STORAGE`.
    pub bodies: wgpu::Buffer,
}

#[cfg(test)]
mod tests {
    use std::mem::offset_of;

    use super::*;

    #[test]
    fn the_layout_is_the_shaders() {
        assert_eq!(size_of::<Drawn>(), 64);
        let offsets = [
            offset_of!(Drawn, position),
            offset_of!(Drawn, orientation),
            offset_of!(Drawn, position_last),
            offset_of!(Drawn, orientation_last),
        ];
        assert_eq!(offsets, [0, 16, 32, 48]);
    }
}
