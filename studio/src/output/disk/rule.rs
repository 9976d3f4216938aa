//! The rule of what may take the place of what.

use super::place::{is_same, is_stream};
use crate::failure::Failure;
use crate::output::kind::{Output, OutputKind, Over};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Judges whether an output may be written to a file.
pub(super) fn judge(output: &Output, over: &Over, target: &Path) -> Result<(), Failure> {
    let path = output.path.display();
    if let Over::Text(text) = over {
        return still_has(text, &output.path);
    }
    if output.inputs.iter().any(|input| is_same(input, target)) {
        return Err(Failure::file(format!(
            "`{path}` is the file that is read: it is not written over; choose another name"
        )));
    }
    // A stream takes whatever comes. A folder is refused when it is opened.
    if !target.exists() || is_stream(&output.path, target) {
        return Ok(());
    }
    match over {
        Over::Any | Over::Text(_) => Ok(()),
        Over::Nothing(instead) => Err(Failure::file(format!(
            "`{path}` is there already; {instead}"
        ))),
        Over::OfKind(instead) => {
            let kind = output.kind;
            let first = beginning(target, OutputKind::FIRST).map_err(|error| {
                Failure::file(format!(
                    "`{path}` is there already and cannot be read: {error}"
                ))
            })?;
            if first.is_empty() || kind.has_ending(target) && kind.begins(&first) {
                return Ok(());
            }
            let name = kind.name();
            Err(Failure::file(format!(
                "`{path}` is there already, and is not {name}; {instead}"
            )))
        }
    }
}

/// Judges whether a file still has the text that was read from it.
fn still_has(text: &str, path: &Path) -> Result<(), Failure> {
    let most = text.len() as u64 + 1;
    let found = beginning(path, most)
        .map_err(|error| Failure::file(format!("cannot read `{}`: {error}", path.display())))?;
    if found == text.as_bytes() {
        return Ok(());
    }
    let path = path.display();
    Err(Failure::file(format!(
        "`{path}` was changed by another program after it was read; nothing is written"
    )))
}

/// The first bytes of a file.
fn beginning(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}
