//! The narrow phase in WGSL against the one in Rust, on the device that is there: 4,000 random pairs for
//! each kind of pair.
//!
//! WGSL may fuse a multiplication with an addition, so that numbers differ in their last bits. Where two
//! directions are equally good, or two points equally far out, the other one may be taken then: both
//! are right, and how many they are is bounded.

use bytemuck::{Pod, Zeroable};
use ch00_scenes::random::SplitMix64;
use ch06_compute::own_row::narrow::{PAIR_KINDS, Posed, manifold, pair_kind};
use ch06_compute::rows::Manifold;
use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, StreamError, source};
use glam::{Quat, Vec3};

use crate::bodies::{BALL, CYLINDER, apart_along, at_points, normal_of, random_pair, size};

const PAIRS: usize = 4000;

/// Gaps that count, as a share of the smaller body's size.
const MARGIN: f32 = 0.2;

/// `Posed` as WGSL lays it out, and the margin.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Given {
    position: Vec3,
    kind: u32,
    size: Vec3,
    margin: f32,
    attitude: Quat,
}

fn row(body: &Posed, margin: f32) -> Given {
    Given {
        position: body.position,
        kind: body.kind,
        size: body.size,
        margin,
        attitude: body.attitude,
    }
}

const KERNEL: &str = "
    override PAIR_KIND: u32;
    struct Given { position: vec3f, kind: u32, size: vec3f, margin: f32, attitude: vec4f, }
    @group(0) @binding(0) var<storage, read> bodies: array<Given>;
    @group(0) @binding(1) var<storage, read_write> manifolds: array<Manifold>;
    fn posed(body: Given) -> Posed {
        return Posed(body.position, body.kind, body.size, body.attitude);
    }
    @compute @workgroup_size(64)
    fn meet_all(@builtin(global_invocation_id) id: vec3u) {
        let row = id.x;
        if row >= arrayLength(&manifolds) { return; }
        let a = bodies[2u * row];
        let b = bodies[2u * row + 1u];
        manifolds[row] = manifold_of_kind(PAIR_KIND, posed(a), posed(b), a.margin);
    }";

/// The manifolds of pairs of one kind, as the device finds them.
fn on_device(gpu: &Gpu, kind: u32, bodies: &[Given]) -> Result<Vec<Manifold>, StreamError> {
    let text = source("common/narrow")? + KERNEL;
    let constants = [("PAIR_KIND", f64::from(kind))];
    let kernel = Kernel::new(gpu, "meet_all", &text, "meet_all", &constants)?;
    let mut columns = Columns::new(gpu);
    columns.add::<Given>("bodies", bodies.len())?;
    columns.write("bodies", bodies)?;
    columns.add::<Manifold>("manifolds", bodies.len() / 2)?;
    columns.set_rows("manifolds", bodies.len() / 2)?;
    let mut passes = Passes::new(&columns);
    passes.run(&kernel, bodies.len() / 2)?;
    passes.submit()?;
    columns.read("manifolds")
}

/// How the two differ, in numbers of pairs.
#[derive(Default, Debug)]
struct Tally {
    touching: usize,
    same_points: usize,
    other_normal: usize,
    worst: f64,
}

impl Tally {
    fn compare(&mut self, a: &Posed, b: &Posed, margin: f32, by_device: &Manifold) {
        let here = manifold(a, b, margin);
        let size = size(a).min(size(b));
        let truth = |m: &Manifold| apart_along(a, b, normal_of(m, a, b).normalize());
        if here.points == 0 || by_device.points == 0 {
            let other = if here.points == 0 { by_device } else { &here };
            let at_the_margin = (truth(other) - f64::from(margin)).abs() < 1e-3 * size;
            assert!(
                here.points == other.points || at_the_margin,
                "{other:?} {a:?} {b:?}"
            );
            return;
        }
        self.touching += 1;
        let deepest = |m: &Manifold| at_points(m, a, b).into_iter().fold(f64::INFINITY, f64::min);
        let error = (deepest(&here) - deepest(by_device)).abs() / size;
        self.worst = self.worst.max(error);
        let turned = normal_of(&here, a, b).angle_between(normal_of(by_device, a, b));
        self.other_normal += usize::from(turned > 1e-2);
        let features = |m: &Manifold| m.core_a.map(|core| core.w.to_bits());
        let near = |k: usize| here.core_a[k].distance(by_device.core_a[k]) < 1e-3 * size as f32;
        let same = here.points == by_device.points
            && features(&here) == features(by_device)
            && (0..here.points as usize).all(near);
        self.same_points += usize::from(same);
        assert_eq!(here.kind, by_device.kind);
    }
}

#[test]
fn the_device_finds_the_same_contacts() {
    let gpu = Gpu::open().unwrap_or_else(|error| panic!("{error}"));
    for (a, b) in (0..4).flat_map(|a| (a..4).map(move |b| (a, b))) {
        let kind = pair_kind(a, b);
        assert!(kind < PAIR_KINDS);
        let mut random = SplitMix64::new(u64::from(kind));
        let pairs: Vec<_> = (0..PAIRS)
            .map(|i| random_pair([a, b], i, &mut random))
            .collect();
        let margin = |a: &Posed, b: &Posed| MARGIN * size(a).min(size(b)) as f32;
        let rows: Vec<Given> = pairs
            .iter()
            .flat_map(|(a, b)| [row(a, margin(a, b)), row(b, margin(a, b))])
            .collect();
        let found = on_device(&gpu, kind, &rows).unwrap_or_else(|error| panic!("{error}"));
        let mut tally = Tally::default();
        for ((a, b), m) in pairs.iter().zip(&found) {
            tally.compare(a, b, margin(a, b), m);
        }
        println!("{a} {b}: {tally:?}");
        assert!(tally.touching > PAIRS / 4, "{a} {b}: {tally:?}");
        assert!(tally.worst < 2e-3, "{a} {b}: {tally:?}");
        let others = tally.touching - tally.same_points;
        let may_differ = if b == CYLINDER && a != BALL {
            PAIRS / 10
        } else {
            PAIRS / 400
        };
        assert!(others <= may_differ, "{a} {b}: {tally:?}");
        assert!(tally.other_normal <= PAIRS / 400, "{a} {b}: {tally:?}");
    }
}
