//! `mech completions`.

use super::{CODES, CommandLine};
use crate::console::Console;
use crate::failure::Failure;
use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};

/// Writes what a shell needs to complete commands of mech.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Completions {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,
}

const EXAMPLES: &str = "\
Examples:
  mech completions bash > ~/.local/share/bash-completion/completions/mech
  mech completions zsh > ~/.zfunc/_mech";

impl Completions {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let mut script = Vec::new();
        generate(self.shell, &mut CommandLine::command(), "mech", &mut script);
        console.deliver(script)
    }
}
