//! `mech report`.

use super::CODES;
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::job::Job;
use clap::Args;

/// Tells what a mechanism does, and how: ranges of motors, strokes, loops in the order in which they are solved, methods, operations.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Report {
    #[command(flatten)]
    pub(super) target: Target,
}

const EXAMPLES: &str = "\
Examples:
  mech report four_bar.mech
  mech report src/main.rs --mechanism FourBar";

impl Report {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let analysed = self.target.coherent(console)?;
        let text = Job::Report.run(analysed, console)?;
        console.deliver(text)
    }
}
