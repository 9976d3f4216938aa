//! The question before a text with changes is left.

use crate::editor::Editor;
use eframe::egui;
use eframe::egui::Key;

/// What becomes of changes that are not saved.
#[derive(Clone, Copy)]
pub(super) enum Answer {
    /// They are saved.
    Save,
    /// They are lost.
    Discard,
    /// The text is not left.
    Cancel,
}

/// Asks what becomes of the changes, until that is answered.
pub(super) fn ask_to_save(editor: &Editor, context: &egui::Context) -> Option<Answer> {
    let mut given = None;
    egui::Modal::new(egui::Id::unique("unsaved")).show(context, |ui| {
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
