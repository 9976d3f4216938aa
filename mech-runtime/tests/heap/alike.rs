//! Pictures on the heap look like those in arrays, pixel for pixel.

use crate::outlines::{Any, any as outline};
use mech_runtime::{
    Canvas, Frame, HeapFrame, HeapSmooth, HeapStage, Palette, Pose, Smooth, Stage, View,
};
use proptest::prelude::*;

/// A shape, where it is, and its colour.
type Thing = (Any, Pose<f64>, u8);

fn paint(canvas: &mut impl Canvas<f64>, things: &[Thing]) {
    for (outline, pose, color) in things {
        outline.draw_at(*pose, canvas, *color);
    }
}

fn number() -> impl Strategy<Value = f64> + Clone + 'static {
    prop_oneof![9 => -40.0..40.0, 1 => proptest::num::f64::ANY]
}

fn pose() -> impl Strategy<Value = Pose<f64>> {
    (-7.0_f64..7.0, number(), number()).prop_map(|(angle, x, y)| {
        let (sin, cos) = angle.sin_cos();
        Pose { cos, sin, x, y }
    })
}

fn things() -> impl Strategy<Value = Vec<Thing>> {
    prop::collection::vec((outline(number()), pose(), any::<u8>()), 0..9)
}

fn palette() -> impl Strategy<Value = Palette> {
    prop::sample::select(vec![Palette::TEXTBOOK, Palette::NIGHT])
}

fn view() -> impl Strategy<Value = View> {
    let center = [-30.0..30.0, -30.0..30.0];
    (center, 0.1..10.0).prop_map(|(center, scale)| View::new(center, scale))
}

fn are_alike<const W: usize, const H: usize>(things: &[Thing], view: View, palette: &Palette) {
    let mut array = Frame::<W, H>::new();
    let mut heap = HeapFrame::new(W, H).expect("it is small");
    array.look_at(view);
    heap.look_at(view);
    array.set_palette(palette.clone());
    heap.set_palette(palette.clone());
    paint(&mut array, things);
    paint(&mut heap, things);
    assert_eq!(heap.pixels(), array.pixels().as_flattened());
    let mut array = Smooth::<W, H>::new();
    let mut heap = HeapSmooth::new(W, H).expect("it is small");
    array.look_at(view);
    heap.look_at(view);
    array.set_palette(palette.clone());
    heap.set_palette(palette.clone());
    array.clear();
    heap.clear();
    paint(&mut array, things);
    paint(&mut heap, things);
    assert_eq!(heap.pixels(), array.pixels().as_flattened());
    for (x, y) in [(0, 0), (W / 2, H / 2), (W, 0), (0, H), (usize::MAX, usize::MAX)] {
        assert_eq!(heap.pixel(x, y), array.pixel(x, y));
    }
}

proptest! {
    #[test]
    fn pictures_are_alike(things in things(), view in view(), palette in palette()) {
        are_alike::<33, 17>(&things, view, &palette);
        are_alike::<1, 40>(&things, view, &palette);
        are_alike::<0, 5>(&things, view, &palette);
        are_alike::<5, 0>(&things, view, &palette);
    }

    #[test]
    fn stages_are_alike(
        things in things(),
        moments in prop::collection::vec((prop::collection::vec(prop_oneof![3 => Just(None), 1 => pose().prop_map(Some)], 9), 0_usize..9, prop::option::weighted(0.2, view())), 1..9),
    ) {
        let mut array = Stage::<96, 80, 16>::new();
        let mut heap = HeapStage::new(96, 80).expect("it is small");
        for (poses, seen, view) in moments {
            if let Some(view) = view {
                array.look_at(view);
                heap.look_at(view);
            }
            let moved = things.iter().zip(poses).take(seen);
            let moved: Vec<Thing> = moved
                .map(|((outline, pose, color), other)| (outline.clone(), other.unwrap_or(*pose), *color))
                .collect();
            array.show(|canvas| paint(canvas, &moved));
            heap.show(|canvas| paint(canvas, &moved));
            prop_assert_eq!(heap.frame().pixels(), array.frame().pixels().as_flattened());
            // Both have a place for every thing, so the same is painted again.
            prop_assert!(heap.changed().eq(array.changed()));
        }
    }
}
