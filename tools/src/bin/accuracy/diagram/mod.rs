//! The work–precision diagram: a panel for each mechanism, and a legend.

mod legend;
mod marks;
mod panel;

use crate::measurement::Measurement;
use epaint_default_fonts::UBUNTU_LIGHT;
use mech_gallery::Picture;
use panel::{Panel, Scale};
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

/// The size in pixels. It is shown at half of this, so that it is sharp on every screen.
const WIDTH: u16 = 1800;
const PANEL_HEIGHT: u16 = 560;
const TEXT: RGBColor = RGBColor(34, 36, 44);
const SOFT: RGBColor = RGBColor(104, 108, 118);
const LINE: RGBColor = RGBColor(228, 230, 234);
const FONT: &str = "sans-serif";

type Area<'a, B> = DrawingArea<B, Shift>;
type Drawn<B> = Result<(), DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>>;

/// The diagram as SVG.
///
/// # Errors
/// If it could not be drawn.
pub(crate) fn svg(measurements: &[Measurement]) -> Result<String, String> {
    font()?;
    let (width, height) = size(measurements);
    let mut text = String::new();
    {
        let backend = SVGBackend::with_string(&mut text, (width.into(), height.into()));
        let area = backend.into_drawing_area();
        draw(&area, measurements).map_err(|error| error.to_string())?;
        area.present().map_err(|error| error.to_string())?;
    }
    // Shown at half its size, like the PNG.
    let (whole, half) = (
        format!("width=\"{width}\" height=\"{height}\""),
        format!("width=\"{}\" height=\"{}\"", width / 2, height / 2),
    );
    Ok(text.replacen(&whole, &half, 1))
}

/// The diagram in pixels.
///
/// # Errors
/// If it could not be drawn.
pub(crate) fn picture(measurements: &[Measurement]) -> Result<Picture, String> {
    font()?;
    let (width, height) = size(measurements);
    let mut bytes = vec![0; usize::from(width) * usize::from(height) * 3];
    {
        let backend = BitMapBackend::with_buffer(&mut bytes, (width.into(), height.into()));
        let area = backend.into_drawing_area();
        draw(&area, measurements).map_err(|error| error.to_string())?;
        area.present().map_err(|error| error.to_string())?;
    }
    let (pixels, _) = bytes.as_chunks::<3>();
    Ok(Picture {
        width,
        height,
        pixels: pixels.iter().map(|&[red, green, blue]| [red, green, blue, u8::MAX]).collect(),
    })
}

/// The font of the diagram, because the machine may have none.
fn font() -> Result<(), String> {
    let registered = register_font(FONT, FontStyle::Normal, UBUNTU_LIGHT);
    registered.map_err(|_| "the font cannot be read".to_owned())
}

/// A cell for each mechanism, and one for the legend.
fn rows(measurements: &[Measurement]) -> u16 {
    u16::try_from((measurements.len() + 1).div_ceil(2)).unwrap_or(u16::MAX / PANEL_HEIGHT)
}

fn size(measurements: &[Measurement]) -> (u16, u16) {
    (WIDTH, rows(measurements).saturating_mul(PANEL_HEIGHT))
}

fn draw<B: DrawingBackend>(area: &Area<'_, B>, measurements: &[Measurement]) -> Drawn<B> {
    area.fill(&WHITE)?;
    let cells = area.split_evenly((rows(measurements).into(), 2));
    let scale = Scale::fit(measurements);
    for (measurement, cell) in measurements.iter().zip(&cells) {
        Panel::new(measurement, scale, cell.dim_in_pixel()).draw(cell)?;
    }
    match cells.last() {
        Some(cell) => legend::draw(cell),
        None => Ok(()),
    }
}

/// The anchor of a text beside its point.
#[derive(Clone, Copy, Debug)]
enum Side {
    Left,
    Center,
    Right,
}

fn write<B: DrawingBackend>(
    area: &Area<'_, B>,
    (text, size, color): (&str, f64, RGBColor),
    at: (i32, i32),
    side: Side,
) -> Drawn<B> {
    let side = match side {
        Side::Left => HPos::Right,
        Side::Center => HPos::Center,
        Side::Right => HPos::Left,
    };
    let style = TextStyle::from((FONT, size).into_font()).color(&color);
    let style = style.pos(Pos::new(side, VPos::Center));
    area.draw(&Text::new(text.to_owned(), at, style))
}

/// The approximate width of a text.
fn width(text: &str, size: f64) -> i32 {
    let font = (FONT, size).into_font();
    font.box_size(text).map_or(0, |(width, _)| width.cast_signed())
}
