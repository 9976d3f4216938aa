//! Stills: away from edges and slivers pixels have the colour that the rasteriser gives them, eight times as large.

use mech_gallery::four_bar::CrankRocker;
use mech_gallery::geared_piston::GearedPiston;
use mech_gallery::jansen::JansenLeg;
use mech_runtime::files::{Sheet, Svg};
use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, Scalar, View};
use proptest::prelude::*;
use resvg::{tiny_skia, usvg};

const SIDE: usize = 64;
/// Samples a pixel in each direction.
const FINE: usize = 8;
const LARGE: usize = SIDE * FINE;

/// What is seen of an SVG, eight times as large: so no line is thinner than a pixel, which the other renderer treats in a manner of
/// its own.
fn rendered(svg: &str) -> Vec<[u8; 3]> {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).expect("an SVG");
    assert_eq!((tree.size().width(), tree.size().height()), (64.0, 64.0));
    let side = u32::try_from(LARGE).expect("small");
    let mut pixels = tiny_skia::Pixmap::new(side, side).expect("a size");
    let large = tiny_skia::Transform::from_scale(8.0, 8.0);
    resvg::render(&tree, large, &mut pixels.as_mut());
    let opaque = pixels.pixels().iter().map(|pixel| {
        assert_eq!(pixel.alpha(), 255);
        [pixel.red(), pixel.green(), pixel.blue()]
    });
    opaque.collect()
}

/// Compares all pixels around which there are no edges; gives their number.
fn compare(svg: &str, frame: &Frame<LARGE, LARGE>) -> usize {
    let (mut compared, mut different) = (0, 0);
    for (index, found) in rendered(svg).into_iter().enumerate() {
        let (x, y) = (index % LARGE, index / LARGE);
        let around = |middle: usize| middle.saturating_sub(2)..(middle + 3).min(LARGE);
        let mut rows = around(y).map(|y| &frame.pixels()[y][around(x)]);
        let entry = frame.pixels()[y][x];
        if rows.all(|row| row.iter().all(|&other| other == entry)) {
            let wanted = frame.palette().rgb(entry);
            let distances = found.iter().zip(wanted).map(|(found, wanted)| found.abs_diff(wanted));
            let distance = distances.max().expect("three");
            different += usize::from(distance > 3);
            compared += 1;
        }
    }
    assert!(different * 200 <= compared, "{different} of {compared} differ:\n{svg}");
    compared
}

/// Both pictures of the same thing.
fn both(
    view: View,
    paint_svg: impl FnOnce(&mut Svg),
    paint_frame: impl FnOnce(&mut Frame<LARGE, LARGE>),
) -> usize {
    let mut svg = Svg::new(Sheet::new(SIDE, SIDE).look_at(view).palette(Palette::NIGHT));
    paint_svg(&mut svg);
    let mut frame = Box::new(Frame::new());
    frame.set_palette(Palette::NIGHT);
    #[expect(clippy::cast_precision_loss, reason = "eight")]
    frame.look_at(View::new(view.center(), view.scale() * FINE as f64));
    paint_frame(&mut frame);
    compare(&svg.finish(), &frame)
}

#[test]
fn mechanisms() {
    let view = View::new([0.5, 0.5], 9.0);
    let (piston, four_bar, leg) = (GearedPiston::new(), CrankRocker::new(), JansenLeg::new());
    let compared = [
        both(view, |svg| piston.draw(svg), |frame| piston.draw(frame)),
        both(view, |svg| four_bar.draw(svg), |frame| four_bar.draw(frame)),
        both(View::new([0.0, 0.0], 0.5), |svg| leg.draw(svg), |frame| leg.draw(frame)),
    ];
    assert!(compared.iter().all(|count| *count > LARGE * LARGE / 2), "{compared:?}");
}

