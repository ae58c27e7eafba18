//! Objects that come and go, the same ones in every architecture: leaves of the tree that a seed
//! chooses are removed, and others come below parents that it chooses.

use ch00_scenes::random::SplitMix64;
use ch01_hierarchy::styles::items::{Item, scene};
use ch01_hierarchy::styles::living::Living;

/// The IDs of a world's objects.
pub struct People<Id> {
    items: Vec<Item>,
    /// In the order of the items: first those that have something below them, then the leaves. Who
    /// comes takes the place of one who went.
    pub ids: Vec<Id>,
    parents: usize,
    random: SplitMix64,
}

impl<Id: Copy> People<Id> {
    /// A world of `count` objects and their IDs.
    pub fn settle<S: Living<Id = Id>>(count: usize) -> (S, Self) {
        let items = scene(count);
        let (world, ids) = S::populate(&items);
        let parents = items
            .last()
            .and_then(|item| item.parent)
            .map_or(0, |last| last + 1);
        let people = Self {
            items,
            ids,
            parents,
            random: SplitMix64::new(2004),
        };
        (world, people)
    }

    /// What the world was built from.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// Places of `count` leaves, each at most once.
    pub fn choose(&mut self, count: usize) -> Vec<usize> {
        let leaves = self.ids.len() - self.parents;
        if count == 1 {
            return vec![self.parents + self.below(leaves)];
        }
        let mut places = Vec::with_capacity(count);
        let mut chosen = vec![false; leaves];
        while places.len() < count.min(leaves) {
            let place = self.below(leaves);
            if !std::mem::replace(&mut chosen[place], true) {
                places.push(self.parents + place);
            }
        }
        places
    }

    /// The IDs at these places.
    pub fn at(&self, places: &[usize]) -> Vec<Id> {
        places.iter().map(|&place| self.ids[place]).collect()
    }

    /// For each place, who comes there: an item, and the parent below which it comes.
    pub fn newcomers(&mut self, places: &[usize]) -> Vec<(Item, Id)> {
        let parents = self.parents;
        let newcomer = |&place: &usize| {
            let parent = self.ids[(self.random.next_u64() % parents as u64) as usize];
            (self.items[place], parent)
        };
        places.iter().map(newcomer).collect()
    }

    /// Those who came have these IDs.
    pub fn take_in(&mut self, places: &[usize], ids: &[Id]) {
        for (&place, &id) in places.iter().zip(ids) {
            self.ids[place] = id;
        }
    }

    /// IDs of `count` objects, drawn from all, some perhaps more than once.
    pub fn draw(&mut self, count: usize) -> Vec<Id> {
        let all = self.ids.len();
        let places: Vec<usize> = (0..count).map(|_| self.below(all)).collect();
        self.at(&places)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.random.next_u64() % end as u64) as usize
    }
}
