//! What an image takes.

use crate::error::Error;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind};
use std::fs;
use std::path::Path;

/// The flash that an image takes: code, constants and what variables begin with, in bytes.
pub(crate) fn flash(path: &Path) -> Result<u64, Error> {
    read(path, |file| {
        let stored = file.sections().filter(|section| {
            use SectionKind::{Data, ReadOnlyData, ReadOnlyString, Text};
            matches!(section.kind(), Text | ReadOnlyData | ReadOnlyString | Data)
        });
        stored.map(|section| section.size()).sum()
    })
}

/// The functions in an image that compute in `f64` by software.
pub(crate) fn soft_doubles(path: &Path) -> Result<Vec<String>, Error> {
    read(path, |file| {
        let names = file.symbols().filter_map(|symbol| symbol.name().ok());
        let doubles = names.filter(|name| {
            let routine = name.strip_prefix("__aeabi_");
            routine.is_some_and(|name| name.starts_with('d') || name.ends_with("2d"))
        });
        doubles.map(str::to_owned).collect()
    })
}

fn read<T>(path: &Path, find: impl FnOnce(&object::File<'_>) -> T) -> Result<T, Error> {
    let data = fs::read(path).map_err(|source| Error::File { path: path.to_owned(), source })?;
    let file = object::File::parse(&*data)
        .map_err(|source| Error::Image { path: path.to_owned(), source })?;
    Ok(find(&file))
}
