//! Mechanisms and shapes painted on a display.

use super::panel::{Panel, SIDE};
use crate::outlines::any;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::raster::embedded::{Screen, rgb};
use mech_runtime::{Canvas, Frame, Outline, Overlay, Palette, Pose, View, mechanism};
use proptest::prelude::*;

mechanism! {
    struct SliderCrank: f32;
    ground { polygon [(2.5, -1), (5.5, -1), (5.5, -0.6), (2.5, -0.6)] on plane 0 color 1; }
    link crank { circle (0, 0) radius 0.6 on plane 1 color 2; circle (1, 0.5) radius 0.3 on plane 2 color 3; }
    link rod {
        polygon [(1, 0.3), (4, -0.2), (4, 0.2), (1, 0.7)] on plane 3 color 4;
        point middle = (2.5, 0.25);
    }
    link block { polygon [(3.4, -0.6), (4.6, -0.6), (4.6, 0.6), (4, 0.3), (3.4, 0.6)] on plane 2 color 5; }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0);
    joint x = prismatic(ground, block) at (4, 0) along (1, 0);
    motor a;
    effects { overlay; trace rod.middle 64; }
}

/// A pixel is a unit; the origin is the upper left corner of a mock display.
const PIXELWISE: View = View::new([32.0, -32.0], 1.0);

const LIT: fn([u8; 3]) -> BinaryColor = |_| BinaryColor::On;

/// Paints everything, with the crank at an angle in radians.
fn paint(slider_crank: &SliderCrank, canvas: &mut impl Canvas<f32>) {
    slider_crank.draw(canvas);
    slider_crank.draw_overlay(canvas, &Overlay::new().links(true));
    let middle = slider_crank.rod_middle();
    canvas.text([middle.x, middle.y], "rod, 1.5 Δφ", Palette::INK);
}

/// Some poses, with the picture of each.
fn poses() -> impl Iterator<Item = (SliderCrank, Frame<SIDE, SIDE>)> {
    let mut slider_crank = SliderCrank::new();
    (0_u8..12).map(move |step| {
        let moved = slider_crank.move_to([0.55 * f32::from(step)]);
        assert!(moved.is_ok());
        let mut frame = Frame::new();
        frame.look_at(view());
        frame.clear();
        paint(&slider_crank, &mut frame);
        (slider_crank, frame)
    })
}

/// Some of the mechanism is beyond the picture's right border.
fn view() -> View {
    View::fit([-1.4, -1.5], [4.6, 1.5], SIDE, SIDE, 0.0)
}

fn paint_on<D: DrawTarget<Color = Rgb565, Error: core::fmt::Debug>>(
    display: &mut D,
    slider_crank: &SliderCrank,
) {
    let mut screen = Screen::new(display, view(), rgb);
    screen.clear();
    paint(slider_crank, &mut screen);
    screen.finish().expect("a display that does not fail");
}

#[test]
fn a_mechanism_looks_as_it_does_on_a_frame() {
    for (slider_crank, frame) in poses() {
        let mut panel = Panel::new();
        paint_on(&mut panel, &slider_crank);
        assert!(panel.pixels == Panel::map(&frame));
        let kinds = [Palette::GROUND, Palette::BLUE, Palette::TEAL, Palette::INK];
        for kind in kinds {
            assert!(frame.pixels().as_flattened().contains(&kind));
        }
    }
}

#[test]
fn displays_may_begin_anywhere() {
    let far = i32::MAX - 240;
    for corner in [[0, 0], [-100, 17], [i32::MIN, i32::MIN], [far, far], [far, -1]] {
        for (slider_crank, frame) in poses().step_by(5) {
            let mut panel = Panel::at(Point::new(corner[0], corner[1]));
            paint_on(&mut panel, &slider_crank);
            assert!(panel.pixels == Panel::map(&frame));
        }
    }
}

#[test]
fn a_part_of_a_display_is_a_whole_one() {
    let area = Rectangle::new(Point::new(30, 50), Size::new(150, 101));
    let outside = |x: usize, y: usize| !(30..180).contains(&x) || !(50..151).contains(&y);
    for (slider_crank, _) in poses() {
        let mut frame = Frame::<150, 101>::new();
        frame.look_at(view());
        paint(&slider_crank, &mut frame);
        let [mut cropped, mut clipped, mut translated] = [(); 3].map(|()| Panel::new());
        paint_on(&mut cropped.cropped(&area), &slider_crank);
        paint_on(&mut clipped.clipped(&area), &slider_crank);
        let mut moved = translated.translated(Point::new(-7, 1000));
        paint_on(
            &mut moved.clipped(&Rectangle::new(Point::new(37, -950), area.size)),
            &slider_crank,
        );
        for panel in [cropped, clipped, translated] {
            for y in 0..SIDE {
                for x in 0..SIDE {
                    let expected = if outside(x, y) {
                        Some(Rgb565::MAGENTA)
                    } else {
                        frame.rgb(x - 30, y - 50).map(rgb)
                    };
                    assert_eq!(Some(panel.pixels[y][x]), expected, "at {x}, {y}");
                }
            }
        }
    }
}

