//! What is kept of a desk beside the file of its text, from one time to the next.

use super::backdrop::{Backdrop, PicturePlace};
use super::{Desk, Item};
use crate::failure::Failure;
use crate::output;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// What is kept of a desk: `.NAME.desk` beside the file, in JSON.
#[derive(Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Record {
    picture: Option<(PathBuf, PicturePlace)>,
    locked: BTreeSet<Item>,
    groups: Vec<BTreeSet<Item>>,
}

/// What is known of the file in which a desk is kept.
#[derive(Default)]
pub(super) struct Kept {
    /// The file of the text.
    path: PathBuf,
    /// What it says.
    record: Record,
    /// The picture that it names and that is not there.
    missing: Option<(PathBuf, PicturePlace)>,
    /// Whether it cannot be read. Then it is left as it is.
    is_broken: bool,
}

/// The file in which the desk of a text is kept.
fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".desk");
    path.with_file_name(name)
}

impl Desk {
    /// Keeps it beside the file of its text, if it has changed. An empty one needs no file.
    ///
    /// # Errors
    /// If the file cannot be written, or not be removed. That is told once.
    pub(in crate::editor) fn keep(&mut self, path: &Path) -> Result<(), Failure> {
        let record = self.record();
        // Under another name, nothing is known of what is there.
        let is_new = self.kept.path != path;
        if !is_new && (self.kept.is_broken || record == self.kept.record) {
            return Ok(());
        }
        path.clone_into(&mut self.kept.path);
        self.kept.is_broken = false;
        self.kept.record = record.clone();
        let file = beside(path);
        if record != Record::default() {
            let text = serde_json::to_string_pretty(&record);
            let text = text.map_err(|error| Failure::internal(error.to_string()))?;
            return output::replace(&file, format!("{text}\n").as_bytes());
        }
        match fs::remove_file(&file) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(failed(&file, &error)),
            _ => Ok(()),
        }
    }

    fn record(&self) -> Record {
        let backdrop = self.backdrop.as_ref();
        let shown = backdrop.map(|backdrop| (backdrop.path.clone(), backdrop.place));
        Record {
            picture: shown.or_else(|| self.kept.missing.clone()),
            locked: self.locked.clone(),
            groups: self.groups.clone(),
        }
    }

    /// What was kept beside a file, and what of it cannot be read.
    pub(in crate::editor) fn of(path: &Path) -> (Self, Result<(), Failure>) {
        let mut desk = Self::default();
        path.clone_into(&mut desk.kept.path);
        let record = match read(&beside(path)) {
            Ok(record) => record,
            Err(failure) => {
                desk.kept.is_broken = true;
                return (desk, Err(failure));
            }
        };
        desk.kept.record = record.clone();
        (desk.locked, desk.groups) = (record.locked, record.groups);
        let done = record.picture.map_or(Ok(()), |(picture, place)| {
            match picture_at(&picture, path) {
                Ok(mut backdrop) => {
                    backdrop.place = place;
                    desk.backdrop = Some(backdrop);
                    Ok(())
                }
                Err(failure) => {
                    desk.kept.missing = Some((picture, place));
                    Err(failure)
                }
            }
        });
        (desk, done)
    }
}

/// The picture in a file, or in one of this name beside the text, if the folder was moved.
fn picture_at(picture: &Path, text: &Path) -> Result<Backdrop, Failure> {
    let moved = text.with_file_name(picture.file_name().unwrap_or_default());
    let path = if picture.is_file() { picture } else { &moved };
    let bytes = fs::read(path).map_err(|error| failed(picture, &error))?;
    Backdrop::read(path, &bytes)
}

fn read(file: &Path) -> Result<Record, Failure> {
    match fs::read(file) {
        Ok(bytes) => {
            let read = serde_json::from_slice::<Record>(&bytes);
            let record = read.map_err(|error| failed(file, &error))?;
            match &record.picture {
                Some((_, place)) if !place.is_sound() => {
                    Err(failed(file, &"a picture cannot be there"))
                }
                _ => Ok(record),
            }
        }
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Record::default()),
        Err(error) => Err(failed(file, &error)),
    }
}

fn failed(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::file(format!("`{}`: {error}", path.display()))
}
