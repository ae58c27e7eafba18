//! What stands around the moving bodies, found once when a scene is loaded: which static
//! boxes are walls (drawn as glass, so that they hide nothing), how high the ground is, and
//! the box about everything that a camera should see at the start.

mod extent;
mod removal;

use ch00_scenes::{Body, Scene, Shape};
use glam::{DMat3, DVec3, Vec3};

use extent::{box_about, paths_box, worth_seeing};
use removal::Numbers;

/// A rectangle in the world with a side to look at it from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Its middle, m.
    pub centre: Vec3,
    /// Unit vector out of the side to look at.
    pub normal: Vec3,
    /// Half of its width, m.
    pub across: Vec3,
    /// Half of its height, m.
    pub up: Vec3,
}

/// What stands around the moving bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Surroundings {
    /// Which bodies of the scene as loaded are left.
    numbers: Numbers,
    /// For each body of the scene as loaded: whether it is drawn as a wall or as the ground.
    is_scenery: Vec<bool>,
    /// For each body of the scene as loaded: whose colour it has. Bodies that joints connect share one.
    family: Vec<usize>,
    /// The inner faces of the walls.
    pub wall_faces: Vec<Face>,
    /// Whether anything static but walls is there.
    pub has_floor: bool,
    /// Height at which the ground is drawn, m.
    pub ground_height: f32,
    /// Whether anything with edges is drawn as a body: all but balls.
    pub has_edges: bool,
    /// Lower corner of the box to see at the start, m.
    pub low: Vec3,
    /// Upper corner of the box to see at the start, m.
    pub high: Vec3,
}

impl Surroundings {
    /// Whose colour body `i` has, as a number like [`Self::number`]: the first body of those that
    /// joints connect it with; itself if it was added later.
    #[must_use]
    pub fn family(&self, i: usize) -> usize {
        let number = self.number(i);
        self.family.get(number).copied().unwrap_or(number)
    }

    /// Looks at the scene as it starts.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let bodies = &scene.bodies;
        let moving: Vec<&Body> = bodies.iter().filter(|body| !body.is_static()).collect();
        let moving_box = paths_box(scene, &moving);
        let faces: Vec<Option<Face>> = bodies
            .iter()
            .map(|body| wall_face(body, &moving, moving_box))
            .collect();
        let is_floor = |(body, face): &(&Body, &Option<Face>)| body.is_static() && face.is_none();
        let floors: Vec<&Body> = bodies
            .iter()
            .zip(&faces)
            .filter(is_floor)
            .map(|(body, _)| body)
            .collect();
        let wall_faces = trimmed(&faces.iter().flatten().copied().collect::<Vec<_>>());
        let enclosed = enclosed_floor(&floors, &wall_faces);
        let is_scenery: Vec<bool> = bodies
            .iter()
            .zip(&faces)
            .map(|(body, face)| face.is_some() || enclosed.is_some_and(|f| std::ptr::eq(f, body)))
            .collect();
        let has_edge = |(body, is_scenery): (&Body, &bool)| {
            !is_scenery && !matches!(body.shape, Shape::Sphere { .. })
        };
        let (low, high) = worth_seeing(scene, moving_box, &floors, &wall_faces);
        Self {
            has_edges: bodies.iter().zip(&is_scenery).any(has_edge),
            numbers: Numbers::default(),
            is_scenery,
            family: families(scene),
            wall_faces,
            has_floor: !floors.is_empty(),
            ground_height: ground_height(&floors, enclosed, (high - low).length())
                .unwrap_or(low.y - 0.25 * (high.y - low.y)),
            low,
            high,
        }
    }

    /// Whether body `i` is drawn as a wall or as the ground. Bodies thrown in never are.
    #[must_use]
    pub fn is_scenery(&self, i: usize) -> bool {
        let number = self.number(i);
        self.is_scenery.get(number).copied().unwrap_or(false)
    }

    /// The middle of the box to see at the start, m.
    #[must_use]
    pub fn centre(&self) -> Vec3 {
        0.5 * (self.low + self.high)
    }

    /// Radius of the sphere about the box to see at the start, m.
    #[must_use]
    pub fn radius(&self) -> f32 {
        (0.5 * (self.high - self.low).length()).max(0.05)
    }
}

