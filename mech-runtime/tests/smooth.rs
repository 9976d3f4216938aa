//! Tests of the anti-aliased picture: it paints as much of each pixel as an outline covers.

use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, Real, Scalar, Smooth, View};
use proptest::prelude::*;

const W: usize = 48;
const H: usize = 40;

/// A picture in which a scene unit is a pixel, the origin is the lower left corner, and white is painted on black: what is seen is
/// how much of each pixel is covered, in 255ths.
fn picture<T: Scalar, const W: usize, const H: usize>(outline: Outline<T>) -> Vec<[u8; W]> {
    let mut picture = Box::new(Smooth::<W, H>::new());
    picture.set_palette(Palette::default().with(0, [0; 3]).with(1, [255; 3]));
    picture.clear();
    #[expect(clippy::cast_precision_loss, reason = "small")]
    picture.look_at(View::new([W as f64 / 2.0, H as f64 / 2.0], 1.0));
    picture.fill(outline, Pose::identity(), 1);
    let rows = picture.pixels().iter();
    rows.map(|row| row.map(|pixel| pixel[0])).collect()
}

fn coverage(outline: Outline<f64>) -> Vec<[u8; W]> {
    picture::<f64, W, H>(outline)
}

/// The part of a polygon on one side of a line parallel to an axis.
fn clip(corners: &[[f64; 2]], axis: usize, limit: f64, sign: f64) -> Vec<[f64; 2]> {
    let mut clipped = Vec::new();
    let depth = |corner: [f64; 2]| sign * (corner[axis] - limit);
    for (index, &head) in corners.iter().enumerate() {
        let tail = corners[(index + corners.len() - 1) % corners.len()];
        let [from, to] = [depth(tail), depth(head)];
        if (from < 0.0) != (to < 0.0) {
            let share = from / (from - to);
            clipped.push([0, 1].map(|part| tail[part] + share * (head[part] - tail[part])));
        }
        if to >= 0.0 {
            clipped.push(head);
        }
    }
    clipped
}

fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let pairs = corners.iter().zip(next);
    0.5 * pairs.map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
}

/// The area of a simple polygon in each pixel, found by cutting it.
fn shares(corners: &[[f64; 2]]) -> Vec<[f64; W]> {
    let rows = (0..40).rev().map(|row| {
        let strip = clip(&clip(corners, 1, f64::from(row), 1.0), 1, f64::from(row + 1), -1.0);
        std::array::from_fn(|column| {
            #[expect(clippy::cast_precision_loss, reason = "small")]
            let left = column as f64;
            let pixel = clip(&clip(&strip, 0, left, 1.0), 0, left + 1.0, -1.0);
            area(&pixel).abs()
        })
    });
    rows.collect()
}

/// The area within a circle around the origin above a level and between two abscissas, by the antiderivative of its height.
fn area_above(level: f64, [from, to]: [f64; 2], radius: f64) -> f64 {
    let reach = (radius * radius - level * level).max(0.0).sqrt();
    let half = |x: f64| (radius * radius - x * x).max(0.0).sqrt();
    let sum = |x: f64| 0.5 * (x * half(x) + radius * radius * (x / radius).clamp(-1.0, 1.0).asin());
    let within = |limit: f64| [from.clamp(-limit, limit), to.clamp(-limit, limit)];
    let [a, b] = within(reach);
    let above_chord = sum(b) - sum(a) - level * (b - a);
    if level >= 0.0 {
        return above_chord;
    }
    // The parts beside the chord, above and below the diameter.
    let [c, d] = within(radius);
    above_chord + 2.0 * (sum(d) - sum(c) - (sum(b) - sum(a)))
}

/// The area of a circle in each pixel.
fn disc_shares<const W: usize, const H: usize>([x, y]: [f64; 2], radius: f64) -> Vec<[f64; W]> {
    let number = |index: usize| f64::from(u32::try_from(index).expect("small"));
    let above = |level: f64, sides| {
        if level < radius { area_above(level, sides, radius) } else { 0.0 }
    };
    let rows = (0..H).rev().map(|row| {
        let [bottom, top] = [number(row) - y, number(row) + 1.0 - y];
        std::array::from_fn(|column| {
            let sides = [number(column) - x, number(column) + 1.0 - x];
            above(bottom, sides) - above(top, sides)
        })
    });
    rows.collect()
}

