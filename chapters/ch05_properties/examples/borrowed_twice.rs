//! A ball that is hit passes half of the blow on to the next. As objects, a row of balls can do
//! that and a ring can't: the rule "one writer at a time" is looked up when the program runs, and
//! what it finds depends on the scene. As a column, both can, and the rule is the compiler's.

use std::cell::{BorrowMutError, RefCell};
use std::rc::{Rc, Weak};

use ch01_hierarchy::Shared;

/// A blow below this speed is not passed on, m/s.
const FAINT: f32 = 0.1;

// ANCHOR: objects
/// A ball that knows the next one.
#[derive(Default)]
struct Ball {
    speed: f32,
    next: Weak<RefCell<Ball>>,
}

/// The ball gets faster, and hits the next one.
fn hit(ball: &Shared<Ball>, blow: f32) -> Result<(), BorrowMutError> {
    let mut ball = ball.try_borrow_mut()?; // With borrow_mut() it would be a panic.
    ball.speed += blow;
    match ball.next.upgrade() {
        Some(next) if blow > FAINT => hit(&next, 0.5 * blow),
        _ => Ok(()),
    }
}
// ANCHOR_END: objects

// ANCHOR: columns
/// The same with a column of speeds and one of row numbers.
fn hit_row(speed: &mut [f32], next: &[Option<usize>], row: usize, blow: f32) {
    speed[row] += blow;
    if let Some(next_row) = next[row].filter(|_| blow > FAINT) {
        hit_row(speed, next, next_row, 0.5 * blow);
    }
}
// ANCHOR_END: columns

/// Hits the first of three balls as objects.
fn objects(next: &[Option<usize>]) -> String {
    let balls: Vec<Shared<Ball>> = next.iter().map(|_| Shared::default()).collect();
    for (ball, next) in balls.iter().zip(next) {
        if let Some(next) = next {
            ball.borrow_mut().next = Rc::downgrade(&balls[*next]);
        }
    }
    let outcome = match hit(&balls[0], 1.0) {
        Ok(()) => "fine".to_owned(),
        Err(error) => error.to_string(),
    };
    let speeds: Vec<f32> = balls.iter().map(|ball| ball.borrow().speed).collect();
    format!("{speeds:.2?} {outcome}")
}

/// Hits the first of three balls as rows.
fn columns(next: &[Option<usize>]) -> String {
    let mut speed = vec![0.0; next.len()];
    hit_row(&mut speed, next, 0, 1.0);
    format!("{speed:.2?} fine")
}

fn main() {
    let row = [Some(1), Some(2), None];
    let ring = [Some(1), Some(2), Some(0)];
    for (name, next) in [("a row", row), ("a ring", ring)] {
        println!("{name:7} as objects  {}", objects(&next));
        println!("{name:7} as columns  {}", columns(&next));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_of_objects_borrows_the_first_one_twice() {
        assert!(objects(&[Some(1), None]).ends_with("fine"));
        assert!(!objects(&[Some(1), Some(0)]).ends_with("fine"));
    }

    #[test]
    fn a_ring_of_rows_is_hit_until_the_blow_is_faint() {
        let mut speed = [0.0; 2];
        hit_row(&mut speed, &[Some(1), Some(0)], 0, 1.0);
        assert_eq!(speed, [1.0 + 0.25 + 0.0625, 0.5 + 0.125]);
    }
}
