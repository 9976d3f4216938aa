//! What reads texts.

mod desk;
mod document;
mod import;
mod mechanism;
mod script;

use crate::corpus::{Corpus, texts};
use crate::finding::Finding;
use crate::language::{DESK, LINKAGE, Language, MECHANISM, PMKS, SCRIPT};
use std::path::{Path, PathBuf};

/// The folders of mechanisms of which most are right.
const RIGHT: [&str; 6] = [
    "tests/cases/expanded",
    "tests/cases/orders",
    "tests/cases/right",
    "tests/cases/seen",
    "tests/fuzz/corpus",
    "studio/tests",
];

/// What reads texts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Target {
    /// The macro, by its tokens.
    Mechanism,
    /// The command, the studio and the page, by a file of Rust or with the inside of a macro.
    Document,
    /// The dialogue, line by line.
    Script,
    /// The studio, by the file of its desk.
    Desk,
    /// `mech import`, by a document of Linkage.
    Linkage,
    /// `mech import`, by a link of PMKS+.
    Pmks,
}

impl Target {
    pub(crate) const ALL: [Self; 6] =
        [Self::Mechanism, Self::Document, Self::Script, Self::Desk, Self::Linkage, Self::Pmks];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Mechanism => "mechanism",
            Self::Document => "document",
            Self::Script => "script",
            Self::Desk => "desk",
            Self::Linkage => "linkage",
            Self::Pmks => "pmks",
        }
    }

    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|target| target.name() == name);
        found.ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("there is no target `{name}`; there are {names}")
        })
    }

    pub(crate) const fn language(self) -> &'static Language {
        match self {
            Self::Mechanism | Self::Document => &MECHANISM,
            Self::Script => &SCRIPT,
            Self::Desk => &DESK,
            Self::Linkage => &LINKAGE,
            Self::Pmks => &PMKS,
        }
    }

    /// The texts that are mangled for it, also from these folders.
    pub(crate) fn corpus(self, others: &[PathBuf]) -> Result<Corpus, String> {
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let folders = |own: &[&str]| {
            let own = own.iter().map(|folder| repository.join(folder));
            own.chain(others.iter().cloned()).collect::<Vec<_>>()
        };
        let mechanisms = || {
            // Those that are right are taken more often: most changes make them wrong.
            let right = texts(&folders(&RIGHT), &["mech"])?;
            let others = texts(&folders(&["tests/cases"]), &["mech"])?;
            Ok::<_, String>([right.clone(), right, others].concat())
        };
        let texts = match self {
            Self::Mechanism => mechanisms()?,
            Self::Document => {
                let rust = ["tests/programs", "examples/gallery/src/mechanisms"];
                let mut all = texts(&folders(&rust), &["rs"])?;
                all.retain(|text| text.contains("mechanism"));
                all.extend(mechanisms()?);
                all
            }
            Self::Script => {
                let mut dialogues =
                    texts(&folders(&["tests/cases/edits", "tests/cases/commands"]), &["txt"])?;
                dialogues.sort();
                script::scripts(&dialogues, &mechanisms()?)
            }
            Self::Desk => texts(&folders(&["tests/fuzz/corpus"]), &["desk"])?,
            Self::Linkage => {
                texts(&folders(&["studio/tests/samples", "tests/fuzz/corpus"]), &["linkage2"])?
            }
            Self::Pmks => {
                let mut all = texts(
                    &folders(&["studio/tests/samples", "tests/fuzz/corpus"]),
                    &["pmks", "url"],
                )?;
                all.extend(import::links(&texts(&folders(&["tests/cases/commands"]), &["txt"])?));
                all
            }
        };
        Ok(Corpus::new(self.language(), texts))
    }

    /// Lets it read a text; whether that is understood.
    pub(crate) fn examine(self, text: &str) -> Result<bool, Finding> {
        match self {
            Self::Mechanism => mechanism::examine(text),
            Self::Document => document::examine(text),
            Self::Script => script::examine(text),
            Self::Desk => desk::examine(text),
            Self::Linkage => import::examine(text, "a.linkage2"),
            Self::Pmks => import::examine(text, "a.url"),
        }
    }
}
