//! Which mechanism of which file.

use crate::check::render;
use crate::console::Console;
use crate::document::{Declaration, Document};
use crate::failure::{Failure, FailureKind};
use clap::Args;
use mech_compiler::Compiled;
use mech_compiler::model::Model;
use std::path::PathBuf;

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

    /// The file.
    pub(super) fn document(&self) -> Result<Document, Failure> {
        match &self.given {
            Some(document) => Ok(document.clone()),
            None => Document::read(&self.file),
        }
    }

    /// The mechanism, which has to be coherent. What is wrong with it is told.
    pub(super) fn coherent(&self, console: &mut Console) -> Result<(Model, Compiled), Failure> {
        let document = self.document()?;
        let declaration = document.choose(self.mechanism.as_deref())?;
        coherent(&document, declaration, console)
    }
}

/// A mechanism of a file, which has to be coherent. What is wrong with it is told.
pub(super) fn coherent(
    document: &Document,
    declaration: &Declaration,
    console: &mut Console,
) -> Result<(Model, Compiled), Failure> {
    let reading = document.analyse(declaration)?;
    match reading.result {
        Ok(compiled) => Ok((reading.model, *compiled)),
        Err(faults) => {
            console.complain(&render(
                document.source(),
                &faults.messages,
                console.has_colors(),
            ));
            Err(Failure::reported(FailureKind::Mechanism))
        }
    }
}
