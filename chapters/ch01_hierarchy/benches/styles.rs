//! The three styles under criterion: a frame's update and the gathering of the position
//! column, per object, for N = 10 … 1,000,000.
//!
//! `cargo bench -p ch01_hierarchy --no-default-features`. The book's table comes from the
//! example `styles_table`, which takes a minute.

use std::time::Duration;

use ch01_hierarchy::styles::items::scene;
use ch01_hierarchy::styles::{Style, components, hierarchy, hybrid};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const COUNTS: [usize; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];
const DT: f32 = 1.0 / 60.0;

fn bench<S: Style>(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group(S::NAME);
    group.measurement_time(Duration::from_secs(2));
    for count in COUNTS {
        let mut world = S::build(&scene(count));
        let mut column = Vec::with_capacity(count);
        group.sample_size(if count > 10_000 { 10 } else { 50 });
        group.throughput(Throughput::Elements(count as u64));
        group.bench_function(BenchmarkId::new("update", count), |bencher| {
            bencher.iter(|| world.update(DT));
        });
        group.bench_function(BenchmarkId::new("gather", count), |bencher| {
            bencher.iter(|| world.gather_positions(&mut column));
        });
    }
    group.finish();
}

fn styles(criterion: &mut Criterion) {
    bench::<hierarchy::World>(criterion);
    bench::<components::World>(criterion);
    bench::<hybrid::World>(criterion);
}

criterion_group!(benches, styles);
criterion_main!(benches);
