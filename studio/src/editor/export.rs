//! What `mech` writes to files, from the window.

use super::Editor;
use super::order::{Export, Order};
use super::worker::Task;
use crate::failure::Failure;
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
