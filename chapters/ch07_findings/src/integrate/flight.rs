//! Bodies that fly far apart from each other, as objects and as columns, and what is timed on them: to
//! advance them by a step, to gather where they are, and to copy as many bytes.

use std::hint::black_box;
use std::time::Instant;

use ch00_scenes::random::SplitMix64;
use ch00_scenes::{Body, Scene, Settings, Shape};
use ch03_collision::{CollisionEngine, Rules};
use ch05_properties::data::Bodies;
use ch05_properties::plan::Plan;
use ch05_properties::world::{Method, World};
use glam::DVec3;

use super::{Sample, Way};
use crate::FindingsError;
use crate::lab::Spread;

/// s.
const DT: f32 = 1.0 / 60.0;
/// Between two bodies at the start, m.
const APART: f64 = 2.0;
/// A run goes through so many bodies at least, all of them once or several times.
const BODIES_A_RUN: usize = 50_000;
/// Runs of each way, in turn with the others.
const RUNS: usize = 15;
/// What a copy reads, and writes again, for each body: half of what advancing places reads and writes,
/// which is p and p* both ways, and 1/m.
const COPIED: usize = Way::ColumnsPlaces.bytes() / 2;

/// The same bodies in both layouts.
struct Flight {
    objects: CollisionEngine,
    columns: World,
}

/// Bodies on a lattice, which move in all directions; those that turn spin too.
fn scene(count: usize, turning: bool) -> Scene {
    let mut random = SplitMix64::new(1);
    let edge = (count as f64).cbrt().ceil() as usize;
    let body = |index: usize| {
        let place = [index % edge, index / edge % edge, index / edge / edge];
        let place = DVec3::from_array(place.map(|k| APART * k as f64));
        let spin = random.vector(3.0);
        Body {
            linear_velocity: random.vector(1.0),
            angular_velocity: if turning { spin } else { DVec3::ZERO },
            friction: 0.0,
            ..Body::new(Shape::Sphere { radius: 0.2 }, 30.0, place)
        }
    };
    let bodies = (0..count).map(body).collect();
    Scene {
        bodies,
        ..Scene::new("free flight")
    }
}

impl Flight {
    /// Loads the scene twice. No body can touch another: the columns are those of one alone.
    fn load(count: usize, turning: bool) -> Result<Self, FindingsError> {
        let scene = scene(count, turning);
        let (settings, method) = (Settings::defaults(), Method::Corrected);
        let alone = Scene {
            bodies: scene.bodies[..1].to_vec(),
            ..scene.clone()
        };
        let plan = Plan::of(&alone, method);
        let columns = World::load(&scene, method, Rules::default(), plan);
        Ok(Self {
            objects: CollisionEngine::load_bodies(&ch03_collision::ENGINE, &scene, &settings)?,
            columns: columns.expect("no force of this scene can be refused"),
        })
    }

    /// Whether both have the same bits.
    fn same(&self) -> Result<(), FindingsError> {
        let bodies = &self.columns.data.bodies;
        let off = self
            .objects
            .bodies()
            .iter()
            .enumerate()
            .find(|(row, body)| {
                let body = body.borrow();
                let (p, q) = (body.position(), body.orientation());
                // A column that isn't there stands for bodies that aren't turned.
                let turned = bodies.orientation.get(*row).copied().unwrap_or_default();
                bits(p.to_array()) != bits(bodies.position[*row].to_array())
                    || bits(q.to_array()) != bits(turned.to_array())
            });
        match off {
            None => Ok(()),
            Some((row, _)) => Err(FindingsError::Differs {
                chart: "integrate",
                scene: "free flight".to_owned(),
                run: "columns".to_owned(),
                what: format!("body {row}"),
            }),
        }
    }
}

fn bits<const N: usize>(numbers: [f32; N]) -> [u32; N] {
    numbers.map(f32::to_bits)
}

