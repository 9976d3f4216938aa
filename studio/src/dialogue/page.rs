//! In a browser's page there is no command line that a line of the dialogue could go on to.

use crate::console::Console;
use crate::document::Document;
use crate::failure::Failure;
use crate::output::Writer;

/// Says that a subcommand is not there.
pub(super) fn obey_within(
    words: &[String],
    _: Document,
    _: usize,
    _: &mut Writer,
    _: &mut Console,
) -> Result<(), Failure> {
    let name = words.first();
    let name = name.ok_or_else(|| Failure::internal("a command without a word"))?;
    Err(Failure::usage(format!("`{name}` is not there in a browser; say it to the command `mech`")))
}
