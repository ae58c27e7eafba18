//! A level's frame: all gather before any updates, and what leaves leaves no trace.

use std::cell::RefCell;
use std::rc::Rc;

use ch01_hierarchy::{GameObject, Level, NodeId, SceneGraph, Shared, Transform};
use glam::Vec3;

/// Walks along x at 1 m/s, or stays one metre behind another.
struct Walker {
    node: NodeId,
    x: f32,
    ahead: Option<Shared<Walker>>,
    seen: f32,
}

impl Walker {
    fn add_to(level: &mut Level, x: f32, ahead: Option<Shared<Walker>>) -> Shared<Self> {
        let node = level.graph.add("walker", None, at(x));
        level.add(Self {
            node,
            x,
            ahead,
            seen: x,
        })
    }
}

impl GameObject for Walker {
    fn node(&self) -> NodeId {
        self.node
    }

    fn gather(&mut self) {
        if let Some(ahead) = &self.ahead {
            self.seen = ahead.borrow().x;
        }
    }

    fn update(&mut self, graph: &mut SceneGraph, dt: f32) {
        self.x = match self.ahead {
            Some(_) => self.seen - 1.0,
            None => self.x + dt,
        };
        graph.set_local(self.node, at(self.x));
    }
}

fn at(x: f32) -> Transform {
    Transform::from_translation(Vec3::X * x)
}

#[test]
fn a_frame_moves_the_object_and_its_node() {
    let mut level = Level::new();
    let walker = Walker::add_to(&mut level, 0.0, None);
    level.update(0.5);
    level.update(0.5);
    assert_eq!(walker.borrow().x, 1.0);
    assert_eq!(level.graph.world(walker.borrow().node).translation, Vec3::X);
}

#[test]
fn it_does_not_matter_who_was_added_first() {
    let mut level = Level::new();
    let early = Walker::add_to(&mut level, 0.0, None);
    let leader = Walker::add_to(&mut level, 10.0, None);
    let late = Walker::add_to(&mut level, 0.0, Some(leader.clone()));
    early.borrow_mut().ahead = Some(leader);
    for _ in 0..3 {
        level.update(0.25);
        assert_eq!(early.borrow().x, late.borrow().x);
    }
    // Both see the leader where it was a frame before: at 10.5 m.
    assert_eq!(early.borrow().x, 9.5);
}

#[test]
fn two_objects_may_look_at_each_other() {
    let mut level = Level::new();
    let one = Walker::add_to(&mut level, 0.0, None);
    let other = Walker::add_to(&mut level, 5.0, Some(one.clone()));
    one.borrow_mut().ahead = Some(other.clone());
    level.update(0.1);
    assert_eq!((one.borrow().x, other.borrow().x), (4.0, -1.0));
    // They hold each other, and nothing would ever free them: cut the ring.
    one.borrow_mut().ahead = None;
}

#[test]
fn a_removed_object_leaves_the_level_and_the_graph() {
    let mut level = Level::new();
    let leaves = Walker::add_to(&mut level, 0.0, None);
    let stays = Walker::add_to(&mut level, 5.0, None);
    let child = level.graph.add("hat", Some(leaves.borrow().node), at(0.5));
    assert!(level.remove(&leaves));
    assert!(!level.remove(&leaves), "it is gone already");
    level.update(1.0);
    assert_eq!((leaves.borrow().x, stays.borrow().x), (0.0, 6.0));
    assert_eq!(level.objects().len(), 1);
    assert_eq!(level.graph.len(), 2);
    assert_eq!(level.graph.world(child).translation, Vec3::X * 0.5);
}

#[test]
fn an_object_of_another_level_is_not_removed() {
    let (mut here, mut there) = (Level::new(), Level::new());
    Walker::add_to(&mut here, 0.0, None);
    let stranger = Walker::add_to(&mut there, 0.0, None);
    assert!(!here.remove(&stranger));
    assert_eq!((here.graph.len(), there.graph.len()), (1, 1));
}

#[test]
fn the_level_and_the_handle_share_one_object() {
    let mut level = Level::new();
    let walker = Walker::add_to(&mut level, 0.0, None);
    assert_eq!(Rc::strong_count(&walker), 2);
    RefCell::borrow_mut(&walker).x = 4.0;
    level.update(1.0);
    assert_eq!(walker.borrow().x, 5.0);
}

#[test]
fn several_objects_leave_in_one_go_and_the_others_keep_their_order() {
    let mut level = Level::new();
    let walkers = [0.0, 1.0, 2.0, 3.0].map(|x| Walker::add_to(&mut level, x, None));
    let nodes = [1, 3].map(|place: usize| walkers[place].borrow().node);
    level.remove_all(&nodes);
    level.remove_all(&nodes);
    level.update(1.0);
    let now: Vec<f32> = walkers.iter().map(|walker| walker.borrow().x).collect();
    assert_eq!(now, [1.0, 1.0, 3.0, 3.0]);
    assert_eq!((level.objects().len(), level.graph.len()), (2, 2));
}