/// No pixel is more than one step of 255 off, but for what the expectation itself may err.
#[track_caller]
fn assert_exact<const W: usize>(found: &[[u8; W]], expected: &[[f64; W]]) {
    for (row, (found, expected)) in found.iter().zip(expected).enumerate() {
        for (column, (found, expected)) in found.iter().zip(expected).enumerate() {
            let error = f64::from(*found) - 255.0 * expected;
            assert!(error.abs() <= 1.0, "{found} of {} at {column}, {row}", 255.0 * expected);
        }
    }
}

fn star() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let centers = [10.0..40.0, 5.0..35.0];
    (prop::collection::vec(0.3..30.0, 3..24), centers).prop_map(|(radii, [x, y])| {
        #[expect(clippy::cast_precision_loss, reason = "small")]
        let step = std::f64::consts::TAU / radii.len() as f64;
        let mut angle = 0.1_f64;
        let corners = radii.into_iter().map(|radius: f64| {
            angle += step;
            [x + radius * angle.cos(), y + radius * angle.sin()]
        });
        corners.collect()
    })
}

proptest! {
    #[test]
    fn a_polygon_covers_its_part_of_each_pixel(corners in star()) {
        let expected = shares(&corners);
        assert_exact(&coverage(Outline::Polygon(&corners)), &expected);
        assert_exact(&coverage(Outline::Winding(&corners)), &expected);
        let narrow: Vec<_> = corners.iter().map(|corner| corner.map(<f32 as Real>::from_f64)).collect();
        assert_exact(&picture::<f32, W, H>(Outline::Polygon(&narrow)), &expected);
    }

    #[test]
    fn a_circle_covers_its_part_of_each_pixel(center in [-20.0..220.0, -40.0..200.0], radius in prop_oneof![0.2..9.0, 3.0..200.0]) {
        assert_exact(&picture::<f64, 200, 160>(Outline::Circle { center, radius }), &disc_shares::<200, 160>(center, radius));
    }

    #[test]
    fn so_does_one_within_the_margins(radius in prop_oneof![0.2..9.0, 3.0..98.0], place in 0.0..1.0, y in -60.0..220.0) {
        let center = [radius + 1.0 + place * (198.0 - 2.0 * radius), y];
        assert_exact(&picture::<f64, 200, 160>(Outline::Circle { center, radius }), &disc_shares::<200, 160>(center, radius));
        let (center, radius) = (center.map(<f32 as Real>::from_f64), <f32 as Real>::from_f64(radius));
        let found = picture::<f32, 200, 160>(Outline::Circle { center, radius });
        assert_exact(&found, &disc_shares::<200, 160>(center.map(f64::from), f64::from(radius)));
    }

    #[test]
    fn a_ring_is_a_circle_without_its_hole(center in [0.0..48.0, 0.0..40.0], radius in 2.0..40.0, share in 0.1..0.99) {
        let hole = share * radius;
        let (outer, inner) = (disc_shares::<W, H>(center, radius), disc_shares::<W, H>(center, hole));
        let expected: Vec<_> = outer.iter().zip(&inner).map(|(outer, inner)| {
            let mut difference = *outer;
            for (outer, inner) in difference.iter_mut().zip(inner) {
                *outer -= inner;
            }
            difference
        }).collect();
        // Each circle may be half a step off.
        let found = coverage(Outline::Ring { center, radius, hole });
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            prop_assert!((f64::from(*found) - 255.0 * expected).abs() <= 1.25);
        }
    }

    #[test]
    fn a_straight_line_covers_what_is_within_half_its_width(ends in [[5.0..43.0, 5.0..35.0], [5.0..43.0, 5.0..35.0]], width in 0.5..9.0) {
        let found = coverage(Outline::Line { points: &ends, width });
        let [from, to] = ends;
        let offset = [to[0] - from[0], to[1] - from[1]];
        let square = offset[0] * offset[0] + offset[1] * offset[1];
        let distance = |x: f64, y: f64| {
            let share = (((x - from[0]) * offset[0] + (y - from[1]) * offset[1]) / square).clamp(0.0, 1.0);
            f64::hypot(x - from[0] - share * offset[0], y - from[1] - share * offset[1])
        };
        for (row, found) in found.iter().rev().enumerate() {
            for (column, &found) in found.iter().enumerate() {
                let samples = 24_u32;
                let mut inside = 0;
                for sample in 0..samples * samples {
                    #[expect(clippy::cast_precision_loss, reason = "small")]
                    let [x, y] = [(column, sample % samples), (row, sample / samples)]
                        .map(|(pixel, part)| pixel as f64 + (f64::from(part) + 0.5) / f64::from(samples));
                    inside += u32::from(distance(x, y) <= width / 2.0);
                }
                let share = f64::from(inside) / f64::from(samples * samples);
                prop_assert!((f64::from(found) / 255.0 - share).abs() < 0.035, "{found} of {} at {column}, {row}", share * 255.0);
            }
        }
    }

    #[test]
    fn what_frames_paint_is_at_least_half_covered(corners in star(), line in prop::collection::vec([3.0..45.0, 3.0..37.0], 1..6), width in 1.0..6.0, angle in -6.0..6.0) {
        let outlines = [
            Outline::Polygon(&corners),
            Outline::Line { points: &line, width },
            Outline::Arc { center: [24.0, 20.0], start: line[0], angle, width },
        ];
        for outline in outlines {
            let mut frame = Frame::<W, H>::new();
            frame.look_at(View::new([24.0, 20.0], 1.0));
            frame.fill(outline, Pose::identity(), 1);
            let smooth = coverage(outline);
            let (mut hard, mut soft) = (0.0, 0.0);
            for (hard_row, soft_row) in frame.pixels().iter().zip(&smooth) {
                for (&pixel, &share) in hard_row.iter().zip(soft_row) {
                    hard += f64::from(pixel);
                    soft += f64::from(share) / 255.0;
                    // A centre that is inside has some of its pixel around it inside, and the reverse.
                    prop_assert!(pixel == 0 || share > 0, "{outline:?}");
                    // Not so where a line crosses itself: what it covers twice counts twice.
                    let may_cross = matches!(outline, Outline::Line { points: [_, _, _, ..], .. });
                    prop_assert!(pixel == 1 || share < 255 || may_cross, "{outline:?}");
                }
            }
            prop_assert!((hard - soft).abs() < 0.12 * soft + 16.0, "{hard} and {soft}");
        }
    }

    #[test]
    fn no_number_is_too_bad(
        corners in prop::collection::vec([prop::num::f64::ANY, prop::num::f64::ANY], 0..12),
        far in prop::collection::vec([-1e9..1e9, -1e9..1e9], 0..12),
        pose in [prop::num::f64::ANY; 4],
        number in prop::num::f64::ANY,
        scale in prop::num::f64::ANY,
        color in any::<u8>(),
    ) {
        let [cos, sin, x, y] = pose;
        let narrow = |pair: [f64; 2]| pair.map(<f32 as Real>::from_f64);
        let mut smooth = Smooth::<33, 17>::new();
        let mut frame = Frame::<33, 17>::new();
        for view in [View::new([0.0, 0.0], 1.0), View::new([x, y], scale)] {
            smooth.look_at(view);
            frame.look_at(view);
            for pose in [Pose::identity(), Pose { cos, sin, x, y }] {
                for points in [&corners, &far] {
                    let center = points.first().copied().unwrap_or([number; 2]);
                    let outlines = [
                        Outline::Polygon(points),
                        Outline::Winding(points),
                        Outline::Circle { center, radius: x },
                        Outline::Ring { center, radius: 2.0 * y, hole: y },
                        Outline::Line { points, width: 5.0 },
                        Outline::Line { points, width: number.clamp(-1e6, 1e6) },
                        Outline::Arc { center, start: [sin, cos], angle: x, width: y.clamp(-1e6, 1e6) },
                    ];
                    for outline in outlines {
                        smooth.fill(outline, pose, color);
                        frame.fill(outline, pose, color);
                    }
                    let points: Vec<_> = points.iter().copied().map(narrow).collect();
                    let [in_single, [radius, _]] = [narrow(center), narrow([number, x])];
                    for outline in [Outline::Polygon(&points[..]), Outline::Circle { center: in_single, radius }] {
                        smooth.fill(outline, Pose::identity(), color);
                        frame.fill(outline, Pose::identity(), color);
                    }
                    smooth.text(center, "M\u{fc}", color);
                    frame.text(center, "M\u{fc}", color);
                }
            }
        }
    }

    #[test]
    fn far_corners_are_clipped(corners in prop::collection::vec([-1e9..1e9, -1e9..1e9], 3..9)) {
        let found = coverage(Outline::Polygon(&corners));
        for (column, row) in [(0, 0), (47, 39), (20, 20)] {
            let (x, y) = (f64::from(column) + 0.5, 40.0 - f64::from(row) - 0.5);
            let sides = corners.iter().zip(corners.iter().cycle().skip(1));
            let mut crossings = 0;
            let mut is_near = false;
            for (a, b) in sides {
                let crosses = (a[1] > y) != (b[1] > y);
                let at = a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
                crossings += usize::from(crosses && x > at);
                // The distance to the whole line.
                let offset = [b[0] - a[0], b[1] - a[1]];
                let distance = ((x - a[0]) * offset[1] - (y - a[1]) * offset[0]) / offset[0].hypot(offset[1]);
                is_near |= distance.abs() < 2.0;
            }
            let expected = if crossings % 2 == 1 { 255 } else { 0 };
            let found = found[usize::try_from(row).expect("a row")][usize::try_from(column).expect("a column")];
            prop_assert!(is_near || found == expected, "{found} in place of {expected}");
        }
    }
}

