//! Questions in a window of their own.

use crate::edit::Workspace;
use crate::editor::Editor;
use crate::editor::order::{Export, Order};
use crate::editor::question::{Destination, Dialog, FileUse};
use crate::editor::worker::Task;
use crate::text::masked;
use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::{self, Key};
use std::path::Path;

pub(in crate::editor) fn dialogs(editor: &mut Editor, context: &egui::Context) {
    match editor.talk.dialog.take() {
        None => {}
        Some(Dialog::File(purpose, path)) => ask_for_file(editor, purpose, path, context),
        Some(Dialog::Leave(to)) => match ask_to_save(editor.workspace(), context) {
            None => editor.talk.dialog = Some(Dialog::Leave(to)),
            Some(Answer::Cancel) => {}
            Some(Answer::Discard) => editor.arrive(to),
            Some(Answer::Save) if !editor.is_at_rest() => {
                let why = "a gesture is still being tried; save in a moment";
                editor.talk.refuse(why);
                editor.talk.dialog = Some(Dialog::Leave(to));
            }
            Some(Answer::Save) if editor.workspace().is_named() => {
                save(editor, None, false, Some(to));
            }
            Some(Answer::Save) => ask_for(editor, FileUse::Save(Some(to))),
        },
    }
}

/// The user's answer on changes that are not saved.
#[derive(Clone, Copy)]
enum Answer {
    Save,
    Discard,
    Cancel,
}

/// Asks what becomes of the changes, until that is answered.
fn ask_to_save(workspace: &Workspace, context: &egui::Context) -> Option<Answer> {
    let mut given = None;
    egui::Modal::new(egui::Id::unique("unsaved")).show(context, |ui| {
        ui.heading("Save the changes?");
        let name = workspace.path().file_name().unwrap_or_default();
        let question = format!("{} has changes that are not saved.", name.display());
        ui.label(masked(&question));
        ui.horizontal(|ui| {
            let answers =
                [("Save", Answer::Save), ("Discard", Answer::Discard), ("Cancel", Answer::Cancel)];
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

fn ask_for_file(editor: &mut Editor, purpose: FileUse, mut path: String, context: &egui::Context) {
    let (title, verb) = purpose.words();
    #[cfg(not(target_arch = "wasm32"))]
    let beside = editor.workspace().path().parent().map(Path::to_owned);
    let [mut is_done, mut is_given_up, mut is_there] = [false; 3];
    egui::Modal::new(egui::Id::unique("dialog")).show(context, |ui| {
        ui.heading(title);
        let label = ui.label("File");
        let edit =
            egui::TextEdit::singleline(&mut path).hint_text(purpose.hint()).desired_width(320.0);
        let response = ui.add(edit).labelled_by(label.id);
        if !response.lost_focus() && !is_focus_in(ui) {
            response.request_focus();
        }
        if response.gained_focus() {
            select_all(response.id, &path, ui.ctx());
        }
        // Only a click on the button that says so replaces an existing file.
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
        use_file(editor, purpose, path.trim(), is_there);
    } else if !is_given_up {
        editor.talk.dialog = Some(Dialog::File(purpose, path));
    }
}

/// Lets what is typed take the place of a name that is proposed.
fn select_all(field: egui::Id, text: &str, context: &egui::Context) {
    let mut state = egui::TextEdit::load_state(context, field).unwrap_or_default();
    let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(context, field);
}

/// Whether a field or a button of this window has the focus of keys.
fn is_focus_in(ui: &egui::Ui) -> bool {
    let focused = ui.memory(egui::Memory::focused);
    let focused = focused.and_then(|focused| ui.ctx().read_response(focused));
    focused.is_some_and(|focused| focused.layer_id == ui.layer_id())
}

/// The question which file something is done with. Where the text is saved, the name that it has is proposed.
fn file_dialog(purpose: FileUse, text: &Path) -> Dialog {
    let path = match purpose {
        FileUse::Save(_) => text.display().to_string(),
        FileUse::Export(kind) => kind.path(text),
        FileUse::Open | FileUse::Picture => String::new(),
    };
    Dialog::File(purpose, path)
}

/// Lets the user say which file something is done with. A page reads what its browser gives it.
pub(super) fn ask_for(editor: &mut Editor, purpose: FileUse) {
    #[cfg(target_arch = "wasm32")]
    if !purpose.writes() {
        editor.talk.refuse_failed(crate::browser::ask_for_file());
        return;
    }
    editor.talk.dialog = Some(file_dialog(purpose, editor.workspace().path()));
}

/// Writes the text: to its own file, or to another, which is written over if the user has said so. Afterwards another text may be edited.
pub(super) fn save(
    editor: &mut Editor,
    path: Option<&Path>,
    is_there: bool,
    to: Option<Destination>,
) {
    match editor.session.workspace.save(path, is_there) {
        Ok(path) => {
            editor.talk.tell(format!("saved `{}`", path.display()));
            if let Some(to) = to {
                editor.arrive(to);
            }
        }
        Err(failure) => editor.talk.refuse(failure),
    }
}

fn use_file(editor: &mut Editor, purpose: FileUse, path: &str, is_there: bool) {
    match purpose {
        FileUse::Open => editor.leave_for(Destination::File(path.to_owned())),
        FileUse::Picture => {
            let shown = editor.desk.show_file(Path::new(path), &editor.sight.camera);
            editor.talk.tell_done(shown);
        }
        FileUse::Export(kind) => export(editor, kind, path),
        FileUse::Save(to) => save(editor, Some(Path::new(path)), is_there, to),
    }
}

/// Writes a file of a kind, beside the window.
fn export(editor: &mut Editor, kind: Export, path: &str) {
    let playing = &editor.sight.playing;
    let measure = editor.plotted.measure(playing, &editor.analysis.snapshot);
    let job = kind.job(&playing.seen_at().unwrap_or_default(), &measure);
    let traced = editor.desk.backdrop.as_ref();
    let traced = traced.map(|backdrop| &*backdrop.path);
    match Order::new(kind, path, editor.workspace(), job, traced) {
        Ok(order) => {
            editor.talk.tell(format!("writing `{}`", order.path));
            editor.give(Task::Export(Box::new(order)));
        }
        Err(why) => editor.talk.refuse(why),
    }
}
