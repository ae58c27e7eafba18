//! The drawings.

use ch03_collision::narrow::clip::clip as clipped;
use ch03_collision::narrow::features::Feature;
use ch03_collision::narrow::simplex::Simplex;
use ch03_collision::narrow::support_point::{Core, Hull, Vertex};
use glam::{Mat3, Vec2, Vec3, vec2};

use crate::svg::{A, B, BOUND, Frame, GREY, NEAREST, SEEING, SIMPLEX, SUPPORT, Svg, TEXT};
use crate::{Look, apart, disc_and_bar, overlapping, triangle, watch};

/// The outline of what has these support points.
fn outline(support: impl Fn(Vec3) -> Vec3) -> Vec<Vec3> {
    let mut corners: Vec<Vec3> = Vec::new();
    for k in 0..180 {
        let angle = (k as f32 + 0.5) * std::f32::consts::TAU / 180.0;
        let corner = support(Vec3::new(angle.cos(), angle.sin(), 0.0));
        if corners
            .last()
            .is_none_or(|last| last.distance(corner) > 1e-4)
        {
            corners.push(corner);
        }
    }
    corners
}

fn difference([a, b]: &[Core; 2]) -> Vec<Vec3> {
    outline(|direction| Vertex::support(a, b, direction).point)
}

/// Two pairs of rectangles and their differences.
pub fn minkowski() -> String {
    let label = "Above, two rectangles that are apart, and the set of all differences of their points: an \
                 octagon beside the origin, as far from it as the two are from each other. Below, the same two \
                 overlapping: now the origin is inside the octagon";
    let mut svg = Svg::new(vec2(720.0, 440.0), label);
    let rows = [
        (apart(), vec2(95.0, 150.0), vec2(440.0, 155.0)),
        (overlapping(), vec2(95.0, 350.0), vec2(500.0, 340.0)),
    ];
    for (row, (pair, left, right)) in rows.into_iter().enumerate() {
        let [left, right] = [left, right].map(|origin| Frame {
            origin,
            scale: 50.0,
        });
        let [a, b] = &pair;
        for (core, color, name) in [(a, A, "a"), (b, B, "b")] {
            let corners = outline(|direction| core.support(direction));
            svg.area(&left.all(&corners), color, 0.3, 2.0);
            svg.letter(left.at(core.centre) + vec2(0.0, 5.0), name, TEXT);
        }
        svg.area(&right.all(&difference(&pair)), GREY, 0.16, 1.5);
        svg.letter(
            right.at(a.centre - b.centre) + vec2(30.0, 5.0),
            "a − b",
            TEXT,
        );
        let way = shortest(&pair);
        svg.line([right.at(Vec3::ZERO), right.at(way.point)], NEAREST, 3.0);
        svg.line([left.at(way.on_a), left.at(way.on_b)], NEAREST, 3.0);
        svg.origin(right.at(Vec3::ZERO));
        let top = 20.0 + 220.0 * row as f32;
        svg.heading(vec2(10.0, top), ["apart", "overlapping"][row]);
        let words = ["the origin lies outside", "the origin lies inside"][row];
        svg.heading(vec2(270.0, top), words);
    }
    svg.finish()
}

/// The point of the difference's outline that is nearest to the origin, with the points of a and b.
fn shortest(pair: &[Core; 2]) -> Vertex {
    let [a, b] = pair;
    let (looks, _) = watch(a, b);
    let from_simplex = |simplex: &Simplex| {
        let (on_a, on_b) = simplex.witnesses();
        Vertex {
            point: on_a - on_b,
            on_a,
            on_b,
        }
    };
    match looks.last() {
        Some(last) if last.at_least > 0.0 => from_simplex(&last.simplex),
        _ => {
            let looks = crate::epa::epa(a, b, triangle().vertices());
            let last = looks.last().expect("it looks at least once");
            let next = (last.nearest + 1) % last.polygon.len();
            let edge = Simplex::new(&[last.polygon[last.nearest], last.polygon[next]]);
            from_simplex(&edge)
        }
    }
}

