//! A writer: for a person it writes each file at once, for a script all when it has ended well.

use super::draft::{Draft, put_all};
use super::fence::Fence;
use super::place::{is_same, is_stream, target, unwritten};
use crate::failure::Failure;
use crate::output::kind::{Output, OutputKind, Over};
use std::fs::{File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

/// The most bytes that wait until the end of a script.
const MOST: usize = 1 << 30;

/// A writer of files. The default is that of a person, who sees what is written where.
#[derive(Default)]
pub(crate) struct Writer {
    /// Where it may write; anywhere, without.
    fence: Option<Fence>,
    /// The files that it has made itself.
    made: Vec<PathBuf>,
    /// What is written at the end; none if each is written at once.
    planned: Option<Vec<Planned>>,
}

/// A file that is written at the end.
struct Planned {
    output: Output,
    /// Where its path leads.
    target: PathBuf,
    /// What it may take the place of; an output of the same file that came before has said that.
    over: Over,
}

impl Writer {
    /// For lines that nobody types: each file is written at once, within a fence.
    pub(crate) fn within(fence: Fence) -> Self {
        Self { fence: Some(fence), ..Self::default() }
    }

    /// For a script: all files are written at its end, within a fence.
    pub(crate) fn of_script(fence: Fence) -> Self {
        Self { planned: Some(Vec::new()), ..Self::within(fence) }
    }

    /// Whether files are written at the end.
    pub(crate) const fn is_deferred(&self) -> bool {
        self.planned.is_some()
    }

    /// Writes a file, now or at the end.
    ///
    /// # Errors
    /// If it may not be written, or cannot be. What is there stays as it is.
    pub(crate) fn write(&mut self, output: Output) -> Result<(), Failure> {
        let target = target(&output.path).map_err(|error| unwritten(&output.path, &error))?;
        let is_own = self.made.contains(&target);
        if let Some(fence) = &self.fence {
            fence.judge(&output, &target, is_own)?;
        }
        let planned = self.planned.as_mut();
        let earlier = planned.and_then(|all| all.iter_mut().find(|one| one.target == target));
        if let Some(earlier) = earlier {
            earlier.succeed(output)?;
            return Ok(());
        }
        judge(&output, &output.over, &target)?;
        self.has_room_for(&output)?;
        match &mut self.planned {
            None => write_all(&[(&output, &target)])?,
            Some(planned) => {
                planned.push(Planned { over: output.over.clone(), output, target: target.clone() });
            }
        }
        self.made.push(target);
        Ok(())
    }

    /// Judges whether a file can wait with the others until the end.
    fn has_room_for(&self, output: &Output) -> Result<(), Failure> {
        let planned = self.planned.iter().flatten();
        let waiting: usize = planned.map(|one| one.output.bytes.len()).sum();
        if self.planned.is_none() || waiting + output.bytes.len() <= MOST {
            return Ok(());
        }
        let (path, most) = (output.path.display(), MOST >> 20);
        Err(Failure::file(format!(
            "`{path}` is too much: the files of a script have {most} MiB together; write it by another script"
        )))
    }

    /// Writes what is to be written at the end, all or nothing. Gives the files, and their kinds.
    pub(crate) fn finish(self) -> Result<Vec<(OutputKind, PathBuf)>, Failure> {
        let planned = self.planned.unwrap_or_default();
        for Planned { output, target, over } in &planned {
            // Much may have happened since it was planned.
            judge(output, over, target)?;
        }
        let all: Vec<_> = planned.iter().map(|one| (&one.output, &*one.target)).collect();
        write_all(&all)?;
        let outputs = planned.into_iter().map(|one| one.output);
        Ok(outputs.map(|output| (output.kind, output.path)).collect())
    }
}

impl Planned {
    /// Lets another output take its place. A text has to be that of the file, which is not written yet.
    fn succeed(&mut self, output: Output) -> Result<(), Failure> {
        let path = output.path.display();
        match &output.over {
            Over::Text(text) if text.as_bytes() != self.output.bytes => {
                Err(Failure::file(format!(
                    "`{path}` was written by the script after it was read; `open` it in another script"
                )))
            }
            Over::Nothing(instead) => {
                Err(Failure::file(format!("the script writes `{path}` already; {instead}")))
            }
            _ => {
                self.output = output;
                Ok(())
            }
        }
    }
}

fn write_all(outputs: &[(&Output, &Path)]) -> Result<(), Failure> {
    let mut drafts = Vec::new();
    for (output, target) in outputs {
        let failed = |error: io::Error| unwritten(&output.path, &error);
        if is_stream(&output.path, target) {
            stream(target, &output.bytes).map_err(failed)?;
        } else {
            drafts.push(Draft::of(target, &output.bytes, None).map_err(failed)?);
        }
    }
    put_all(drafts).map_err(|(target, error)| {
        let mut all = outputs.iter();
        let output = all.find(|(_, path)| *path == target);
        unwritten(output.map_or(&*target, |(output, _)| &output.path), &error)
    })
}

/// Writes into what cannot be replaced.
fn stream(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().append(true).open(path)?;
    file.write_all(bytes)?;
    file.flush()
}

/// Judges whether an output may be written to a file.
fn judge(output: &Output, over: &Over, target: &Path) -> Result<(), Failure> {
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
        Over::Nothing(instead) => {
            Err(Failure::file(format!("`{path}` is there already; {instead}")))
        }
        Over::OfKind(instead) => {
            let kind = output.kind;
            let first = beginning(target, OutputKind::FIRST).map_err(|error| {
                Failure::file(format!("`{path}` is there already and cannot be read: {error}"))
            })?;
            if first.is_empty() || kind.has_ending(target) && kind.begins(&first) {
                return Ok(());
            }
            let name = kind.name();
            Err(Failure::file(format!("`{path}` is there already, and is not {name}; {instead}")))
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
