//! A file that is being edited: its text as it is now, and the steps that led there.

use super::{Applied, Command, Refusal, apply};
use crate::document::{Document, Listing, Source};
use crate::failure::Failure;
#[cfg(feature = "editor")]
use crate::output;
use crate::output::{Output, OutputKind, Over};
use std::path::{Path, PathBuf};

/// A file that is being edited, its text as it is now, and the steps that led there.
#[derive(Clone, Debug)]
pub struct Workspace {
    path: PathBuf,
    /// Whether somebody has said that this is the file. If not, the path is a proposal.
    is_named: bool,
    /// The file as it was read or written last; none if there is no file yet.
    source: Option<Source>,
    history: History,
    /// The number of the mechanism in the file.
    index: usize,
}

impl Default for Workspace {
    fn default() -> Self {
        Self {
            path: PathBuf::from("untitled.mech"),
            is_named: false,
            source: None,
            history: History::new(""),
            index: 0,
        }
    }
}

impl Workspace {
    /// A text for a file that is not there yet.
    #[must_use]
    pub fn unsaved(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { is_named: true, ..Self::proposed(path, text) }
    }

    /// A text that is in no file, with a proposal for its name.
    #[must_use]
    pub fn proposed(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { path: path.into(), history: History::new(text), ..Self::default() }
    }

    /// A file that was read elsewhere, at its first mechanism.
    #[must_use]
    pub fn of(source: Source) -> Self {
        Self {
            path: source.path().to_owned(),
            is_named: true,
            history: History::new(source.text()),
            source: Some(source),
            ..Self::default()
        }
    }

    /// Reads a file; of several mechanisms, the one of this name.
    ///
    /// # Errors
    /// If it cannot be read, or has no such mechanism.
    pub fn open(path: &Path, mechanism: Option<&str>) -> Result<Self, Failure> {
        let document = Document::read_plain(path)?;
        let chosen = document.choose(mechanism)?;
        Ok(Self {
            path: path.to_owned(),
            is_named: true,
            index: document.index_of(chosen)?,
            history: History::new(document.source().text()),
            source: Some(document.source().clone()),
        })
    }

    /// The name of the file, whether it is there or not.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The text as it is now.
    #[must_use]
    pub fn text(&self) -> &str {
        self.history.text()
    }

    /// The steps that led there.
    #[must_use]
    pub const fn history(&self) -> &History {
        &self.history
    }

    /// The number of the mechanism in the file.
    #[must_use]
    pub const fn index(&self) -> usize {
        self.index
    }

    /// Goes on with another mechanism of the file, by its number.
    pub const fn choose(&mut self, index: usize) {
        self.index = index;
    }

    /// The file as it is now.
    #[must_use]
    pub fn document(&self) -> Document {
        Document::of(Source::new(&self.path, self.text()))
    }

    /// The names and numbers of the text as it is now, as far as they can be read.
    #[must_use]
    pub fn listing(&self) -> Listing {
        let document = self.document();
        let declaration = document.declarations().get(self.index);
        let listing = declaration.map(|declaration| document.listing(declaration));
        listing.and_then(Result::ok).flatten().unwrap_or_default()
    }

    /// Applies a command, as one step.
    ///
    /// # Errors
    /// If the command is refused: nothing is changed then.
    pub fn apply(&mut self, command: &Command) -> Result<Applied, Refusal> {
        let applied = apply(&self.document(), self.index, command)?;
        let text = applied.document.source().text();
        self.push(applied.title.as_str(), text);
        Ok(applied)
    }

    /// Makes a step to another text; none if it is the same.
    pub fn push(&mut self, title: impl Into<String>, text: impl AsRef<str> + Into<String>) {
        if text.as_ref() != self.text() {
            self.history.push(title, text);
        }
    }

    /// Makes a step to another text, or takes the last one there, if it has the same title and nothing was undone.
    pub fn retype(&mut self, title: &str, text: &str) {
        if text != self.text() && !self.history.amend(title, text) {
            self.history.push(title, text);
        }
    }

    /// Goes back by a step, and gives its title; none at the beginning.
    pub fn undo(&mut self) -> Option<&str> {
        self.history.undo()
    }

    /// Makes the next step again that was undone, and gives its title; none if there is none.
    pub fn redo(&mut self) -> Option<&str> {
        self.history.redo()
    }

