//! Graphs of what was measured.

mod scale;

use crate::failure::Failure;
use crate::quantity::{Table, tick};
use epaint_default_fonts::UBUNTU_LIGHT;
use mech_runtime::Palette;
use mech_runtime::files::Picture;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::register_font;
use scale::Scale;

/// Graphs of what was measured: one for each unit, below each other.
pub(crate) struct Chart<'t> {
    title: &'t str,
    table: &'t Table,
    panels: Vec<Panel<'t>>,
}

/// The graph of all quantities with the same unit.
struct Panel<'t> {
    unit: &'t str,
    /// The numbers of their columns.
    columns: Vec<usize>,
    /// Whether they are shown over the same unit: then both axes have the same scale.
    is_path: bool,
}

/// The width of a chart, and the height of its title, of a legend and of a graph with its axes, in pixels of a screen.
const WIDTH: u32 = 800;
const TITLE: u32 = 40;
const LEGEND: u32 = 26;
const PANEL: u32 = 280;
/// The height of a graph in which both axes have the same scale.
const SQUARE: u32 = 560;
/// Where a graph begins, right of the numbers of its upward axis, and how much is left free at its right.
const LEFT: u32 = 80;
const RIGHT: u32 = 24;
/// The height of the numbers and the name below a graph, and of what is left free below them.
const BELOW: u32 = 40;
const BOTTOM: u32 = 8;
/// A PNG has so many pixels for each of these, so that it can be printed.
const FINENESS: u32 = 2;

/// The colours of curves, in turn.
const COLORS: [u8; 8] = [
    Palette::BLUE,
    Palette::ORANGE,
    Palette::TEAL,
    Palette::RED,
    Palette::PURPLE,
    Palette::GREEN,
    Palette::PINK,
    Palette::SLATE,
];

const FONT: &str = "sans-serif";

impl Panel<'_> {
    fn height(&self) -> u32 {
        LEGEND + if self.is_path { SQUARE } else { PANEL }
    }
}

impl<'t> Chart<'t> {
    /// The graphs of a table, over one of its columns.
    pub(crate) fn new(title: &'t str, table: &'t Table) -> Self {
        let mut panels: Vec<Panel<'t>> = Vec::new();
        for number in table.curves() {
            let unit = &table.columns[number].1;
            match panels.iter_mut().find(|panel| panel.unit == unit) {
                Some(panel) => panel.columns.push(number),
                None => {
                    panels.push(Panel {
                        unit,
                        columns: vec![number],
                        is_path: table.is_path(unit),
                    });
                }
            }
        }
        Self { title, table, panels }
    }

    pub(crate) fn svg(&self) -> Result<String, Failure> {
        let mut text = String::new();
        let root = SVGBackend::with_string(&mut text, self.size(1)).into_drawing_area();
        self.draw(&root, 1)?;
        drop(root);
        Ok(text)
    }

    pub(crate) fn png(&self) -> Result<Vec<u8>, Failure> {
        let (width, height) = self.size(FINENESS);
        let size = [width as usize, height as usize];
        let mut pixels = vec![0; 3 * size[0] * size[1]];
        let backend = BitMapBackend::with_buffer(&mut pixels, (width, height));
        let root = backend.into_drawing_area();
        self.draw(&root, FINENESS)?;
        drop(root);
        let (pixels, _) = pixels.as_chunks();
        let opaque = |&[red, green, blue]: &[u8; 3]| [red, green, blue, 255];
        let pixels: Vec<[u8; 4]> = pixels.iter().map(opaque).collect();
        Ok(Picture::rgba(size, &pixels)?.png()?)
    }

    fn size(&self, fineness: u32) -> (u32, u32) {
        let panels: u32 = self.panels.iter().map(Panel::height).sum();
        (fineness * WIDTH, fineness * (TITLE + panels))
    }

    fn draw<B: DrawingBackend>(
        &self,
        root: &DrawingArea<B, Shift>,
        fineness: u32,
    ) -> Result<(), Failure> {
        // Registering it again changes nothing.
        if register_font(FONT, FontStyle::Normal, UBUNTU_LIGHT).is_err() {
            return Err(Failure::internal("the font of charts is not one"));
        }
        self.paint(root, fineness)
            .map_err(|error| Failure::internal(format!("the chart cannot be drawn: {error}")))
    }

    fn paint<B: DrawingBackend>(
        &self,
        root: &DrawingArea<B, Shift>,
        fineness: u32,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        root.fill(&WHITE)?;
        let (head, mut body) = root.split_vertically(fineness * TITLE);
        let place = (to_pixels(fineness * 16), to_pixels(fineness * 12));
        let style = (FONT, fineness * 18).into_font().color(&ink());
        head.draw(&Text::new(self.title.to_owned(), place, style))?;
        for panel in &self.panels {
            let (area, below) = body.split_vertically(fineness * panel.height());
            self.paint_panel(panel, &area, fineness)?;
            body = below;
        }
        root.present()
    }

