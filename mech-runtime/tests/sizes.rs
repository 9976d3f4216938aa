//! Pictures of every size, down to none at all, take whatever is painted: what is not in them is not painted, and nothing panics.

use mech_runtime::raster::{bar, line};
use mech_runtime::{
    Canvas, Frame, Mechanism, Outline, Overlay, Pose, Smooth, Stage, Trace, View, mechanism,
};
use proptest::prelude::*;

mechanism! {
    /// With everything that is ever painted.
    struct FourBar;
    ground { circle (0, 0) radius 0.5; }
    link crank { polygon [(0, 0), (0.8, 0.6), (0, 0.5)] on plane 1 color 2; }
    link coupler { point tip = (2.5, 3); polygon [(0.8, 0.6), (3.3, 2.9), (2.5, 3)] on plane 2 color 3; }
    link rocker { ring (4, 0) radius 1 hole 0.5; }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;
    effects { velocity; overlay; trace coupler.tip 8; }
}

/// Numbers of which many are none, or are beyond all others.
fn number() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        4 => -20.0..20.0,
        1 => proptest::num::f64::ANY,
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 0.0, -0.0, 1e15, -1e9]),
    ]
}

/// Everything that can be painted, from some numbers, and a mechanism.
fn everything(
    canvas: &mut impl Canvas<f64>,
    numbers: [f64; 12],
    trace: &Trace<f64, 4>,
    four_bar: &FourBar,
) {
    let [cos, sin, x, y, a, b, c, d, e, f, g, width] = numbers;
    let pose = Pose { cos, sin, x, y };
    let corners = [[a, b], [c, d], [e, f], [g, a]];
    let center = [a, b];
    let outlines = [
        Outline::Polygon(&corners),
        Outline::Winding(&corners),
        Outline::Circle { center, radius: c },
        Outline::Ring { center, radius: c, hole: d },
        Outline::Line { points: &corners, width },
        Outline::Arc { center, start: [c, d], angle: e, width },
    ];
    for outline in outlines {
        for pose in [Pose::identity(), pose] {
            canvas.fill(outline, pose, 1);
        }
    }
    canvas.text(center, "0 Ω", 2);
    bar(canvas, &corners, pose, width, 3);
    line(canvas, [center, [c, d]], width, 4);
    trace.draw(canvas, 5);
    four_bar.draw(canvas);
    four_bar.draw_overlay(canvas, &Overlay::new().links(true));
}

/// Paints pictures of a size by all methods: a stage shows what a frame does, as long as no square overflows.
fn pictures<const W: usize, const H: usize>(numbers: [f64; 12], view: View, four_bar: &FourBar) {
    let mut trace = Trace::new();
    for place in numbers.as_chunks::<2>().0 {
        trace.push(*place);
    }
    let mut frame = Frame::<W, H>::new();
    let mut smooth = Smooth::<W, H>::new();
    let mut stage = Stage::<W, H, 8>::new();
    for view in
        [View::fit([numbers[0]; 2], [numbers[1]; 2], W, H, numbers[2]), FourBar::view(W, H), view]
    {
        frame.clear();
        frame.look_at(view);
        smooth.look_at(view);
        stage.look_at(view);
        everything(&mut frame, numbers, &trace, four_bar);
        everything(&mut smooth, numbers, &trace, four_bar);
        stage.show(|canvas| everything(canvas, numbers, &trace, four_bar));
        // Where squares overflow, neither is right.
        let seen = [view.center()[0], view.center()[1], view.scale(), 1.0 / view.scale()];
        let overflows = |number: &f64| number.is_finite() && number.abs() > 1e70;
        if !numbers.iter().chain(&seen).any(overflows) {
            assert_eq!(stage.frame().pixels(), frame.pixels());
        }
        assert!(stage.changed().all(|area| area.x + area.width <= W && area.y + area.height <= H));
    }
    assert_eq!([frame.pixel(W, 0), frame.pixel(0, H)], [None; 2]);
    assert_eq!([smooth.pixel(W, 0), smooth.pixel(0, H)], [None; 2]);
}

proptest! {
    #[test]
    fn pictures_of_any_size_take_anything(
        numbers in prop::array::uniform12(number()),
        center in prop::array::uniform2(number()),
        scale in number(),
        angle in -10.0..10.0,
    ) {
        let mut four_bar = FourBar::new();
        four_bar.move_with([angle], [1.0]).expect("it turns");
        let view = View::new(center, scale);
        pictures::<0, 0>(numbers, view, &four_bar);
        pictures::<0, 5>(numbers, view, &four_bar);
        pictures::<5, 0>(numbers, view, &four_bar);
        pictures::<1, 40>(numbers, view, &four_bar);
        pictures::<33, 17>(numbers, view, &four_bar);
    }
}
