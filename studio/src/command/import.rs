//! `mech import`.

use super::CODES;
use super::target::{Replacing, moving};
use crate::check::verdict_line;
use crate::console::Console;
use crate::document::{Document, Source};
use crate::failure::{Failure, FailureKind};
use crate::import::{self, FileKind, Written, listed};
use crate::job::Analysed;
use crate::output::{Output, OutputKind, Writer};
use clap::Args;
use std::path::{Path, PathBuf};

/// Reads a mechanism of another program, and writes it as a text of the language.
///
/// Files `.linkage2` of Linkage and links of PMKS+ are read. What cannot be carried over is listed, a line each. The text has the
/// allowances that the drawing needs and the ranges that can be proved; several inputs follow their speeds by laws. It is checked as by
/// `mech check`. If something is wrong with it, the line is told, and the exit code is 1: `mech fix` may mend it. Where nothing can be read,
/// the code is 2 for a link and 3 for a file.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Import {
    /// A file, `-` for the standard input, or a link in quotes. A link may begin with its question mark.
    #[arg(value_name = "FILE|LINK")]
    from: String,
    /// The file to write, which may not be there yet without `--replace`: `.mech`, or `.rs` for Rust. Without, the text is the answer.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replacing: Replacing,
    /// The name of the mechanism; without, that of the file.
    #[arg(short, long, value_name = "NAME")]
    mechanism: Option<String>,
}

const EXAMPLES: &str = "\
Examples:
  mech import lift.linkage2
  mech import lift.linkage2 -o lift.mech
  mech import lift.linkage2 -o src/lift.rs --mechanism Lift
  mech import 'https://app.pmksplus.com/?0P.SS.K,0.101...' -o four_bar.mech";

const STANDARD_INPUT: &str = "-";

/// What is read, and what it is called.
struct Origin {
    source: Source,
    /// `lift.linkage2`, for the text.
    title: String,
    /// The name of the mechanism, as far as it can be one.
    wish: String,
    /// What it is if it cannot be read.
    fault: FailureKind,
}

impl Import {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let kind = self.kind()?;
        let origin = self.origin()?;
        let imported = import::read(&origin.source).map_err(|message| {
            console.complain_of(&origin.source, &[message]);
            Failure::reported(origin.fault)
        })?;
        let name = self.name(&origin.wish)?;
        let Written { text, omissions } = imported.written(&origin.title, &name, kind)?;
        match &self.output {
            Some(path) => {
                let output = Output::new(path, OutputKind::Mechanism, text.as_str());
                let output = output.over(self.replacing.over_nothing());
                writer.write(output.from([&self.from]))?;
                console.answer(format!("saved `{}`\n", path.display()))?;
            }
            None => console.deliver(&text)?,
        }
        console.complain(&listed(&omissions));
        self.check(&name, text, console)
    }

    /// What the text stands in.
    fn kind(&self) -> Result<FileKind, Failure> {
        let Some(path) = &self.output else {
            return Ok(FileKind::Mechanism);
        };
        let ending = path.extension().and_then(|ending| ending.to_str());
        let kind = match ending {
            Some("mech") => FileKind::Mechanism,
            Some("rs") => FileKind::Rust,
            _ => {
                let path = path.display();
                return Err(Failure::usage(format!(
                    "`{path}` ends neither in `.mech` nor in `.rs`"
                )));
            }
        };
        Ok(kind)
    }

    fn origin(&self) -> Result<Origin, Failure> {
        if import::is_link(&self.from) {
            return Ok(Origin {
                source: Source::new("link", &*self.from),
                title: "a link of PMKS+".to_owned(),
                wish: self.stem_of_output(),
                fault: FailureKind::Usage,
            });
        }
        let fault = FailureKind::File;
        if self.from == STANDARD_INPUT {
            return Ok(Origin {
                source: Source::read_foreign_from(STANDARD_INPUT, std::io::stdin())?,
                title: "the standard input".to_owned(),
                wish: self.stem_of_output(),
                fault,
            });
        }
        let path = Path::new(&self.from);
        let name = |part: Option<&std::ffi::OsStr>| {
            part.map(|part| part.to_string_lossy().into_owned()).unwrap_or_default()
        };
        Ok(Origin {
            source: Source::read_foreign(path)?,
            title: name(path.file_name()),
            wish: name(path.file_stem()),
            fault,
        })
    }

    /// What a mechanism is called whose origin has no name.
    fn stem_of_output(&self) -> String {
        let stem = self.output.as_deref().and_then(Path::file_stem);
        stem.map_or_else(|| "Imported".to_owned(), |stem| stem.to_string_lossy().into_owned())
    }

    fn name(&self, wish: &str) -> Result<String, Failure> {
        match &self.mechanism {
            None => import::type_name(wish),
            Some(name) if import::is_type(name)? => Ok(name.clone()),
            Some(name) => {
                Err(Failure::usage(format!("`{name}` cannot be the name of a mechanism")))
            }
        }
    }

    /// Tells what is wrong with the text, or that it moves where there is room to say so.
    fn check(&self, name: &str, text: String, console: &mut Console) -> Result<(), Failure> {
        let path = self.output.clone();
        let path = path.unwrap_or_else(|| PathBuf::from(format!("{name}.mech")));
        let document = Document::of(Source::new(path, text));
        let reading = document.check(document.choose(None)?)?;
        let Analysed { model, compiled } = moving(&document, reading, console)?;
        if self.output.is_none() {
            return Ok(());
        }
        console.answer(format!("{}\n", verdict_line(&model, &compiled)))
    }
}
