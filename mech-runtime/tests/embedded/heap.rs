//! Frames on the heap are drawn on and shown as those in arrays are.
#![cfg(feature = "std")]

use super::drawn_on::draw;
use embedded_graphics::image::Image;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::raster::embedded::rgb;
use mech_runtime::{Frame, HeapFrame};

type Display = MockDisplay<Rgb888>;

fn show_the_same(one: impl FnOnce(&mut Display), other: impl FnOnce(&mut Display)) {
    let mut shown = Display::new();
    one(&mut shown);
    let mut expected = Display::new();
    other(&mut expected);
    shown.assert_eq(&expected);
}

#[test]
fn a_frame_on_the_heap_is_drawn_on_and_shown() {
    let mut array = Frame::<60, 40>::new();
    let mut heap = HeapFrame::new(60, 40).expect("it is small");
    let (Ok(()), Ok(())) = (draw(&mut array), draw(&mut heap));
    assert_eq!(heap.pixels(), array.pixels().as_flattened());
    assert_eq!(heap.size(), Size::new(60, 40));
    show_the_same(
        |display| {
            let Ok(()) = heap.show(display, rgb);
        },
        |display| {
            let Ok(()) = array.show(display, rgb);
        },
    );
    let part = Rectangle::new(Point::new(5, -3), Size::new(20, 30));
    show_the_same(
        |display| {
            let Ok(()) = heap.show_part(display, &part, rgb);
        },
        |display| {
            let Ok(()) = array.show_part(display, &part, rgb);
        },
    );
    let place = Point::new(4, 7);
    show_the_same(
        |display| {
            let Ok(()) = Image::new(&heap.image(rgb), place).draw(display);
        },
        |display| {
            let Ok(()) = Image::new(&array.image(rgb), place).draw(display);
        },
    );
}
