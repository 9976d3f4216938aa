//! Tests of the rasteriser: see the documentation of `raster`.

use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, Scalar, View};
use proptest::prelude::*;

const STILL: Pose<f64> = Pose { cos: 1.0, sin: 0.0, x: 0.0, y: 0.0 };

/// A view in which a scene unit is a pixel and the origin is the lower left corner of a picture of this size.
fn pixelwise(width: f64, height: f64) -> View {
    View::new([width / 2.0, height / 2.0], 1.0)
}

/// Outlines are for ever, as those in a mechanism are.
fn polygon<T: Scalar>(corners: &[[T; 2]]) -> Outline<'static, T> {
    Outline::Polygon(corners.to_vec().leak())
}

fn circle(center: [f64; 2], radius: f64) -> Outline<'static, f64> {
    Outline::Circle { center, radius }
}

fn picture<const W: usize, const H: usize>(outline: Outline<f64>) -> Frame<W, H> {
    let mut frame = Frame::new();
    #[expect(clippy::cast_precision_loss, reason = "a few hundred pixels")]
    frame.look_at(pixelwise(W as f64, H as f64));
    frame.fill(outline, STILL, 1);
    frame
}

fn area<const W: usize, const H: usize>(frame: &Frame<W, H>) -> f64 {
    frame.pixels().iter().flatten().map(|&pixel| f64::from(pixel)).sum()
}

#[test]
fn a_pose_turns_and_moves() {
    let quarter = Pose { cos: 0.0, sin: 1.0, x: 5.0, y: 1.0 };
    let mut frame = Frame::<6, 5>::new();
    frame.look_at(pixelwise(6.0, 5.0));
    frame.fill(polygon(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]]), quarter, 7);
    let painted: Vec<_> = (0..5)
        .flat_map(|y| (0..6).map(move |x| (x, y)))
        .filter(|&(x, y)| frame.pixel(x, y) == Some(7))
        .collect();
    assert_eq!(painted, [(4, 1), (4, 2), (4, 3)]);
}

#[test]
fn the_two_scalars_paint_the_same() {
    let corners = [[1.25, 2.5], [60.75, 11.0], [41.5, 44.125], [7.0, 39.5]];
    let f64_frame = picture::<64, 48>(polygon(&corners));
    let mut f32_frame = Frame::<64, 48>::new();
    f32_frame.look_at(f64_frame.view());
    let corners = corners.map(|corner| corner.map(<f32 as mech_runtime::Real>::from_f64));
    f32_frame.fill(polygon(&corners), Pose::identity(), 1);
    assert_eq!(f64_frame, f32_frame);
}

#[test]
fn nothing_to_paint() {
    let empty: [Outline<f64>; 7] = [
        polygon(&[]),
        polygon(&[[1.0, 1.0]]),
        polygon(&[[1.0, 1.0], [8.0, 6.0]]),
        polygon(&[[3.0, 3.0]; 5]),
        circle([4.0, 4.0], 0.0),
        circle([4.0, 4.0], -3.0),
        circle([4.0, 4.0], f64::NAN),
    ];
    for outline in empty {
        assert_eq!(area(&picture::<9, 9>(outline)), 0.0, "{outline:?}");
    }
}

#[test]
fn a_corner_that_is_not_finite_hides_the_shape() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..2 {
            for corner in 0..3 {
                let mut corners = [[-90.0, -90.0], [90.0, -90.0], [0.0, 90.0]];
                corners[corner][axis] = bad;
                assert_eq!(area(&picture::<9, 9>(polygon(&corners))), 0.0);
            }
            let mut center = [4.0, 4.0];
            center[axis] = bad;
            assert_eq!(area(&picture::<9, 9>(circle(center, 3.0))), 0.0);
        }
        assert_eq!(area(&picture::<9, 9>(circle([4.0, 4.0], bad))), 0.0);
        let lost = Pose { cos: bad, ..STILL };
        let mut frame = Frame::<9, 9>::new();
        frame.fill(circle([1.0, 1.0], 3.0), lost, 1);
        frame.fill(polygon(&[[-90.0, -90.0], [90.0, -90.0], [0.0, 90.0]]), lost, 1);
        assert_eq!(area(&frame), 0.0);
    }
}

