//! What acts on bodies beside gravity: where chapter 2 has lists of callbacks, here are tables.

use glam::Vec3;

crate::table! {
    /// Ends of magnets. Poles of the same force feel each other, unless they sit in the same body.
    pub struct Poles of
    /// A magnetic pole.
    Pole in "poles" {
        /// Row of the body that it sits in.
        body: u32, "body", "";
        /// Index of the force in the scene.
        force: u32, "force", "";
        /// Where in the body.
        place: Vec3, "s", "m";
        /// Positive for north.
        strength: f32, "strength", "√(N m²)";
        /// Length that keeps the force finite where poles meet.
        softening: f32, "ε", "m";
    }
}

crate::table! {
    /// Bodies that hang on a point of the world.
    pub struct FixedPoints of
    /// A fixed point.
    FixedPoint in "fixed_points" {
        /// Row of the body.
        body: u32, "body", "";
        /// Index of the force in the scene.
        force: u32, "force", "";
        /// Where in the world.
        point: Vec3, "c", "m";
        /// From it to the body's centre, in the body's axes.
        arm: Vec3, "s", "m";
        /// m g.
        weight: Vec3, "m g", "N";
    }
}

crate::table! {
    /// Forces that stay the same.
    pub struct Pushes of
    /// A constant force on a body's centre of mass.
    Push in "pushes" {
        /// Row of the body.
        body: u32, "body", "";
        /// Index of the force in the scene.
        force: u32, "force", "";
        /// In world axes.
        push: Vec3, "F", "N";
    }
}

crate::table! {
    /// The mouse: one row while it drags a body.
    pub struct Springs of
    /// A spring.
    Spring in "springs" {
        /// Row of the body.
        body: u32, "body", "";
        /// Where it is held, in the body's axes.
        anchor: Vec3, "anchor", "m";
        /// Where it is pulled to.
        target: Vec3, "target", "m";
        /// The body's mass.
        mass: f32, "m", "kg";
    }
}