fn pose<T: Scalar>() -> impl Strategy<Value = Pose<T>> {
    let number = mech_runtime::Real::from_f64;
    (0.0..7.0, -3.0..3.0, -3.0..3.0).prop_map(move |(angle, x, y): (f64, f64, f64)| {
        let [cos, sin, x, y] = [angle.cos(), angle.sin(), x, y].map(number);
        Pose { cos, sin, x, y }
    })
}

/// An outline of some kind through these points, a size, a size and an angle.
type Random<T> = (u8, Vec<[T; 2]>, [T; 3], Pose<T>, u8);

/// A few shapes of all kinds: polygons may cut themselves, lines turn back, arcs go more than once round.
fn shapes<T: Scalar>() -> impl Strategy<Value = Vec<Random<T>>> {
    let number = mech_runtime::Real::from_f64;
    let point = [-3.0..3.0, -3.0..3.0].prop_map(move |point: [f64; 2]| point.map(number));
    let points = prop::collection::vec(point, 2..8);
    let sizes =
        [0.05..2.0, 0.05..2.0, -7.0..7.0].prop_map(move |sizes: [f64; 3]| sizes.map(number));
    prop::collection::vec((0_u8..6, points, sizes, pose(), 0_u8..48), 1..8)
}

fn paint<T: Scalar>(shapes: &[Random<T>], canvas: &mut impl Canvas<T>) {
    for (kind, points, [radius, hole, angle], pose, color) in shapes {
        let (center, start, radius, width) = (points[0], points[1], *radius, *hole);
        let outline = match kind {
            0 => Outline::Circle { center, radius },
            1 => Outline::Ring { center, radius, hole: *hole },
            2 => Outline::Polygon(points),
            3 => Outline::Winding(points),
            4 => Outline::Line { points, width },
            _ => Outline::Arc { center, start, angle: *angle, width },
        };
        canvas.fill(outline, *pose, *color);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn random_shapes(shapes in shapes::<f64>(), scale in 4.0..12.0) {
        let view = View::new([0.3, -0.2], scale);
        both(view, |svg| paint(&shapes, svg), |frame| paint(&shapes, frame));
    }

    #[test]
    fn random_shapes_in_single_precision(shapes in shapes::<f32>(), scale in 4.0..12.0) {
        let view = View::new([0.3, -0.2], scale);
        both(view, |svg| paint(&shapes, svg), |frame| paint(&shapes, frame));
    }

    /// Whatever numbers there are, the file is an SVG, and what is not finite is not in it.
    #[test]
    fn wild_numbers(numbers in prop::array::uniform8(any::<f64>()), scale in any::<f64>()) {
        let [x, y, radius, cos, sin, to_x, to_y, z] = numbers;
        let mut svg = Svg::new(Sheet::new(SIDE, SIDE).look_at(View::new([z, x], scale)));
        let pose = Pose { cos, sin, x: to_x, y: to_y };
        svg.fill(Outline::Circle { center: [x, y], radius }, pose, 3);
        svg.fill(Outline::Line { points: &[[x, y], [radius, cos], [sin, z]], width: to_y }, pose, 4);
        svg.fill(Outline::Arc { center: [x, y], start: [radius, cos], angle: sin, width: z }, pose, 4);
        let text = svg.finish();
        prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{}", text);
        prop_assert!(text.len() < 2000);
        usvg::roxmltree::Document::parse(&text).expect("well-formed");
    }

    /// A title is read as it was written.
    #[test]
    fn titles(title in "[ -~äΩ→😀]{1,40}") {
        let text = Svg::new(Sheet::new(3, 2).title(title.as_str())).finish();
        let document = usvg::roxmltree::Document::parse(&text).expect("well-formed");
        let read = document.descendants().find(|node| node.has_tag_name("title"));
        prop_assert_eq!(read.and_then(|node| node.text()), Some(title.as_str()));
    }
}

#[test]
fn titles_with_characters_that_no_document_may_hold() {
    let text = Svg::new(Sheet::new(3, 2).title("a\u{0}\u{1b}\u{FFFE}\u{7f}")).finish();
    usvg::roxmltree::Document::parse(&text).expect("well-formed");
}
