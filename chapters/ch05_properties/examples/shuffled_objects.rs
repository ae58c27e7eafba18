//! Exercise 1 of the page on columns: the objects of step 1 were made one after the other, and lie in
//! memory as they stand in the list. What if the list is in another order, as it is in a level where
//! objects have come and gone for an hour?

use std::cell::RefCell;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Instant;

use ch00_maths::f32::verlet;
use ch00_scenes::random::SplitMix64;
use ch01_hierarchy::Shared;
use glam::Vec3;

const COUNTS: [usize; 4] = [1_000, 10_000, 100_000, 1_000_000];
const RUNS: usize = 15;

/// A ball of step 1: what flies, and the rest.
struct Ball {
    p: Vec3,
    p_last: Vec3,
    _rest: [f32; 19],
}

fn main() {
    println!("balls      in order, ns/ball  shuffled, ns/ball  ratio");
    for count in COUNTS {
        let mut balls: Vec<Shared<Ball>> = (0..count)
            .map(|_| {
                Rc::new(RefCell::new(Ball {
                    p: Vec3::Y,
                    p_last: Vec3::Y,
                    _rest: [0.0; 19],
                }))
            })
            .collect();
        let in_order = median_time(&balls);
        shuffle(&mut balls);
        let shuffled = median_time(&balls);
        let ratio = shuffled / in_order;
        println!("{count:<10} {in_order:17.1} {shuffled:18.1} {ratio:6.1}");
    }
}

/// Time of `integrate` a ball, ns.
fn median_time(balls: &[Shared<Ball>]) -> f64 {
    let mut times = [0.0; RUNS];
    for time in &mut times {
        let start = Instant::now();
        integrate(balls, black_box(1.0 / 60.0));
        *time = start.elapsed().as_secs_f64() * 1e9 / balls.len() as f64;
    }
    times.sort_by(f64::total_cmp);
    times[RUNS / 2]
}

fn integrate(balls: &[Shared<Ball>], dt: f32) {
    for ball in balls {
        let mut ball = ball.borrow_mut();
        let (p, p_last) = (ball.p, ball.p_last);
        ball.p += verlet::displacement(p, p_last, Vec3::NEG_Y, 1.0, dt, dt);
        ball.p_last = p;
    }
}

/// Any order is as likely as any other [Fisher and Yates].
fn shuffle<T>(list: &mut [T]) {
    let mut random = SplitMix64::new(1);
    for place in (1..list.len()).rev() {
        let other = (random.unit() * (place + 1) as f64) as usize;
        list.swap(place, other);
    }
}