/// Four iterations of GJK.
pub fn gjk() -> String {
    let label = "Four iterations of GJK on a disc and a bar. The simplex is a point, then a segment that comes \
                 nearer to the origin each time, and a line behind which all differences lie comes nearer from \
                 the other side, until both meet";
    let mut svg = Svg::new(vec2(720.0, 500.0), label);
    let pair = disc_and_bar();
    let (looks, _) = watch(&pair[0], &pair[1]);
    for (i, look) in looks.iter().enumerate() {
        let corner = vec2(360.0 * (i % 2) as f32, 250.0 * (i / 2) as f32);
        let frame = Frame {
            origin: corner + vec2(118.0, 218.0),
            scale: 56.0,
        };
        svg.area(&frame.all(&difference(&pair)), GREY, 0.14, 1.5);
        iteration(&mut svg, frame, look);
        svg.heading(corner + vec2(10.0, 20.0), &(i + 1).to_string());
        let distance = look.simplex.nearest().length();
        let numbers = format!("|v| = {distance:.3}, at least {:.3}", look.at_least);
        let numbers = numbers.replace('-', "−");
        svg.words(corner + vec2(30.0, 20.0), &numbers);
    }
    svg.finish()
}

fn iteration(svg: &mut Svg, frame: Frame, look: &Look) {
    let v = look.simplex.nearest();
    let (at_v, at_w) = (frame.at(v), frame.at(look.support.point));
    let toward = Frame::along(v);
    // No difference lies before the line through w.
    let foot = frame.at(v.normalize() * look.at_least);
    let along = (foot - at_w).normalize_or(toward.perp());
    svg.line([at_w - 30.0 * along, foot + 12.0 * along], BOUND, 2.0);
    let corners: Vec<Vec2> = look
        .simplex
        .vertices()
        .iter()
        .map(|w| frame.at(w.point))
        .collect();
    if let [one, other] = corners[..] {
        svg.line([one, other], SIMPLEX, 4.0);
    }
    svg.line([frame.at(Vec3::ZERO), at_v], NEAREST, 2.5);
    svg.origin(frame.at(Vec3::ZERO));
    for corner in corners {
        svg.dot(corner, 5.0, SIMPLEX);
    }
    svg.dot(at_v, 4.0, NEAREST);
    svg.ring(at_w, 6.5, SUPPORT);
    svg.letter(at_v + 17.0 * toward + vec2(0.0, 5.0), "v", NEAREST);
    let side = (at_w - at_v).normalize_or_zero();
    svg.letter(
        at_w + 17.0 * (side - 0.3 * toward) + vec2(0.0, 5.0),
        "w",
        SUPPORT,
    );
}

/// Three iterations of EPA.
pub fn epa() -> String {
    let label = "Three iterations of EPA in the plane. A triangle round the origin grows by the furthest point \
                 beyond its nearest edge, twice; the third time nothing lies beyond";
    let mut svg = Svg::new(vec2(720.0, 250.0), label);
    let pair = overlapping();
    let looks = crate::epa::epa(&pair[0], &pair[1], triangle().vertices());
    for (i, look) in looks.iter().enumerate() {
        let corner = vec2(240.0 * i as f32, 0.0);
        let frame = Frame {
            origin: corner + vec2(82.0, 160.0),
            scale: 44.0,
        };
        svg.area(&frame.all(&difference(&pair)), GREY, 0.14, 1.5);
        let polygon: Vec<Vec2> = look.polygon.iter().map(|w| frame.at(w.point)).collect();
        svg.area(&polygon, SIMPLEX, 0.16, 2.0);
        let next = (look.nearest + 1) % polygon.len();
        svg.line([polygon[look.nearest], polygon[next]], SEEING, 5.0);
        let foot = frame.at(look.normal * look.distance);
        svg.line([frame.at(Vec3::ZERO), foot], NEAREST, 2.5);
        let along = Frame::along(look.normal);
        let at_w = frame.at(look.support.point);
        let line = frame.at(look.normal * look.at_most());
        if look.at_most() - look.distance > 1e-3 {
            svg.dashes(
                [line - 60.0 * along.perp(), line + 60.0 * along.perp()],
                BOUND,
                2.0,
            );
            svg.ring(at_w, 6.5, SUPPORT);
            svg.letter(at_w + 16.0 * along + vec2(10.0, 5.0), "w", SUPPORT);
        }
        svg.origin(frame.at(Vec3::ZERO));
        svg.heading(corner + vec2(10.0, 20.0), &(i + 1).to_string());
        svg.words(
            corner + vec2(30.0, 20.0),
            &format!("at least {:.3}", look.distance),
        );
        svg.words(
            corner + vec2(30.0, 38.0),
            &format!("w at {:.3}", look.at_most()),
        );
    }
    svg.finish()
}

