//! Files that `mech` writes from the window: their kinds, and how they are written beside it.

#[cfg(not(target_arch = "wasm32"))]
use super::journal::Heard;
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
    pub(super) const fn suffix(self) -> &'static str {
        match self {
            Self::Gif | Self::Apng | Self::MovingDrawing => "_film",
            Self::GraphDrawing | Self::GraphPicture => "_plots",
            Self::LinkGraph => "_links",
            Self::LoopGraph => "_loops",
            _ => "",
        }
    }

    /// The words of the command that writes it; none if there is none.
    pub(super) const fn words(self) -> &'static [&'static str] {
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
    pub(super) const fn is_answer(self) -> bool {
        matches!(self, Self::Report | Self::LinkGraph | Self::LoopGraph)
    }
}

/// What is to be written where.
pub(super) struct Order {
    pub(super) kind: Export,
    pub(super) words: Vec<String>,
    pub(super) document: Document,
    pub(super) index: usize,
    pub(super) path: String,
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
