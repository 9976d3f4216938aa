//! `mech check`.

use super::CODES;
use super::target::Target;
use crate::check::{Verdict, to_json, verdicts};
use crate::console::Console;
use crate::failure::{Failure, FailureKind};
use clap::Args;

/// Tells what is wrong with mechanisms, in the words of the macro, or that they move.
///
/// All mechanisms of the file are checked, unless one is named.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Check {
    #[command(flatten)]
    pub(super) target: Target,
    /// Answers in JSON, for editors: places in bytes, and in lines and columns from 1. Repairs come with the changes of the text that make them.
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  mech check src/main.rs
  mech check four_bar.mech --json
  mech check src/main.rs --mechanism FourBar";

impl Check {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let document = self.target.document()?;
        let verdicts = verdicts(&document, self.target.mechanism.as_deref(), self.json)?;
        let source = document.source();
        if self.json {
            console.deliver(to_json(source, &verdicts))?;
        } else {
            for verdict in &verdicts {
                match verdict {
                    Verdict::Moves { line, motors, notes, .. } => {
                        let motors = motors.iter().map(|range| format!("motor {range}\n"));
                        let notes = notes.iter().map(|note| format!("note: {note}\n"));
                        let more: String = motors.chain(notes).collect();
                        console.answer(format!("{line}\n{more}"))?;
                    }
                    Verdict::Faulty { messages, .. } => {
                        console.complain_of(source, messages);
                    }
                }
            }
        }
        let is_faulty = |verdict: &Verdict| matches!(verdict, Verdict::Faulty { .. });
        if verdicts.iter().any(is_faulty) {
            return Err(Failure::reported(FailureKind::Mechanism));
        }
        Ok(())
    }
}
