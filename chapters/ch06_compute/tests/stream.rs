//! The streamlining type on a real device; without one, these tests fail and say what to install.

use ch06_compute::rows::{Motion, Place};
use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, Readback, StreamError, Timer, source};
use glam::Vec3;

fn gpu() -> Gpu {
    Gpu::open().unwrap_or_else(|error| panic!("{error}"))
}

/// `common/index`, the rows, and a kernel.
fn with_index(kernel: &str) -> String {
    let index = source("common/index").expect("it is there");
    index + &ch06_compute::rows::wgsl() + kernel
}

/// Adds its row's number and a uniform to every number.
fn adding() -> String {
    with_index(
        "
        override TIMES: u32 = 1u;
        struct Amount { value: u32, rows: u32, }
        @group(0) @binding(0) var<uniform> amount: Amount;
        @group(0) @binding(1) var<storage, read_write> numbers: array<u32>;
        @compute @workgroup_size(WORKGROUP)
        fn add(@builtin(global_invocation_id) id: vec3u) {
            let row = row_index(id);
            if row >= amount.rows { return; }
            numbers[row] += TIMES * amount.value + row;
        }",
    )
}

/// The same in Rust.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Amount {
    value: u32,
    rows: u32,
}

/// Columns with so many zeros, and the amount to add.
fn numbers(gpu: &Gpu, count: usize, amount: u32) -> Columns {
    let mut columns = Columns::new(gpu);
    let amount = Amount {
        value: amount,
        rows: count as u32,
    };
    columns
        .add_uniform("amount", &amount)
        .and_then(|()| columns.add::<u32>("numbers", count))
        .and_then(|()| columns.set_rows("numbers", count))
        .expect("they fit");
    columns
}

fn add(gpu: &Gpu, constants: &[(&str, f64)]) -> Kernel {
    Kernel::new(gpu, "add", &adding(), "add", constants).expect("a kernel")
}

fn run(columns: &Columns, kernel: &Kernel, rows: usize) -> Result<(), StreamError> {
    let mut passes = Passes::new(columns);
    passes.run(kernel, rows)?;
    passes.submit()
}

#[test]
fn without_an_adapter_it_says_what_to_install() {
    let nothing = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::empty(),
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let opened = pollster::block_on(Gpu::request(&nothing, None));
    let error = opened.expect_err("there is none");
    assert!(matches!(error, StreamError::NoAdapter(_)), "{error}");
    assert!(error.to_string().contains("mesa-vulkan-drivers"), "{error}");
}

#[test]
fn a_kernel_runs_over_every_row() {
    let gpu = gpu();
    // More than one line of workgroups can hold, and not a whole number of lines.
    for count in [1, 63, 64, 65, 5000, 65536 * 64 + 100] {
        let columns = numbers(&gpu, count, 7);
        run(&columns, &add(&gpu, &[]), count).expect("it runs");
        let found: Vec<u32> = columns.read("numbers").expect("they come down");
        let wrong = (0..count).find(|&row| found[row] != 7 + row as u32);
        assert_eq!((found.len(), wrong), (count, None));
    }
}

#[test]
fn a_pass_sees_what_those_before_it_wrote() {
    let gpu = gpu();
    let columns = numbers(&gpu, 1000, 1);
    let kernel = add(&gpu, &[]);
    let mut passes = Passes::new(&columns);
    for _ in 0..40 {
        passes.run(&kernel, 1000).expect("it runs");
    }
    passes.submit().expect("all is well");
    let found: Vec<u32> = columns.read("numbers").expect("they come down");
    let expected: Vec<u32> = (0..1000).map(|row| 40 * (1 + row)).collect();
    assert_eq!(found, expected);
}

#[test]
fn constants_make_another_kernel_of_the_same_text() {
    let gpu = gpu();
    let columns = numbers(&gpu, 100, 10);
    let kernel = add(&gpu, &[("TIMES", 3.0), ("WORKGROUP", 32.0)]);
    assert_eq!(kernel.workgroup(), 32);
    run(&columns, &kernel, 100).expect("it runs");
    let found: Vec<u32> = columns.read("numbers").expect("they come down");
    assert_eq!(found[99], 30 + 99);
}

#[test]
fn a_renamed_kernel_runs_over_another_column() {
    let gpu = gpu();
    let mut columns = numbers(&gpu, 10, 1);
    columns.add::<u32>("others", 10).expect("it fits");
    columns.write("others", &[100_u32; 10]).expect("they fit");
    let kernel = add(&gpu, &[])
        .renamed(&[("numbers", "others")])
        .expect("a binding");
    run(&columns, &kernel, 10).expect("it runs");
    assert_eq!(columns.read::<u32>("others").expect("down")[9], 110);
    assert_eq!(columns.read::<u32>("numbers").expect("down")[9], 0);
    columns.swap("numbers", "others").expect("the same rows");
    run(&columns, &kernel, 10).expect("it runs");
    assert_eq!(columns.read::<u32>("others").expect("down")[9], 10);
    assert_eq!(columns.read::<u32>("numbers").expect("down")[9], 110);
}

