//! What is left around the bodies when one of them is taken out: the others keep their colours, and
//! a wall that is gone is not drawn any more.

use ch00_scenes::Scene;

use super::Surroundings;

/// Which body is which: its index in the scene as it was loaded, whatever was removed before it.
/// Bodies that were thrown in are numbered on from there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Numbers {
    /// The first bodies' numbers; after these come all that there are, one by one.
    first: Vec<usize>,
    removed: usize,
}

impl Numbers {
    /// The number of body `i`.
    pub fn of(&self, i: usize) -> usize {
        self.first.get(i).copied().unwrap_or(i + self.removed)
    }

    fn remove(&mut self, i: usize) {
        for next in self.first.len()..=i {
            self.first.push(next + self.removed);
        }
        self.first.remove(i);
        self.removed += 1;
    }
}

impl Surroundings {
    /// The index that body `i` had in the scene as it was loaded; of those thrown in, one that no
    /// body had.
    #[must_use]
    pub fn number(&self, i: usize) -> usize {
        self.numbers.of(i)
    }

    /// Body `i` is gone; `scene` is what is left, and `was_static` whether it may have been a wall.
    pub fn forget(&mut self, i: usize, was_static: bool, scene: &Scene) {
        self.numbers.remove(i);
        if !was_static {
            return;
        }
        let loaded = self.family.len();
        let mut left = scene.clone();
        let is_loaded = |i: &usize| self.number(*i) < loaded;
        left.bodies
            .truncate((0..scene.bodies.len()).take_while(is_loaded).count());
        let found = Self::of(&left);
        let mut is_scenery = vec![false; loaded];
        for (i, &is_wall) in found.is_scenery.iter().enumerate() {
            is_scenery[self.number(i)] = is_wall;
        }
        *self = Self {
            is_scenery,
            family: std::mem::take(&mut self.family),
            numbers: std::mem::take(&mut self.numbers),
            low: self.low,
            high: self.high,
            ..found
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_keep_their_numbers_when_those_before_them_go() {
        let mut numbers = Numbers::default();
        let mut bodies: Vec<usize> = (0..8).collect();
        for i in [2, 0, 5, 0, 3] {
            numbers.remove(i);
            bodies.remove(i);
            let named: Vec<usize> = (0..bodies.len()).map(|i| numbers.of(i)).collect();
            assert_eq!(named, bodies);
        }
        assert_eq!(numbers.of(3), 8, "the next one thrown in");
    }

    #[test]
    fn what_is_left_of_a_ragdoll_keeps_its_colour() {
        let mut scene = Scene::open("ragdolls", Some(2), None).expect("a built-in");
        let mut around = Surroundings::of(&scene);
        scene.joints.clear();
        scene.bodies.remove(6);
        around.forget(6, false, &scene);
        let of = |i| (around.number(i), around.family(i));
        assert_eq!([5, 6, 16].map(of), [(5, 5), (7, 5), (17, 17)]);
    }

    #[test]
    fn a_removed_wall_is_not_drawn_and_the_other_walls_stay_walls() {
        let mut scene = Scene::open("balls", Some(10), None).expect("a built-in");
        let mut around = Surroundings::of(&scene);
        let (walls, low) = (around.wall_faces.len(), around.low);
        let wall = (0..scene.bodies.len())
            .find(|&i| around.is_scenery(i) && scene.bodies[i].position.y > 0.1)
            .expect("balls fall into a box");
        let others = |around: &Surroundings, count: usize| {
            (0..count).filter(|&i| around.is_scenery(i)).count()
        };
        let before = others(&around, scene.bodies.len());
        scene.bodies.remove(wall);
        around.forget(wall, true, &scene);
        assert_eq!((around.wall_faces.len(), around.low), (walls - 1, low));
        let after = others(&around, scene.bodies.len());
        assert!(after < before && after >= walls - 1, "{after} of {before}");
        assert!(!around.is_scenery(wall) || around.number(wall) == wall + 1);
    }

    #[test]
    fn balls_thrown_in_are_no_part_of_the_walls_when_one_goes() {
        let mut scene = Scene::open("balls", Some(10), None).expect("a built-in");
        let mut around = Surroundings::of(&scene);
        let far = glam::DVec3::new(100.0, 5.0, 100.0);
        let ball = scene.bodies.last().expect("there are balls").clone();
        scene.bodies.push(ch00_scenes::Body {
            position: far,
            ..ball
        });
        scene.bodies.remove(0);
        around.forget(0, true, &scene);
        let thrown = scene.bodies.len() - 1;
        assert!(!around.is_scenery(thrown));
        assert_eq!(around.number(thrown), thrown + 1);
        assert!(!around.wall_faces.is_empty());
    }
}
