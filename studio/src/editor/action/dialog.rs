//! What is asked in a window of its own.

use super::unsaved::{Answer, ask_to_save};
use crate::editor::Editor;
use crate::editor::question::{Destination, Dialog, FileUse};
use eframe::egui;
use eframe::egui::Key;
use eframe::egui::text::{CCursor, CCursorRange};
use std::path::Path;

/// Asks what has to be asked.
pub(in crate::editor) fn dialogs(editor: &mut Editor, context: &egui::Context) {
    match editor.dialog.take() {
        None => {}
        Some(Dialog::File(purpose, path)) => ask_for_file(editor, purpose, path, context),
        Some(Dialog::Leave(to)) => match ask_to_save(editor, context) {
            None => editor.dialog = Some(Dialog::Leave(to)),
            Some(Answer::Cancel) => {}
            Some(Answer::Discard) => editor.arrive(to),
            Some(Answer::Save) if !editor.is_at_rest() => {
                editor.refuse("a gesture is still being tried; save in a moment");
                editor.dialog = Some(Dialog::Leave(to));
            }
            Some(Answer::Save) if editor.workspace().is_named() => {
                let saved = editor.save(None);
                editor.arrive_if_done(saved, Some(to));
            }
            Some(Answer::Save) => {
                editor.dialog = Some(editor.file_dialog(FileUse::Save(Some(to))));
            }
        },
    }
}

/// Asks which file something is done with.
fn ask_for_file(editor: &mut Editor, purpose: FileUse, mut path: String, context: &egui::Context) {
    let (title, verb) = purpose.words();
    #[cfg(not(target_arch = "wasm32"))]
    let beside = editor.workspace().path().parent().map(Path::to_owned);
    let [mut is_done, mut is_given_up, mut is_there] = [false; 3];
    egui::Modal::new(egui::Id::unique("dialog")).show(context, |ui| {
        ui.heading(title);
        let label = ui.label("File");
        let edit = egui::TextEdit::singleline(&mut path)
            .hint_text(purpose.hint())
            .desired_width(320.0);
        let response = ui.add(edit).labelled_by(label.id);
        if !response.lost_focus() && !is_focus_in(ui) {
            response.request_focus();
        }
        if response.gained_focus() {
            select_all(response.id, &path, ui.ctx());
        }
        // What is there already is written over only by a click that says so.
        let is_own = matches!(purpose, FileUse::Save(_))
            && Path::new(path.trim()) == editor.workspace().path();
        is_there = purpose.writes() && !is_own && Path::new(path.trim()).is_file();
        let is_entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        is_done = is_entered && !is_there;
        #[cfg(not(target_arch = "wasm32"))]
        {
            let beside = beside.unwrap_or_default();
            let is_chosen = crate::editor::files::choose(&purpose, &mut path, &beside, ui);
            // A file that is there is not written over by a slip.
            is_done |= is_chosen && !purpose.writes();
        }
        ui.horizontal(|ui| {
            is_done |= ui.button(if is_there { "Replace" } else { verb }).clicked();
            is_given_up =
                ui.button("Cancel").clicked() || ui.input(|input| input.key_pressed(Key::Escape));
        });
    });
    if is_done {
        editor.use_file(purpose, path.trim(), is_there);
    } else if !is_given_up {
        editor.dialog = Some(Dialog::File(purpose, path));
    }
}

/// Lets what is typed take the place of a name that is proposed.
fn select_all(field: egui::Id, text: &str, context: &egui::Context) {
    let mut state = egui::TextEdit::load_state(context, field).unwrap_or_default();
    let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(context, field);
}

/// Whether the keys go to something in this window of its own.
fn is_focus_in(ui: &egui::Ui) -> bool {
    let focused = ui.memory(egui::Memory::focused);
    let focused = focused.and_then(|focused| ui.ctx().read_response(focused));
    focused.is_some_and(|focused| focused.layer_id == ui.layer_id())
}

impl Editor {
    /// Lets the user say which file something is done with.
    #[cfg(not(target_arch = "wasm32"))]
    pub(in crate::editor) fn ask_for_file(&mut self, purpose: FileUse) {
        self.dialog = Some(self.file_dialog(purpose));
    }

    /// The question which file something is done with. Where the text is saved, the name that it has is proposed.
    pub(in crate::editor) fn file_dialog(&self, purpose: FileUse) -> Dialog {
        let path = match purpose {
            FileUse::Save(_) => self.workspace().path().display().to_string(),
            FileUse::Export(kind) => self.export_path(kind),
            FileUse::Open | FileUse::Picture => String::new(),
        };
        Dialog::File(purpose, path)
    }

    /// Lets the user say which file something is done with. A page reads what its browser gives it.
    #[cfg(target_arch = "wasm32")]
    pub(in crate::editor) fn ask_for_file(&mut self, purpose: FileUse) {
        if purpose.writes() {
            self.dialog = Some(self.file_dialog(purpose));
        } else {
            let asked = crate::browser::ask_for_file();
            self.refuse_failed(asked);
        }
    }

    /// Does something with a file. One that is there is written over if the user has said so.
    fn use_file(&mut self, purpose: FileUse, path: &str, is_there: bool) {
        match purpose {
            FileUse::Open => self.leave_for(Destination::File(path.to_owned())),
            FileUse::Picture => self.show_picture(Path::new(path)),
            FileUse::Export(kind) => self.export(kind, path),
            FileUse::Save(to) => {
                let path = Path::new(path);
                let saved = if is_there {
                    self.save_over(path)
                } else {
                    self.save(Some(path))
                };
                self.arrive_if_done(saved, to);
            }
        }
    }
}