#[test]
fn shapes_much_larger_than_the_picture() {
    let corners = [[-1e9, -1e9], [1e9, -1e9], [1e9, 1e9], [-1e9, 1e9]];
    assert_eq!(area(&picture::<20, 30>(polygon(&corners))), 600.0);
    assert_eq!(area(&picture::<20, 30>(circle([0.0, 0.0], 1e9))), 600.0);
    // The half plane left of x = 7, the half plane above y = 7.
    assert_eq!(area(&picture::<20, 30>(circle([7.0 - 1e9, 15.0], 1e9))), 7.0 * 30.0);
    assert_eq!(
        area(&picture::<20, 30>(polygon(&[[-1e9, 7.0], [1e9, 7.0], [0.0, 1e9]]))),
        20.0 * 23.0
    );
    // Wholly to one side.
    for center in [[-1e9, 15.0], [1e9, 15.0], [10.0, -1e9], [10.0, 1e9]] {
        assert_eq!(area(&picture::<20, 30>(circle(center, 1e8))), 0.0);
        let moved = corners.map(|[x, y]| [x / 2.0 + center[0], y / 2.0 + center[1]]);
        assert_eq!(area(&picture::<20, 30>(polygon(&moved))), 0.0);
    }
}

#[test]
fn views_of_any_box_are_usable() {
    let numbers =
        [0.0, -3.0, 1e-300, 1e300, f64::MAX, f64::MIN, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for a in numbers {
        for b in numbers {
            for c in numbers {
                for size in [0, 1, 640] {
                    let view = View::fit([a, b], [c, a], size, 480, b);
                    assert!(view.scale().is_finite() && view.scale() > 0.0);
                    assert!(view.center().iter().all(|c| c.is_finite()));
                    let mut frame = Frame::<8, 8>::new();
                    frame.look_at(view);
                    frame.fill(circle([a, b], c), STILL, 1);
                    frame.fill(polygon(&[[a, b], [b, c], [c, a]]), STILL, 1);
                }
            }
        }
    }
}

#[test]
fn a_box_fits_with_its_margin() {
    let mut frame = Frame::<40, 20>::new();
    let [low, high] = [[-2.0, 1.0], [4.0, 9.0]];
    frame.look_at(View::fit(low, high, 40, 20, 2.0));
    assert_eq!(frame.view(), View::new([1.0, 5.0], 2.0));
    frame.fill(polygon(&[low, [4.0, 1.0], high, [-2.0, 9.0]]), STILL, 1);
    assert_eq!(area(&frame), 12.0 * 16.0);
    assert_eq!(View::fit(high, low, 40, 20, 2.0), frame.view());
    let upright = View::fit([0.0, 0.0], [0.0, 8.0], 40, 20, 2.0);
    assert_eq!(upright.scale(), 2.0);
    let point = View::fit([3.0, 3.0], [3.0, 3.0], 40, 20, 2.0);
    assert_eq!((point.center(), point.scale()), ([3.0, 3.0], 16.0));
}

#[test]
fn palettes_keep_to_their_order() {
    for palette in [Palette::TEXTBOOK, Palette::NIGHT] {
        for color in Palette::BLUE..=Palette::SLATE {
            let [dark, main, light] =
                [Palette::darker(color), color, Palette::lighter(color)].map(|entry| {
                    let [r, g, b] = palette.rgb(entry).map(u32::from);
                    299 * r + 587 * g + 114 * b
                });
            let ink_is_dark = palette.rgb(Palette::INK) < palette.rgb(Palette::PAPER);
            assert_eq!(dark < main, ink_is_dark, "{color}");
            assert_eq!(main < light, ink_is_dark, "{color}");
        }
        assert_eq!(Palette::shade(Palette::SLATE, 99), 255);
        assert_eq!(Palette::shade(Palette::BLUE, 0), 64);
        assert_eq!(palette.rgb(Palette::shade(Palette::INK, 15)), palette.rgb(Palette::PAPER));
        let distinct: std::collections::BTreeSet<_> = palette.entries()[..48].iter().collect();
        assert_eq!(distinct.len(), 48);
    }
    assert_eq!(Frame::<0, 3>::new().rgb(0, 0), None);
    let own = Palette::default().with(200, [1, 2, 3]);
    let mut frame = Frame::<1, 1>::new();
    frame.fill(circle([0.0, 0.0], 9.0), STILL, 200);
    frame.set_palette(own);
    assert_eq!(frame.rgb(0, 0), Some([1, 2, 3]));
    frame.clear();
    assert_eq!(frame.rgb(0, 0), Some(frame.palette().rgb(Palette::PAPER)));
}

fn sides(corners: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
    corners.iter().copied().zip(corners.iter().copied().cycle().skip(1))
}

/// Corners in and around a picture: anywhere, or on the centres of some pixels, so that many sides run through others.
fn corners() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let corner = [-30.0..160.0, -30.0..160.0];
    let corners = prop_oneof![
        prop::collection::vec(corner.clone(), 3..6),
        prop::collection::vec(corner, 3..40),
    ];
    let centers = |corners: Vec<[f64; 2]>| {
        let center = |part: f64| (part / 8.0).round() * 8.0 + 0.5;
        corners.iter().map(|corner| corner.map(center)).collect()
    };
    prop_oneof![corners.clone(), corners.prop_map(centers)]
}

