//! The guard of the user's work: against a crash, against other programs, and against a window that is closed too early.

mod autosave;
mod left;
mod watch;

use super::Editor;
use crate::editor::question::{Destination, Ending};
use crate::text::masked;
use autosave::Autosave;
use eframe::egui::{self, ViewportCommand};
use std::path::PathBuf;
use watch::Watch;

/// The guard of the user's work. In tests it may have no files: then it only asks before the window is closed.
#[derive(Default)]
pub(super) struct Guard {
    autosave: Option<Autosave>,
    watch: Option<Watch>,
    is_closing: bool,
}

impl Guard {
    /// One that keeps the text beside its file, or in a folder if it has none, and watches the file. Calls `wake` when the file has changed.
    pub(super) fn of(unnamed: PathBuf, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            autosave: Some(Autosave::new(unnamed)),
            watch: Some(Watch::new(wake)),
            is_closing: false,
        }
    }

    /// Asks what has to be asked: at the top of the window, or before it is closed.
    pub(super) fn ask(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let wants_to_close = ui.input(|input| input.viewport().close_requested());
        if wants_to_close && editor.has_work() && editor.talk.ending != Ending::Granted {
            ui.ctx().send_viewport_cmd(ViewportCommand::CancelClose);
            editor.leave_for(Destination::Away);
        }
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
        // A text that is given up is not kept again before the window is gone.
        if editor.talk.ending != Ending::Granted {
            if let Some(autosave) = &mut self.autosave {
                autosave.keep(&editor.session.workspace, &mut editor.talk);
            }
        } else if !std::mem::replace(&mut self.is_closing, true) {
            if let Some(autosave) = &mut self.autosave {
                autosave.forget(&mut editor.talk);
            }
            context.send_viewport_cmd(ViewportCommand::Close);
        }
    }
}

/// Shows a question with its answers, and gives the number of the one that is clicked.
fn bar(name: &str, question: &str, answers: [&str; 2], ui: &mut egui::Ui) -> Option<usize> {
    let mut given = None;
    egui::Panel::top(name.to_owned()).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.strong(masked(question));
            for (number, answer) in answers.into_iter().enumerate() {
                if ui.button(answer).clicked() {
                    given = Some(number);
                }
            }
        });
    });
    given
}
