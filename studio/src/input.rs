//! The reading of files, up to a limit: what is sent by a stranger may have no end.

use std::fs::{self, File};
use std::io::{self, BufRead, Read};
use std::path::Path;

/// Reads a plain file, or one that a link leads to, if it has at most so many bytes.
///
/// # Errors
/// If it is longer, cannot be read, or is a pipe or a device: who opens one may wait for ever.
pub(crate) fn read(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    is_plain(&fs::metadata(path)?)?;
    let file = File::open(path)?;
    is_plain(&file.metadata()?)?;
    read_from(file, most)
}

/// Reads a file of ours: as others, but no link.
///
/// # Errors
/// As of others, or if it is a link.
#[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
pub(crate) fn read_own(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    is_plain(&fs::symlink_metadata(path)?)?;
    read(path, most)
}

/// Reads what has no name, if it has at most so many bytes.
///
/// # Errors
/// If it is longer, or cannot be read.
pub(crate) fn read_from(input: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(too_long(most));
    }
    Ok(bytes)
}

/// Reads the next line, without its end; none after the last.
///
/// # Errors
/// If it has more bytes, cannot be read, or is not UTF-8.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn read_line(input: impl BufRead, most: u64) -> io::Result<Option<String>> {
    let mut line = String::new();
    // The end of a line may have two bytes.
    if input.take(most + 2).read_line(&mut line)? == 0 {
        return Ok(None);
    }
    if line.ends_with('\n') {
        line.pop();
        if line.ends_with('\r') {
            line.pop();
        }
    }
    if line.len() as u64 > most {
        return Err(too_long(most));
    }
    Ok(Some(line))
}

fn is_plain(known: &fs::Metadata) -> io::Result<()> {
    if known.is_dir() {
        Err(io::Error::other("it is a folder"))
    } else if known.is_file() {
        Ok(())
    } else {
        Err(io::Error::other("it is no plain file"))
    }
}

fn too_long(most: u64) -> io::Error {
    io::Error::other(format!("it has more than {most} bytes, which is the limit"))
}