#[test]
fn a_column_that_grows_keeps_what_it_holds() {
    let gpu = gpu();
    let mut columns = numbers(&gpu, 100, 5);
    let kernel = add(&gpu, &[]);
    run(&columns, &kernel, 100).expect("it runs");
    columns.reserve("numbers", 101).expect("it fits");
    assert_eq!(columns.info("numbers").expect("it is there").capacity, 150);
    run(&columns, &kernel, 100).expect("it runs");
    let found: Vec<u32> = columns.read_rows("numbers", 0..150).expect("down");
    assert_eq!((found[99], found[149]), (2 * (5 + 99), 0));
}

#[test]
fn the_gpu_says_how_many_workgroups_run() {
    let gpu = gpu();
    let mut columns = numbers(&gpu, 1000, 1);
    let uses = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::INDIRECT;
    columns
        .add_for::<[u32; 3]>("groups", 1, uses)
        .expect("it fits");
    let text = with_index(
        "
        @group(0) @binding(0) var<storage, read_write> groups: array<u32>;
        @compute @workgroup_size(1)
        fn count() {
            let found = groups_for(500u);
            groups[0] = found.x; groups[1] = found.y; groups[2] = found.z;
        }",
    );
    let count = Kernel::new(&gpu, "count", &text, "count", &[]).expect("a kernel");
    let mut passes = Passes::new(&columns);
    passes.run(&count, 1).expect("it runs");
    passes
        .run_indirect(&add(&gpu, &[]), "groups", 0)
        .expect("it runs");
    passes.submit().expect("all is well");
    let found: Vec<u32> = columns.read("numbers").expect("down");
    // Eight workgroups of 64.
    assert_eq!((found[511], found[512]), (512, 0));
}

#[test]
fn rows_lie_on_the_gpu_as_they_lie_here() {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    columns.add::<Place>("places", 0).expect("it fits");
    columns.add::<Motion>("motions", 0).expect("it fits");
    let places: Vec<_> = (0..100)
        .map(|row| Place {
            position: Vec3::new(row as f32, 2.0, 3.0),
            reach: 0.5,
        })
        .collect();
    let motions = [Motion {
        velocity: Vec3::X,
        shares: 2.0,
    }; 100];
    columns.write("places", &places).expect("they fit");
    columns.write("motions", &motions).expect("they fit");
    let text = with_index(
        "
        @group(0) @binding(0) var<storage, read_write> places: array<Place>;
        @group(0) @binding(1) var<storage, read> motions: array<Motion>;
        @compute @workgroup_size(64)
        fn move_all(@builtin(global_invocation_id) id: vec3u) {
            let row = row_index(id);
            if row >= arrayLength(&places) { return; }
            places[row].position += motions[row].velocity * motions[row].shares;
            places[row].reach = 0.25;
        }",
    );
    let kernel = Kernel::new(&gpu, "move_all", &text, "move_all", &[]).expect("a kernel");
    assert_eq!(kernel.row_bytes(&columns), Ok(32));
    run(&columns, &kernel, 100).expect("it runs");
    let expected: Vec<_> = (0..100)
        .map(|row| Place {
            position: Vec3::new(row as f32 + 2.0, 2.0, 3.0),
            reach: 0.25,
        })
        .collect();
    assert_eq!(columns.read::<Place>("places"), Ok(expected));
}

#[test]
fn a_column_of_other_rows_is_refused_by_name() {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    columns.add::<Vec3>("places", 10).expect("it fits");
    columns.add::<Motion>("motions", 10).expect("it fits");
    let text = with_index(
        "
        @group(0) @binding(0) var<storage, read_write> places: array<Place>;
        @group(0) @binding(1) var<storage, read_write> motions: array<Place>;
        @compute @workgroup_size(64) fn one() { places[0].reach = 1.0; }
        @compute @workgroup_size(64) fn two() { motions[0].reach = 1.0; }",
    );
    let error = |entry| {
        let kernel = Kernel::new(&gpu, entry, &text, entry, &[]).expect("a kernel");
        run(&columns, &kernel, 1)
            .expect_err("the rows differ")
            .to_string()
    };
    let one = error("one");
    assert!(one.contains("`places` holds Vec3 of 12 bytes"), "{one}");
    assert!(
        one.contains("Place of 16 bytes, as kernel `one` has it"),
        "{one}"
    );
    let two = error("two");
    assert!(two.contains("`motions` holds Motion of 16 bytes"), "{two}");
}

#[test]
fn an_unknown_column_is_named_with_those_that_there_are() {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    columns.add::<u32>("digits", 1).expect("it fits");
    columns
        .add_uniform("amount", &Amount { value: 1, rows: 1 })
        .expect("it fits");
    let expected = StreamError::UnknownColumn {
        column: "numbers".to_owned(),
        known: "digits, amount".to_owned(),
    };
    assert_eq!(run(&columns, &add(&gpu, &[]), 1), Err(expected.clone()));
    assert_eq!(columns.read::<u32>("numbers"), Err(expected));
    let twice = StreamError::Duplicate("digits".to_owned());
    assert_eq!(columns.add::<u32>("digits", 1), Err(twice));
}

