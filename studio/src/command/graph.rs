//! `mech graph`.

use super::CODES;
use super::target::{Replacing, Target};
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{GraphKind, Job};
use crate::output::{OutputKind, Writer};
use clap::Args;
use std::path::PathBuf;

/// Writes a graph of a mechanism in the language DOT of Graphviz.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Graph {
    #[command(flatten)]
    pub(super) target: Target,
    /// What the graph shows.
    #[arg(long, value_enum, default_value_t = GraphKind::Links)]
    of: GraphKind,
    /// The file to write; without, the graph is the answer.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replacing: Replacing,
}

const EXAMPLES: &str = "\
Examples:
  mech graph four_bar.mech | dot -Tsvg > links.svg
  mech graph src/main.rs --mechanism FourBar --of loops";

impl Graph {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let analysed = self.target.coherent(console)?;
        let dot = Job::Graph(self.of).run(analysed, console)?;
        match &self.output {
            Some(path) => {
                let replacing = self.replacing;
                writer.write(replacing.output(path, OutputKind::Dot, dot, &self.target))
            }
            None => console.deliver(dot),
        }
    }
}
