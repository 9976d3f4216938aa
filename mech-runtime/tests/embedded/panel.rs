//! Displays that know what was done to them.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::{Frame, raster::embedded::rgb};

pub(crate) const SIDE: usize = 240;

/// A display of 240 × 240 pixels that takes no pixel outside, and may fail.
pub(crate) struct Panel {
    pub(crate) pixels: Vec<[Rgb565; SIDE]>,
    corner: Point,
    /// The areas that were asked for: rectangles, and areas that came in pixels.
    pub(crate) rectangles: Vec<Rectangle>,
    pub(crate) contiguous: Vec<Rectangle>,
    /// The number of calls that succeed.
    pub(crate) patience: usize,
}

/// The number of the call that failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Failed(pub(crate) usize);

impl Panel {
    pub(crate) fn new() -> Self {
        Self::at(Point::zero())
    }

    /// Its first pixel is here.
    pub(crate) fn at(corner: Point) -> Self {
        Self {
            pixels: vec![[Rgb565::MAGENTA; SIDE]; SIDE],
            corner,
            rectangles: Vec::new(),
            contiguous: Vec::new(),
            patience: usize::MAX,
        }
    }

    fn call(&self) -> Result<(), Failed> {
        let calls = self.rectangles.len() + self.contiguous.len();
        if calls > self.patience {
            return Err(Failed(calls));
        }
        Ok(())
    }

    fn set(&mut self, point: Point, color: Rgb565) {
        let place = [point.x - self.corner.x, point.y - self.corner.y];
        let [x, y] = place.map(|at| usize::try_from(at).expect("within the panel"));
        self.pixels[y][x] = color;
    }

    /// A frame of the same size, in the panel's colours.
    pub(crate) fn map(frame: &Frame<SIDE, SIDE>) -> Vec<[Rgb565; SIDE]> {
        let color = |entry| rgb(frame.palette().rgb(entry));
        frame.pixels().iter().map(|row| row.map(color)).collect()
    }
}

impl Dimensions for Panel {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(self.corner, Size::new(240, 240))
    }
}

impl DrawTarget for Panel {
    type Color = Rgb565;
    type Error = Failed;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Failed> {
        for Pixel(point, color) in pixels {
            self.set(point, color);
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Failed> {
        self.contiguous.push(*area);
        self.call()?;
        let mut colors = colors.into_iter();
        for point in area.points() {
            let color = colors.next().expect("as many colours as pixels");
            self.set(point, color);
        }
        assert_eq!(colors.next(), None);
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Failed> {
        self.rectangles.push(*area);
        self.call()?;
        for point in area.points() {
            self.set(point, color);
        }
        Ok(())
    }
}

/// No display, but a rectangle within which everything has to stay.
pub(crate) struct Bounds {
    pub(crate) area: Rectangle,
    pub(crate) calls: usize,
}

impl Bounds {
    pub(crate) fn new(area: Rectangle) -> Self {
        Self { area, calls: 0 }
    }

    fn check(&mut self, area: &Rectangle) {
        self.calls += 1;
        assert!(area.size.width > 0 && area.size.height > 0);
        let ends = |area: &Rectangle| {
            let Rectangle { top_left, size } = *area;
            let end = |start: i32, length: u32| i64::from(start) + i64::from(length);
            [end(top_left.x, size.width), end(top_left.y, size.height)]
        };
        let [inner, outer] = [ends(area), ends(&self.area)];
        assert!(area.top_left.x >= self.area.top_left.x && inner[0] <= outer[0]);
        assert!(area.top_left.y >= self.area.top_left.y && inner[1] <= outer[1]);
    }
}

impl Dimensions for Bounds {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Bounds {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        for Pixel(point, _) in pixels {
            self.check(&Rectangle::new(point, Size::new(1, 1)));
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Self::Error> {
        self.check(area);
        let pixels = u64::from(area.size.width) * u64::from(area.size.height);
        assert_eq!(colors.into_iter().count() as u64, pixels);
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, _: Rgb565) -> Result<(), Self::Error> {
        self.check(area);
        Ok(())
    }

    fn clear(&mut self, _: Rgb565) -> Result<(), Self::Error> {
        self.calls += 1;
        Ok(())
    }
}