#[test]
fn palettes_and_views_can_be_changed() {
    let (slider_crank, _) = poses().nth(3).expect("twelve poses");
    let mut frame = Frame::<SIDE, SIDE>::new();
    frame.set_palette(Palette::NIGHT);
    let other = View::new([1.0, 0.5], 30.0);
    frame.look_at(other);
    paint(&slider_crank, &mut frame);
    let mut panel = Panel::new();
    let mut screen = Screen::new(&mut panel, view(), rgb);
    screen.set_palette(&Palette::NIGHT);
    screen.look_at(other);
    assert_eq!((screen.view(), screen.palette()), (other, &Palette::NIGHT));
    assert_eq!(Canvas::<f64>::scale(&screen), 30.0);
    screen.clear();
    paint(&slider_crank, &mut screen);
    assert_eq!(screen.finish(), Ok(()));
    assert!(panel.pixels == Panel::map(&frame));
}

#[test]
fn colours_are_those_of_the_palette() {
    let mut display = MockDisplay::<Rgb888>::new();
    display.set_allow_overdraw(true);
    let palette =
        Palette::TEXTBOOK.with(1, [255, 0, 0]).with(2, [0, 0, 255]).with(3, [255, 255, 255]);
    let mut screen = Screen::new(&mut display, PIXELWISE, rgb);
    screen.set_palette(&palette);
    let below = [[1.0_f32, -1.0], [9.0, -1.0], [9.0, -4.0], [1.0, -4.0]];
    screen.fill(Outline::Polygon(&below), Pose::identity(), 1);
    let above = [[4.0_f32, 0.0], [8.0, 0.0], [4.0, -4.0]];
    screen.fill(Outline::Polygon(&above), Pose::identity(), 2);
    screen.text([10.0_f32, -7.0], "if", 3);
    assert_eq!(screen.finish(), Ok(()));
    display.assert_pattern(&[
        "    BBB     W     WW ", //
        " RRRBBRRR        W  W",
        " RRRBRRRR  WW    W   ",
        " RRRRRRRR   W   WWW  ",
        "            W    W   ",
        "            W    W   ",
        "           WWW   W   ",
    ]);
}

#[test]
fn a_rectangle_is_one_call_and_so_is_a_bar_of_a_letter() {
    let mut panel = Panel::new();
    let mut screen = Screen::new(&mut panel, View::new([120.0, -120.0], 1.0), rgb);
    let corners = [[10.0, -20.0], [210.0, -20.0], [210.0, -120.0], [10.0, -120.0]];
    screen.fill(Outline::Polygon(&corners), Pose::<f64>::identity(), 1);
    screen.text([20.0, -207.0], "I", 1);
    assert_eq!(screen.finish(), Ok(()));
    let rectangle =
        |x, y, width, height| Rectangle::new(Point::new(x, y), Size::new(width, height));
    let expected = [
        rectangle(10, 20, 200, 100),
        rectangle(21, 200, 3, 1),
        rectangle(22, 201, 1, 5),
        rectangle(21, 206, 3, 1),
    ];
    assert_eq!(panel.rectangles, expected);
}

proptest! {
    /// A mock display panics where a pixel is drawn twice, or outside.
    #[test]
    fn any_shape_is_painted_once_where_a_frame_has_it(shape in any(-20.0..90.0)) {
        let mut display = MockDisplay::<BinaryColor>::new();
        let view = View::new([32.0, 32.0], 1.0);
        let mut screen = Screen::new(&mut display, view, LIT);
        shape.draw(&mut screen, 1);
        prop_assert_eq!(screen.finish(), Ok(()));
        let mut frame = Frame::<64, 64>::new();
        frame.look_at(view);
        shape.draw(&mut frame, 1);
        for (point, entry) in display.bounding_box().points().zip(frame.pixels().as_flattened()) {
            prop_assert_eq!(display.get_pixel(point).is_some(), *entry == 1, "{}", point);
        }
    }
}
