//! Scenes by name, and as JSON files in and out.

use std::path::Path;

use crate::{Joint, Scene, SceneError, builtin};

impl Scene {
    /// The scene that `--scene` asks for: a path that ends in `.json` is a file, anything
    /// else the name of a built-in one, which `count` and `seed` may scale.
    ///
    /// # Errors
    /// Everything that [`Scene::load`] and [`builtin::build`] can answer, and
    /// [`SceneError::Flag`] for a count or a seed beside a file.
    pub fn open(
        name_or_path: &str,
        count: Option<u64>,
        seed: Option<u64>,
    ) -> Result<Self, SceneError> {
        let path = Path::new(name_or_path);
        if path.extension().is_none_or(|ending| ending != "json") {
            return builtin::build(name_or_path, count, seed);
        }
        for (flag, given) in [("count", count), ("seed", seed)] {
            if given.is_some() {
                return Err(SceneError::Flag {
                    scene: name_or_path.to_owned(),
                    flag,
                    why: "a file lists its bodies one by one".to_owned(),
                });
            }
        }
        Self::load(path)
    }

    /// Reads and checks a scene file.
    ///
    /// # Errors
    /// [`SceneError::Read`] and everything that [`Scene::from_json`] can answer.
    pub fn load(path: &Path) -> Result<Self, SceneError> {
        let text = std::fs::read_to_string(path).map_err(|source| SceneError::Read {
            file: path.to_owned(),
            source,
        })?;
        Self::from_json(&text, &path.display().to_string())
    }

    /// Reads and checks a scene; `file` is what errors call it. Quaternions and axes
    /// that are nearly of unit length are made so.
    ///
    /// # Errors
    /// [`SceneError::Parse`] with the place for text that is no scene, unknown fields
    /// among it; [`SceneError::Value`] and [`SceneError::SceneValue`] for values that no
    /// engine can simulate.
    pub fn from_json(text: &str, file: &str) -> Result<Self, SceneError> {
        let parse_error = |path: String, source| SceneError::Parse {
            file: file.into(),
            path,
            source,
        };
        let mut json = serde_json::Deserializer::from_str(text);
        let mut scene: Scene = serde_path_to_error::deserialize(&mut json)
            .map_err(|error| parse_error(error.path().to_string(), error.into_inner()))?;
        json.end()
            .map_err(|source| parse_error("after the scene".to_owned(), source))?;
        scene.validate(file)?;
        scene.normalise();
        Ok(scene)
    }

    /// The scene as JSON text, every number with all the digits that it needs to come
    /// back the same.
    ///
    /// # Panics
    /// Never: every key of a scene is text, and numbers, even those that are not finite,
    /// can always be written.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("all keys are text")
    }

    /// Gives every quaternion and axis unit length. Those that have it up to rounding
    /// stay as they are, so that a file that we wrote reads back the same.
    fn normalise(&mut self) {
        for body in &mut self.bodies {
            if !is_unit(body.orientation.length()) {
                body.orientation = body.orientation.normalize();
            }
        }
        for joint in &mut self.joints {
            match joint {
                Joint::Ball {
                    rest: Some(rest), ..
                } if !is_unit(rest.length()) => *rest = rest.normalize(),
                Joint::Hinge { axis_a, axis_b, .. } => {
                    for axis in [axis_a, axis_b] {
                        if !is_unit(axis.length()) {
                            *axis = axis.normalize();
                        }
                    }
                }
                Joint::Ball { .. } | Joint::Distance { .. } => {}
            }
        }
    }
}

fn is_unit(length: f64) -> bool {
    (length - 1.0).abs() < 1e-12
}