/// Advances so many bodies, in all ways.
///
/// # Errors
/// [`FindingsError`] where objects and columns come to different places.
pub fn measured(count: usize) -> Result<Vec<Sample>, FindingsError> {
    let mut samples = Vec::new();
    let Flight {
        mut objects,
        mut columns,
    } = Flight::load(count, true)?;
    let mut upload: Vec<[f32; 7]> = Vec::with_capacity(count);
    let mut bytes = Vec::with_capacity(28 * count);
    samples.extend(timed(
        count,
        &mut [
            (Way::Objects, &mut || objects.update_objects(DT)),
            (Way::Columns, &mut || columns.step(DT, |_, _| ())),
        ],
    ));
    samples.extend(timed(
        count,
        &mut [
            (Way::GatherObjects, &mut || {
                gather(&objects, black_box(&mut upload));
            }),
            (Way::GatherColumns, &mut || {
                copy_columns(&columns.data.bodies, black_box(&mut bytes));
            }),
        ],
    ));
    Flight { objects, columns }.same()?;

    let Flight {
        mut objects,
        mut columns,
    } = Flight::load(count, false)?;
    let source = vec![1_u8; COPIED * count];
    let mut target = vec![0_u8; COPIED * count];
    samples.extend(timed(
        count,
        &mut [
            (Way::ObjectsPlaces, &mut || objects.update_objects(DT)),
            (Way::ColumnsPlaces, &mut || columns.step(DT, |_, _| ())),
            (Way::Copy, &mut || {
                black_box(&mut target).copy_from_slice(black_box(&source));
            }),
        ],
    ));
    Flight { objects, columns }.same()?;
    Ok(samples)
}

/// Where every object is, one after the other, as an upload wants it.
fn gather(objects: &CollisionEngine, upload: &mut Vec<[f32; 7]>) {
    upload.clear();
    for body in objects.bodies() {
        let body = body.borrow();
        let ([x, y, z], [i, j, k, w]) = (body.position().into(), body.orientation().into());
        upload.push([x, y, z, i, j, k, w]);
    }
}

/// The same of columns, which lie as an upload wants them.
fn copy_columns(bodies: &Bodies, bytes: &mut Vec<u8>) {
    bytes.clear();
    bytes.extend_from_slice(bodies.position.bytes());
    bytes.extend_from_slice(bodies.orientation.bytes());
}

/// Times each way in turn. Before each run, one goes uncounted: what was in the caches is gone with the
/// way before. All ways are called equally often.
fn timed(count: usize, ways: &mut [(Way, &mut dyn FnMut())]) -> Vec<Sample> {
    let calls = (BODIES_A_RUN / count).max(1);
    let mut times = vec![Vec::new(); ways.len()];
    for _ in 0..RUNS {
        for ((_, call), times) in ways.iter_mut().zip(&mut times) {
            call();
            let start = Instant::now();
            for _ in 0..calls {
                call();
            }
            times.push(1e9 * start.elapsed().as_secs_f64() / (calls * count) as f64);
        }
    }
    let both = ways.iter().zip(&times);
    both.map(|((way, _), times)| Sample {
        way: *way,
        count,
        ns: Spread::of_all(times),
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_no_more_than_what_flies_needs() {
        for (turning, bytes) in [(false, 28), (true, 84)] {
            let flight = Flight::load(10, turning).expect("it loads");
            let systems: Vec<_> = flight.columns.plan.systems().map(|s| s.name).collect();
            let wanted = ["advance positions", "advance orientations"];
            assert_eq!(systems, wanted[..=usize::from(turning)]);
            let kept = ch05_properties::columns::AnyTable::row_bytes(&flight.columns.data.bodies);
            assert_eq!(kept, bytes);
        }
    }

    #[test]
    fn both_gather_the_same_bytes() {
        let Flight { objects, columns } = Flight::load(27, true).expect("it loads");
        let (mut rows, mut bytes) = (Vec::new(), Vec::new());
        gather(&objects, &mut rows);
        copy_columns(&columns.data.bodies, &mut bytes);
        assert_eq!(bytes.len(), 28 * 27);
        for (k, row) in rows.iter().enumerate() {
            let p = &bytes[12 * k..12 * k + 4];
            assert_eq!(p, row[0].to_ne_bytes());
            let q = &bytes[12 * 27 + 16 * k..12 * 27 + 16 * k + 4];
            assert_eq!(q, row[3].to_ne_bytes());
        }
    }

    #[test]
    fn after_many_steps_both_have_the_same_bits() {
        for turning in [false, true] {
            let mut flight = Flight::load(30, turning).expect("it loads");
            let start = flight.columns.data.bodies.position[29];
            for _ in 0..100 {
                flight.objects.update_objects(DT);
                flight.columns.step(DT, |_, _| ());
            }
            assert!(flight.columns.data.bodies.position[29].distance(start) > 0.1);
            flight.same().expect("they fly alike");
        }
    }
}
