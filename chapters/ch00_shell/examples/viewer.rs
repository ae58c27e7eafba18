//! A viewer with an engine of its own: balls that fly, spin and bounce off the planes of
//! an open box. For looking at the window while chapters are not there yet.

use std::process::ExitCode;
use std::time::Duration;

use ch00_scenes::*;
use ch00_shell::Chapter;
use glam::*;

const ENGINE: EngineEntry = EngineEntry {
    name: "objects",
    chapter: "ch00_shell",
    methods: &[
        Method {
            name: "corrected",
            about: "flies",
        },
        Method {
            name: "printed",
            about: "flies",
        },
    ],
    load,
};

fn main() -> ExitCode {
    ch00_shell::main(&Chapter {
        name: "viewer",
        title: "Viewer",
        about: "Balls fly.",
        engines: &[ENGINE],
        default_scene: "balls",
        scenes: builtin::NAMES,
    })
}

struct Flying {
    scene: Scene,
    state: State,
    inner: Option<[f64; 2]>,
    pull: Option<Pull>,
    contacts: usize,
}

fn load(scene: &Scene, _: &Settings) -> Result<Box<dyn Engine>, LoadError> {
    Ok(Box::new(Flying {
        state: State::start_of(scene),
        inner: scene.meta_pair("inner_half_extents"),
        scene: scene.clone(),
        pull: None,
        contacts: 0,
    }))
}

impl Engine for Flying {
    fn info(&self) -> EngineInfo {
        EngineInfo {
            engine: "objects",
            method: "corrected",
            threads: 1,
            device: "cpu".into(),
            substeps: 1,
            sweeps: Some(4),
            real_size: 4,
            restitution_threshold: 0.0,
        }
    }
    fn step(&mut self, dt: f32) {
        let dt = f64::from(dt);
        self.contacts = 0;
        for i in 0..self.state.len() {
            let b = &self.scene.bodies[i];
            if b.is_static() {
                continue;
            }
            let s = &mut self.state;
            s.linear_velocity[i] += self.scene.gravity * dt;
            if let Some(p) = self.pull.filter(|p| p.body == i) {
                let at = s.position[i] + s.orientation[i] * p.anchor;
                let v = s.linear_velocity[i];
                s.linear_velocity[i] += (60.0 * (p.target - at) - 8.0 * v) * dt;
            }
            s.position[i] += s.linear_velocity[i] * dt;
            let w = s.angular_velocity[i];
            s.orientation[i] = (DQuat::from_scaled_axis(w * dt) * s.orientation[i]).normalize();
            let r = b.shape.bounding_radius();
            if let Some(inner) = self.inner {
                if s.position[i].y < r {
                    s.position[i].y = r;
                    s.linear_velocity[i].y = s.linear_velocity[i].y.abs() * 0.9;
                    self.contacts += 1;
                }
                for (axis, h) in [(0, inner[0]), (2, inner[1])] {
                    let p = s.position[i][axis];
                    if p.abs() > h - r {
                        s.position[i][axis] = p.signum() * (h - r);
                        s.linear_velocity[i][axis] *= -0.9;
                    }
                }
            }
        }
    }
    fn read_state(&self, state: &mut State) {
        state.clone_from(&self.state);
    }
    fn write_state(&mut self, state: &State, _: f32) {
        self.state.clone_from(state);
    }
    fn columns(&self) -> Vec<Column> {
        let v =
            |v: &[DVec3]| ColumnData::Vector(v.iter().map(|p| p.as_vec3().to_array()).collect());
        vec![
            Column {
                name: "position",
                unit: "m",
                about: "Where",
                data: v(&self.state.position),
            },
            Column {
                name: "linear velocity",
                unit: "m/s",
                about: "How fast",
                data: v(&self.state.linear_velocity),
            },
            Column {
                name: "orientation",
                unit: "",
                about: "Body to world",
                data: ColumnData::Quaternion(
                    self.state
                        .orientation
                        .iter()
                        .map(|q| q.as_quat().to_array())
                        .collect(),
                ),
            },
            Column {
                name: "mass",
                unit: "kg",
                about: "Mass",
                data: ColumnData::Scalar(self.scene.bodies.iter().map(|b| b.mass as f32).collect()),
            },
        ]
    }
    fn counters(&self) -> Counters {
        Counters {
            pairs: 0,
            contacts: self.contacts,
            overflow: 0,
        }
    }
    fn pass_times(&self) -> Vec<PassTime> {
        ["integrate", "broad step", "narrow step", "resolve"]
            .map(|name| PassTime {
                name,
                time: Duration::from_micros(10 * name.len() as u64),
            })
            .to_vec()
    }
    fn explain(&self) -> String {
        "Every body flies freely and bounces off the box's planes.".into()
    }
    fn layer(&self, layer: Layer) -> Vec<Line> {
        let mut lines = Vec::new();
        if layer != Layer::Aabbs {
            return lines;
        }
        for i in 0..self.state.len() {
            if self.scene.bodies[i].is_static() {
                continue;
            }
            let r = self.scene.bodies[i].shape.bounding_radius() as f32;
            let p = self.state.position[i].as_vec3();
            let c = |k: u32| {
                p + r * Vec3::new(
                    (k & 1) as f32 * 2.0 - 1.0,
                    (k >> 1 & 1) as f32 * 2.0 - 1.0,
                    (k >> 2) as f32 * 2.0 - 1.0,
                )
            };
            for k in 0..8u32 {
                for bit in [1, 2, 4] {
                    if k & bit == 0 {
                        lines.push(Line {
                            from: c(k).to_array(),
                            to: c(k | bit).to_array(),
                            color: [0.4, 0.8, 1.0],
                        });
                    }
                }
            }
        }
        lines
    }
    fn layers(&self) -> &'static [Layer] {
        &[Layer::Aabbs]
    }
    fn add_body(&mut self, b: &Body, _: f32) -> Added {
        self.scene.bodies.push(b.clone());
        self.state.push(
            b.position,
            b.orientation,
            b.linear_velocity,
            b.angular_velocity,
        );
        Ok(self.state.len() - 1)
    }
    fn pull(&mut self, pull: Option<Pull>) {
        self.pull = pull;
    }
}
