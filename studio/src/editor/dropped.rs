//! Files that are dropped on the window, or that the page was given by its browser.

use super::Editor;
#[cfg(not(target_arch = "wasm32"))]
use super::opening::longest;
use eframe::egui::{self, DroppedFileHandle};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

/// A file with its bytes, or why they cannot be read.
type Read = (PathBuf, Result<Vec<u8>, String>);

/// Files that are dropped, from when they are dropped until they are read: a browser takes its time.
#[derive(Default)]
pub(super) struct Dropped(Inbox);

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
