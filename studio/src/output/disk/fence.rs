//! The fence of a script: where it may write.
//!
//! A script may come from a stranger. It writes in its folder and below, only what has the ending of its kind, and nothing hidden. It
//! replaces nothing but what it has opened or made itself. More, the user allows by `--allow-write`.

use super::place::{folder_of, is_same, target};
use crate::failure::Failure;
use crate::output::kind::{Output, Over, ends_in};
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};
use std::{fs, io};

pub(crate) struct Fence {
    /// The script; none if its lines come from elsewhere.
    script: Option<PathBuf>,
    /// The folder of the script, through all links.
    folder: PathBuf,
    /// Files and folders in which the user lets it write more.
    allowed: Vec<PathBuf>,
    /// Files that the user has named, so that it saves them.
    named: Vec<PathBuf>,
}

impl Fence {
    /// The fence of a script in a file. Lines from elsewhere, such as a pipe, have the present folder.
    pub(crate) fn around(script: Option<&Path>, allowed: &[PathBuf]) -> Result<Self, Failure> {
        let lost = |path: &Path, error: &io::Error| {
            Failure::file(format!("cannot find `{}`: {error}", path.display()))
        };
        let script = script.filter(|path| path.is_file());
        let at = script.unwrap_or(Path::new(""));
        let folder = folder_of(at).map_err(|error| lost(at, &error))?;
        let allowed = allowed.iter();
        let allowed = allowed.map(|path| target(path).map_err(|error| lost(path, &error)));
        Ok(Self {
            script: script.map(Path::to_owned),
            folder,
            allowed: allowed.collect::<Result<_, _>>()?,
            named: Vec::new(),
        })
    }

    /// The same, when the user has named a file that it may save.
    pub(crate) fn with_named(mut self, path: &Path) -> Self {
        self.named.extend(target(path).ok());
        self
    }

    /// Judges whether the script may write a file. It may replace what `is_own`: what it has made itself.
    pub(super) fn judge(
        &self,
        output: &Output,
        target: &Path,
        is_own: bool,
    ) -> Result<(), Failure> {
        let path = output.path.display();
        let refused = |why: String| Err(Failure::file(why));
        if self.script.as_ref().is_some_and(|script| is_same(script, target)) {
            return refused(format!("`{path}` is the script itself: it is not written over"));
        }
        // A link that leads to no file is none either.
        let known = fs::symlink_metadata(target);
        if known.as_ref().is_ok_and(|known| !known.is_file()) {
            return refused(format!("`{path}` is no plain file: a script writes nothing else"));
        }
        let is_saved = matches!(output.over, Over::Text(_));
        let is_named = |paths: &[PathBuf]| paths.iter().any(|path| path == target);
        if is_named(&self.allowed) || is_saved && is_named(&self.named) {
            return Ok(());
        }
        if !output.kind.has_ending(target) {
            let endings = output.kind.endings().iter();
            let endings: Vec<String> = endings.map(|ending| format!("`.{ending}`")).collect();
            let endings = endings.join(" or ");
            return refused(format!(
                "a script writes this to a file that ends in {endings}, and `{path}` does not; `--allow-write {path}` lets it"
            ));
        }
        let within = |folder: &PathBuf| target.strip_prefix(folder).ok();
        let seen = |folder: &PathBuf| within(folder).is_some_and(|below| !is_hidden(below));
        if self.allowed.iter().any(seen) {
            return Ok(());
        }
        if !self.allowed.iter().chain([&self.folder]).any(|one| within(one).is_some()) {
            let folder = match self.script {
                Some(_) => "the script's folder",
                None => "this folder",
            };
            return refused(format!(
                "`{path}` is outside of {folder}; `--allow-write {path}` lets the script write it"
            ));
        }
        if !seen(&self.folder) {
            return refused(format!(
                "`{path}` is hidden, as its name or its folder begins with a dot; `--allow-write {path}` lets the script write it"
            ));
        }
        let is_rust = matches!(output.over, Over::Nothing(_)) && !ends_in(target, &["mech"]);
        if is_rust {
            return refused(format!(
                "`{path}` is Rust, which a build may run; `--allow-write {path}` lets the script make it"
            ));
        }
        // What is saved anew takes the place of nothing anyway.
        let replaces = matches!(output.over, Over::OfKind(_) | Over::Any);
        if known.is_ok() && replaces && !is_own {
            return refused(format!(
                "`{path}` is there already, and the script has not made it; `--allow-write {path}` lets the script replace it"
            ));
        }
        Ok(())
    }
}

/// Whether a part of a path begins with a dot.
fn is_hidden(path: &Path) -> bool {
    let begins = |part: &OsStr| part.as_encoded_bytes().starts_with(b".");
    path.components().any(|part| matches!(part, Component::Normal(part) if begins(part)))
}
