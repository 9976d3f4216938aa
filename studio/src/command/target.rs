//! Which mechanism of which file, and what a file that is written may take the place of.

use super::assignment::Assignment;
use crate::console::Console;
use crate::document::{Declaration, Document, Reading};
use crate::failure::{Failure, FailureKind};
use crate::job::Analysed;
use crate::output::{Output, OutputKind, Over};
use clap::Args;
use std::path::{Path, PathBuf};

/// Which mechanism of which file.
#[derive(Args, Clone, Debug)]
pub(super) struct Target {
    /// A Rust file with `mechanism!` in it, or a file `.mech` with the inside of one.
    pub(super) file: PathBuf,
    /// The mechanism, where the file has several: the name of its type.
    #[arg(short, long, value_name = "NAME")]
    pub(super) mechanism: Option<String>,
    /// A text that stands for that of the file.
    #[arg(skip)]
    given: Option<Document>,
}

impl Target {
    /// Gives the text itself, and the number of the mechanism in it.
    pub(super) fn give(&mut self, document: Document, index: usize) {
        let declaration = document.declarations().get(index);
        self.mechanism = declaration.and_then(|declaration| declaration.name.clone());
        self.given = Some(document);
    }

    pub(super) fn path(&self) -> &Path {
        let given = self.given.as_ref();
        given.map_or(&*self.file, |document| document.source().path())
    }

    pub(super) fn document(&self) -> Result<Document, Failure> {
        match &self.given {
            Some(document) => Ok(document.clone()),
            None => Document::read(&self.file),
        }
    }

    /// The mechanism, which has to be coherent. What is wrong with it is told.
    pub(super) fn coherent(&self, console: &mut Console) -> Result<Analysed, Failure> {
        self.coherent_with(&[], console)
    }

    /// The same with other values of constants and params. The file stays as it is.
    pub(super) fn coherent_with(
        &self,
        assignments: &[Assignment],
        console: &mut Console,
    ) -> Result<Analysed, Failure> {
        let mut document = self.document()?;
        let index = document.index_of(document.choose(self.mechanism.as_deref())?)?;
        for assignment in assignments {
            document = assignment.apply_to(&document, index)?;
        }
        let declaration = document.declarations().get(index);
        let declaration = declaration
            .ok_or_else(|| Failure::internal("a number has taken the mechanism away"))?;
        coherent(&document, declaration, console)
    }
}

/// A mechanism of a file, which has to be coherent. What is wrong with it is told.
pub(super) fn coherent(
    document: &Document,
    declaration: &Declaration,
    console: &mut Console,
) -> Result<Analysed, Failure> {
    moving(document, document.analyse(declaration)?, console)
}

/// A mechanism that was read, which has to be coherent. What is wrong with it is told.
pub(super) fn moving(
    document: &Document,
    reading: Reading,
    console: &mut Console,
) -> Result<Analysed, Failure> {
    Analysed::of(reading).map_err(|faults| {
        console.complain_of(document.source(), &faults.messages);
        Failure::reported(FailureKind::Mechanism)
    })
}

/// What a file that is written may take the place of.
#[derive(Args, Clone, Copy, Debug)]
pub(super) struct Replacing {
    /// Writes over a file of another kind, too; never over one that is read.
    #[arg(long)]
    replace: bool,
}

/// What can be done where a file of another kind is there.
const INSTEAD: &str = "`--replace` writes over it";

impl Replacing {
    /// What a file may take the place of, where that is one of its kind unless the user says more.
    pub(super) fn over_its_kind(self) -> Over {
        self.or(Over::OfKind(INSTEAD))
    }

    /// What a file may take the place of, where that is nothing unless the user says more.
    pub(super) fn over_nothing(self) -> Over {
        self.or(Over::Nothing(INSTEAD))
    }

    fn or(self, usual: Over) -> Over {
        if self.replace { Over::Any } else { usual }
    }

    /// A file of this kind, made from a mechanism.
    pub(super) fn output(
        self,
        path: &Path,
        kind: OutputKind,
        bytes: Vec<u8>,
        of: &Target,
    ) -> Output {
        let output = Output::new(path, kind, bytes).over(self.over_its_kind());
        output.from([of.path()])
    }
}
