//! What is asked in a window of its own.

use crate::editor::Editor;
use crate::editor::export::Export;
use eframe::egui;
use eframe::egui::Key;
use std::path::Path;

/// Something that is asked in a window of its own.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Dialog {
    /// Which file is read.
    Open(String),
    /// Where the text is written.
    Save(String),
    /// Where something of this kind is written.
    Export(Export, String),
}

/// Asks what has to be asked.
pub(in crate::editor) fn dialogs(editor: &mut Editor, context: &egui::Context) {
    let Some(mut dialog) = editor.settings.dialog.take() else {
        return;
    };
    let (title, verb) = match dialog {
        Dialog::Open(_) => ("Open a file", "Open"),
        Dialog::Save(_) => ("Save to a file", "Save"),
        Dialog::Export(kind, _) => (kind.name(), "Write"),
    };
    #[cfg(not(target_arch = "wasm32"))]
    let beside = editor.workspace().path().parent().map(Path::to_owned);
    let (mut is_done, mut is_given_up) = (false, false);
    egui::Modal::new(egui::Id::unique("dialog")).show(context, |ui| {
        ui.heading(title);
        let label = ui.label("File");
        let (Dialog::Open(path) | Dialog::Save(path) | Dialog::Export(_, path)) = &mut dialog;
        let edit = egui::TextEdit::singleline(path)
            .hint_text("four_bar.mech")
            .desired_width(320.0);
        let response = ui.add(edit).labelled_by(label.id);
        if !response.lost_focus() && !is_focus_in(ui) {
            response.request_focus();
        }
        is_done = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        #[cfg(not(target_arch = "wasm32"))]
        {
            let is_saved = !matches!(dialog, Dialog::Open(_));
            let is_chosen =
                crate::editor::files::choose(&mut dialog, &beside.unwrap_or_default(), ui);
            // A file that is there is not written over by a slip.
            is_done |= is_chosen && !is_saved;
        }
        ui.horizontal(|ui| {
            is_done |= ui.button(verb).clicked();
            is_given_up =
                ui.button("Cancel").clicked() || ui.input(|input| input.key_pressed(Key::Escape));
        });
    });
    if is_done {
        editor.finish(&dialog);
    } else if !is_given_up {
        editor.settings.dialog = Some(dialog);
    }
}

/// Whether the keys go to something in this window of its own.
fn is_focus_in(ui: &egui::Ui) -> bool {
    let focused = ui.memory(egui::Memory::focused);
    let focused = focused.and_then(|focused| ui.ctx().read_response(focused));
    focused.is_some_and(|focused| focused.layer_id == ui.layer_id())
}

impl Editor {
    /// Does what was asked for.
    fn finish(&mut self, dialog: &Dialog) {
        match dialog {
            Dialog::Open(path) => self.open_named(path),
            Dialog::Export(kind, path) => self.export(*kind, path),
            Dialog::Save(path) => {
                let saved = self.save(Some(Path::new(path)));
                self.refuse_failed(saved);
            }
        }
    }
}