#[test]
fn half_a_pixel_is_half_a_color() {
    let corners = [[3.5, 4.0], [8.0, 4.0], [8.0, 6.25], [3.5, 6.25]];
    let found = coverage(Outline::Polygon(&corners));
    assert_eq!(found[35][3], 128);
    assert_eq!(found[35][4], 255);
    assert_eq!(found[33][5], 64);
    assert_eq!(found[33][3], 32);
    assert_eq!(found[33][8], 0);
}

#[test]
fn a_part_of_a_pixel_takes_a_part_of_the_color() {
    let mut picture = Smooth::<4, 4>::new();
    let palette = Palette::default().with(0, [10, 20, 30]).with(1, [210, 120, 30]);
    picture.set_palette(palette);
    picture.clear();
    picture.fill(
        Outline::Polygon(&[[-2.0, -2.0], [-1.5, -2.0], [-1.5, 2.0], [-2.0, 2.0]]),
        Pose::identity(),
        1,
    );
    assert_eq!(picture.pixel(0, 1), Some([110, 70, 30, 255]));
    assert_eq!(picture.pixel(1, 1), Some([10, 20, 30, 255]));
    assert_eq!(picture.pixel(4, 1), None);
}

#[test]
fn what_is_surrounded_twice() {
    let twice = [
        [2.0, 2.0],
        [20.0, 2.0],
        [20.0, 20.0],
        [2.0, 20.0],
        [2.0, 2.0],
        [8.0, 8.0],
        [14.0, 8.0],
        [14.0, 14.0],
        [8.0, 14.0],
        [8.0, 8.0],
    ];
    let (hollow, full) = (coverage(Outline::Polygon(&twice)), coverage(Outline::Winding(&twice)));
    assert_eq!((hollow[29][10], full[29][10]), (0, 255));
    assert_eq!((hollow[35][4], full[35][4]), (255, 255));
}

#[test]
fn a_picture_is_a_value() {
    let mut one = Smooth::<8, 8>::default();
    let other = one.clone();
    assert_eq!(one, other);
    one.fill(Outline::Circle { center: [0.0, 0.0], radius: 2.0 }, Pose::identity(), 3);
    assert_ne!(one, other);
    one.clear();
    assert_eq!(one, other);
    assert_eq!(
        format!("{one:?}"),
        "Smooth<8, 8> { view: View { center: [0.0, 0.0], scale: 1.0 }, .. }"
    );
    assert_eq!(one.palette(), &Palette::TEXTBOOK);
    assert_eq!(Canvas::<f64>::scale(&one), one.view().scale());
}
