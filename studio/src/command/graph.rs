//! `mech graph`.

use super::CODES;
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::output;
use clap::{Args, ValueEnum};
use mech_compiler::graphs;
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
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let (model, compiled) = self.target.coherent(console)?;
        let graph = match self.of {
            Kind::Links => graphs::kinematic(&model, &compiled.structure),
            Kind::Loops => graphs::loops(&model, &compiled.plan),
            Kind::CommonJoints => graphs::common_joints(&model, &compiled.plan),
        };
        match &self.output {
            Some(path) => output::replace(path, graph.to_dot().as_bytes()),
            None => console.answer(graph.to_dot()),
        }
    }
}
