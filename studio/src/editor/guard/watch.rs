//! The file on disk, which other programs change.
//!
//! Its folder is watched, as many programs do not write into a file but put another in its place.

use super::bar;
use crate::document::Source;
use crate::editor::Editor;
use crate::failure::Failure;
use eframe::egui;
use notify::{Event, EventKind, RecommendedWatcher, RecursiveMode, Watcher};
use std::ffi::OsStr;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// The time for which a file must be left alone before it is read: another program may write it in pieces.
const QUIET: Duration = Duration::from_millis(60);

pub(super) struct Watch {
    wake: Arc<dyn Fn() + Send + Sync>,
    path: PathBuf,
    watcher: Option<RecommendedWatcher>,
    /// When something happened to it that was not looked at.
    stirred: Stirred,
    /// The text that another program has written while there are changes here.
    theirs: Option<String>,
    /// The text of the file before it was deleted.
    deleted: Option<String>,
}

type Stirred = Arc<Mutex<Option<Instant>>>;

impl Watch {
    /// One that watches nothing yet, and calls `wake` when a file has changed.
    pub(super) fn new(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            wake: Arc::new(wake),
            path: PathBuf::new(),
            watcher: None,
            stirred: Stirred::default(),
            theirs: None,
            deleted: None,
        }
    }

    /// Looks at the file, if something has happened to it.
    pub(super) fn look(&mut self, editor: &mut Editor, context: &egui::Context) {
        let workspace = editor.workspace();
        if !workspace.is_named() {
            self.end();
            return;
        }
        if workspace.path() != self.path {
            self.path = workspace.path().to_owned();
            (self.theirs, self.deleted) = (None, None);
            if let Err(error) = self.begin() {
                let why = format!("`{}` is not watched: {error}", self.path.display());
                editor.talk.refuse(why);
            }
        }
        if !editor.is_at_rest() || !self.is_time(context) {
            return;
        }
        let looked = self.compare(editor);
        editor.talk.refuse_failed(looked);
    }

    /// Watches nothing any more: the text has no file.
    fn end(&mut self) {
        self.path = PathBuf::new();
        (self.watcher, self.theirs, self.deleted) = (None, None, None);
    }

    fn begin(&mut self) -> notify::Result<()> {
        self.watcher = None;
        self.stirred = Stirred::default();
        // Where a link leads, there it is written.
        let path = fs::canonicalize(&self.path).unwrap_or_else(|_| self.path.clone());
        let name = path.file_name().unwrap_or_default().to_owned();
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        // A folder that is not there yet has no file that could change.
        if !folder.is_dir() {
            return Ok(());
        }
        let (stirred, wake) = (self.stirred.clone(), self.wake.clone());
        let mut watcher = notify::recommended_watcher(move |event: notify::Result<Event>| {
            if event.map_or(true, |event| concerns(&event, &name)) {
                note(&stirred, Some(Instant::now()));
                wake();
            }
        })?;
        watcher.watch(&folder, RecursiveMode::NonRecursive)?;
        self.watcher = Some(watcher);
        // A first look finds changes between reading and watching.
        note(&self.stirred, Some(Instant::now()));
        Ok(())
    }

    /// Whether it is time to look at the file: it has changed, and is left alone now.
    fn is_time(&self, context: &egui::Context) -> bool {
        let focused = |event: &egui::Event| *event == egui::Event::WindowFocused(true);
        // Some disks tell nothing of what happens on them.
        if context.input(|input| input.events.iter().any(focused)) {
            return self.watcher.is_some();
        }
        let stirred = *self.stirred.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(at) = stirred else {
            return false;
        };
        let rest = QUIET.saturating_sub(at.elapsed());
        if rest.is_zero() {
            note(&self.stirred, None);
        } else {
            context.request_repaint_after(rest);
        }
        rest.is_zero()
    }

    /// Compares the file with what is known of it.
    fn compare(&mut self, editor: &mut Editor) -> Result<(), Failure> {
        let on_disk = read(&self.path)?;
        let workspace = editor.workspace();
        let (known, text) = (workspace.saved(), workspace.text());
        let is_untouched = !workspace.is_changed() || self.deleted.as_deref() == Some(text);
        self.theirs = None;
        match on_disk {
            Some(theirs) if known == Some(theirs.as_str()) => {}
            Some(theirs) if text == theirs => {
                editor.session.workspace.note_file(Some(&theirs));
            }
            Some(theirs) if is_untouched => take(editor, &theirs),
            Some(theirs) => self.theirs = Some(theirs),
            None => {
                if let Some(known) = known {
                    self.deleted = Some(known.to_owned());
                    editor.session.workspace.note_file(None);
                    let path = self.path.display();
                    let why = format!("`{path}` was deleted; saving writes it again");
                    editor.talk.refuse(why);
                }
                return Ok(());
            }
        }
        self.deleted = None;
        Ok(())
    }

    /// Asks whose text counts, if both have changed.
    pub(super) fn ask(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let Some(theirs) = &self.theirs else {
            return;
        };
        let name = self.path.file_name().unwrap_or_default();
        let question = format!("{} changed on disk", name.display());
        match bar("theirs", &question, ["Take theirs", "Keep mine"], ui) {
            Some(0) if editor.is_at_rest() => take(editor, theirs),
            // From now on, theirs is what is written over.
            Some(1) => editor.session.workspace.note_file(Some(theirs)),
            _ => return,
        }
        self.theirs = None;
    }
}

/// Takes over what another program has written.
fn take(editor: &mut Editor, theirs: &str) {
    editor.session.workspace.note_file(Some(theirs));
    editor.session.workspace.push("changed on disk", theirs);
    editor.take_over("changed on disk");
}

/// The text of a file; none if it is not there.
fn read(path: &Path) -> Result<Option<String>, Failure> {
    match path.try_exists() {
        Ok(false) => Ok(None),
        Err(error) if error.kind() == ErrorKind::NotADirectory => Ok(None),
        _ => Source::read_plain(path).map(|source| Some(source.text().to_owned())),
    }
}

fn note(stirred: &Stirred, at: Option<Instant>) {
    *stirred.lock().unwrap_or_else(PoisonError::into_inner) = at;
}

/// Whether an event may have changed the file of this name. Reading does not count.
fn concerns(event: &Event, name: &OsStr) -> bool {
    let is_read = matches!(event.kind, EventKind::Access(_));
    let has_name = |path: &PathBuf| path.file_name() == Some(name);
    event.need_rescan() || !is_read && event.paths.iter().any(has_name)
}
