//! The editor in a window of egui.

use super::canvas::Canvas;
#[cfg(not(target_arch = "wasm32"))]
use super::guard::Guard;
#[cfg(not(target_arch = "wasm32"))]
use super::opening::longest;
use super::question::Ending;
use super::{Editor, action, panel};
use crate::edit::Workspace;
use crate::text::masked;
use eframe::egui::{self, DroppedFileHandle};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// The editor in a window of egui.
pub struct Studio {
    editor: Editor,
    canvas: Canvas,
    line: panel::Line,
    panels: panel::Panels,
    busy: panel::Busy,
    title: String,
    dropped: Dropped,
    #[cfg(not(target_arch = "wasm32"))]
    guard: Guard,
}

/// Below this width the window is that of a telephone: tools stand above the drawing, panels below it.
const NARROW: f32 = 720.0;

impl Studio {
    /// Shows an editor.
    #[must_use]
    pub fn new(editor: Editor) -> Self {
        Self {
            editor,
            canvas: Canvas::default(),
            line: panel::Line::default(),
            panels: panel::Panels::default(),
            busy: panel::Busy::default(),
            title: String::new(),
            dropped: Dropped::default(),
            #[cfg(not(target_arch = "wasm32"))]
            guard: Guard::default(),
        }
    }

    /// Shows an editor, keeps its text beside its file, or in the folder `unnamed` if it has none, and watches the file. Calls `wake` when the
    /// file has changed.
    #[cfg(not(target_arch = "wasm32"))]
    #[must_use]
    pub fn guarded(
        editor: Editor,
        unnamed: PathBuf,
        wake: impl Fn() + Send + Sync + 'static,
    ) -> Self {
        Self { guard: Guard::of(unnamed, wake), ..Self::new(editor) }
    }

    /// The editor that is shown.
    #[must_use]
    pub const fn editor(&self) -> &Editor {
        &self.editor
    }

    /// The editor that is shown, to be told what to do.
    pub const fn editor_mut(&mut self) -> &mut Editor {
        &mut self.editor
    }

    /// Shows everything, and takes what the user does.
    pub fn show(&mut self, ui: &mut egui::Ui) {
        let editor = &mut self.editor;
        editor.look();
        let is_more = editor.analysis.worker.go_on();
        editor.look();
        if is_more {
            ui.ctx().request_repaint();
        }
        let theme = if editor.settings.is_dark { egui::Theme::Dark } else { egui::Theme::Light };
        ui.ctx().set_theme(theme);
        let context = ui.ctx().clone();
        let seconds = context.input(|input| input.stable_dt.min(0.1));
        editor.sight.advance(f64::from(seconds));
        if editor.player().is_some_and(crate::play::Player::plays) {
            context.request_repaint();
        }
        self.dropped.take(editor, &context);
        action::obey_keys(editor, self.canvas.is_focused, &context);
        let title = title(editor.workspace());
        if title != self.title {
            self.title.clone_from(&title);
            context.send_viewport_cmd(egui::ViewportCommand::Title(title));
        }
        let is_narrow = ui.available_width() < NARROW;
        if is_narrow {
            for_fingers(ui.spacing_mut());
        }
        let height = ui.available_height();
        egui::Panel::top("menu").show(ui, |ui| action::menu(editor, ui));
        #[cfg(not(target_arch = "wasm32"))]
        self.guard.ask(editor, ui);
        self.busy.show(editor, ui);
        egui::Panel::bottom("line").show(ui, |ui| self.line.show(editor, ui));
        egui::Panel::bottom("play").show(ui, |ui| {
            panel::play(&mut editor.sight, &editor.analysis.snapshot, ui);
        });
        if is_narrow {
            egui::Panel::top("tools").show(ui, |ui| panel::tools(editor, ui, true));
            egui::Panel::bottom("panel")
                .resizable(true)
                .default_size(0.3 * height)
                .max_size(0.4 * height)
                .show(ui, |ui| self.panels.show(editor, is_narrow, ui));
        } else {
            egui::Panel::left("tools")
                .resizable(false)
                .exact_size(92.0)
                .show(ui, |ui| panel::tools(editor, ui, false));
            egui::Panel::right("panel")
                .resizable(true)
                .default_size(380.0)
                .show(ui, |ui| self.panels.show(editor, is_narrow, ui));
        }
        editor.prepare_arrows();
        egui::CentralPanel::no_frame().show(ui, |ui| self.canvas.show(editor, ui));
        action::dialogs(editor, &context);
        if editor.talk.ending == Ending::Wanted {
            editor.talk.ending = Ending::Stays;
            context.send_viewport_cmd(egui::ViewportCommand::Close);
        }
        if let Some(text) = editor.clipboard.next.take() {
            context.copy_text(text);
        }
        #[cfg(not(target_arch = "wasm32"))]
        {
            self.guard.stand(editor, &context);
            // While the pointer is down, something may be moving; the desk is saved afterwards.
            let workspace = &editor.session.workspace;
            if !context.input(|input| input.pointer.any_down()) && workspace.saved().is_some() {
                let saved = editor.desk.save(workspace.path());
                editor.talk.refuse_failed(saved);
            }
        }
    }
}

/// The title of the window: the file, and whether it has changes that are not saved.
fn title(workspace: &Workspace) -> String {
    let name = workspace.path().file_name().unwrap_or_default();
    let changed = if workspace.has_work() { " (changed)" } else { "" };
    masked(&format!("{}{changed} - mech edit", name.display())).into_owned()
}

fn for_fingers(spacing: &mut egui::Spacing) {
    spacing.interact_size.y = 32.0;
    spacing.button_padding = egui::vec2(8.0, 7.0);
}

impl eframe::App for Studio {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.show(ui);
    }
}

/// A file with its bytes, or why they cannot be read.
type Read = (PathBuf, Result<Vec<u8>, String>);

/// Files that are dropped, from when they are dropped until they are read: a browser takes its time.
#[derive(Default)]
struct Dropped(Inbox);

/// Where a file is put when it is read.
type Inbox = Arc<Mutex<Vec<Read>>>;

impl Dropped {
    /// Takes the file that is dropped on the window.
    pub(super) fn take(&self, editor: &mut Editor, context: &egui::Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        match &dropped[..] {
            [] => {}
            _ if context.memory(|memory| memory.top_modal_layer().is_some()) => {
                let why = "answer the question first, and then drop the file";
                editor.talk.refuse(why);
            }
            [file] => read(file, &self.0, context),
            _ => editor.talk.refuse("drop one file at a time"),
        }
        let read = std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner));
        for (path, bytes) in read {
            match bytes {
                Ok(bytes) => editor.take_file(&path, bytes),
                Err(error) => {
                    let path = path.display();
                    editor.talk.refuse(format!("cannot read `{path}`: {error}"));
                }
            }
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn read(file: &DroppedFileHandle, to: &Inbox, context: &egui::Context) {
    let path = file.path().to_owned();
    let bytes = crate::input::read(&path, longest(&path));
    let read = (path, bytes.map_err(|error| error.to_string()));
    to.lock().unwrap_or_else(PoisonError::into_inner).push(read);
    context.request_repaint();
}

#[cfg(target_arch = "wasm32")]
fn read(file: &DroppedFileHandle, to: &Inbox, context: &egui::Context) {
    let (file, to, context) = (file.clone(), to.clone(), context.clone());
    wasm_bindgen_futures::spawn_local(async move {
        let read = (file.path().to_owned(), file.bytes_async().await);
        to.lock().unwrap_or_else(PoisonError::into_inner).push(read);
        context.request_repaint();
    });
}
