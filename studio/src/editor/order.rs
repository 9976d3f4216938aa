//! Files that `mech` writes from the window: their kinds, and how they are written beside it.

use crate::check::render;
use crate::document::{Document, in_rust};
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::job::{
    Analysed, Draw, Film, FilmKind, GraphKind, Job, Listener, Measure, Picture, Plot, StillKind,
};
use crate::motion::Setting;
use crate::output::{self, Output, OutputKind, ends_in};
use std::path::{Path, PathBuf};

/// A kind of file that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Export {
    Picture,
    Drawing,
    Gif,
    Apng,
    MovingDrawing,
    Table,
    GraphDrawing,
    GraphPicture,
    Rust,
    Report,
    LinkGraph,
    LoopGraph,
}

impl Export {
    pub(super) const ALL: [Self; 12] = [
        Self::Picture,
        Self::Drawing,
        Self::Gif,
        Self::Apng,
        Self::MovingDrawing,
        Self::Table,
        Self::GraphDrawing,
        Self::GraphPicture,
        Self::Rust,
        Self::Report,
        Self::LinkGraph,
        Self::LoopGraph,
    ];

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Picture => "Picture as PNG",
            Self::Drawing => "Picture as SVG",
            Self::Gif => "Film as GIF",
            Self::Apng => "Film as animated PNG",
            Self::MovingDrawing => "Film as moving SVG",
            Self::Table => "Table as CSV",
            Self::GraphDrawing => "Plots as SVG",
            Self::GraphPicture => "Plots as PNG",
            Self::Rust => "Rust source",
            Self::Report => "Report as text",
            Self::LinkGraph => "Kinematic graph as DOT",
            Self::LoopGraph => "Graph of loops as DOT",
        }
    }

    /// Returns the endings that its file may have; the first is the default.
    pub(super) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Picture | Self::GraphPicture => &["png"],
            Self::Apng => &["apng", "png"],
            _ => self.kind().endings(),
        }
    }

    const fn kind(self) -> OutputKind {
        match self {
            Self::Picture | Self::GraphPicture | Self::Apng => OutputKind::Png,
            Self::Drawing | Self::MovingDrawing | Self::GraphDrawing => OutputKind::Svg,
            Self::Gif => OutputKind::Gif,
            Self::Table => OutputKind::Csv,
            Self::Rust => OutputKind::Rust,
            Self::Report => OutputKind::Report,
            Self::LinkGraph | Self::LoopGraph => OutputKind::Dot,
        }
    }

    /// Returns the suffix that tells its file from others with the same ending.
    const fn suffix(self) -> &'static str {
        match self {
            Self::Gif | Self::Apng | Self::MovingDrawing => "_film",
            Self::GraphDrawing | Self::GraphPicture => "_plots",
            Self::LinkGraph => "_links",
            Self::LoopGraph => "_loops",
            _ => "",
        }
    }

    /// A name for its file, beside that of the text.
    pub(super) fn path(self, text: &Path) -> String {
        let stem = text.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}{}.{}", self.suffix(), self.endings()[0]);
        text.with_file_name(name).display().to_string()
    }

    /// Makes the job for it; none for the text itself. A picture shows the pose that is seen, a table or a graph the measured quantities.
    pub(super) fn job(self, seen: &[(String, f64)], measure: &Measure) -> Option<Job> {
        let draw = |kind| {
            let at = seen.iter().cloned().map(Setting::from).collect();
            let picture = Picture { at, ..Picture::default() };
            Job::Draw(Draw { picture, reach: None, kind })
        };
        let film = |kind| Job::Film(Film::of_kind(kind));
        let plot = |kind| Job::Plot(Plot { measure: measure.clone(), kind, title: None });
        Some(match self {
            Self::Picture => draw(StillKind::Png),
            Self::Drawing => draw(StillKind::Svg),
            Self::Gif => film(FilmKind::Gif),
            Self::Apng => film(FilmKind::Apng),
            Self::MovingDrawing => film(FilmKind::Svg),
            Self::Table => Job::Table(measure.clone()),
            Self::GraphDrawing => plot(StillKind::Svg),
            Self::GraphPicture => plot(StillKind::Png),
            Self::Rust => return None,
            Self::Report => Job::Report,
            Self::LinkGraph => Job::Graph(GraphKind::Links),
            Self::LoopGraph => Job::Graph(GraphKind::Loops),
        })
    }
}

/// An order to write something to a file.
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Order {
    /// The job that makes it; none for the text itself as Rust.
    job: Option<Job>,
    document: Document,
    index: usize,
    kind: Export,
    pub(super) path: String,
    /// The files that are shown: none of them is written over.
    inputs: Vec<PathBuf>,
}

/// What is to be written to a file.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Made {
    bytes: Vec<u8>,
    kind: Export,
    /// The files that are shown: none of them is written over.
    inputs: Vec<PathBuf>,
    /// What is to be told about it.
    notes: String,
}

impl Made {
    pub(super) fn write(self, path: &str) -> Result<String, Failure> {
        let output = Output::new(path, self.kind.kind(), self.bytes);
        output::write(output.from(&self.inputs))?;
        Ok(format!("wrote `{path}`{}", self.notes))
    }
}

#[derive(Default)]
struct Notes(String);

impl Listener for Notes {
    fn note(&mut self, text: &str) {
        self.0 += &format!("; {text}");
    }

    fn progress(&mut self, _: u32, _: u32) {}
}

impl Order {
    /// Prepares to write something to a file of this name; an error says why that is impossible.
    pub(super) fn new(
        kind: Export,
        path: &str,
        workspace: &Workspace,
        job: Option<Job>,
        traced: Option<&Path>,
    ) -> Result<Self, String> {
        let path = path.trim();
        if path.is_empty() {
            return Err("no file is named".to_owned());
        }
        if !ends_in(Path::new(path), kind.endings()) {
            let ending = kind.endings()[0];
            return Err(format!("`{path}` is no name for this: write `.{ending}` at its end"));
        }
        if Path::new(path) == workspace.path() {
            return Err(format!("`{path}` is the file of the text; save it instead"));
        }
        Ok(Self {
            job,
            document: workspace.document(),
            index: workspace.index(),
            kind,
            inputs: [workspace.path()].into_iter().chain(traced).map(Path::to_owned).collect(),
            path: path.to_owned(),
        })
    }

    pub(super) fn make(&self) -> Result<Made, Failure> {
        let mut notes = Notes::default();
        let bytes = match &self.job {
            Some(job) => job.run(self.analysed()?, &mut notes)?,
            None => self.in_rust().into_bytes(),
        };
        Ok(Made { bytes, kind: self.kind, inputs: self.inputs.clone(), notes: notes.0 })
    }

    fn in_rust(&self) -> String {
        let source = self.document.source();
        let ending = source.path().extension();
        if ending.is_some_and(|ending| ending == "mech") {
            in_rust(source.text().lines())
        } else {
            source.text().to_owned()
        }
    }

    /// The mechanism, which has to be coherent.
    fn analysed(&self) -> Result<Analysed, Failure> {
        let declaration = self.document.declarations().get(self.index);
        let declaration =
            declaration.ok_or_else(|| Failure::mechanism("there is no mechanism yet"))?;
        let analysed = Analysed::of(self.document.analyse(declaration)?);
        analysed.map_err(|faults| {
            let text = render(self.document.source(), &faults.messages, false);
            Failure::mechanism(text)
        })
    }
}
