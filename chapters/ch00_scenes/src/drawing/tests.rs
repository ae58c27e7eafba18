use std::f32::consts::{FRAC_PI_2, PI};

use super::*;

fn vec(point: [f32; 3]) -> Vec3 {
    Vec3::from(point)
}

#[test]
fn an_arrow_ends_where_it_points_and_its_head_is_closed() {
    let mut drawing = Drawing::default();
    drawing.arrow(Vec3::ZERO, Vec3::new(0.0, 2.0, 0.0), 1.0, palette::BLUE);
    assert!((vec(drawing.lines[0].to).y - 1.4).abs() < 1e-6);
    // Eight sides, and a base of eight corners in six triangles.
    assert_eq!(drawing.faces.len(), 8 + 6);
    let tips = drawing
        .faces
        .iter()
        .filter(|f| f.corners[2] == [0.0, 2.0, 0.0]);
    assert_eq!(tips.count(), 8);
}

#[test]
fn an_arrow_of_no_length_is_nothing() {
    let mut drawing = Drawing::default();
    drawing.arrow(Vec3::ONE, Vec3::ONE, 1.0, palette::BLUE);
    assert_eq!(drawing, Drawing::default());
}

#[test]
fn a_cones_rim_lies_at_its_angle_and_length_even_past_a_right_angle() {
    for angle in [0.3, FRAC_PI_2, 2.0, PI] {
        let mut drawing = Drawing::default();
        drawing.cone(Vec3::ONE, Vec3::Y, angle, 0.5, palette::BLUE);
        for line in &drawing.lines {
            let side = vec(line.from) - Vec3::ONE;
            assert!((side.length() - 0.5).abs() < 1e-5);
            assert!(
                (side.angle_between(Vec3::Y) - angle).abs() < 1e-3,
                "{angle}"
            );
        }
    }
}

#[test]
fn a_round_swing_cone_is_the_cone() {
    let (mut round, mut swing) = (Drawing::default(), Drawing::default());
    round.cone(Vec3::ZERO, Vec3::Y, 0.7, 1.0, palette::BLUE);
    swing.swing_cone(Vec3::ZERO, Quat::IDENTITY, |_| 0.7, 1.0, palette::BLUE);
    assert_eq!(round.faces.len(), swing.faces.len());
    let height = vec(swing.lines[5].from).y;
    assert!((height - vec(round.lines[5].from).y).abs() < 1e-6);
}

#[test]
fn a_sector_begins_and_ends_at_its_limits_and_has_two_sides() {
    let mut drawing = Drawing::default();
    let limits = [-0.5, 1.0];
    drawing.sector(Vec3::ZERO, Vec3::Z, Vec3::X, limits, 2.0, palette::GREEN);
    let first = vec(drawing.lines[0].from);
    assert!(first.distance(2.0 * Vec3::new(0.5_f32.cos(), -0.5_f32.sin(), 0.0)) < 1e-5);
    let from_centre = drawing.lines.iter().filter(|line| line.from == [0.0; 3]);
    assert_eq!(from_centre.count(), 2);
}

#[test]
fn dashes_begin_and_end_with_the_line() {
    let mut drawing = Drawing::default();
    drawing.dashes(Vec3::ZERO, Vec3::X, 0.1, 1.0, palette::GREY);
    assert_eq!(drawing.lines.len(), 5);
    assert_eq!(drawing.lines[0].from, [0.0; 3]);
    assert!((drawing.lines[4].to[0] - 1.0).abs() < 1e-6);
}

#[test]
fn a_boxs_edges_are_as_long_as_it_is() {
    let mut drawing = Drawing::default();
    drawing.cuboid(Vec3::ZERO, Vec3::new(1.0, 2.0, 3.0), 1.0, palette::SKY);
    let length = |line: &Line| vec(line.from).distance(vec(line.to));
    let sum: f32 = drawing.lines.iter().map(length).sum();
    assert_eq!((drawing.lines.len(), sum), (12, 24.0));
}