/// Which part of a triangle is nearest to a point of the plane.
pub fn regions() -> String {
    let label = "A triangle with corners A, B, C. Perpendiculars to its sides at the corners divide the plane \
                 into seven regions: the inside, three strips that belong to the sides, and three wedges that \
                 belong to the corners";
    let mut svg = Svg::new(vec2(720.0, 330.0), label);
    let frame = Frame {
        origin: vec2(280.0, 205.0),
        scale: 68.0,
    };
    let corners = [
        Vec3::new(-1.1, -0.35, 0.0),
        Vec3::new(1.3, -0.5, 0.0),
        Vec3::new(0.2, 1.25, 0.0),
    ];
    for i in 0..3 {
        strip_and_wedge(&mut svg, &frame, &corners, i);
    }
    svg.area(&frame.all(&corners), BOUND, 0.3, 2.0);
    check(&corners, Vec3::ZERO, 3);
    svg.letter(frame.at(Vec3::new(0.13, 0.05, 0.0)), "ABC", TEXT);
    legend(&mut svg);
    svg.finish()
}

/// The strip along the side that begins at a corner, and the corner's wedge.
fn strip_and_wedge(svg: &mut Svg, frame: &Frame, corners: &[Vec3; 3], i: usize) {
    let (from, to, last) = (corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]);
    let out = (to - from).cross(Vec3::Z).normalize();
    let before = (from - last).cross(Vec3::Z).normalize();
    let strip = [from, to, to + 1.2 * out, from + 1.2 * out];
    svg.area(&frame.all(&strip), SIMPLEX, 0.18, 0.0);
    let between = (out + before).normalize();
    let wedge = [
        from,
        from + 1.2 * before,
        from + 1.2 * between,
        from + 1.2 * out,
    ];
    svg.area(&frame.all(&wedge), SUPPORT, 0.18, 0.0);
    for end in [from + 1.2 * out, from + 1.2 * before] {
        svg.dashes([frame.at(from), frame.at(end)], GREY, 1.5);
    }
    let middle = frame.at(0.5 * (from + to) + 0.75 * out);
    let edge = ["AB", "BC", "CA"][i];
    check(corners, 0.5 * (from + to) + 0.75 * out, 2);
    svg.letter(middle + vec2(0.0, 5.0), edge, TEXT);
    let beyond = from + 0.75 * between;
    check(corners, beyond, 1);
    svg.letter(frame.at(beyond) + vec2(0.0, 5.0), ["A", "B", "C"][i], TEXT);
}

/// What the colours of the regions say.
fn legend(svg: &mut Svg) {
    for (at, color, words) in [
        (110.0, SUPPORT, "a corner"),
        (150.0, SIMPLEX, "a side"),
        (190.0, BOUND, "the inside"),
    ] {
        svg.area(
            &[
                vec2(540.0, at - 11.0),
                vec2(560.0, at - 11.0),
                vec2(560.0, at + 3.0),
                vec2(540.0, at + 3.0),
            ],
            color,
            0.3,
            1.0,
        );
        svg.words(vec2(572.0, at), words);
    }
    svg.words(vec2(540.0, 75.0), "If the origin is here,");
    svg.words(vec2(540.0, 228.0), "carries the nearest point.");
}

