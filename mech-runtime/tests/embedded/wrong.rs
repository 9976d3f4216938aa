//! Displays that fail, displays without pixels, numbers that are not finite.

use super::panel::{Bounds, Failed, Panel};
use crate::outlines::{Any, any};
use embedded_graphics::image::ImageDrawable;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::raster::embedded::{Screen, rgb};
use mech_runtime::{Frame, OwnedOutline, View};
use proptest::prelude::*;

fn shapes() -> [Any; 4] {
    [
        Any::Outline(OwnedOutline::Ring { center: [0.0, 0.0], radius: 60.0, hole: 30.0 }),
        Any::Outline(OwnedOutline::Polygon(vec![[-90.0, -90.0], [0.0, 80.0], [70.0, -60.0]])),
        Any::Text([-50.0, 10.0], "what fails".to_string()),
        Any::Outline(OwnedOutline::Line { points: vec![[-90.0, 50.0], [80.0, 70.0]], width: 5.0 }),
    ]
}

/// Paints on a panel where so many calls succeed; returns it with the result of `finish`.
fn paint(patience: usize) -> (Panel, Result<(), Failed>) {
    let mut panel = Panel::new();
    panel.patience = patience;
    let mut screen = Screen::new(&mut panel, View::default(), rgb);
    screen.clear();
    for (shape, color) in shapes().iter().zip(1..) {
        shape.draw(&mut screen, color);
    }
    screen.clear();
    let outcome = screen.finish();
    (panel, outcome)
}

#[test]
fn the_first_error_is_returned_and_nothing_follows() {
    let (whole, outcome) = paint(usize::MAX);
    assert_eq!(outcome, Ok(()));
    let calls = whole.rectangles.len();
    assert!(calls > 200);
    for patience in (0..calls).step_by(7).chain([calls - 1]) {
        let (panel, outcome) = paint(patience);
        assert_eq!(outcome, Err(Failed(patience + 1)));
        assert_eq!(panel.rectangles, whole.rectangles[..=patience]);
    }
    assert_eq!(paint(calls).1, Ok(()));
}

#[test]
fn a_display_that_cannot_show() {
    let mut panel = Panel::new();
    panel.patience = 0;
    let frame = Frame::<8, 8>::new();
    assert_eq!(frame.show(&mut panel, rgb), Err(Failed(1)));
    let part = Rectangle::new(Point::new(1, 1), Size::new(2, 2));
    assert_eq!(frame.show_part(&mut panel, &part, rgb), Err(Failed(2)));
    let nothing = Rectangle::new(Point::new(8, 8), Size::new(2, 2));
    assert_eq!(frame.show_part(&mut panel, &nothing, rgb), Ok(()));
}

#[test]
fn displays_without_pixels() {
    for size in [Size::zero(), Size::new(0, 50), Size::new(50, 0)] {
        let mut nothing = Bounds::new(Rectangle::new(Point::new(3, 4), size));
        let view = View::fit([-1.0, -1.0], [1.0, 1.0], 0, 0, 2.0);
        let mut screen = Screen::new(&mut nothing, view, rgb);
        for shape in shapes() {
            shape.draw(&mut screen, 1);
        }
        let Ok(()) = screen.finish();
        let Ok(()) = Frame::<8, 8>::new().show(&mut nothing, rgb);
        assert_eq!(nothing.calls, 0);
    }
    let mut display = Bounds::new(Rectangle::new(Point::zero(), Size::new(9, 9)));
    let Ok(()) = Frame::<0, 8>::new().show(&mut display, rgb);
    let Ok(()) = Frame::<8, 0>::new().show(&mut display, rgb);
    assert_eq!(display.calls, 0);
}

/// Numbers of which some are very large, or not numbers.
fn any_number() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![
        -300.0..300.0,
        proptest::num::f64::ANY,
        (-40..40).prop_map(|power| 10_f64.powi(power)),
    ]
}

/// From the first place there is to the last, and some between.
fn displays() -> impl Strategy<Value = Rectangle> {
    let start = prop_oneof![
        -300..300,
        Just(i32::MIN),
        Just(i32::MAX),
        (1..100).prop_map(|less| i32::MAX - less)
    ];
    let side = prop_oneof![0_u32..300, Just(300_u32)];
    (prop::array::uniform2(start), prop::array::uniform2(side)).prop_map(
        |([x, y], [width, height])| Rectangle::new(Point::new(x, y), Size::new(width, height)),
    )
}

proptest! {
    #[test]
    fn whatever_is_painted_stays_on_the_display(shape in any(any_number()), area in displays(), scale in any_number()) {
        let mut bounds = Bounds::new(area);
        let mut screen = Screen::new(&mut bounds, View::new([0.0, 0.0], scale), rgb);
        shape.draw(&mut screen, 1);
        let Ok(()) = screen.finish();
        let Ok(()) = Frame::<8, 8>::new().show(&mut bounds, rgb);
    }
}

/// A display with more pixels than can be counted has a first place and a last.
#[test]
fn displays_without_end() {
    let corners = [i32::MIN, -1, 0, i32::MAX - 5, i32::MAX];
    for (x, y) in corners.into_iter().flat_map(|x| corners.map(|y| (x, y))) {
        let mut bounds =
            Bounds::new(Rectangle::new(Point::new(x, y), Size::new(u32::MAX, u32::MAX)));
        let mut screen = Screen::new(&mut bounds, View::default(), rgb);
        for shape in shapes() {
            shape.draw(&mut screen, 1);
        }
        let Ok(()) = screen.finish();
        assert_eq!(bounds.calls > 0, x < i32::MAX && y < i32::MAX);
        let frame = Frame::<8, 8>::new();
        let part = Rectangle::new(Point::new(x, y), Size::new(u32::MAX, 7));
        let Ok(()) = frame.show_part(&mut bounds, &part, rgb);
        let Ok(()) = frame.image(rgb).draw_sub_image(&mut bounds, &part);
        let mut display = Bounds::new(Rectangle::new(Point::zero(), Size::new(9, 9)));
        let Ok(()) = frame.image(rgb).draw_sub_image(&mut display, &part);
        assert_eq!(display.calls, usize::from([-1, 0].contains(&x) && [-1, 0].contains(&y)));
    }
}
