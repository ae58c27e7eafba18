//! The columns between which the state of balls goes back and forth: which holds what now, and which a kernel
//! binds.

/// Which of two columns holds what is true now.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sides {
    pub places: usize,
    pub movers: usize,
    /// What holds balls.
    pub helds: usize,
    /// Attitudes, what stays with a ball, and the lists of neighbours: they change once a step.
    pub step: usize,
}

/// The names of the columns that hold the state now.
#[derive(Clone, Copy, Debug)]
pub struct Names {
    /// Where balls are.
    pub places: &'static str,
    /// How they move.
    pub movers: &'static str,
    /// How they are turned.
    pub attitudes: &'static str,
    /// What stays with them.
    pub balls: &'static str,
}

const PLACES: [&str; 2] = ["places_a", "places_b"];
const MOVERS: [&str; 2] = ["movers_a", "movers_b"];
const ATTITUDES: [&str; 2] = ["attitudes_a", "attitudes_b"];
const BALLS: [&str; 2] = ["balls_a", "balls_b"];
const HELDS: [&str; 2] = ["helds_a", "helds_b"];
const COUNTS: [&str; 2] = ["neighbour_counts_a", "neighbour_counts_b"];
const NEIGHBOURS: [&str; 2] = ["neighbours_a", "neighbours_b"];
const IMPULSES: [&str; 2] = ["impulses_a", "impulses_b"];

impl Sides {
    /// All ways in which they can stand, by their numbers.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..16).map(|way| Self {
            helds: way >> 3 & 1,
            places: way >> 2 & 1,
            movers: way >> 1 & 1,
            step: way & 1,
        })
    }

    /// The number of the way in which they stand.
    #[must_use]
    pub fn number(self) -> usize {
        8 * self.helds + 4 * self.places + 2 * self.movers + self.step
    }

    /// What was next is now.
    pub fn flip(&mut self) {
        self.places ^= 1;
        self.movers ^= 1;
        self.helds ^= 1;
    }

    /// The columns that hold the state now.
    #[must_use]
    pub fn names(self) -> Names {
        Names {
            places: PLACES[self.places],
            movers: MOVERS[self.movers],
            attitudes: ATTITUDES[self.step],
            balls: BALLS[self.step],
        }
    }
}

/// What a kernel binds: its binding's name and a column's.
pub type Naming = Vec<(&'static str, &'static str)>;

/// The slots of balls.
pub fn name_cells(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
    ]
}

/// Rows, moved into the order of the grid.
pub fn name_sort(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("attitudes", ATTITUDES[s.step]),
        ("balls", BALLS[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
        ("attitudes_next", ATTITUDES[s.step ^ 1]),
        ("balls_next", BALLS[s.step ^ 1]),
    ]
}

/// Neighbours, and what the last step pressed.
pub fn name_meet(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("last_counts", COUNTS[s.step ^ 1]),
        ("last_neighbours", NEIGHBOURS[s.step ^ 1]),
        ("last_impulses", IMPULSES[s.step ^ 1]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("impulses", IMPULSES[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
        ("helds_next", HELDS[s.helds ^ 1]),
    ]
}

/// A substep.
pub fn name_solve(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("impulses", IMPULSES[s.step]),
        ("places_next", PLACES[s.places ^ 1]),
        ("movers_next", MOVERS[s.movers ^ 1]),
        ("attitudes", ATTITUDES[s.step]),
        ("helds", HELDS[s.helds]),
        ("helds_next", HELDS[s.helds ^ 1]),
    ]
}

/// Restitution.
pub fn name_bounce(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("balls", BALLS[s.step]),
        ("neighbour_counts", COUNTS[s.step]),
        ("neighbours", NEIGHBOURS[s.step]),
        ("movers_next", MOVERS[s.movers ^ 1]),
    ]
}

/// What is drawn.
pub fn name_state(s: Sides) -> Naming {
    vec![
        ("places", PLACES[s.places]),
        ("movers", MOVERS[s.movers]),
        ("attitudes", ATTITUDES[s.step]),
        ("balls", BALLS[s.step]),
    ]
}
