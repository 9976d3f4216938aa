//! Frames shown on a display.

use super::panel::{Panel, SIDE};
use crate::outlines::any;
use embedded_graphics::image::Image;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::raster::embedded::rgb;
use mech_runtime::{Canvas, Frame, Outline, Palette, Pose, View};
use proptest::prelude::*;

fn area(x: i32, y: i32, width: u32, height: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, height))
}

/// Every pixel another entry than its neighbours.
fn motley<const W: usize, const H: usize>() -> Frame<W, H> {
    let mut frame = Frame::new();
    let entries = (0_u32..)
        .map(|at| Palette::shade(at.to_le_bytes()[0] % 12 + 2, (at / 7).to_le_bytes()[0] % 16));
    let whole = frame.bounding_box();
    let Ok(()) = frame.fill_contiguous(&whole, entries.map(mech_runtime::raster::embedded::Entry));
    frame
}

#[test]
fn a_whole_frame_in_one_call() {
    let frame = motley::<SIDE, SIDE>();
    let mut panel = Panel::new();
    assert_eq!(frame.show(&mut panel, rgb), Ok(()));
    assert!(panel.pixels == Panel::map(&frame));
    assert_eq!(panel.contiguous, [area(0, 0, 240, 240)]);
    assert!(panel.rectangles.is_empty());
}

#[test]
fn a_frame_larger_or_smaller_than_the_display() {
    let (small, large) = (motley::<100, 30>(), motley::<300, 250>());
    let mut panel = Panel::new();
    assert_eq!(large.show(&mut panel, rgb), Ok(()));
    assert_eq!(small.show(&mut panel, rgb), Ok(()));
    assert_eq!(panel.contiguous, [area(0, 0, 240, 240), area(0, 0, 100, 30)]);
    for y in 0..SIDE {
        for x in 0..SIDE {
            let expected = small.rgb(x, y).or_else(|| large.rgb(x, y));
            assert_eq!(Some(panel.pixels[y][x]), expected.map(rgb));
        }
    }
}

#[test]
fn two_tones() {
    let mut frame = Frame::<8, 8>::new();
    frame.look_at(View::new([4.0, -4.0], 1.0));
    let center = [4.0_f32, -4.0];
    frame.fill(Outline::Circle { center, radius: 3.0 }, Pose::identity(), Palette::INK);
    let mut display = MockDisplay::<BinaryColor>::new();
    let Ok(()) = frame.show(&mut display, |[red, ..]| BinaryColor::from(red < 128));
    display.assert_pattern(&[
        "........", //
        "..####..", ".######.", ".######.", ".######.", ".######.", "..####..", "........",
    ]);
    let mut light = MockDisplay::<BinaryColor>::new();
    let Ok(()) = frame.show_part(&mut light, &area(2, 1, 3, 2), rgb);
    light.assert_pattern(&["     ", "  ...", "  ..."]);
}

#[test]
fn an_image_has_its_place() {
    let frame = motley::<50, 20>();
    let picture = frame.image(rgb::<Rgb565>);
    let mut panel = Panel::new();
    assert_eq!(Image::new(&picture, Point::new(30, 40)).draw(&mut panel), Ok(()));
    let part = picture.sub_image(&area(10, 5, 8, 4));
    assert_eq!(Image::new(&part, Point::new(100, 100)).draw(&mut panel), Ok(()));
    assert_eq!(panel.contiguous, [area(30, 40, 50, 20), area(100, 100, 8, 4)]);
    for y in 0..SIDE {
        for x in 0..SIDE {
            let from = |x0: usize, y0: usize| frame.rgb(x.checked_sub(x0)?, y.checked_sub(y0)?);
            let in_part = (100..108).contains(&x) && (100..104).contains(&y);
            let expected = if in_part { from(90, 95) } else { from(30, 40) };
            let expected = expected.map_or(Rgb565::MAGENTA, rgb);
            assert_eq!(panel.pixels[y][x], expected);
        }
    }
}

proptest! {
    /// A part that is shown looks as in the whole picture, and the rest is as it was.
    #[test]
    fn a_part(x in -300..300, y in -300..300, width in 0_u32..300, height in 0_u32..300, shape in any(-9.0..200.0)) {
        let mut frame = motley::<200, 260>();
        shape.draw(&mut frame, Palette::INK);
        let mut panel = Panel::new();
        let part = area(x, y, width, height);
        prop_assert_eq!(frame.show_part(&mut panel, &part, rgb), Ok(()));
        for point in panel.bounding_box().points() {
            let [column, row] = [point.x, point.y].map(|at| usize::try_from(at).unwrap_or_default());
            let inside = part.contains(point).then(|| frame.rgb(column, row)).flatten();
            prop_assert_eq!(panel.pixels[row][column], inside.map_or(Rgb565::MAGENTA, rgb));
        }
        prop_assert!(panel.contiguous.len() <= 1);
    }
}
