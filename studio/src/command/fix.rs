//! `mech fix`.

use super::CODES;
use super::target::{Target, coherent};
use crate::check::verdict_line;
use crate::console::Console;
use crate::document::{Document, Source};
use crate::failure::{Failure, FailureKind};
use crate::job::Analysed;
use crate::mend::{Mending, Remainder, mendings};
use crate::output::Writer;
use clap::Args;
use similar::TextDiff;

/// Shows the repairs of a mechanism as changes of its text, and makes the one that is picked.
///
/// Each repair was tried before it is shown. Bytes outside of the change stay as they are.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Fix {
    #[command(flatten)]
    pub(super) target: Target,
    /// Makes the repair with this number.
    #[arg(short, long, value_name = "NUMBER", value_parser = clap::value_parser!(u32).range(1..))]
    pick: Option<u32>,
}

const EXAMPLES: &str = "\
Examples:
  mech fix four_bar.mech
  mech fix src/main.rs --mechanism FourBar --pick 1";

impl Fix {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let document = self.target.document()?;
        let declaration = document.choose(self.target.mechanism.as_deref())?;
        let reading = document.prove(declaration)?;
        let faults = match &reading.result {
            Ok(compiled) => {
                let line = verdict_line(&reading.model, compiled);
                return console.answer(format!("{line}\n"));
            }
            Err(faults) => faults,
        };
        let mendings = mendings(&document, declaration, &reading)?;
        if let Some(number) = self.pick {
            let index = document.index_of(declaration)?;
            return pick((&document, index), &mendings, number, (writer, console));
        }
        console.complain_of(document.source(), &faults.messages);
        if mendings.is_empty() {
            console.complain("note: no repair is known\n");
        }
        for (number, mending) in (1..).zip(&mendings) {
            console.deliver(shown(document.source(), number, mending))?;
        }
        Err(Failure::reported(FailureKind::Mechanism))
    }
}

/// A repair with its number and its diff.
fn shown(source: &Source, number: usize, mending: &Mending) -> String {
    let words = &mending.words;
    let remainder = match mending.remainder {
        Remainder::Nothing => "",
        Remainder::OtherStart => " (and it has to start elsewhere)",
        Remainder::OtherFaults => " (for one fault alone)",
    };
    let head = format!("{number}: {words}{remainder}\n");
    head + &diff(source, &mending.text) + "\n"
}

/// The difference of two texts, as `diff -u` shows it.
fn diff(source: &Source, text: &str) -> String {
    let path = source.path().to_string_lossy();
    let difference = TextDiff::from_lines(source.text(), text);
    let mut lines = difference.unified_diff();
    lines.context_radius(2).header(&path, &path).to_string()
}

/// Makes a repair of the mechanism at this position, and tells what is left to do.
fn pick(
    (document, position): (&Document, usize),
    mendings: &[Mending],
    number: u32,
    (writer, console): (&mut Writer, &mut Console),
) -> Result<(), Failure> {
    let index = number as usize - 1;
    let mending = mendings.get(index).ok_or_else(|| match mendings.len() {
        0 => Failure::mechanism("no repair is known"),
        count => Failure::usage(format!("there is no repair {number}; the last is {count}")),
    })?;
    let text = &mending.text;
    writer.write(document.source().replacement(text))?;
    console.deliver(diff(document.source(), text))?;
    let changed = Document::of(Source::new(document.source().path(), text));
    let declaration = changed
        .declarations()
        .get(position)
        .ok_or_else(|| Failure::internal("a repair has removed its mechanism"))?;
    let Analysed { model, compiled } = coherent(&changed, declaration, console)?;
    console.answer(format!("{}\n", verdict_line(&model, &compiled)))
}
