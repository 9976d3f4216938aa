//! Files to choose from: in a list, or in the system's own dialog.

use super::question::FileUse;
use crate::output::ends_in;
use crate::text::masked;
use eframe::egui;
use rfd::AsyncFileDialog;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::{fs, thread};

/// A name in a folder.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Entry {
    Folder(String),
    File(String),
}

/// Offers what is in the folder that a path names, and the system's own dialog. Returns whether a file was chosen.
pub(super) fn choose(
    purpose: &FileUse,
    path: &mut String,
    beside: &Path,
    ui: &mut egui::Ui,
) -> bool {
    let folder = folder_of(path, beside);
    let mut is_chosen = browse(purpose, path, &folder, ui);
    let entries = match entries(&folder, purpose.endings().1) {
        Ok(entries) => entries,
        Err(error) => {
            ui.weak(format!("cannot read the folder: {error}"));
            return is_chosen;
        }
    };
    egui::ScrollArea::vertical().max_height(240.0).auto_shrink([false, true]).show(ui, |ui| {
        if let Some(above) = above(&folder)
            && ui.button("..").on_hover_text("the folder above").clicked()
        {
            *path = format!("{}/", above.display());
        }
        for entry in entries {
            match entry {
                Entry::Folder(name) => {
                    if ui.button(masked(&format!("{name}/"))).clicked() {
                        *path = format!("{}/", folder.join(name).display());
                    }
                }
                Entry::File(name) => {
                    if ui.button(masked(&name)).clicked() {
                        *path = folder.join(name).display().to_string();
                        is_chosen = true;
                    }
                }
            }
        }
    });
    is_chosen
}

/// The folder that a path names, or that of the file it names.
fn folder_of(path: &str, beside: &Path) -> PathBuf {
    let named = Path::new(path);
    if path.is_empty() {
        beside.to_owned()
    } else if path.ends_with(std::path::is_separator) {
        named.to_owned()
    } else {
        named.parent().unwrap_or(named).to_owned()
    }
}

fn above(folder: &Path) -> Option<PathBuf> {
    let folder = std::path::absolute(present(folder)).ok()?;
    folder.parent().map(Path::to_owned)
}

/// The folder itself, where a path without a folder means the present one.
fn present(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() { Path::new(".") } else { folder }
}

/// The folders in a folder, and then the files whose names end so. What is hidden is left out.
fn entries(folder: &Path, endings: &[&str]) -> std::io::Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for entry in fs::read_dir(present(folder))? {
        let entry = entry?;
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        let path = entry.path();
        let is_hidden = name.starts_with('.');
        if path.is_dir() && !is_hidden {
            entries.push(Entry::Folder(name));
        } else if ends_in(&path, endings) && !is_hidden {
            entries.push(Entry::File(name));
        }
    }
    entries.sort();
    Ok(entries)
}

/// The answer of the system's own dialog, until it is read.
type Answer = Arc<Mutex<Option<PathBuf>>>;

/// Opens the system's own dialog if that is wanted. Returns whether it has answered.
fn browse(purpose: &FileUse, path: &mut String, folder: &Path, ui: &mut egui::Ui) -> bool {
    let answer: Answer = ui.data_mut(|data| {
        let answer = data.get_temp_mut_or_default::<Answer>(
            egui::Id::unique("browse").with(purpose.endings().0),
        );
        answer.clone()
    });
    if ui.button("Browse").on_hover_text("opens the system's own dialog").clicked() {
        ask_system(purpose, folder, answer.clone(), ui.ctx().clone());
    }
    let chosen = answer.lock().unwrap_or_else(PoisonError::into_inner).take();
    if let Some(chosen) = &chosen {
        *path = chosen.display().to_string();
    }
    chosen.is_some()
}

/// Lets the system ask, and waits for its answer beside the window.
fn ask_system(purpose: &FileUse, folder: &Path, answer: Answer, window: egui::Context) {
    let (kind, endings) = purpose.endings();
    let mut dialog = AsyncFileDialog::new().add_filter(kind, endings);
    if let Ok(folder) = std::path::absolute(present(folder)) {
        dialog = dialog.set_directory(folder);
    }
    let wait = move |chosen: Option<rfd::FileHandle>| {
        let chosen = chosen.map(|file| file.path().to_owned());
        *answer.lock().unwrap_or_else(PoisonError::into_inner) = chosen;
        window.request_repaint();
    };
    // It has to be opened here, and may be waited for elsewhere.
    if purpose.writes() {
        let asked = dialog.save_file();
        thread::spawn(move || wait(pollster::block_on(asked)));
    } else {
        let asked = dialog.pick_file();
        thread::spawn(move || wait(pollster::block_on(asked)));
    }
}
