//! Files that are written from the window.

use super::Editor;
use super::order::{Export, Order};
use super::worker::Task;
use crate::failure::Failure;
use crate::job::{Draw, Film, FilmKind, GraphKind, Job, Measure, Picture, Plot, StillKind};
use crate::motion::Setting;
use std::path::Path;

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
        self.tell(format!("writing `{path}`"));
        let order = Order {
            job: self.job(kind),
            document: self.workspace().document(),
            index: self.workspace().index(),
            path: path.to_owned(),
        };
        self.give(Task::Export(Box::new(order)));
    }

    /// What makes a file of this kind; none for the text itself.
    fn job(&self, kind: Export) -> Option<Job> {
        let draw = |kind| {
            let seen = self.scene.playing.seen_at().unwrap_or_default();
            let at = seen.into_iter().map(Setting::from).collect();
            let picture = Picture {
                at,
                ..Picture::default()
            };
            Job::Draw(Draw { picture, kind })
        };
        let film = |kind| Job::Film(Film::of_kind(kind));
        let plot = |kind| {
            Job::Plot(Plot {
                measure: self.measure(),
                kind,
                title: None,
            })
        };
        Some(match kind {
            Export::Picture => draw(StillKind::Png),
            Export::Drawing => draw(StillKind::Svg),
            Export::Gif => film(FilmKind::Gif),
            Export::Apng => film(FilmKind::Apng),
            Export::MovingDrawing => film(FilmKind::Svg),
            Export::Table => Job::Table(self.measure()),
            Export::GraphDrawing => plot(StillKind::Svg),
            Export::GraphPicture => plot(StillKind::Png),
            Export::Rust => return None,
            Export::Report => Job::Report,
            Export::LinkGraph => Job::Graph(GraphKind::Links),
            Export::LoopGraph => Job::Graph(GraphKind::Loops),
        })
    }

    /// What is plotted.
    fn measure(&self) -> Measure {
        let wanted = self
            .wanted_curves()
            .filter(|_| !self.plotted.names.is_empty());
        let measure = Measure {
            quantities: self.plotted.names.clone(),
            ..Measure::default()
        };
        match wanted {
            Some(wanted) => Measure {
                over: wanted.over,
                motor: wanted.motor,
                at: wanted.others.into_iter().map(Setting::from).collect(),
                loads: wanted.loads,
                ..measure
            },
            None => measure,
        }
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
