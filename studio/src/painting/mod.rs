//! Mechanisms that the interpreter moves, painted as their generated code would paint them.

mod names;

use crate::motion::Paths;
use mech_compiler::model::{LinkId, Look, Measure, Model};
use mech_compiler::{Compiled, Looks, Points, Symbols, looks, symbols};
use mech_runtime::overlay::{Overlay, Symbol};
use mech_runtime::{Canvas, Outline, Pose, View};
use names::Label;

/// An outline of a link, with its colour and its own points.
type Shape = mech_core::Shape<f64, Vec<[f64; 2]>>;

pub(crate) struct Painting {
    /// From the plane farthest from the eye to the nearest.
    shapes: Vec<Shape>,
    /// For each trace, in the order of their planes, its number and how many shapes lie behind it.
    traces: Vec<(usize, usize)>,
    colors_of_traces: Vec<u8>,
    /// Painted over all shapes, with the size of a pixel of theirs in scene units; none if pixels are those of the picture.
    symbols: Option<(Vec<Symbol<f64>>, Option<f64>)>,
    /// Painted over everything, if it is asked for.
    diagram: Option<Vec<Symbol<f64>>>,
    /// Written over everything, if they are asked for.
    names: Vec<Label>,
    extent: [[f64; 2]; 2],
}

impl Painting {
    /// Paints a coherent mechanism, with the symbols of its joints if these are asked for. Numbers that depend on params are as at the
    /// start.
    pub(crate) fn new(model: &Model, compiled: &Compiled, has_diagram: bool) -> Self {
        let looks = looks(model, compiled);
        let extent = looks.extent(model, compiled);
        Self::of(model, compiled, &looks, extent, has_diagram)
    }

    /// The same, where the look is known, and the box around the whole motion of it.
    pub(crate) fn of(
        model: &Model,
        compiled: &Compiled,
        looks: &Looks,
        extent: [[f64; 2]; 2],
        has_diagram: bool,
    ) -> Self {
        let number = |link| number_of(compiled, link);
        let shapes = looks.painted.iter().filter_map(|painted| {
            Some(Shape {
                link: number(painted.link)?,
                outline: painted.outline.map(Measure::at_start, Points::at_start),
                color: painted.color,
            })
        });
        let mut traces: Vec<(usize, usize)> = model
            .traces
            .iter()
            .enumerate()
            .map(|(index, trace)| (index, looks.behind(trace.plane)))
            .collect();
        traces.sort_by_key(|(_, behind)| *behind);
        let drawn = |symbols: &[symbols::Symbol]| {
            let drawn = symbols.iter();
            let drawn = drawn.filter_map(|symbol| symbol.try_map(Measure::at_start, number));
            drawn.collect::<Vec<_>>()
        };
        let diagram = || {
            let has_pose = |link| compiled.program.place_of(link).is_some();
            drawn(&symbols::symbols(model, &compiled.structure, has_pose))
        };
        Self {
            shapes: shapes.collect(),
            traces,
            colors_of_traces: model.traces.iter().map(|trace| trace.color).collect(),
            symbols: match &looks.symbols {
                None => None,
                Some(Symbols::Diagram) => Some((diagram(), None)),
                Some(Symbols::Elastic { symbols, unit }) => Some((drawn(symbols), Some(*unit))),
            },
            diagram: has_diagram.then(diagram),
            names: Vec::new(),
            extent,
        }
    }

    /// The same in a view that has room for the bodies of all links, which a diagram is not wider than.
    pub(crate) fn with_room_for_bodies(mut self, model: &Model, compiled: &Compiled) -> Self {
        let bodies = Model { look: Some(Look::Machine), ..model.clone() };
        let [low, high] = looks(&bodies, compiled).extent(&bodies, compiled);
        for part in 0..2 {
            self.extent[0][part] = self.extent[0][part].min(low[part]);
            self.extent[1][part] = self.extent[1][part].max(high[part]);
        }
        self
    }

    /// The same with the names of joints and links.
    pub(crate) fn with_names(mut self, model: &Model, compiled: &Compiled) -> Self {
        self.names = Label::of_all(model, compiled);
        self
    }

