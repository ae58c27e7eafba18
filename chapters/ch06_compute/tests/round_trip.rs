//! Chapter 5's integration on a real device, and the maths that it is made of.

use ch00_maths::f32::{free_rotation, rotation};
use ch00_maths::f64 as double;
use ch00_scenes::random::SplitMix64;
use ch05_properties::columns::Table;
use ch05_properties::data::{Bodies, Body};
use ch05_properties::systems::Pull;
use ch05_properties::systems::advance::{self, Step};
use ch06_compute::round_trip::RoundTrip;
use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, behind_needs};
use glam::{DQuat, DVec3, Quat, Vec3, Vec4};

const GRAVITY: Vec3 = Vec3::new(0.0, -9.81, 0.0);
/// Uneven, and with drag.
const STEP: Step = Step {
    dt: 1.0 / 60.0,
    dt_last: 1.0 / 50.0,
    kept: 0.999,
};

fn gpu() -> Gpu {
    Gpu::open().unwrap_or_else(|error| panic!("{error}"))
}

fn vector(random: &mut SplitMix64, size: f32) -> Vec3 {
    let mut number = || size * (2.0 * random.unit() as f32 - 1.0);
    Vec3::new(number(), number(), number())
}

/// Bodies that fly and turn, up to 20 rad/s; every tenth can't move.
fn bodies(count: usize, inertia: Vec3) -> Bodies {
    let mut random = SplitMix64::new(6);
    let mut bodies = Bodies::default();
    for row in 0..count {
        let position = vector(&mut random, 10.0);
        let orientation = rotation::exp(vector(&mut random, 1.5));
        let turn = vector(&mut random, 11.0 * STEP.dt_last);
        bodies.push(Body {
            position,
            last_position: position - vector(&mut random, 5.0) * STEP.dt_last,
            orientation,
            last_orientation: rotation::turned(orientation, -turn),
            inverse_mass: if row % 10 == 9 { 0.0 } else { 2.0 },
            inertia,
            inverse_inertia: inertia.recip(),
            ..Body::default()
        });
    }
    bodies
}

/// Chapter 5's way.
fn advance(bodies: &mut Bodies, step: Step) {
    advance::positions(
        &mut bodies.position,
        &mut bodies.last_position,
        &bodies.inverse_mass,
        Pull::Gravity(GRAVITY),
        step,
    );
    advance::orientations(
        &mut bodies.orientation,
        &mut bodies.last_orientation,
        &bodies.inertia,
        &bodies.inverse_inertia,
        &[],
        &bodies.inverse_mass,
        step,
    );
}

/// The same in double precision, body by body.
fn advance_exactly(body: &mut Exact, step: Step) {
    let [dt, dt_last, kept] = [step.dt, step.dt_last, step.kept].map(f64::from);
    let [p, p_last] = body.positions;
    let moved = double::verlet::displacement(p, p_last, GRAVITY.as_dvec3(), kept, dt, dt_last);
    body.positions = [p + moved, p];
    let ([q, q_last], i) = (body.orientations, body.inertia);
    let momentum = double::spin::momentum_of_turn(q, q_last, i, dt_last).expect("it can be read");
    let momentum = double::spin::momentum_after(momentum, DVec3::ZERO, kept, dt, dt_last);
    body.orientations = [double::spin::turned_by(q, i, i.recip(), momentum, dt), q];
}

/// A body in double precision: each now and a step ago.
struct Exact {
    positions: [DVec3; 2],
    orientations: [DQuat; 2],
    inertia: DVec3,
}

impl Exact {
    fn of(body: &Body) -> Self {
        Self {
            positions: [body.position, body.last_position].map(Vec3::as_dvec3),
            orientations: [body.orientation, body.last_orientation].map(Quat::as_dquat),
            inertia: body.inertia.as_dvec3(),
        }
    }

    /// How far a body is from it, m and rad.
    fn error(&self, body: &Body) -> [f64; 2] {
        let turned = body.orientation.as_dquat() * self.orientations[0].conjugate();
        [
            self.positions[0].distance(body.position.as_dvec3()),
            double::rotation::log(turned.normalize()).length(),
        ]
    }
}

