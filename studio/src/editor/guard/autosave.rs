//! The text, kept beside its file while it is not saved.
//!
//! It is written whole after each step, so that a crash loses nothing that was accepted. A window writes only under a name that it has
//! taken itself: what an earlier one has left waits for an answer.

use super::bar;
use super::left::{Left, claim, left_at, place_of};
use crate::edit::Workspace;
use crate::editor::Editor;
use crate::editor::talk::Talk;
use crate::failure::Failure;
use crate::output::{keep, remove};
use eframe::egui;
use std::fs;
use std::path::PathBuf;

#[derive(Default)]
pub(super) struct Autosave {
    /// The folder in which texts without a file are kept.
    unnamed: PathBuf,
    /// The file beside which it is kept.
    place: PathBuf,
    /// Where it is kept, and how it reads there.
    kept: Option<Left>,
    /// The texts that were left by windows that were never closed.
    left: Vec<Left>,
    /// Whether it was told that nothing can be kept.
    has_failed: bool,
}

impl Autosave {
    /// Keeps texts without a file in this folder.
    pub(super) fn new(unnamed: PathBuf) -> Self {
        Self { unnamed, ..Self::default() }
    }

    /// Keeps the text, if it has changed and is not saved.
    pub(super) fn keep(&mut self, workspace: &Workspace, talk: &mut Talk) {
        let place = place_of(workspace, &self.unnamed);
        if place != self.place {
            let moved = self.move_to(place, workspace);
            talk.refuse_failed(moved);
        }
        if !workspace.has_work() {
            self.forget(talk);
            return;
        }
        let text = workspace.text();
        if self.kept.as_ref().is_some_and(|kept| kept.text == text) {
            return;
        }
        match self.write(text) {
            Ok(()) => self.has_failed = false,
            // Told once, not after each step.
            Err(_) if self.has_failed => {}
            Err(failure) => {
                self.has_failed = true;
                talk.refuse(format!("a crash would lose what is not saved: {failure}"));
            }
        }
    }

    /// Goes on beside another file, and looks for what was left there.
    fn move_to(&mut self, place: PathBuf, workspace: &Workspace) -> Result<(), Failure> {
        self.place = place;
        self.left.clear();
        let removed = self.remove_kept();
        let (left, read) = left_at(&self.place, workspace.text());
        self.left = left;
        removed.and(read)
    }

    fn write(&mut self, text: &str) -> Result<(), Failure> {
        let path = match &mut self.kept {
            Some(kept) => {
                kept.unlock();
                kept.path.clone()
            }
            None => self.claim()?,
        };
        let written = keep(&path, text.as_bytes(), &self.place);
        match written {
            Ok(()) => {
                self.kept = Some(Left::at(path, text.to_owned()));
                Ok(())
            }
            Err(failure) => {
                let removed = match &mut self.kept {
                    Some(kept) => {
                        kept.lock_again();
                        Ok(())
                    }
                    None => remove(&path),
                };
                removed.and(Err(failure))
            }
        }
    }

    fn claim(&self) -> Result<PathBuf, Failure> {
        if let Some(folder) = self.place.parent()
            && !folder.as_os_str().is_empty()
        {
            // If it cannot be made, the next step tells why.
            let _ = fs::create_dir_all(folder);
        }
        claim(&self.place)
    }

    /// Removes what is kept of the present text.
    pub(super) fn forget(&mut self, talk: &mut Talk) {
        let removed = self.remove_kept();
        talk.refuse_failed(removed);
    }

    fn remove_kept(&mut self) -> Result<(), Failure> {
        self.kept.take().map_or(Ok(()), |kept| remove(&kept.path))
    }

    /// Asks what becomes of a text that was left.
    pub(super) fn ask(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let Some(first) = self.left.first() else {
            return;
        };
        let name = editor.workspace().path().file_name().unwrap_or_default();
        let question = format!(
            "{} was not saved when the studio ended. What was not saved is kept.",
            name.display()
        );
        match bar("left", &question, ["Restore", "Discard"], ui) {
            Some(0) if editor.is_at_rest() => {
                let text = first.text.clone();
                editor.session.workspace.push("restored", text);
                editor.take_over("restored");
                if let Err(failure) = self.adopt() {
                    editor.talk.refuse(failure);
                }
            }
            Some(1) => {
                let removed = remove(&first.path);
                self.left.remove(0);
                editor.talk.refuse_failed(removed);
            }
            _ => {}
        }
    }

    /// Goes on under the name of the text that was restored, so that it is kept all the time.
    fn adopt(&mut self) -> Result<(), Failure> {
        let restored = self.left.remove(0);
        let before = self.kept.replace(restored);
        before.map_or(Ok(()), |before| remove(&before.path))
    }
}
