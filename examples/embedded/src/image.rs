//! What an image takes.

use crate::error::Error;
use object::{Object, ObjectSection, SectionKind};
use std::fs;
use std::path::Path;

/// The flash that an image takes: code, constants and what variables begin with, in bytes.
pub(crate) fn flash(path: &Path) -> Result<u64, Error> {
    let data = fs::read(path).map_err(|source| Error::File {
        path: path.to_owned(),
        source,
    })?;
    let file = object::File::parse(&*data).map_err(|source| Error::Image {
        path: path.to_owned(),
        source,
    })?;
    let kept = file.sections().filter(|section| {
        use SectionKind::{Data, ReadOnlyData, ReadOnlyString, Text};
        matches!(section.kind(), Text | ReadOnlyData | ReadOnlyString | Data)
    });
    Ok(kept.map(|section| section.size()).sum())
}