/// The faces without what lies behind other walls, where these stand at right angles.
fn trimmed(faces: &[Face]) -> Vec<Face> {
    let trim = |face: &Face| {
        let width = face.across.length();
        let along = face.across / width;
        let (mut from, mut to) = (-width, width);
        for other in faces {
            let slope = other.normal.dot(along);
            if slope.abs() > 0.999 {
                let at = (other.centre - face.centre).dot(along);
                if slope > 0.0 {
                    from = from.max(at);
                } else {
                    to = to.min(at);
                }
            }
        }
        Face {
            centre: face.centre + f32::midpoint(from, to) * along,
            across: 0.5 * (to - from).max(0.0) * along,
            ..*face
        }
    };
    faces.iter().map(trim).collect()
}

/// The floor between walls: nothing can fall off it, so that it needs no edge and the ground
/// can be drawn in its place.
fn enclosed_floor<'a>(floors: &[&'a Body], walls: &[Face]) -> Option<&'a Body> {
    let is_level = |floor: &Body| {
        let up = floor.orientation * DVec3::Y;
        matches!(floor.shape, Shape::Box { .. }) && up.y > 0.9999
    };
    match floors {
        [floor] if walls.len() >= 4 => Some(*floor).filter(|floor| is_level(floor)),
        _ => None,
    }
}

/// The height of the ground, m: the top of a floor between walls; otherwise a little below the
/// top of the lowest floor, so that this stands out as a thin plate.
fn ground_height(floors: &[&Body], enclosed: Option<&Body>, size: f32) -> Option<f32> {
    if let Some(floor) = enclosed {
        return Some(box_about(&[floor]).1.as_vec3().y);
    }
    let plate = |floor: &&Body| {
        let (low, high) = box_about(&[floor]);
        let (low, high) = (low.as_vec3().y, high.as_vec3().y);
        low.max(high - 0.02 * size)
    };
    floors.iter().map(plate).min_by(f32::total_cmp)
}

/// The inner face of a body that is a wall: a static box with an upright face which has all
/// moving bodies in front of it and is about as wide as they are spread.
fn wall_face(body: &Body, moving: &[&Body], moving_box: (DVec3, DVec3)) -> Option<Face> {
    let Shape::Box { half_extents } = body.shape else {
        return None;
    };
    if !body.is_static() || moving.is_empty() {
        return None;
    }
    let axes = DMat3::from_quat(body.orientation);
    let spread = moving_box.1 - moving_box.0;
    for axis in 0..3 {
        for sign in [-1.0, 1.0] {
            let normal = sign * axes.col(axis);
            let centre = body.position + normal * half_extents[axis];
            let is_upright = normal.y.abs() < 0.5;
            let holds_all = || {
                moving
                    .iter()
                    .all(|other| (other.position - centre).dot(normal) > 0.0)
            };
            let (across, up) = edges(&axes, half_extents, axis);
            let is_wide = 2.5 * across.length() > spread.x.max(spread.z);
            let is_high = 4.0 * up.length() > spread.y;
            if is_upright && is_wide && is_high && holds_all() {
                return Some(Face {
                    centre: centre.as_vec3(),
                    normal: normal.as_vec3(),
                    across: across.as_vec3(),
                    up: up.as_vec3(),
                });
            }
        }
    }
    None
}

/// Half of the width and half of the height of the box's face across `axis`.
fn edges(axes: &DMat3, half_extents: DVec3, axis: usize) -> (DVec3, DVec3) {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let a = axes.col(i) * half_extents[i];
    let b = axes.col(j) * half_extents[j];
    if axes.col(i).y.abs() < axes.col(j).y.abs() {
        (a, b)
    } else {
        (b, a)
    }
}

