//! Documents: the mechanisms of a file, as text and as what the compiler makes of it.

#[cfg(feature = "editor")]
mod part_offer;
mod reading;
mod scanner;
mod source;
mod tree;
mod unlexed;

#[cfg(feature = "editor")]
pub(crate) use part_offer::PartOffer;
pub use reading::{Faults, Listing, Message, NameText, NumberText, Reading};
pub use source::{LONGEST, Source, Spot};
pub(crate) use tree::TextTree;

use crate::failure::Failure;
use proc_macro2::TokenStream;
use std::ops::Range;
use std::path::Path;

/// The macros that a Rust file is searched for.
const MECHANISM: &str = "mechanism";
const PART: &str = "mechanism_part";

/// A file with mechanisms: Rust with `mechanism!` in it, or, where its name ends in `.mech`, the inside of one.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "transfer",
    derive(serde::Serialize, serde::Deserialize),
    serde(from = "Source", into = "Source")
)]
pub struct Document {
    source: Source,
    declarations: Vec<Declaration>,
    /// The bodies of `mechanism_part!`.
    parts: Vec<Declaration>,
}

/// Where a mechanism stands in its file, in bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration {
    /// The name of its type, if it has one.
    pub name: Option<String>,
    /// The whole call of the macro; in a file of its own all of it.
    pub whole: Range<usize>,
    /// The input of the macro; none if its brackets are not closed.
    pub body: Option<Range<usize>>,
}

#[cfg(feature = "transfer")]
impl From<Source> for Document {
    fn from(source: Source) -> Self {
        Self::of(source)
    }
}

#[cfg(feature = "transfer")]
impl From<Document> for Source {
    fn from(document: Document) -> Self {
        document.source
    }
}

impl Document {
    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read, is not UTF-8, or has no mechanism.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        Self::with_any(Source::read(path)?)
    }

    /// Reads a plain file, no pipe and no device.
    pub(crate) fn read_plain(path: &Path) -> Result<Self, Failure> {
        Self::with_any(Source::read_plain(path)?)
    }

    /// The mechanisms of a text that has one at least.
    fn with_any(source: Source) -> Result<Self, Failure> {
        let document = Self::of(source);
        if document.declarations.is_empty() && document.parts.is_empty() {
            let path = document.source.path().display();
            return Err(Failure::file(format!(
                "`{path}` has no mechanism: neither `mechanism! {{ ... }}` nor, in a file `.mech`, the inside of one"
            )));
        }
        Ok(document)
    }

    /// The mechanisms of a text.
    #[must_use]
    pub fn of(source: Source) -> Self {
        let text = source.text();
        if source.path().extension().is_some_and(|end| end == "mech") {
            let whole = 0..text.len();
            let declarations = if text.trim().is_empty() {
                Vec::new()
            } else {
                vec![Declaration::new(text, whole.clone(), Some(whole))]
            };
            return Self { source, declarations, parts: Vec::new() };
        }
        let calls = scanner::calls(text, &[MECHANISM, PART]);
        let (mechanisms, parts): (Vec<_>, Vec<_>) =
            calls.into_iter().partition(|call| call.name == MECHANISM);
        let declared = |calls: Vec<scanner::Call<'_>>| {
            let calls = calls.into_iter();
            calls.map(|call| Declaration::new(text, call.whole, call.body)).collect()
        };
        let (declarations, parts) = (declared(mechanisms), declared(parts));
        Self { source, declarations, parts }
    }

    /// Its text.
    #[must_use]
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// All its mechanisms, in order.
    #[must_use]
    pub fn declarations(&self) -> &[Declaration] {
        &self.declarations
    }

    /// The number of one of its mechanisms.
    pub(crate) fn index_of(&self, declaration: &Declaration) -> Result<usize, Failure> {
        let mut all = self.declarations.iter();
        let index = all.position(|one| one == declaration);
        index.ok_or_else(|| Failure::internal("a mechanism is not in its file"))
    }

    /// The mechanism of this name; without a name the only one.
    ///
    /// # Errors
    /// If there is none, or if there are several and none is named.
    pub fn choose(&self, name: Option<&str>) -> Result<&Declaration, Failure> {
        let path = self.source.path().display();
        match (name, &self.declarations[..]) {
            (None, [only]) => Ok(only),
            (None, []) => Err(Failure::file(format!("`{path}` has no mechanism, only parts"))),
            (None, _) => {
                let names = self.names();
                Err(Failure::usage(format!(
                    "`{path}` has several mechanisms; name one of them with `--mechanism`: {names}"
                )))
            }
            (Some(name), all) => {
                let is_it = |one: &&Declaration| one.name.as_deref() == Some(name);
                all.iter().find(is_it).ok_or_else(|| {
                    let names = self.names();
                    Failure::usage(format!("`{path}` has no mechanism `{name}`; it has {names}"))
                })
            }
        }
    }

    /// The names of all mechanisms, for a message.
    fn names(&self) -> String {
        let name = |one: &Declaration| match &one.name {
            Some(name) => format!("`{name}`"),
            None => {
                format!("one without a name in line {}", self.source.spot(one.whole.start).line)
            }
        };
        let names: Vec<String> = self.declarations.iter().map(name).collect();
        names.join(", ")
    }

    /// The tokens of a range, whose places are those in the file.
    fn tokens(&self, range: &Range<usize>) -> Result<TokenStream, proc_macro2::LexError> {
        self.source.masked(range).parse()
    }
}

impl Declaration {
    fn new(text: &str, whole: Range<usize>, body: Option<Range<usize>>) -> Self {
        let inside = body.clone().unwrap_or_else(|| whole.clone());
        let name = scanner::word_after(&text[inside], "struct");
        Self { name: name.map(ToOwned::to_owned), whole, body }
    }
}

/// The inside of a mechanism, by its lines, in a file of Rust: a call of `mechanism!`.
pub(crate) fn in_rust<'t>(inside: impl IntoIterator<Item = &'t str>) -> String {
    let inside = inside.into_iter().map(|line| match line {
        "" => "\n".to_owned(),
        line => format!("    {line}\n"),
    });
    let inside: String = inside.collect();
    format!("use mech_runtime::mechanism;\n\nmechanism! {{\n{inside}}}\n")
}
