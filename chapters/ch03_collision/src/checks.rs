//! What this chapter models so far: which scenes it takes and which it must refuse.

use ch00_maths::f32::shape::Shape;
use ch00_scenes::{LoadError, Scene, Settings};
use ch01_hierarchy::Shared;
use ch02_rigid_bodies::RigidBody;

use crate::ENGINE;
use crate::narrow::is_known;

/// Whether every pair of bodies that could meet has a narrow phase.
///
/// # Errors
/// [`LoadError::Unsupported`] that names the body.
pub fn check_shapes(scene: &Scene, bodies: &[Shared<RigidBody>]) -> Result<(), LoadError> {
    for (i, body) in bodies.iter().enumerate() {
        let body = body.borrow();
        if body.is_held() || body.is_static() {
            continue;
        }
        for other in bodies {
            if std::rc::Rc::ptr_eq(&bodies[i], other) || other.borrow().is_held() {
                continue;
            }
            let other = other.borrow();
            if !is_known(body.collider(), other.collider()) {
                let what = format!(
                    "{} against {} is not modelled yet, only balls against balls and boxes; \
                     chapter 2 (ch02_rigid_bodies) runs it without collisions",
                    name(body.collider()),
                    name(other.collider()),
                );
                return Err(unsupported(scene, what, Some(i)));
            }
        }
    }
    Ok(())
}

/// The error for something that this engine doesn't model.
pub fn unsupported(scene: &Scene, what: String, index: Option<usize>) -> LoadError {
    LoadError::Unsupported {
        engine: ENGINE.name,
        chapter: ENGINE.chapter,
        scene: scene.name.clone(),
        what,
        index,
    }
}

/// Refuses settings that mean nothing to this engine.
///
/// # Errors
/// [`LoadError::Setting`] that says why.
pub fn check_settings(method: &'static str, settings: &Settings) -> Result<(), LoadError> {
    let sweeps = match (method, settings.sweeps) {
        ("printed", Some(n)) if n != 1 => Some((n, "the report resolves every contact once")),
        (_, Some(0)) => Some((0, "at least one sweep is needed")),
        (_, Some(n)) if n > 10_000 => Some((n, "more than 10000 sweeps is surely a slip")),
        _ => None,
    };
    let refused = [
        ("sweeps", sweeps),
        (
            "substeps",
            settings
                .substeps
                .filter(|&n| n != 1)
                .map(|n| (n, "this method makes whole steps")),
        ),
        (
            "threads",
            settings
                .threads
                .filter(|&n| n != 1)
                .map(|n| (n, "this engine has one thread")),
        ),
    ];
    for (setting, refused) in refused {
        if let Some((value, why)) = refused {
            return Err(LoadError::Setting {
                method,
                setting,
                value: value.to_string(),
                why: why.to_owned(),
            });
        }
    }
    Ok(())
}

fn name(shape: &Shape) -> &'static str {
    match shape {
        Shape::Sphere { .. } => "a ball",
        Shape::Box { .. } => "a box",
        Shape::Capsule { .. } => "a capsule",
        Shape::Cylinder { .. } => "a cylinder",
    }
}
