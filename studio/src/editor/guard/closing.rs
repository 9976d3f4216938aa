//! The question before a window with unsaved changes is closed.

use super::super::Editor;
use super::super::action::{Answer, FileUse, ask_to_save};
use eframe::egui;
use eframe::egui::ViewportCommand;

/// The question before a window with unsaved changes is closed.
#[derive(Default)]
pub(super) enum Closing {
    /// Nobody wants to close it.
    #[default]
    Not,
    /// The user is asked.
    Asks,
    /// The user says to which file the text is saved first.
    Saves,
    /// The user has answered: it may be closed.
    May,
}

impl Closing {
    /// Whether the user has answered: what is given up is not kept again before the window is gone.
    pub(super) const fn is_answered(&self) -> bool {
        matches!(self, Self::May)
    }

    /// Asks if there is something to lose. Returns whether nothing has to be kept any more.
    pub(super) fn ask(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        let is_changed = editor.has_work();
        let wants_to_close = context.input(|input| input.viewport().close_requested());
        if wants_to_close && is_changed && !matches!(self, Self::May) {
            context.send_viewport_cmd(ViewportCommand::CancelClose);
            editor.dialog = None;
            *self = Self::Asks;
        }
        match self {
            Self::Asks => self.answer(editor, context),
            Self::Saves if editor.dialog.is_none() => self.close_if_saved(editor, context),
            Self::Not | Self::Saves | Self::May => false,
        }
    }

    fn answer(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        match ask_to_save(editor, context) {
            None => false,
            Some(Answer::Cancel) => {
                *self = Self::Not;
                false
            }
            Some(Answer::Discard) => {
                *self = Self::May;
                context.send_viewport_cmd(ViewportCommand::Close);
                true
            }
            Some(Answer::Save) if editor.workspace().is_named() => {
                let saved = editor.save(None);
                editor.refuse_failed(saved);
                self.close_if_saved(editor, context)
            }
            Some(Answer::Save) => {
                editor.dialog = Some(editor.file_dialog(FileUse::Save(None)));
                *self = Self::Saves;
                false
            }
        }
    }

    fn close_if_saved(&mut self, editor: &Editor, context: &egui::Context) -> bool {
        let is_saved = !editor.has_work();
        *self = if is_saved { Self::May } else { Self::Not };
        if is_saved {
            context.send_viewport_cmd(ViewportCommand::Close);
        }
        is_saved
    }
}
