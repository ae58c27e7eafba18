//! The contacts of a step. The order is that of the bodies' rows, then of the features that meet; a
//! contact that was there a step ago takes over what it carried.

use glam::Vec3;

crate::table! {
    /// Where bodies touch.
    pub struct Contacts of
    /// A contact.
    Contact in "contacts" {
        /// Row of body 1.
        a: u32, "1", "";
        /// Row of body 2, which comes later.
        b: u32, "2", "";
        /// Which corners, edges or faces meet.
        feature: u32, "feature", "";
        /// n̂, from body 2 to body 1.
        normal: Vec3, "n̂", "";
        /// How deep they overlap; negative for a gap.
        depth: f32, "d", "m";
        /// Between the two surfaces.
        point: Vec3, "c", "m";
        /// The impulse that holds the bodies apart at rest.
        support: f32, "λ_k", "N s";
        /// The impulse of friction at rest.
        rub: Vec3, "C_t", "N s";
        /// The impulse of impacts: never taken back.
        impact: Vec3, "C", "N s";
        /// From body 1's centre to the contact.
        arm_a: Vec3, "r₁", "m";
        /// From body 2's centre to the contact.
        arm_b: Vec3, "r₂", "m";
        /// Depth to be pushed out.
        excess: f32, "d − slop", "m";
        /// How far it has pushed its bodies apart.
        pushed: f32, "s", "m";
        /// Speed at which a gap would just close in a step.
        gap_speed: f32, "g/Δt", "m/s";
        /// Acceleration with which the two are pulled together.
        closing: f32, "a_n", "m/s²";
        /// The slowest approach that is an impact.
        slowest_impact: f32, "u_min", "m/s";
        /// What a unit impulse along the normal changes.
        response: f32, "k", "1/kg";
        /// What one across the normal changes, at most.
        response_across: f32, "k_t", "1/kg";
        /// e of the pair.
        restitution: f32, "e", "";
        /// μ of the pair.
        friction: f32, "μ", "";
        /// μ_s of the pair.
        static_friction: f32, "μ_s", "";
    }
}

crate::table! {
    /// Runs of contacts between the same two bodies, as sweeps visit them.
    pub struct Touches of
    /// A touch.
    Touch in "touches" {
        /// Row of its first contact.
        first: u32, "first", "";
        /// Row after its last contact.
        end: u32, "end", "";
        /// Row of body 1.
        a: u32, "1", "";
        /// Row of body 2.
        b: u32, "2", "";
        /// The visit that last looked at it.
        seen: u32, "seen", "";
    }
}
