//! The same scene by other crates. y points down in all of them: what is seen is mirrored, and as large.

use crate::scene::{SIDE, Shape};
use embedded_graphics::{pixelcolor::Gray8, prelude::*, primitives as eg};
use mech_runtime::Palette;
use tiny_skia::{Color, FillRule, Mask, Paint, PathBuilder, Pixmap, Transform};
use vello_cpu::kurbo::{self, Shape as _};

#[expect(clippy::cast_possible_truncation, reason = "their paths are of this precision")]
fn narrow([x, y]: [f64; 2]) -> [f32; 2] {
    [x as f32, y as f32]
}

fn sk_path(shape: &Shape) -> tiny_skia::Path {
    let mut path = PathBuilder::new();
    match shape {
        Shape::Hexagon(corners) => {
            for (number, corner) in corners.iter().enumerate() {
                let [x, y] = narrow(*corner);
                if number == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            path.close();
        }
        Shape::Circle(center, radius) => {
            let [x, y] = narrow(*center);
            path.push_circle(x, y, narrow([*radius; 2])[0]);
        }
    }
    path.finish().expect("a path")
}

/// tiny-skia, into true colour or into a mask of one byte a pixel. Paths are built before, once.
pub struct TinySkia {
    paths: Vec<(tiny_skia::Path, [u8; 3])>,
    pixmap: Pixmap,
    mask: Mask,
}

impl TinySkia {
    pub fn new(scene: &[(Shape, u8)]) -> Self {
        let side = u32::from(SIDE);
        Self {
            paths: scene
                .iter()
                .map(|(shape, color)| (sk_path(shape), Palette::TEXTBOOK.rgb(*color)))
                .collect(),
            pixmap: Pixmap::new(side, side).expect("a size"),
            mask: Mask::new(side, side).expect("a size"),
        }
    }

    pub fn paint(&mut self, anti_alias: bool) {
        self.pixmap.fill(Color::from_rgba8(0xFA, 0xF6, 0xED, 255));
        for (path, [r, g, b]) in &self.paths {
            let mut paint = Paint { anti_alias, ..Paint::default() };
            paint.set_color_rgba8(*r, *g, *b, 255);
            self.pixmap.fill_path(path, &paint, FillRule::EvenOdd, Transform::identity(), None);
        }
    }

    pub fn mask(&mut self) {
        self.mask.clear();
        for (path, _) in &self.paths {
            self.mask.fill_path(path, FillRule::EvenOdd, false, Transform::identity());
        }
    }

    pub fn covered(&self) -> usize {
        self.mask.data().iter().filter(|&&pixel| pixel != 0).count()
    }

    pub fn pixels(&self) -> &[u8] {
        self.pixmap.data()
    }
}

/// `vello_cpu` with one thread.
pub struct Vello {
    paths: Vec<(kurbo::BezPath, [u8; 3])>,
    context: vello_cpu::RenderContext,
    resources: vello_cpu::Resources,
    pixmap: vello_cpu::Pixmap,
}

impl Vello {
    pub fn new(scene: &[(Shape, u8)]) -> Self {
        let path = |shape: &Shape| match shape {
            Shape::Hexagon(corners) => {
                let mut path = kurbo::BezPath::new();
                for (number, &[x, y]) in corners.iter().enumerate() {
                    if number == 0 { path.move_to((x, y)) } else { path.line_to((x, y)) }
                }
                path.close_path();
                path
            }
            Shape::Circle([x, y], radius) => kurbo::Circle::new((*x, *y), *radius).to_path(0.05),
        };
        Self {
            paths: scene
                .iter()
                .map(|(shape, color)| (path(shape), Palette::TEXTBOOK.rgb(*color)))
                .collect(),
            context: vello_cpu::RenderContext::new(SIDE, SIDE),
            resources: vello_cpu::Resources::new(),
            pixmap: vello_cpu::Pixmap::new(SIDE, SIDE),
        }
    }

    pub fn paint(&mut self) {
        use vello_cpu::color::AlphaColor;
        let side = f64::from(SIDE);
        self.context.reset();
        self.context.set_paint(AlphaColor::from_rgba8(0xFA, 0xF6, 0xED, 255));
        self.context.fill_rect(&kurbo::Rect::new(0.0, 0.0, side, side));
        for (path, [r, g, b]) in &self.paths {
            self.context.set_paint(AlphaColor::from_rgba8(*r, *g, *b, 255));
            self.context.fill_path(path);
        }
        self.context.flush();
        self.context.render(&mut self.pixmap, &mut self.resources);
    }

    pub fn pixels(&self) -> &[u8] {
        self.pixmap.data_as_u8_slice()
    }
}

/// zeno makes masks of single paths; each is mixed into the picture by a plain loop.
pub struct Zeno {
    paths: Vec<(Vec<zeno::Command>, [u8; 3])>,
    scratch: zeno::Scratch,
    mask: Vec<u8>,
    pixels: Vec<[u8; 4]>,
}

impl Zeno {
    pub fn new(scene: &[(Shape, u8)]) -> Self {
        use zeno::PathBuilder as _;
        let path = |shape: &Shape| {
            let mut path = Vec::new();
            match shape {
                Shape::Hexagon(corners) => {
                    for (number, corner) in corners.iter().enumerate() {
                        if number == 0 {
                            path.move_to(narrow(*corner));
                        } else {
                            path.line_to(narrow(*corner));
                        }
                    }
                    path.close();
                }
                Shape::Circle(center, radius) => {
                    path.add_circle(narrow(*center), narrow([*radius; 2])[0]);
                }
            }
            path
        };
        Self {
            paths: scene
                .iter()
                .map(|(shape, color)| (path(shape), Palette::TEXTBOOK.rgb(*color)))
                .collect(),
            scratch: zeno::Scratch::new(),
            mask: Vec::new(),
            pixels: vec![[0; 4]; usize::from(SIDE) * usize::from(SIDE)],
        }
    }

    /// Paints, or only makes the masks.
    pub fn paint(&mut self, is_mixed: bool) {
        if is_mixed {
            self.pixels.fill([0xFA, 0xF6, 0xED, 255]);
        }
        for (path, [r, g, b]) in &self.paths {
            let mut mask = zeno::Mask::with_scratch(path, &mut self.scratch);
            let placement = mask
                .style(zeno::Fill::EvenOdd)
                .inspect(|format, width, height| {
                    self.mask.clear();
                    self.mask.resize(format.buffer_size(width, height), 0);
                })
                .render_into(&mut self.mask, None);
            if !is_mixed {
                continue;
            }
            let (width, left) = (placement.width as usize, placement.left.max(0) as usize);
            let paint = [*r, *g, *b, 255];
            for (row, shares) in self.mask.chunks_exact(width).enumerate() {
                let start = (placement.top as usize + row) * usize::from(SIDE) + left;
                for (pixel, &share) in self.pixels[start..].iter_mut().zip(shares) {
                    if share == 255 {
                        *pixel = paint;
                    } else if share > 0 {
                        for (channel, paint) in pixel.iter_mut().zip(paint) {
                            let sum = u32::from(*channel) * u32::from(255 - share)
                                + u32::from(paint) * u32::from(share)
                                + 128;
                            *channel = ((sum + (sum >> 8)) >> 8) as u8;
                        }
                    }
                }
            }
        }
    }

    pub fn pixels(&self) -> &[u8] {
        self.pixels.as_flattened()
    }
}

/// embedded-graphics' own circles, and hexagons of four of its triangles: it fills no polygons.
pub struct EmbeddedGraphics {
    scene: Vec<(Shape, u8)>,
    pixels: Vec<u8>,
}

impl EmbeddedGraphics {
    pub fn new(scene: &[(Shape, u8)]) -> Self {
        Self { scene: scene.to_vec(), pixels: vec![0; usize::from(SIDE) * usize::from(SIDE)] }
    }

    pub fn paint(&mut self) {
        let whole = |[x, y]: [f64; 2]| Point::new(x.round() as i32, y.round() as i32);
        let scene = std::mem::take(&mut self.scene);
        self.pixels.fill(0);
        for (shape, color) in &scene {
            let style = eg::PrimitiveStyle::with_fill(Gray8::new(*color));
            match shape {
                Shape::Hexagon([first, rest @ ..]) => {
                    for pair in rest.windows(2) {
                        let triangle =
                            eg::Triangle::new(whole(*first), whole(pair[0]), whole(pair[1]));
                        let Ok(()) = triangle.into_styled(style).draw(self);
                    }
                }
                Shape::Circle(center, radius) => {
                    let circle =
                        eg::Circle::with_center(whole(*center), (2.0 * radius).round() as u32);
                    let Ok(()) = circle.into_styled(style).draw(self);
                }
            }
        }
        self.scene = scene;
    }
}

impl OriginDimensions for EmbeddedGraphics {
    fn size(&self) -> Size {
        Size::new(SIDE.into(), SIDE.into())
    }
}

impl DrawTarget for EmbeddedGraphics {
    type Color = Gray8;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), Self::Error> {
        let side = usize::from(SIDE);
        for Pixel(Point { x, y }, color) in pixels {
            if let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y))
                && x < side
                && y < side
            {
                self.pixels[y * side + x] = color.luma();
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &eg::Rectangle, color: Gray8) -> Result<(), Self::Error> {
        let area = area.intersection(&self.bounding_box());
        let side = usize::from(SIDE);
        for y in area.rows() {
            let start = y as usize * side + area.top_left.x as usize;
            self.pixels[start..start + area.size.width as usize].fill(color.luma());
        }
        Ok(())
    }
}