#[test]
fn too_many_rows_are_an_error_before_anything_is_allocated() {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    let most = gpu.most_rows(16);
    let error = columns
        .add::<Place>("places", most as usize + 1)
        .expect_err("too many");
    let expected = StreamError::TooLarge {
        column: "places".to_owned(),
        asked: most + 1,
        row_bytes: 16,
        most,
        device: gpu.name.clone(),
    };
    assert_eq!(error, expected);
    assert_eq!((columns.bytes(), gpu.check()), (0, Ok(())));

    columns.add::<Place>("places", 10).expect("it fits");
    let error = columns.reserve("places", usize::MAX / 2);
    assert!(
        matches!(error, Err(StreamError::TooLarge { .. })),
        "{error:?}"
    );
    assert_eq!(columns.info("places").expect("it is there").capacity, 10);
}

#[test]
fn a_lost_device_is_an_error_and_not_a_panic() {
    let gpu = gpu();
    let mut columns = numbers(&gpu, 1000, 1);
    let kernel = add(&gpu, &[]);
    let (mut readback, mut timer) = (Readback::default(), Timer::new(&gpu, 4));
    run(&columns, &kernel, 1000).expect("it runs");
    gpu.device.destroy();

    let mut passes = Passes::timed(&columns, &mut timer);
    passes.run(&kernel, 1000).expect("it is recorded");
    passes
        .read_back(&mut readback, "numbers", 0..10, 1)
        .expect("it is recorded");
    let submitted = passes.submit().and_then(|()| gpu.poll());
    let Err(StreamError::Failed { device, why }) = submitted else {
        panic!("{submitted:?}");
    };
    assert_eq!(device, gpu.name);
    assert!(why.contains("lost"), "{why}");
    assert_eq!(readback.latest::<u32>(), None);
    assert!(columns.read::<u32>("numbers").is_err());
    assert!(gpu.wait().is_err());
    // Nothing of this panics.
    let _ = columns.write("numbers", &[1_u32; 2000]);
    let _ = columns.clear("numbers");
    let _ = columns.add::<u32>("more", 10);
    let _ = Kernel::new(&gpu, "add", &adding(), "add", &[]);
    assert!(gpu.check().is_err());
}

#[test]
fn an_error_of_the_device_is_kept() {
    let gpu = gpu();
    let columns = numbers(&gpu, 10, 1);
    let mut encoder = gpu
        .device
        .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let buffer = columns.buffer("numbers").expect("it is there");
    encoder.copy_buffer_to_buffer(buffer, 0, buffer, 1 << 20, 40);
    gpu.queue.submit([encoder.finish()]);
    let error = gpu.check().expect_err("it is out of the buffer");
    assert!(error.to_string().contains(&gpu.name), "{error}");
}

#[test]
fn what_was_asked_for_comes_some_frames_late_with_its_label() {
    let gpu = gpu();
    let columns = numbers(&gpu, 100, 1);
    let kernel = add(&gpu, &[]);
    let mut readback = Readback::default();
    let mut seen = Vec::new();
    for frame in 1..=20 {
        let mut passes = Passes::new(&columns);
        passes.run(&kernel, 100).expect("it runs");
        passes
            .read_back(&mut readback, "numbers", 10..12, frame)
            .expect("the rows are there");
        passes.submit().expect("all is well");
        gpu.poll().expect("all is well");
        seen.extend(readback.latest::<u32>());
    }
    gpu.wait().expect("all is well");
    seen.extend(readback.latest::<u32>());
    assert!(!seen.is_empty() && !readback.is_waiting());
    for late in &seen {
        let times = late.frame as u32;
        assert_eq!(
            (late.first, &late.rows[..]),
            (10, &[times * 11, times * 12][..])
        );
    }
    assert!(seen.is_sorted_by(|one, next| one.frame < next.frame));
}

#[test]
fn a_timer_says_how_long_each_section_took() {
    let gpu = gpu();
    assert!(gpu.has_timestamps, "{} has no timestamps", gpu.name);
    let columns = numbers(&gpu, 100_000, 1);
    let kernel = add(&gpu, &[]);
    let mut timer = Timer::new(&gpu, 16);
    let mut passes = Passes::timed(&columns, &mut timer);
    for _ in 0..3 {
        passes.section("long");
        for _ in 0..5 {
            passes.run(&kernel, 100_000).expect("it runs");
        }
        passes.section("short");
        passes.run(&kernel, 100).expect("it runs");
    }
    passes.submit().expect("all is well");
    gpu.wait().expect("all is well");
    let times = timer.latest(&gpu).expect("they have come");
    let names: Vec<_> = times.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ["long", "short"]);
    assert!(times[0].1 > times[1].1, "{times:?}");

    let mut timer = Timer::of_kernels(&gpu, 16);
    let mut passes = Passes::timed(&columns, &mut timer);
    passes.run(&kernel, 100).expect("it runs");
    passes.submit().expect("all is well");
    gpu.wait().expect("all is well");
    assert_eq!(timer.latest(&gpu).expect("they have come")[0].0, "add");
}
