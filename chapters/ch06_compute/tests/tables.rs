//! Chapter 5's tables on a real device and back.

use ch05_properties::columns::{AnyTable, Table};
use ch05_properties::data::{Bodies, Body, Data, Motion, Motions};
use ch06_compute::stream::{Columns, Gpu, Kernel, Passes, StreamError, source, table_wgsl};
use glam::{Mat3, Quat, Vec3};

fn gpu() -> Gpu {
    Gpu::open().unwrap_or_else(|error| panic!("{error}"))
}

fn run(columns: &Columns, kernel: &Kernel, rows: usize) -> Result<(), StreamError> {
    let mut passes = Passes::new(columns);
    passes.run(kernel, rows)?;
    passes.submit()
}

/// Bodies whose every number differs.
fn bodies(count: usize) -> Bodies {
    let mut bodies = Bodies::default();
    for row in 0..count {
        let x = row as f32;
        bodies.push(Body {
            position: Vec3::new(x, x + 0.25, x + 0.5),
            orientation: Quat::from_xyzw(x, 1.0, 2.0, 3.0),
            inverse_mass: 1.0 / (1.0 + x),
            shape: row as u32,
            ..Body::default()
        });
    }
    bodies
}

#[test]
fn columns_of_chapter_5_go_up_and_come_down_by_name() {
    let gpu = gpu();
    let all = ["position", "orientation", "inverse_mass", "shape"];
    let mut table = bodies(1000);
    let mut columns = Columns::new(&gpu);
    columns.upload(&table, &all).expect("they go up");
    let text = source("common/index").expect("it is there")
        + &table_wgsl(&Data::default(), "bodies").expect("a table")
        + "
        @compute @workgroup_size(WORKGROUP)
        fn change(@builtin(global_invocation_id) id: vec3u) {
            let row = row_index(id);
            if row >= arrayLength(&bodies_shape) { return; }
            set_bodies_position(row, get_bodies_position(row).zxy);
            set_bodies_orientation(row, get_bodies_orientation(row).wxyz);
            set_bodies_inverse_mass(row, 2.0 * get_bodies_inverse_mass(row));
            set_bodies_shape(row, get_bodies_shape(row) + 1u);
        }";
    let kernel = Kernel::new(&gpu, "change", &text, "change", &[]).expect("a kernel");
    run(&columns, &kernel, 1000).expect("it runs");
    columns.download(&mut table, &all).expect("they come down");
    for (row, before) in (0..1000).map(|row| (row, bodies(1000).row(row).expect("a row"))) {
        let after = table.row(row).expect("a row");
        assert_eq!(
            after.position,
            Vec3::from_array([before.position.z, before.position.x, before.position.y])
        );
        let q = before.orientation;
        assert_eq!(after.orientation, Quat::from_xyzw(q.w, q.x, q.y, q.z));
        assert_eq!(after.inverse_mass, 2.0 * before.inverse_mass);
        assert_eq!(after.shape, before.shape + 1);
    }
}

#[test]
fn a_matrix_goes_up_column_by_column() {
    let gpu = gpu();
    let mut table = Motions::default();
    let matrix = Mat3::from_cols_array(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    for _ in 0..3 {
        table.push(Motion {
            inverse_inertia: matrix,
            ..Motion::default()
        });
    }
    let mut columns = Columns::new(&gpu);
    columns
        .upload(&table, &["inverse_inertia"])
        .expect("it goes up");
    let text = table_wgsl(&Data::default(), "motions").expect("a table")
        + "
        @compute @workgroup_size(1)
        fn turn(@builtin(global_invocation_id) id: vec3u) {
            set_motions_inverse_inertia(id.x, transpose(get_motions_inverse_inertia(id.x)));
        }";
    let kernel = Kernel::new(&gpu, "turn", &text, "turn", &[]).expect("a kernel");
    run(&columns, &kernel, 2).expect("it runs");
    columns
        .download(&mut table, &["inverse_inertia"])
        .expect("it comes down");
    let expected = [matrix.transpose(), matrix.transpose(), matrix];
    assert_eq!(&table.inverse_inertia[..], expected);
}

#[test]
fn a_column_that_chapter_5_has_not_is_named() {
    let gpu = gpu();
    let mut columns = Columns::new(&gpu);
    let mut table = bodies(3);
    let error = columns
        .upload(&table, &["colour"])
        .expect_err("no such column")
        .to_string();
    assert!(
        error.contains("`bodies` has no column `colour`; it has: position"),
        "{error}"
    );
    let error = columns
        .download(&mut table, &["position"])
        .expect_err("not there")
        .to_string();
    assert!(
        error.contains("no column `bodies_position` on the GPU"),
        "{error}"
    );
    let place = table.place_of("position").expect("a column");
    table.column_mut(place).set_kept(false, 3);
    let error = columns
        .upload(&table, &["position"])
        .expect_err("left out")
        .to_string();
    assert!(error.contains("left out"), "{error}");
}
