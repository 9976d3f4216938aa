//! What a file that is written may take the place of.

use super::target::Target;
use crate::output::{Output, OutputKind, Over};
use clap::Args;
use std::path::Path;

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
