//! Jobs make bytes of a mechanism: pictures, films, tables, charts, reports and graphs. The command line, the window and the page each fill
//! a job in.

mod draw;
mod film;
mod measure;
mod picture;
mod rest;
mod table;

pub(crate) use draw::Draw;
pub(crate) use film::{Film, FilmKind};
pub(crate) use measure::Measure;
pub(crate) use picture::{Picture, Size};
pub(crate) use rest::Rest;

#[cfg(not(target_arch = "wasm32"))]
use crate::chart::Chart;
use crate::document::{Faults, Reading};
use crate::failure::Failure;
use crate::output::OutputKind;
use mech_compiler::model::Model;
use mech_compiler::{Compiled, graphs};

/// Something that can be made of a mechanism.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Job {
    /// A picture as it is assembled, or where its motors are put.
    Draw(Draw),
    Film(Film),
    /// A table of measurements in its motion, as CSV.
    Table(Measure),
    /// The extremes and means of the same, as CSV.
    Summary(Measure),
    Plot(Plot),
    /// Where springs and weights bring it, in words.
    Rest(Rest),
    Report,
    /// A graph in the language DOT.
    Graph(GraphKind),
}

pub(crate) struct Analysed {
    pub(crate) model: Model,
    pub(crate) compiled: Compiled,
}

impl Analysed {
    /// Returns the mechanism that was read, if it is coherent.
    pub(crate) fn of(Reading { model, result, .. }: Reading) -> Result<Self, Faults> {
        let compiled = *result?;
        Ok(Self { model, compiled })
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum StillKind {
    Png,
    Svg,
}

impl StillKind {
    pub(crate) const fn file(self) -> OutputKind {
        match self {
            Self::Png => OutputKind::Png,
            Self::Svg => OutputKind::Svg,
        }
    }
}

/// The subject of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(not(target_arch = "wasm32"), derive(clap::ValueEnum))]
pub(crate) enum GraphKind {
    /// The kinematic graph: links, and the joints between them.
    Links,
    /// Each loop, after the loops and motors that determine it.
    Loops,
    /// Loops that have joints in common.
    CommonJoints,
}

impl GraphKind {
    fn dot(self, Analysed { model, compiled }: &Analysed) -> String {
        let graph = match self {
            Self::Links => graphs::kinematic(model, &compiled.structure),
            Self::Loops => graphs::loops(model, &compiled.plan),
            Self::CommonJoints => graphs::common_joints(model, &compiled.plan),
        };
        graph.to_dot()
    }
}

/// Whoever hears how a job goes.
pub(crate) trait Listener {
    /// Takes a note for whoever gave the job.
    fn note(&mut self, text: &str);

    /// Learns how many of so many parts are done.
    fn progress(&mut self, done: u32, of: u32);
}

impl Job {
    pub(crate) fn run(
        &self,
        analysed: Analysed,
        listener: &mut dyn Listener,
    ) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Draw(draw) => draw.run(analysed),
            Self::Film(film) => film.run(analysed, listener),
            Self::Table(measure) => Ok(table::csv(&measure.table(&analysed)?).into_bytes()),
            Self::Summary(measure) => {
                Ok(table::summaries(&measure.summaries(&analysed)?, analysed.model.precision)
                    .into_bytes())
            }
            Self::Plot(plot) => plot.run(&analysed),
            Self::Rest(rest) => Ok(rest.run(&analysed)?.into_bytes()),
            Self::Report => {
                Ok(crate::report::report(&analysed.model, &analysed.compiled)?.into_bytes())
            }
            Self::Graph(kind) => Ok(kind.dot(&analysed).into_bytes()),
        }
    }
}

/// Charts of what is measured: quantities with the same unit share one.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Plot {
    pub(crate) measure: Measure,
    pub(crate) kind: StillKind,
    /// The title; without, the name of the mechanism.
    pub(crate) title: Option<String>,
}

impl Plot {
    /// The letters of charts are not in a page.
    #[cfg(target_arch = "wasm32")]
    fn run(&self, _: &Analysed) -> Result<Vec<u8>, Failure> {
        Err(Failure::file(
            "a page in a browser draws no charts; export the table, or use `mech plot` on a computer",
        ))
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn run(&self, analysed: &Analysed) -> Result<Vec<u8>, Failure> {
        let table = self.measure.table(analysed)?;
        let title = self.title.as_deref().unwrap_or(&analysed.model.name);
        let chart = Chart::new(title, &table);
        match self.kind {
            StillKind::Svg => chart.svg().map(String::into_bytes),
            StillKind::Png => chart.png(),
        }
    }
}