    fn paint_panel<B: DrawingBackend>(
        &self,
        panel: &Panel<'_>,
        area: &DrawingArea<B, Shift>,
        fineness: u32,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        let (legend, area) = area.split_vertically(fineness * LEGEND);
        self.paint_legend(panel, &legend, fineness)?;
        let driven = self.table.across == 0;
        let (driver, unit) = &self.table.columns[self.table.across];
        let columns = panel.columns.iter();
        let values = columns.flat_map(|&column| self.values(column));
        let mut across = if driven || unit == "s" {
            Scale::exact(self.values(self.table.across), unit, 10)
        } else {
            Scale::with_room(self.values(self.table.across), unit, 10)
        };
        let mut up = Scale::with_room(values, panel.unit, 8);
        if panel.is_path {
            let size = [WIDTH - LEFT - RIGHT, SQUARE - BELOW - BOTTOM];
            Scale::equalize([&mut across, &mut up], size);
        }
        let [xs, ys] = [&across, &up].map(Scale::count);
        let mut chart = ChartBuilder::on(&area)
            .margin_left(fineness * 8)
            .margin_bottom(fineness * BOTTOM)
            .margin_right(fineness * RIGHT)
            .x_label_area_size(fineness * BELOW)
            .y_label_area_size(fineness * (LEFT - 8))
            .build_cartesian_2d(across, up)?;
        let text = |size: u32| (FONT, fineness * size).into_font().color(&ink());
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .bold_line_style(grid())
            .axis_style(ink())
            .x_desc(format!("{driver} [{unit}]"))
            .y_desc(self.label(panel))
            .x_labels(xs)
            .y_labels(ys)
            .x_label_formatter(&|value| tick(*value))
            .y_label_formatter(&|value| tick(*value))
            .label_style(text(13))
            .axis_desc_style(text(14))
            .draw()?;
        for (number, &column) in panel.columns.iter().enumerate() {
            for run in self.runs(column) {
                chart.draw_series(LineSeries::new(run, curve(number, fineness)))?;
            }
        }
        Ok(())
    }

    /// The names of several curves, above their graph.
    fn paint_legend<B: DrawingBackend>(
        &self,
        panel: &Panel<'_>,
        area: &DrawingArea<B, Shift>,
        fineness: u32,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        if panel.columns.len() < 2 {
            return Ok(());
        }
        let style = (FONT, fineness * 13).into_font().color(&ink());
        let [stroke, gap, middle] = [24, 8, LEGEND / 2].map(|size| to_pixels(size * fineness));
        let mut left = to_pixels(LEFT * fineness);
        for (number, &column) in panel.columns.iter().enumerate() {
            let name = &self.table.columns[column].0;
            let ends = vec![(left, middle), (left + stroke, middle)];
            area.draw(&PathElement::new(ends, curve(number, fineness)))?;
            let (width, height) = area.estimate_text_size(name, &style)?;
            let place = (left + stroke + gap, middle - to_pixels(height) / 2);
            area.draw(&Text::new(name.clone(), place, style.clone()))?;
            left += stroke + 3 * gap + to_pixels(width);
        }
        Ok(())
    }

    /// Returns the label of the upward axis of a graph.
    fn label(&self, panel: &Panel<'_>) -> String {
        match panel.columns[..] {
            [only] => format!("{} [{}]", self.table.columns[only].0, panel.unit),
            _ => format!("[{}]", panel.unit),
        }
    }

    fn values(&self, column: usize) -> impl Iterator<Item = f64> + '_ {
        self.table.rows.iter().filter_map(move |row| row[column])
    }

    /// The points of a curve, in pieces between values that are not determined.
    fn runs(&self, column: usize) -> Vec<Vec<(f64, f64)>> {
        let point = |row: &Vec<Option<f64>>| row[self.table.across].zip(row[column]);
        let points: Vec<Option<(f64, f64)>> = self.table.rows.iter().map(point).collect();
        let runs = points.split(Option::is_none).filter(|run| !run.is_empty());
        runs.map(|run| run.iter().flatten().copied().collect()).collect()
    }
}

fn to_pixels(size: u32) -> i32 {
    i32::try_from(size).unwrap_or(i32::MAX)
}

fn curve(number: usize, fineness: u32) -> ShapeStyle {
    color(COLORS[number % COLORS.len()]).stroke_width(2 * fineness)
}

fn color(entry: u8) -> RGBColor {
    let [red, green, blue] = Palette::TEXTBOOK.rgb(entry);
    RGBColor(red, green, blue)
}

fn ink() -> RGBColor {
    color(Palette::INK)
}

fn grid() -> RGBColor {
    color(Palette::GRID)
}
