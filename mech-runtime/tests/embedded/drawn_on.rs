//! A frame that embedded-graphics draws on.

use core::convert::Infallible;
use embedded_graphics::image::{Image, ImageRaw};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::raw::RawU8;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{
    Circle, Ellipse, Line, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle, RoundedRectangle,
    Triangle,
};
use embedded_graphics::text::Text;
use mech_runtime::{Frame, raster::embedded::Entry};
use proptest::prelude::*;

/// Pixel by pixel, with what the trait makes of that.
#[derive(Default)]
struct Plain(Frame<60, 40>);

impl OriginDimensions for Plain {
    fn size(&self) -> Size {
        Size::new(60, 40)
    }
}

impl DrawTarget for Plain {
    type Color = Entry;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Entry>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Infallible> {
        self.0.draw_iter(pixels)
    }
}

pub(crate) fn draw<D: DrawTarget<Color = Entry>>(target: &mut D) -> Result<(), D::Error> {
    let filled = |entry| PrimitiveStyle::with_fill(Entry(entry));
    let framed = PrimitiveStyleBuilder::new()
        .fill_color(Entry(3))
        .stroke_color(Entry(4))
        .stroke_width(3)
        .build();
    let box_at = |x, y, width, height| Rectangle::new(Point::new(x, y), Size::new(width, height));
    target.clear(Entry(200))?;
    Circle::new(Point::new(-6, 5), 20).into_styled(framed).draw(target)?;
    Ellipse::new(Point::new(40, 25), Size::new(40, 30)).into_styled(filled(5)).draw(target)?;
    RoundedRectangle::with_equal_corners(box_at(20, -3, 21, 13), Size::new(4, 4))
        .into_styled(framed)
        .draw(target)?;
    Triangle::new(Point::new(10, 60), Point::new(30, 12), Point::new(35, 38))
        .into_styled(filled(6))
        .draw(target)?;
    Line::new(Point::new(-9, -9), Point::new(90, 50))
        .into_styled(PrimitiveStyle::with_stroke(Entry(7), 2))
        .draw(target)?;
    box_at(50, 2, 30, 4).into_styled(filled(8)).draw(target)?;
    let style = MonoTextStyle::new(&FONT_6X10, Entry(255));
    Text::new("α = 30", Point::new(3, 33), style).draw(target)?;
    let pixels: Vec<u8> = (100..180).collect();
    let raw = ImageRaw::<Entry>::new(&pixels, 10);
    Image::new(&raw, Point::new(54, 34)).draw(target)?;
    raw.sub_image(&box_at(2, 1, 5, 5)).draw(&mut target.translated(Point::new(-2, 1)))
}

#[test]
fn texts_primitives_and_images_go_on_a_frame() {
    let (mut frame, mut plain) = (Frame::<60, 40>::new(), Plain::default());
    let [Ok(()), Ok(())] = [draw(&mut frame), draw(&mut plain)];
    assert!(frame == plain.0);
    for entry in [3, 4, 5, 6, 7, 8, 200, 255, 100, 155, 115] {
        assert!(frame.pixels().as_flattened().contains(&entry), "{entry}");
    }
    assert_eq!(frame.pixel(0, 1), Some(114)); // the image's fourth column and third row: 2 + 2, 1 + 0
}

#[test]
fn a_frame_is_as_large_as_it_is() {
    assert_eq!(
        Frame::<60, 40>::new().bounding_box(),
        Rectangle::new(Point::zero(), Size::new(60, 40))
    );
    assert_eq!(Frame::<0, { usize::MAX }>::new().size(), Size::new(0, 0x7FFF_FFFF));
}

#[test]
fn entries_are_bytes() {
    for entry in 0..=255 {
        assert_eq!(Entry(entry).into_storage(), entry);
        assert_eq!(Entry::from(RawU8::new(entry)), Entry(entry));
    }
}

proptest! {
    /// As the trait would do it pixel by pixel; there may be too few colours, or too many.
    #[test]
    fn rectangles_are_filled_as_pixels_are(
        corner in prop::array::uniform2(-50..80),
        size in prop::array::uniform2(0_u32..70),
        colors in prop::collection::vec(any::<u8>(), 0..3000),
        solid in any::<u8>(),
    ) {
        let area = Rectangle::new(Point::new(corner[0], corner[1]), Size::new(size[0], size[1]));
        let (mut frame, mut plain) = (Frame::<60, 40>::new(), Plain::default());
        let entries = || colors.iter().copied().map(Entry);
        let [Ok(()), Ok(())] = [frame.fill_contiguous(&area, entries()), plain.fill_contiguous(&area, entries())];
        prop_assert!(frame == plain.0);
        let other = Rectangle::new(area.top_left - Point::new(9, 5), area.size);
        let [Ok(()), Ok(())] = [frame.fill_solid(&other, Entry(solid)), plain.fill_solid(&other, Entry(solid))];
        prop_assert!(frame == plain.0);
    }

    /// Nothing overflows, wherever it is.
    #[test]
    fn rectangles_may_be_anywhere(
        corner in prop::array::uniform2(extreme()),
        size in prop::array::uniform2(extreme()),
        solid in 1_u8..,
    ) {
        let size = size.map(|side| u32::from_ne_bytes(side.to_ne_bytes()));
        let area = Rectangle::new(Point::new(corner[0], corner[1]), Size::new(size[0], size[1]));
        let [mut filled, mut contiguous] = [(); 2].map(|()| Frame::<6, 4>::new());
        let Ok(()) = filled.fill_solid(&area, Entry(solid));
        let Ok(()) = contiguous.fill_contiguous(&area, core::iter::repeat(Entry(solid)));
        let Ok(()) = filled.draw_iter([Pixel(area.top_left, Entry(solid))].into_iter().filter(|_| !area.is_zero_sized()));
        prop_assert!(filled == contiguous);
        for (at, entry) in (0_i64..).zip(filled.pixels().as_flattened()) {
            let place = [at % 6, at / 6];
            let inside = (0..2).all(|axis| {
                let from = i64::from(corner[axis]);
                (from..from + i64::from(size[axis])).contains(&place[axis])
            });
            prop_assert_eq!(*entry, if inside { solid } else { 0 });
        }
    }
}

fn extreme() -> impl Strategy<Value = i32> {
    prop_oneof![
        -10..10,
        any::<i32>(),
        (0..5).prop_map(|less| i32::MAX - less),
        (0..5).prop_map(|more| i32::MIN + more),
    ]
}
