//! The components: plain structs, of which the ECS keeps columns.

use bevy_ecs::prelude::{Component, Resource};
use ch01_hierarchy::Transform;

// ANCHOR: components
/// Where it is in its parent.
#[derive(Component)]
pub struct Local(pub Transform);

/// Where it is in the world.
#[derive(Component)]
pub struct Global(pub Transform);

/// Travels on a circle.
#[derive(Component)]
pub struct Circle {
    pub radius: f32,
    pub angle: f32,
    pub rate: f32,
}
// ANCHOR_END: components

// ANCHOR: spinning
/// Turns on its own axis.
#[derive(Component)]
pub struct Spin {
    pub turned: f32,
    pub rate: f32,
}
// ANCHOR_END: spinning

// ANCHOR: glow
/// Brightness.
#[derive(Component, Default)]
pub struct Glow(pub f32);
// ANCHOR_END: glow

/// The length of this frame, s.
#[derive(Resource)]
pub struct Step(pub f32);