/// For each body the first of those that joints connect it with. What can't move connects nothing.
fn families(scene: &Scene) -> Vec<usize> {
    let mut family: Vec<usize> = (0..scene.bodies.len()).collect();
    let first = |family: &[usize], mut i: usize| {
        while family[i] != i {
            i = family[i];
        }
        i
    };
    for joint in &scene.joints {
        let (a, b) = joint.bodies();
        if !scene.bodies[a].is_static() && !scene.bodies[b].is_static() {
            let (a, b) = (first(&family, a), first(&family, b));
            family[a.max(b)] = a.min(b);
        }
    }
    (0..family.len()).map(|i| first(&family, i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open_box_with_balls() -> Scene {
        let mut scene = Scene::new("box");
        let mut add_static = |half_extents, position| {
            let shape = Shape::Box { half_extents };
            scene.bodies.push(Body::new(shape, 0.0, position));
        };
        add_static(DVec3::new(2.0, 0.5, 2.0), DVec3::new(0.0, -0.5, 0.0));
        add_static(DVec3::new(0.5, 5.0, 2.0), DVec3::new(2.0, 5.0, 0.0));
        add_static(DVec3::new(0.5, 5.0, 2.0), DVec3::new(-2.0, 5.0, 0.0));
        for x in [-1.0, 0.0, 1.0] {
            let ball = Shape::Sphere { radius: 0.2 };
            scene
                .bodies
                .push(Body::new(ball, 1.0, DVec3::new(x, 1.0, 0.0)));
        }
        scene
    }

    #[test]
    fn what_joints_connect_is_a_family_and_what_stands_still_is_not() {
        let scene = ch00_scenes::builtin::build("ragdolls", Some(2), None).unwrap();
        let around = Surroundings::of(&scene);
        assert!((5..17).all(|i| around.family(i) == 5));
        assert!((17..29).all(|i| around.family(i) == 17));
        let door = ch00_scenes::builtin::build("door", None, None).unwrap();
        let around = Surroundings::of(&door);
        assert_eq!([0, 1, 2].map(|i| around.family(i)), [0, 1, 2]);
    }

    #[test]
    fn a_tall_stack_in_a_narrow_box_is_seen_where_it_lands() {
        let scene = ch00_scenes::builtin::build("ragdolls", Some(8), None).unwrap();
        let around = Surroundings::of(&scene);
        let size = around.high - around.low;
        assert!(size.y <= 3.0 * size.x, "{size}");
    }

    #[test]
    fn upright_boxes_around_the_balls_are_walls_and_the_floor_is_not() {
        let found = Surroundings::of(&open_box_with_balls());
        let walls: Vec<bool> = (0..6).map(|i| found.is_scenery(i)).collect();
        assert_eq!(walls, [false, true, true, false, false, false]);
        assert!(found.has_floor);
        assert_eq!(found.wall_faces[0].normal, Vec3::NEG_X);
        assert!(found.ground_height < 0.0 && found.ground_height > -0.2);
    }

    #[test]
    fn a_floor_between_four_walls_is_drawn_as_the_ground() {
        let mut scene = open_box_with_balls();
        for z in [-2.0, 2.0] {
            let half_extents = DVec3::new(2.0, 5.0, 0.5);
            let wall = Shape::Box { half_extents };
            scene
                .bodies
                .push(Body::new(wall, 0.0, DVec3::new(0.0, 5.0, z)));
        }
        let found = Surroundings::of(&scene);
        assert!(found.is_scenery(0) && !found.has_edges);
        assert!(found.ground_height.abs() < 1e-6);
    }

    #[test]
    fn a_block_among_the_balls_is_no_wall() {
        let mut scene = open_box_with_balls();
        scene.bodies[1].position = DVec3::new(0.5, 5.0, 0.0);
        scene.bodies[1].shape = Shape::Box {
            half_extents: DVec3::new(0.1, 5.0, 2.0),
        };
        assert!(!Surroundings::of(&scene).is_scenery(1));
    }

    #[test]
    fn the_box_to_see_holds_the_balls_and_the_top_of_the_floor() {
        let found = Surroundings::of(&open_box_with_balls());
        assert!(found.low.y <= 0.0 && found.low.y > -0.5);
        assert!(found.high.y >= 1.2);
    }

    #[test]
    fn an_empty_scene_has_a_picture_too() {
        let found = Surroundings::of(&Scene::new("empty"));
        assert!(found.radius() > 0.0 && found.radius().is_finite());
        assert!(!found.has_floor);
    }
}