/// The greatest errors after a second, m and rad: of chapter 5 and of the GPU.
fn errors(inertia: Vec3) -> [[f64; 2]; 2] {
    let mut ours = bodies(1000, inertia);
    let mut theirs = ours.clone();
    let row = |bodies: &Bodies, row| bodies.row(row).expect("a row");
    let mut exact: Vec<_> = (0..1000).map(|i| Exact::of(&row(&ours, i))).collect();
    let mut round_trip = RoundTrip::new(&gpu(), &ours).expect("it fits");
    let mut step = STEP;
    for _ in 0..60 {
        advance(&mut ours, step);
        round_trip
            .step(&mut theirs, GRAVITY, step)
            .expect("it runs");
        for body in &mut exact {
            advance_exactly(body, step);
        }
        step.dt_last = step.dt;
    }
    assert_eq!(row(&ours, 9), row(&theirs, 9), "what can't move doesn't");
    [&ours, &theirs].map(|bodies| {
        let moving = (0..1000).filter(|i| i % 10 != 9);
        let errors = moving.map(|i| exact[i].error(&row(bodies, i)));
        errors.fold([0.0_f64; 2], |most, error| {
            [most[0].max(error[0]), most[1].max(error[1])]
        })
    })
}

#[track_caller]
fn rounds_no_worse_than_chapter_5(inertia: Vec3) {
    let [ours, theirs] = errors(inertia);
    println!("chapter 5 errs by {ours:?}, the GPU by {theirs:?} (m, rad)");
    for (ours, theirs) in ours.into_iter().zip(theirs) {
        assert!(theirs < 2.0 * ours, "{theirs:e}, chapter 5 {ours:e}");
    }
}

#[test]
fn balls_fly_as_in_chapter_5() {
    rounds_no_worse_than_chapter_5(Vec3::splat(0.4));
}

#[test]
fn boxes_tumble_as_in_chapter_5() {
    rounds_no_worse_than_chapter_5(Vec3::new(0.2, 0.3, 0.4));
}

#[test]
fn the_time_of_each_part_is_known() {
    let gpu = gpu();
    let mut bodies = bodies(10_000, Vec3::ONE);
    let mut round_trip = RoundTrip::new(&gpu, &bodies).expect("it fits");
    let parts = round_trip
        .step_in_parts(&mut bodies, GRAVITY, STEP)
        .expect("it runs");
    assert!(!parts.upload.is_zero() && !parts.download.is_zero());
    let kernels = parts.kernels.expect("the device has a clock");
    assert!(!kernels.is_zero() && kernels < parts.compute, "{parts:?}");
    // Up and down: two positions and two attitudes.
    assert_eq!(round_trip.bytes_a_body(), 2 * (2 * 12 + 2 * 16));
}

#[test]
fn more_bodies_than_went_up_are_taken_up_as_well() {
    let gpu = gpu();
    let mut round_trip = RoundTrip::new(&gpu, &bodies(10, Vec3::ONE)).expect("it fits");
    let (mut ours, mut theirs) = (bodies(100, Vec3::ONE), bodies(100, Vec3::ONE));
    advance(&mut ours, STEP);
    round_trip
        .step(&mut theirs, GRAVITY, STEP)
        .expect("it runs");
    assert!(ours.position[98].distance(theirs.position[98]) < 1e-5);
}

/// What a WGSL expression over `x` makes of each value.
fn by_wgsl(expression: &str, values: &[Vec4]) -> Vec<Vec4> {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    columns
        .add::<Vec4>("values", values.len())
        .and_then(|()| columns.write("values", values))
        .expect("they fit");
    let parts = ["index", "trigonometry", "rotation", "rotation_vector"];
    let parts = parts.map(|name| format!("common/{name}"));
    let shader = format!(
        "// Needs {}, common/free_rotation.
        @group(0) @binding(0) var<storage, read_write> values: array<vec4f>;
        @compute @workgroup_size(WORKGROUP)
        fn main(@builtin(global_invocation_id) id: vec3u) {{
            let row = row_index(id);
            if row >= arrayLength(&values) {{ return; }}
            let x = values[row];
            values[row] = {expression};
        }}",
        parts.join(", ")
    );
    let text = behind_needs(&shader).expect("they are there");
    let kernel = Kernel::new(&gpu, "main", &text, "main", &[]).expect("a kernel");
    let mut passes = Passes::new(&columns);
    passes.run(&kernel, values.len()).expect("it runs");
    passes.submit().expect("all is well");
    columns.read("values").expect("they come down")
}