/// The engine must agree that so many corners carry the point nearest to `origin`.
fn check(corners: &[Vec3; 3], origin: Vec3, count: usize) {
    let seen = corners.map(|corner| Vertex {
        point: corner - origin,
        ..Vertex::default()
    });
    let simplex = Simplex::new(&seen);
    assert_eq!(simplex.vertices().len(), count, "{origin}");
}

/// A face of one box cut to the face of another, seen from above.
pub fn clip() -> String {
    let label = "Three frames, seen from above. A rectangle lies across another one. Cut at the left and right \
                 side of the lower one, then at the other two, it becomes a polygon with six corners, four of which \
                 are kept as contact points";
    let mut svg = Svg::new(vec2(720.0, 285.0), label);
    let lying = |x: f32, z: f32| Core {
        hull: Hull::Box {
            half_extents: Vec3::new(x, 0.2, z),
        },
        radius: 0.0,
        centre: Vec3::ZERO,
        axes: Mat3::IDENTITY,
    };
    let mut upper = lying(1.35, 0.55);
    upper.centre = Vec3::new(0.15, 0.395, 0.1);
    upper.axes = Mat3::from_rotation_y(0.5) * Mat3::from_rotation_z(0.004);
    let other = upper.widest_feature(Vec3::NEG_Y);
    let frames = [
        ("1  the two faces", lying(50.0, 50.0)),
        ("2  cut at two sides", lying(1.0, 50.0)),
        ("3  cut at all four", lying(1.0, 0.65)),
    ];
    let face = frames[2].1.widest_feature(Vec3::Y);
    for (i, (name, lower)) in frames.iter().enumerate() {
        let corner = vec2(240.0 * i as f32, 0.0);
        svg.area(&from_above(corner, face.corners()), B, 0.25, 2.0);
        let (fill, line) = if i == 0 { (0.3, 2.0) } else { (0.08, 0.7) };
        svg.area(&from_above(corner, other.corners()), A, fill, line);
        if i > 0 {
            cut(&mut svg, corner, &other, &lower.widest_feature(Vec3::Y));
        }
        svg.heading(corner + vec2(10.0, 20.0), name);
    }
    let touch = ch03_collision::narrow::manifold(
        &upper,
        &frames[2].1,
        &ch03_collision::narrow::shortest_way::shortest_way(&upper, &frames[2].1, 0.01)
            .expect("they touch"),
        0.01,
    );
    for spot in touch.spots() {
        let at = from_above(vec2(480.0, 0.0), &[spot.point]);
        svg.ring(at[0], 8.5, BOUND);
    }
    svg.words(vec2(10.0, 272.0), "orange: lower face of a");
    svg.words(vec2(250.0, 272.0), "blue: upper face of b");
    svg.words(vec2(490.0, 272.0), "ringed: the four that stay");
    svg.finish()
}

/// Where points are in a frame whose corner is here, seen from above.
fn from_above(corner: Vec2, points: &[Vec3]) -> Vec<Vec2> {
    let seen = |p: &Vec3| corner + vec2(118.0, 150.0) + 76.0 * vec2(p.x, p.z);
    points.iter().map(seen).collect()
}

/// What is left of a face, cut at the sides of another one.
fn cut(svg: &mut Svg, corner: Vec2, face: &Feature, sides: &Feature) {
    let points = clipped(face, sides, Vec3::Y, 0.0);
    let points: Vec<Vec3> = points.points().iter().map(|point| point.at).collect();
    let left = from_above(corner, &points);
    svg.area(&left, A, 0.35, 2.0);
    for &point in &left {
        svg.dot(point, 4.0, SUPPORT);
    }
}
