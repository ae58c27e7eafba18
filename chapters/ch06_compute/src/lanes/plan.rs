//! What a step leaves out where nothing needs it.

// ANCHOR: part
/// A part of the step that is left out where nothing needs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Formulas for bodies of any shape, where two balls touch, or a ball and a box that stands.
    Shapes,
    /// Friction, where a pair has none.
    Friction,
    /// Room for four points, where a pair has fewer.
    Points,
    /// Passes for joints and for what pulls beyond gravity, where there are none.
    Joints,
}

/// All parts.
pub const PARTS: [Part; 4] = [Part::Shapes, Part::Friction, Part::Points, Part::Joints];

/// Which parts a step keeps although nothing needs them: none, unless it is measured what they cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Plan(u8);
// ANCHOR_END: part

impl Part {
    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shapes => "any shape",
            Self::Friction => "friction",
            Self::Points => "four points",
            Self::Joints => "joints and forces",
        }
    }

    /// Whether a run that keeps it has the bits of one that leaves it out. Else both are right to a rounding, or
    /// to what a plan of more points makes of them.
    #[must_use]
    pub fn keeps_bits(self) -> bool {
        matches!(self, Self::Friction | Self::Joints)
    }
}

impl Plan {
    /// All parts are kept.
    #[must_use]
    pub fn full() -> Self {
        PARTS.into_iter().fold(Self::default(), Self::with)
    }

    /// The same, and this part is kept. Pairs of balls have one point in their formulas: who keeps room for four
    /// has those for any shape.
    #[must_use]
    pub fn with(self, part: Part) -> Self {
        let shapes = match part {
            Part::Points => 1 << Part::Shapes as u8,
            _ => 0,
        };
        Self(self.0 | 1 << part as u8 | shapes)
    }

    /// Whether a part is computed although nothing needs it.
    #[must_use]
    pub fn keeps(self, part: Part) -> bool {
        self.0 >> part as u8 & 1 == 1
    }
}
