//! What `mech` writes to files, from the window.

use super::Editor;
#[cfg(not(target_arch = "wasm32"))]
use super::journal::Heard;
use super::worker::Task;
#[cfg(not(target_arch = "wasm32"))]
use crate::command::obey_within;
#[cfg(not(target_arch = "wasm32"))]
use crate::console::Console;
use crate::document::{Document, in_rust};
use crate::failure::Failure;
use crate::output;
use std::path::Path;

/// A kind of file that can be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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

    /// What it is called in the menu.
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

    /// How its file may end; first, how it does if nobody says otherwise.
    pub(super) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Picture | Self::GraphPicture => &["png"],
            Self::Drawing | Self::MovingDrawing | Self::GraphDrawing => &["svg"],
            Self::Gif => &["gif"],
            Self::Apng => &["apng", "png"],
            Self::Table => &["csv"],
            Self::Rust => &["rs"],
            Self::Report => &["txt"],
            Self::LinkGraph | Self::LoopGraph => &["dot", "gv"],
        }
    }

    /// What tells its file from others with the same ending.
    const fn suffix(self) -> &'static str {
        match self {
            Self::Gif | Self::Apng | Self::MovingDrawing => "_film",
            Self::GraphDrawing | Self::GraphPicture => "_plots",
            Self::LinkGraph => "_links",
            Self::LoopGraph => "_loops",
            _ => "",
        }
    }

    /// The words of the command that writes it; none if there is none.
    const fn words(self) -> &'static [&'static str] {
        match self {
            Self::Picture | Self::Drawing => &["draw"],
            Self::Gif | Self::Apng | Self::MovingDrawing => &["film"],
            Self::Table => &["table"],
            Self::GraphDrawing | Self::GraphPicture => &["plot"],
            Self::Rust => &[],
            Self::Report => &["report"],
            Self::LinkGraph => &["graph"],
            Self::LoopGraph => &["graph", "--of", "loops"],
        }
    }

    /// Whether its command has no file of its own, but answers.
    const fn is_answer(self) -> bool {
        matches!(self, Self::Report | Self::LinkGraph | Self::LoopGraph)
    }
}

/// What is to be written where.
pub(super) struct Order {
    kind: Export,
    words: Vec<String>,
    document: Document,
    index: usize,
    path: String,
}

impl Order {
    /// Writes it, and tells so.
    pub(super) fn fulfil(self) -> Result<String, Failure> {
        if self.kind == Export::Rust {
            let source = self.document.source();
            let ending = source.path().extension();
            let is_inside = ending.is_some_and(|ending| ending == "mech");
            let text = if is_inside {
                in_rust(source.text().lines())
            } else {
                source.text().to_owned()
            };
            output::replace(Path::new(&self.path), text.as_bytes())?;
            return Ok(format!("wrote `{}`", self.path));
        }
        self.obey()
    }

    /// Writes what a command of `mech` writes.
    #[cfg(not(target_arch = "wasm32"))]
    fn obey(self) -> Result<String, Failure> {
        let (answer, complaint) = (Heard::default(), Heard::default());
        let mut console = Console::to(answer.clone(), complaint.clone());
        let done = obey_within(&self.words, self.document, self.index, &mut console);
        done.map_err(|failure| {
            if failure.is_reported() {
                Failure::new(failure.kind(), complaint.text())
            } else {
                failure
            }
        })?;
        if self.kind.is_answer() {
            output::replace(Path::new(&self.path), answer.text().as_bytes())?;
        }
        Ok(format!("wrote `{}`", self.path))
    }

    /// The commands of `mech` are not in a page.
    #[cfg(target_arch = "wasm32")]
    fn obey(self) -> Result<String, Failure> {
        Err(Failure::file(
            "a page in a browser exports Rust alone; use `mech edit` on a computer",
        ))
    }
}

impl Editor {
    /// A name for a file of this kind.
    pub(super) fn export_path(&self, kind: Export) -> String {
        let path = self.workspace().path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        let name = format!("{stem}{}.{}", kind.suffix(), kind.endings()[0]);
        path.with_file_name(name).display().to_string()
    }

    /// Writes a file, beside the window. A picture shows the present pose, a table or a graph what is plotted.
    pub(super) fn export(&mut self, kind: Export, path: &str) {
        let path = path.trim();
        if path.is_empty() {
            self.refuse("no file is named");
            return;
        }
        let ending = Path::new(path).extension().unwrap_or_default();
        if !kind
            .endings()
            .iter()
            .any(|known| ending.eq_ignore_ascii_case(known))
        {
            let ending = kind.endings()[0];
            self.refuse(format!(
                "`{path}` is no name for this: write `.{ending}` at its end"
            ));
            return;
        }
        if is_same(Path::new(path), self.workspace().path()) {
            self.refuse(format!("`{path}` is the file of the text; save it instead"));
            return;
        }
        let mut words: Vec<String> = kind.words().iter().map(|word| (*word).to_owned()).collect();
        match kind {
            Export::Picture | Export::Drawing => {
                words.extend(at(self.seen_at().unwrap_or_default()));
            }
            Export::Table | Export::GraphDrawing | Export::GraphPicture
                if !self.plotted.names.is_empty() =>
            {
                words.extend(self.plotted.names.iter().cloned());
                if let Some(wanted) = self.wanted_curves() {
                    words.extend(wanted.over.map(|over| format!("--over={over}")));
                    words.extend(wanted.motor.map(|motor| format!("--motor={motor}")));
                    words.extend(at(wanted.others));
                    let loads = wanted.loads.iter();
                    words.extend(loads.map(|load| format!("--load={load}")));
                }
            }
            _ => {}
        }
        if !kind.is_answer() {
            words.push(format!("--output={path}"));
        }
        self.tell(format!("writing `{path}`"));
        let order = Order {
            kind,
            words,
            document: self.workspace().document(),
            index: self.workspace().index(),
            path: path.to_owned(),
        };
        self.give(Task::Export(Box::new(order)));
    }

    /// Tells that a file was written, or why not.
    pub(super) fn take_export(&mut self, done: Result<String, Failure>) {
        match done {
            Ok(told) => self.tell(told),
            Err(failure) => self.refuse(failure),
        }
    }
}

/// Whether two paths lead to the same file.
fn is_same(one: &Path, other: &Path) -> bool {
    match (one.canonicalize(), other.canonicalize()) {
        (Ok(one), Ok(other)) => one == other,
        _ => one == other,
    }
}

/// The values of motors, as commands take them.
fn at(motors: Vec<(String, f64)>) -> impl Iterator<Item = String> {
    motors
        .into_iter()
        .map(|(name, value)| format!("--at={name}={value}"))
}
