//! `mech graph`.

use super::CODES;
use super::replacing::Replacing;
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{GraphKind, Job};
use crate::output::{OutputKind, Writer};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// Writes a graph of a mechanism in the language DOT of Graphviz.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Graph {
    #[command(flatten)]
    pub(super) target: Target,
    /// What the graph shows.
    #[arg(long, value_enum, default_value_t = Kind::Links)]
    of: Kind,
    /// The file to write; without, the graph is the answer.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replacing: Replacing,
}

/// What a graph shows.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    /// The kinematic graph: links, and the joints between them.
    Links,
    /// Each loop, after the loops and motors that determine it.
    Loops,
    /// Loops that have joints in common.
    CommonJoints,
}

const EXAMPLES: &str = "\
Examples:
  mech graph four_bar.mech | dot -Tsvg > links.svg
  mech graph src/main.rs --mechanism FourBar --of loops";

impl Graph {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let analysed = self.target.coherent(console)?;
        let kind = match self.of {
            Kind::Links => GraphKind::Links,
            Kind::Loops => GraphKind::Loops,
            Kind::CommonJoints => GraphKind::CommonJoints,
        };
        let dot = Job::Graph(kind).run(analysed, console)?;
        match &self.output {
            Some(path) => {
                let replacing = self.replacing;
                writer.write(replacing.output(path, OutputKind::Dot, dot, &self.target))
            }
            None => console.deliver(dot),
        }
    }
}
