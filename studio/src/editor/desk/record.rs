//! The file of a desk, beside the file of its text.

use super::backdrop::{Backdrop, PicturePlace, read_file};
use super::{Desk, Item};
use crate::failure::Failure;
use crate::input::read_own;
use crate::output::{self, hidden_beside};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

const ENDING: &str = ".desk";

/// The longest file that is read, in bytes. Thousands of locks and groups do not come near it.
const LONGEST: u64 = 1 << 20;

/// The content of the file `.NAME.desk`, in JSON.
#[derive(Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Record {
    picture: Option<(PathBuf, PicturePlace)>,
    locked: BTreeSet<Item>,
    groups: Vec<BTreeSet<Item>>,
}

/// The file of a desk, as far as it is known.
#[derive(Default)]
pub(super) struct DeskFile {
    /// The file of the text.
    path: PathBuf,
    record: Record,
    /// The picture that it names and that is not there.
    missing: Option<(PathBuf, PicturePlace)>,
    /// Whether it cannot be read. Then it is left as it is.
    is_broken: bool,
}

impl Desk {
    /// Writes it beside the file of its text, if it has changed. An empty one needs no file.
    ///
    /// # Errors
    /// If the file cannot be written, or not be removed. That is told once.
    pub(in crate::editor) fn save(&mut self, path: &Path) -> Result<(), Failure> {
        // Under another name, nothing is known of what is there.
        let is_new = self.file.path != path;
        if !is_new && (self.file.is_broken || self.says_the_same()) {
            return Ok(());
        }
        path.clone_into(&mut self.file.path);
        self.file.is_broken = false;
        self.file.record = self.record();
        let file = hidden_beside(path, ENDING);
        if self.file.record == Record::default() {
            return output::remove(&file);
        }
        let text = serde_json::to_string_pretty(&self.file.record);
        let text = text.map_err(|error| Failure::internal(error.to_string()))?;
        output::keep(&file, format!("{text}\n").as_bytes(), path)
    }

    /// Whether the file has the content of the desk. Each frame asks this, so nothing is copied for it.
    fn says_the_same(&self) -> bool {
        let Record { picture, locked, groups } = &self.file.record;
        let shown = self.backdrop.as_ref();
        let shown = shown.map(|backdrop| (&backdrop.path, &backdrop.place));
        let missing = || self.file.missing.as_ref().map(|(path, place)| (path, place));
        picture.as_ref().map(|(path, place)| (path, place)) == shown.or_else(missing)
            && *locked == self.locked
            && *groups == self.groups
    }

    fn record(&self) -> Record {
        let backdrop = self.backdrop.as_ref();
        let shown = backdrop.map(|backdrop| (backdrop.path.clone(), backdrop.place));
        Record {
            picture: shown.or_else(|| self.file.missing.clone()),
            locked: self.locked.clone(),
            groups: self.groups.clone(),
        }
    }

    /// Reads the desk of a file; an error says which part of it cannot be read.
    pub(in crate::editor) fn of(path: &Path) -> (Self, Result<(), Failure>) {
        let mut desk = Self::default();
        path.clone_into(&mut desk.file.path);
        let record = match read(&hidden_beside(path, ENDING)) {
            Ok(record) => record,
            Err(failure) => {
                desk.file.is_broken = true;
                return (desk, Err(failure));
            }
        };
        desk.file.record = record.clone();
        (desk.locked, desk.groups) = (record.locked, record.groups);
        let done =
            record.picture.map_or(Ok(()), |(picture, place)| match picture_at(&picture, path) {
                Ok(mut backdrop) => {
                    backdrop.place = place;
                    desk.backdrop = Some(backdrop);
                    Ok(())
                }
                Err(failure) => {
                    desk.file.missing = Some((picture, place));
                    Err(failure)
                }
            });
        (desk, done)
    }
}

/// The picture in a file, or in one of this name beside the text, if the folder was moved.
fn picture_at(picture: &Path, text: &Path) -> Result<Backdrop, Failure> {
    let moved = text.with_file_name(picture.file_name().unwrap_or_default());
    let path = if picture.is_file() { picture } else { &moved };
    let bytes = read_file(path).map_err(|error| failed(picture, &error))?;
    Backdrop::read(path, &bytes)
}

fn read(file: &Path) -> Result<Record, Failure> {
    match read_own(file, LONGEST) {
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
