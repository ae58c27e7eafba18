//! The layers of its inner state that an engine can draw over the bodies.

/// A kind of drawing that an engine can make of its inner state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Layer {
    /// Bounding boxes of the broad phase.
    Aabbs,
    /// Cells of the broad phase: those of its tree, or of its grid.
    Cells,
    /// Contacts with their normals and impulses.
    Contacts,
    /// Frames of nodes or bodies.
    Frames,
    /// Frames of joints, one on each of the two bodies.
    JointFrames,
    /// How far joints let their bodies turn: cones, arcs and sectors.
    Limits,
}

impl Layer {
    /// All layers, in the order in which the overlay lists them.
    pub const ALL: [Layer; 6] = [
        Layer::Aabbs,
        Layer::Cells,
        Layer::Contacts,
        Layer::Frames,
        Layer::JointFrames,
        Layer::Limits,
    ];

    /// The layer's name in the overlay.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Layer::Aabbs => "bounding boxes",
            Layer::Cells => "cells of the broad phase",
            Layer::Contacts => "contacts, normals, impulses",
            Layer::Frames => "frames",
            Layer::JointFrames => "joint frames",
            Layer::Limits => "joint limits",
        }
    }

    /// As `--layers` says it.
    #[must_use]
    pub fn flag(self) -> &'static str {
        match self {
            Layer::Aabbs => "aabbs",
            Layer::Cells => "cells",
            Layer::Contacts => "contacts",
            Layer::Frames => "frames",
            Layer::JointFrames => "joint-frames",
            Layer::Limits => "limits",
        }
    }
}
