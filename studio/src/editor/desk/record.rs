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
#[derive(Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Record {
    picture: Option<(PathBuf, PicturePlace)>,
    locked: BTreeSet<Item>,
    groups: Vec<BTreeSet<Item>>,
}

/// The file in which the desk of a text is kept.
fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(".desk");
    path.with_file_name(name)
}

impl Desk {
    /// Keeps it beside the file of its text. An empty one needs no file.
    ///
    /// # Errors
    /// If the file cannot be written, or not be removed.
    pub(in crate::editor) fn keep(&self, path: &Path) -> Result<(), Failure> {
        let file = beside(path);
        let backdrop = self.backdrop.as_ref();
        let record = Record {
            picture: backdrop.map(|backdrop| (backdrop.path.clone(), backdrop.place)),
            locked: self.locked.clone(),
            groups: self.groups.clone(),
        };
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

    /// What was kept beside a file, and what of it cannot be read.
    pub(in crate::editor) fn of(path: &Path) -> (Self, Result<(), Failure>) {
        let record = match read(&beside(path)) {
            Ok(record) => record,
            Err(failure) => return (Self::default(), Err(failure)),
        };
        let mut desk = Self {
            backdrop: None,
            locked: record.locked,
            groups: record.groups,
        };
        let done = record.picture.map_or(Ok(()), |(path, place)| {
            let bytes = fs::read(&path).map_err(|error| failed(&path, &error))?;
            let mut backdrop = Backdrop::read(&path, &bytes)?;
            if place.width > 0.0 {
                backdrop.place = place;
            }
            desk.backdrop = Some(backdrop);
            Ok(())
        });
        (desk, done)
    }
}

fn read(file: &Path) -> Result<Record, Failure> {
    match fs::read(file) {
        Ok(bytes) => serde_json::from_slice(&bytes).map_err(|error| failed(file, &error)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Record::default()),
        Err(error) => Err(failed(file, &error)),
    }
}

fn failed(path: &Path, error: &dyn std::fmt::Display) -> Failure {
    Failure::file(format!("`{}`: {error}", path.display()))
}