    /// Whether the text is another than that of the file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        let saved = self.source.as_ref().map_or("", Source::text);
        saved != self.text()
    }

    /// Whether leaving the text would lose work. A text that nobody has named or changed can be had again.
    #[must_use]
    pub fn has_work(&self) -> bool {
        self.is_changed() && (self.is_named || !self.history.made().is_empty())
    }

    /// The text of the file as it was read or written last; none if there is no file yet.
    #[must_use]
    pub fn saved(&self) -> Option<&str> {
        self.source.as_ref().map(Source::text)
    }

    /// Notes what the file says since another program has changed it; none if it is gone. The text stays as it is.
    pub fn note_file(&mut self, text: Option<&str>) {
        self.source = text.map(|text| Source::new(&self.path, text));
    }

    /// Whether the user has named the file, even if it is not there.
    #[must_use]
    pub const fn is_named(&self) -> bool {
        self.is_named
    }

    /// Writes the text as `save_to` says; or over a file, whatever text that has by now. Gives the file.
    ///
    /// # Errors
    /// If nobody has said which file, or if it cannot be written. It then counts as not written.
    #[cfg(feature = "editor")]
    pub(crate) fn save(&mut self, path: Option<&Path>, over_any: bool) -> Result<PathBuf, Failure> {
        let before = self.clone();
        let saved = self.save_to(path).and_then(|output| {
            let output = if over_any { over_any_text(output)? } else { output };
            output::write(output)
        });
        if saved.is_err() {
            *self = before;
        }
        saved.map(|()| self.path.clone())
    }

    /// Prepares to write the text: over the file that it was read from, or to a new one. From then on the text counts as written.
    ///
    /// # Errors
    /// If nobody has said which file.
    pub(crate) fn save_to(&mut self, path: Option<&Path>) -> Result<Output, Failure> {
        let path = match path {
            Some(path) => path.to_owned(),
            None if self.is_named => self.path.clone(),
            None => return Err(Failure::usage("the text has no file yet; say `save FILE`")),
        };
        let over = self.source.clone().filter(|_| path == self.path);
        let text = self.text().to_owned();
        let output = match over {
            Some(source) => source.replacement(&text),
            None => Output::new(&path, OutputKind::Mechanism, text.as_str())
                .over(Over::Nothing("`open` it to change it")),
        };
        self.source = Some(Source::new(&path, text));
        self.path = path;
        self.is_named = true;
        Ok(output)
    }
}

/// The same text, over whatever text its file has by now.
#[cfg(feature = "editor")]
fn over_any_text(output: Output) -> Result<Output, Failure> {
    if !OutputKind::Mechanism.has_ending(&output.path) {
        return Err(Failure::file(format!(
            "`{}` is there already, and ends neither in `.mech` nor in `.rs`; choose another name",
            output.path.display()
        )));
    }
    let text = Source::read_plain(&output.path)?.text().to_owned();
    Ok(output.over(Over::Text(text)))
}

/// The texts of a file, one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct History {
    first: String,
    steps: Vec<Step>,
    /// The number of steps that are made; the others are undone.
    made: usize,
}

/// A step from one text to the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// The title of the gesture or command.
    pub title: String,
    /// The text after it.
    pub text: String,
}

impl History {
    /// A text, without a step.
    pub fn new(text: impl Into<String>) -> Self {
        Self { first: text.into(), steps: Vec::new(), made: 0 }
    }

    /// The text of today.
    #[must_use]
    pub fn text(&self) -> &str {
        match self.made.checked_sub(1) {
            Some(last) => &self.steps[last].text,
            None => &self.first,
        }
    }

    /// The steps that are made, the last of them last.
    #[must_use]
    pub fn made(&self) -> &[Step] {
        &self.steps[..self.made]
    }

    /// The steps that are undone, the next to be made again first.
    #[must_use]
    pub fn undone(&self) -> &[Step] {
        &self.steps[self.made..]
    }

    /// Makes a step. Those that are undone are gone for ever.
    pub fn push(&mut self, title: impl Into<String>, text: impl Into<String>) {
        self.steps.truncate(self.made);
        self.steps.push(Step { title: title.into(), text: text.into() });
        self.made += 1;
    }

    /// Lets the last step lead to another text, if it has this title and no step is undone. Returns whether it does.
    pub(crate) fn amend(&mut self, title: &str, text: &str) -> bool {
        let is_last = self.made == self.steps.len();
        let last = self.steps.last_mut();
        let last = last.filter(|last| is_last && last.title == title);
        let is_amended = last.is_some();
        if let Some(last) = last {
            text.clone_into(&mut last.text);
        }
        is_amended
    }

    /// Goes back by a step, and gives its title; none at the beginning.
    pub fn undo(&mut self) -> Option<&str> {
        self.made = self.made.checked_sub(1)?;
        Some(&self.steps[self.made].title)
    }

    /// Makes the next step again that was undone, and gives its title; none if there is none.
    pub fn redo(&mut self) -> Option<&str> {
        let step = self.steps.get(self.made)?;
        self.made += 1;
        Some(&step.title)
    }
}
