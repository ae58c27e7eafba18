//! What every architecture is asked to do, and a world that can be asked.

use std::hint::black_box;

use ch01_hierarchy::styles::living::Living;
use ch01_hierarchy::styles::{Style, components, hierarchy, hybrid};
use glam::{Vec3, Vec4};

use crate::people::People;
use crate::{DT, ecs, properties};

/// How bright is bright: the middle of the scene's glows, about.
const THRESHOLD: f32 = 1.0;

/// What a world is asked to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// One frame.
    Update,
    /// The column of world positions, ready for upload.
    Gather,
    /// How many glow brighter than something: one property of all.
    Count,
    /// World positions of IDs in no order.
    Position,
    /// Places in the parent and in the world, of IDs in no order.
    Frames,
    /// Leaves below parents in no order, a hundredth of all.
    Insert,
    /// Leaves in no order, a hundredth of all in one go.
    Remove,
    /// One leaf, and all is in order again.
    RemoveOne,
    /// One frame, when all of the above has replaced objects, and a quarter of all once more.
    AgedUpdate,
}

impl Operation {
    /// In the order in which they are measured.
    pub const ALL: [Self; 9] = [
        Self::Update,
        Self::Gather,
        Self::Count,
        Self::Position,
        Self::Frames,
        Self::Insert,
        Self::Remove,
        Self::RemoveOne,
        Self::AgedUpdate,
    ];

    /// Those that leave the world as it was, but for the time.
    pub const LASTING: [Self; 5] = [
        Self::Update,
        Self::Gather,
        Self::Count,
        Self::Position,
        Self::Frames,
    ];

    /// The panels of the book's charts.
    pub const OVER_ALL: [Self; 4] = [Self::Update, Self::AgedUpdate, Self::Gather, Self::Count];
    pub const OF_ONE: [Self; 2] = [Self::Position, Self::Frames];
    pub const OF_CHANGE: [Self; 3] = [Self::Insert, Self::Remove, Self::RemoveOne];

    /// In the CSV and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Update => "update",
            Self::Gather => "gather",
            Self::Count => "count",
            Self::Position => "position",
            Self::Frames => "frames",
            Self::Insert => "insert",
            Self::Remove => "remove",
            Self::RemoveOne => "remove_one",
            Self::AgedUpdate => "aged_update",
        }
    }

    /// In tables and charts: what was done, and what one of it is.
    pub fn label(self) -> &'static str {
        match self {
            Self::Update => "update, an object",
            Self::Gather => "gather positions, an object",
            Self::Count => "count who glows, an object",
            Self::Position => "position by ID, a read",
            Self::Frames => "both frames by ID, a read",
            Self::Insert => "insert, an object",
            Self::Remove => "remove 1 % at once, an object",
            Self::RemoveOne => "remove one, an object",
            Self::AgedUpdate => "update after changes, an object",
        }
    }
}

/// Bytes of the records that a pass visits, on average over the objects.
#[derive(Clone, Copy)]
pub struct Visited {
    pub update: usize,
    pub gather: usize,
    pub count: usize,
}

/// A world of some architecture, as those who measure see it.
pub trait Subject {
    fn name(&self) -> &'static str;

    fn visited(&self) -> Visited;

    /// Carries out one of [`Operation::LASTING`]; gives how many objects or reads it was.
    fn carry_out(&mut self, operation: Operation) -> usize;

    /// Removes `count` leaves and inserts as many. `time` is called with each of the two.
    fn replace(&mut self, count: usize, time: &mut dyn FnMut(Operation, &mut dyn FnMut()));
}

/// In the order of all tables.
pub const NAMES: [&str; 5] = [
    hierarchy::World::NAME,
    components::World::NAME,
    hybrid::World::NAME,
    properties::World::NAME,
    ecs::World::NAME,
];

/// All five, with `count` objects each.
pub fn subjects(count: usize) -> [Box<dyn Subject>; 5] {
    [
        subject::<hierarchy::World>(count),
        subject::<components::World>(count),
        subject::<hybrid::World>(count),
        subject::<properties::World>(count),
        subject::<ecs::World>(count),
    ]
}

/// The one of this name; None if there is no such.
pub fn subject_named(name: &str, count: usize) -> Option<Box<dyn Subject>> {
    Some(match NAMES.iter().position(|known| *known == name)? {
        0 => subject::<hierarchy::World>(count),
        1 => subject::<components::World>(count),
        2 => subject::<hybrid::World>(count),
        3 => subject::<properties::World>(count),
        _ => subject::<ecs::World>(count),
    })
}

fn subject<S: Living + 'static>(count: usize) -> Box<dyn Subject> {
    let (mut world, mut people) = People::<S::Id>::settle::<S>(count);
    // What grows with the first frame has grown, and what glows has begun to.
    for _ in 0..30 {
        world.update(DT);
    }
    Box::new(Inhabited::<S> {
        world,
        drawn: people.draw(count.max(1_000)),
        people,
        column: Vec::new(),
    })
}

struct Inhabited<S: Living> {
    world: S,
    people: People<S::Id>,
    /// IDs in no order, to be read.
    drawn: Vec<S::Id>,
    column: Vec<[f32; 3]>,
}

impl<S: Living> Subject for Inhabited<S> {
    fn name(&self) -> &'static str {
        S::NAME
    }

    fn visited(&self) -> Visited {
        let items = self.people.items();
        let bytes = S::bytes(items);
        Visited {
            update: bytes.update / items.len(),
            gather: bytes.gather / items.len(),
            count: S::bytes_to_count(items) / items.len(),
        }
    }

    fn carry_out(&mut self, operation: Operation) -> usize {
        match operation {
            Operation::Update | Operation::AgedUpdate => self.world.update(DT),
            Operation::Gather => {
                self.world.gather_positions(&mut self.column);
                black_box(&self.column);
            }
            Operation::Count => {
                black_box(self.world.count_brighter(black_box(THRESHOLD)));
            }
            Operation::Position => {
                let mut sum = Vec3::ZERO;
                for &id in &self.drawn {
                    sum += self.world.position(id).unwrap_or_default();
                }
                black_box(sum);
                return self.drawn.len();
            }
            Operation::Frames => {
                let mut sum = (Vec3::ZERO, Vec4::ZERO);
                for &id in &self.drawn {
                    if let Some((local, global)) = self.world.frames(id) {
                        sum.0 += local.translation + global.translation;
                        sum.1 += Vec4::from(local.rotation) + Vec4::from(global.rotation);
                    }
                }
                black_box(sum);
                return self.drawn.len();
            }
            Operation::Insert | Operation::Remove | Operation::RemoveOne => {
                unreachable!("what changes who is there goes through `replace`")
            }
        }
        self.people.ids.len()
    }

    fn replace(&mut self, count: usize, time: &mut dyn FnMut(Operation, &mut dyn FnMut())) {
        let (world, people) = (&mut self.world, &mut self.people);
        let places = people.choose(count);
        let gone = people.at(&places);
        let newcomers = people.newcomers(&places);
        time(Operation::Remove, &mut || world.remove(&gone));
        let mut ids = Vec::with_capacity(count);
        time(Operation::Insert, &mut || {
            ids.extend(
                newcomers
                    .iter()
                    .map(|(item, parent)| world.insert(item, *parent)),
            );
        });
        people.take_in(&places, &ids);
    }
}
