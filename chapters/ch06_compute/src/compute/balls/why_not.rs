//! Which scenes are not balls among walls.

use ch00_scenes::Scene;

use crate::bodies::Bodies;

/// Largest ratio of radii: a ball of three times the radius is touched by up to 57 small ones, and there must
/// be as much room for every ball.
const MOST_RATIO: f32 = 3.01;

/// Most walls: every ball looks at each.
const MOST_WALLS: usize = 64;

/// Why this scene is not one of balls among walls; None if it is.
#[must_use]
pub fn why_not(scene: &Scene, bodies: &Bodies) -> Option<&'static str> {
    let walls = (0..bodies.rows())
        .filter(|&row| bodies.is_static(row))
        .count();
    let moving = |row: &usize| !bodies.is_static(*row);
    let ball = |row: usize| bodies.solid[row].kind == 0;
    let wall = |row: usize| bodies.solid[row].kind <= 1;
    let reaches = || {
        (0..bodies.rows())
            .filter(moving)
            .map(|row| bodies.place[row].reach)
    };
    if !scene.joints.is_empty() || !scene.forces.is_empty() {
        return Some("it has joints or forces");
    }
    if !(0..bodies.rows()).filter(moving).all(ball) {
        return Some("not all that moves is a ball");
    }
    if !(0..bodies.rows()).filter(|row| !moving(row)).all(wall) {
        return Some("not all that stays is a ball or a box");
    }
    if walls > MOST_WALLS {
        return Some("it has too many static bodies");
    }
    let narrowest = reaches().fold(f32::INFINITY, f32::min);
    let has_large = reaches().any(|reach| reach > MOST_RATIO * narrowest);
    has_large.then_some("one ball is much larger than another: too many can touch it")
}