    /// The same in a view of this box.
    pub(crate) fn with_extent(self, extent: [[f64; 2]; 2]) -> Self {
        Self { extent, ..self }
    }

    /// The view that fits the whole motion into a picture of this width and height in pixels, with the margin that generated code has.
    pub(crate) fn view(&self, [width, height]: [usize; 2]) -> View {
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
        let margin = width.min(height) as f64 / 24.0;
        let [low, high] = self.extent;
        View::fit(low, high, width, height, margin)
    }

    /// The height of a picture of this width that fits the whole motion, neither a strip nor a tower.
    pub(crate) fn height(&self, width: usize) -> usize {
        let [low, high] = self.extent;
        let ratio = (high[1] - low[1]) / (high[0] - low[0]);
        let ratio = if ratio.is_finite() { ratio.clamp(0.4, 1.5) } else { 1.0 };
        #[expect(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a number of pixels"
        )]
        let height = (width as f64 * ratio).round() as usize;
        height.max(1)
    }

    /// The box around the whole motion: its lower left and upper right corner.
    pub(crate) fn extent(&self) -> [[f64; 2]; 2] {
        self.extent
    }

    /// Whether nothing is painted besides a diagram.
    pub(crate) fn is_empty(&self) -> bool {
        self.shapes.is_empty() && self.traces.is_empty() && self.symbols.is_none()
    }

    /// All outlines from the farthest to the nearest, each with the number of its link.
    pub(crate) fn outlines(&self) -> impl Iterator<Item = (usize, Outline<'_, f64>)> {
        let shapes = self.shapes.iter();
        shapes.map(|shape| (shape.link, shape.outline.borrowed()))
    }

    /// Paints a position: for each moving link its pose, as the interpreter has it.
    pub(crate) fn paint(&self, poses: &[[f64; 4]], paths: &Paths, canvas: &mut impl Canvas<f64>) {
        let poses = poses_of(poses);
        self.paint_look(&poses, paths, canvas);
        self.paint_diagram(&poses, &Overlay::new().axes(true), canvas);
        for name in &self.names {
            name.paint(&poses, canvas);
        }
    }

    /// Paints shapes, traces and the symbols of the look.
    pub(crate) fn paint_look(
        &self,
        poses: &[Pose<f64>],
        paths: &Paths,
        canvas: &mut impl Canvas<f64>,
    ) {
        let mut traces = self.traces.iter().peekable();
        for number in 0..=self.shapes.len() {
            while let Some(&(trace, _)) = traces.next_if(|(_, behind)| *behind == number) {
                paths.draw(trace, canvas, self.colors_of_traces[trace]);
            }
            if let Some(shape) = self.shapes.get(number)
                && let Some(pose) = Pose::of_link(shape.link, poses)
            {
                canvas.fill(shape.outline.borrowed(), pose, shape.color);
            }
        }
        if let Some((symbols, unit)) = &self.symbols {
            let overlay = match unit {
                None => Overlay::new().links(true),
                #[expect(clippy::cast_possible_truncation, reason = "a size in pixels")]
                Some(unit) => Overlay::new().size((unit * canvas.scale()) as f32),
            };
            overlay.draw(symbols, poses, canvas);
        }
    }

    /// Paints the symbols of joints, motors and axes that the overlay wants, if they were asked for.
    pub(crate) fn paint_diagram(
        &self,
        poses: &[Pose<f64>],
        overlay: &Overlay,
        canvas: &mut impl Canvas<f64>,
    ) {
        if let Some(symbols) = &self.diagram {
            overlay.draw(symbols, poses, canvas);
        }
    }
}

/// Poses as the interpreter has them, for the rasteriser.
pub(crate) fn poses_of(poses: &[[f64; 4]]) -> Vec<Pose<f64>> {
    poses.iter().copied().map(Pose::from).collect()
}

/// The number of a link in a table: 0 is the ground; none if its pose is not known.
pub(crate) fn number_of(compiled: &Compiled, link: LinkId) -> Option<usize> {
    if link == LinkId::GROUND {
        return Some(0);
    }
    compiled.program.place_of(link).map(|place| place + 1)
}
