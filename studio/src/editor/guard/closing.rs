//! The question before a window with unsaved changes is closed.

use super::super::Editor;
use super::super::action::Dialog;
use eframe::egui;
use eframe::egui::{Key, ViewportCommand};

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
        let is_changed = editor.workspace().is_changed();
        let wants_to_close = context.input(|input| input.viewport().close_requested());
        if wants_to_close && is_changed && !matches!(self, Self::May) {
            context.send_viewport_cmd(ViewportCommand::CancelClose);
            editor.settings.dialog = None;
            *self = Self::Asks;
        }
        match self {
            Self::Asks => self.answer(editor, context),
            Self::Saves if editor.settings.dialog.is_none() => self.close_if_saved(editor, context),
            Self::Not | Self::Saves | Self::May => false,
        }
    }

    fn answer(&mut self, editor: &mut Editor, context: &egui::Context) -> bool {
        match answer(editor, context) {
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
                editor.settings.dialog = Some(Dialog::Save(String::new()));
                *self = Self::Saves;
                false
            }
        }
    }

    fn close_if_saved(&mut self, editor: &Editor, context: &egui::Context) -> bool {
        let is_saved = !editor.workspace().is_changed();
        *self = if is_saved { Self::May } else { Self::Not };
        if is_saved {
            context.send_viewport_cmd(ViewportCommand::Close);
        }
        is_saved
    }
}

/// What the user says.
#[derive(Clone, Copy)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

fn answer(editor: &Editor, context: &egui::Context) -> Option<Answer> {
    let mut given = None;
    egui::Modal::new(egui::Id::unique("closing")).show(context, |ui| {
        ui.heading("Save the changes?");
        let name = editor.workspace().path().file_name().unwrap_or_default();
        ui.label(format!(
            "{} has changes that are not saved.",
            name.display()
        ));
        ui.horizontal(|ui| {
            let answers = [
                ("Save", Answer::Save),
                ("Discard", Answer::Discard),
                ("Cancel", Answer::Cancel),
            ];
            for (word, answer) in answers {
                if ui.button(word).clicked() {
                    given = Some(answer);
                }
            }
        });
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            given = Some(Answer::Cancel);
        }
    });
    given
}