/// The pixels of a picture, and the place of the centre of each.
fn centers<const W: usize, const H: usize>(
    frame: &Frame<W, H>,
) -> impl Iterator<Item = (u8, [f64; 2])> {
    let half = |number: u16| f64::from(number) + 0.5;
    let rows = frame.pixels().iter().rev().zip((0..).map(half));
    rows.flat_map(move |(row, y)| {
        row.iter().zip((0..).map(half)).map(move |(&pixel, x)| (pixel, [x, y]))
    })
}

/// That a pixel is painted if its centre is surrounded an odd number of times, or lies on the left or the upper border of what is.
fn assert_filled(corners: &[[f64; 2]]) {
    for (pixel, [x, y]) in centers(&picture::<128, 113>(polygon(corners))) {
        let (mut crossings, mut is_open) = (0, false);
        for (a, b) in sides(corners).filter(|(a, b)| (a[1] >= y) != (b[1] >= y)) {
            let slope = (b[0] - a[0]) / (b[1] - a[1]);
            let crossing = a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
            crossings += u8::from(x >= crossing);
            // Rows are stepped through by a slope that is rounded.
            is_open |= x == crossing && (slope * 256.0).fract() != 0.0;
        }
        assert!(is_open || pixel == crossings % 2, "at {x}, {y}");
    }
}

#[test]
fn sides_that_lie_on_each_other() {
    // A hole by a bridge.
    assert_filled(&[
        [0.0, 0.0],
        [7.0, 0.0],
        [7.0, 7.0],
        [0.0, 7.0],
        [0.0, 0.0],
        [2.0, 2.0],
        [2.0, 5.0],
        [5.0, 5.0],
        [5.0, 2.0],
        [2.0, 2.0],
    ]);
    // Sides that go there and back.
    for x in [0.0, 32.0] {
        assert_filled(&[
            [x, 0.0],
            [x, 82.882_158_923_738_03],
            [x, 0.361_989_534_212_752_76],
            [x + 23.929_578_780_299_618, 91.919_274_535_119_34],
        ]);
        assert_filled(&[
            [x, 0.0],
            [x, 47.720_132_416_072_22],
            [x + 26.638_395_494_050_627, 0.0],
            [x, 58.550_714_227_224_78],
        ]);
    }
}

proptest! {
    #[test]
    fn pixels_are_those_whose_centers_are_inside(corners in corners()) {
        assert_filled(&corners);
    }

    #[test]
    fn pixels_of_circles_are_those_whose_centers_are_inside(center in [-40.0..168.0, -40.0..153.0], radius in 0.0..120.0, share in 0.0..1.0) {
        let hole = share * radius;
        let [full, hollow] = [circle(center, radius), Outline::Ring { center, radius, hole }].map(|outline| picture::<128, 113>(outline));
        for ((full, [x, y]), (hollow, _)) in centers(&full).zip(centers(&hollow)) {
            let distance = f64::hypot(x - center[0], y - center[1]);
            let is_near = |radius: f64| (distance - radius).abs() < 1e-9;
            prop_assert!(is_near(radius) || (full == 1) == (distance < radius), "at {x}, {y}");
            prop_assert!(is_near(radius) || is_near(hole) || (hollow == 1) == (hole < distance && distance < radius), "at {x}, {y}");
        }
    }

    #[test]
    fn far_corners_are_clipped(corners in prop::collection::vec([-1e9..1e9, -1e9..1e9], 3..12)) {
        let frame = picture::<33, 17>(polygon(&corners));
        let corner_inside = |[x, y]: [f64; 2]| sides(&corners)
            .filter(|(a, b)| (a[1] > y) != (b[1] > y) && x > a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
            .count() % 2;
        prop_assert_eq!(frame.pixel(0, 0).map(usize::from), Some(corner_inside([0.5, 16.5])));
        prop_assert_eq!(frame.pixel(32, 16).map(usize::from), Some(corner_inside([32.5, 0.5])));
    }
}