#[test]
fn sines_are_good_to_the_last_digits() {
    let angles: Vec<f32> = (-20_000..20_000).map(|n| n as f32 * 1.0e-3).collect();
    let values: Vec<_> = angles.iter().map(|&x| Vec4::splat(x)).collect();
    let found = by_wgsl("vec4f(sine_cosine(x.x), sine(x.x), cosine(x.x))", &values);
    for (x, found) in angles.into_iter().zip(found) {
        let (s, c) = (f64::from(x).sin(), f64::from(x).cos());
        for (found, exact) in [(found.x, s), (found.y, c), (found.z, s), (found.w, c)] {
            let error = (f64::from(found) - exact).abs();
            // 2 units in the last place near 0 and near 1, and the reduction's rounding between.
            assert!(error < 2.4e-7 * exact.abs().max(0.5), "{x}: {error:e}");
        }
    }
}

#[test]
fn small_angles_have_all_their_digits() {
    let angles: Vec<f32> = (1..1000).map(|n| n as f32 * 1.0e-5).collect();
    let values: Vec<_> = angles.iter().map(|&x| Vec4::splat(x)).collect();
    let found = by_wgsl(
        "vec4f(sine(x.x), arc_tangent(x.x), arc_tangent_of(x.x, 1.0), 0.0)",
        &values,
    );
    for (x, found) in angles.into_iter().map(f64::from).zip(found) {
        for (found, exact) in [(found.x, x.sin()), (found.y, x.atan()), (found.z, x.atan())] {
            assert!((f64::from(found) / exact - 1.0).abs() < 2.4e-7, "{x}");
        }
    }
}

#[test]
fn arc_tangents_know_all_four_quarters() {
    let angles: Vec<f32> = (-3141..=3141).map(|n| n as f32 * 1.0e-3).collect();
    let point = |&x: &f32| Vec4::new(x.sin() * 3.0, x.cos() * 3.0, 0.0, 0.0);
    let points: Vec<_> = angles.iter().map(point).collect();
    let found = by_wgsl("vec4f(arc_tangent_of(x.x, x.y), 0.0, 0.0, 0.0)", &points);
    for (point, found) in points.iter().zip(found) {
        let exact = f64::from(point.x).atan2(f64::from(point.y));
        assert!((f64::from(found.x) - exact).abs() < 4e-7, "{exact}");
    }
    let origin = by_wgsl("vec4f(arc_tangent_of(x.x, x.y))", &[Vec4::ZERO]);
    assert_eq!(origin, [Vec4::ZERO]);
}

#[test]
fn turns_are_those_of_the_book() {
    let mut random = SplitMix64::new(7);
    let turns: Vec<Vec3> = (0..1000)
        .map(|n| vector(&mut random, 1.8 * n as f32 / 1000.0))
        .collect();
    let values: Vec<_> = turns.iter().map(|turn| turn.extend(0.0)).collect();
    let inertia = Vec3::new(0.3, 0.2, 0.4);
    let exp = by_wgsl("rotation_exp(x.xyz)", &values);
    let back = by_wgsl("vec4f(rotation_log(rotation_exp(x.xyz)), 0.0)", &values);
    let free = by_wgsl(
        "free_rotation_turn(vec3f(0.3, 0.2, 0.4), x.xyz, 0.5)",
        &values,
    );
    let found = by_wgsl(
        "vec4f(free_rotation_momentum_of_turn(vec4f(0.0, 0.0, 0.0, 1.0),
            free_rotation_turn(vec3f(0.3, 0.2, 0.4), 0.1 * x.xyz, 0.5),
            vec3f(0.3, 0.2, 0.4), 0.5).momentum, 0.0)",
        &values,
    );
    for (row, &turn) in turns.iter().enumerate() {
        let exact = Vec4::from(rotation::exp(turn));
        assert!(exp[row].distance(exact) < 1e-6, "exp {turn}");
        assert!(back[row].truncate().distance(turn) < 3e-6, "log {turn}");
        let exact = Vec4::from(free_rotation::turn(inertia, turn, 0.5));
        assert!(free[row].distance(exact) < 2e-6, "free turn {turn}");
        let momentum = found[row].truncate();
        assert!(momentum.distance(0.1 * turn) < 1e-6, "momentum {turn}");
    }
    assert_eq!(exp[0], Vec4::from(Quat::IDENTITY));
}
