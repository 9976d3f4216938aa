//! What keeps the user's work: against a crash, against other programs, and against a window that is closed too early.

mod autosave;
mod bar;
mod closing;
mod left;
mod watch;

use super::Editor;
use autosave::Autosave;
use closing::Closing;
use eframe::egui;
use watch::Watch;

/// What keeps the user's work. In tests it may have no files: then it only asks before the window is closed.
#[derive(Default)]
pub(super) struct Guard {
    autosave: Option<Autosave>,
    watch: Option<Watch>,
    closing: Closing,
}

impl Guard {
    /// One that keeps the text beside its file, and watches the file. Calls `wake` when the file has changed.
    pub(super) fn of(wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            autosave: Some(Autosave::default()),
            watch: Some(Watch::new(wake)),
            closing: Closing::default(),
        }
    }

    /// Asks at the top of the window what has to be asked.
    pub(super) fn bars(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        if let Some(autosave) = &mut self.autosave {
            autosave.ask(editor, ui);
        }
        if let Some(watch) = &mut self.watch {
            watch.ask(editor, ui);
        }
    }

    /// Looks after the work, when everything else of a picture is done.
    pub(super) fn stand(&mut self, editor: &mut Editor, context: &egui::Context) {
        if let Some(watch) = &mut self.watch {
            watch.look(editor, context);
        }
        if !self.closing.is_answered()
            && let Some(autosave) = &mut self.autosave
        {
            autosave.keep(editor);
        }
        let is_done = self.closing.ask(editor, context);
        if is_done && let Some(autosave) = &mut self.autosave {
            autosave.forget(editor);
        }
    }
}

impl Editor {
    /// Takes over a text from a file, as one step.
    fn take_over(&mut self, title: &str, text: &str) {
        self.session.workspace.push(title, text);
        self.let_go();
        self.read();
        self.tell(title);
    }
}
