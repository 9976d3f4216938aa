//! `mech plot`.

use super::CODES;
use super::measure::{Measure, QUANTITIES};
use super::picture::kind_of;
use super::target::{Replacing, Target};
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{self, Job, StillKind};
use crate::output::Writer;
use clap::Args;
use std::path::PathBuf;

/// Measures a mechanism through the motion of a motor, as graphs: SVG or PNG.
///
/// Quantities with the same unit share a graph; graphs stand below each other.
#[derive(Args, Clone, Debug)]
#[command(after_help = [QUANTITIES, "\n\n", EXAMPLES].concat(), after_long_help = [QUANTITIES, "\n\n", EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Plot {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    measure: Measure,
    /// The file to write: its ending, `.svg` or `.png`, says which kind.
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    replacing: Replacing,
    /// The title; without, the name of the mechanism.
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
}

const EXAMPLES: &str = "\
Examples:
  mech plot four_bar.mech -o joints.svg
  mech plot four_bar.mech velocity:coupler.tip.norm transmission -o four_bar.png --length mm
  mech plot four_bar.mech coupler.tip.y --over coupler.tip.x -o path.svg
  mech plot four_bar.mech coupler.tip.y --over t --rate 6.28 -o time.svg";

impl Plot {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let kinds = [("svg", StillKind::Svg), ("png", StillKind::Png)];
        let kind = kind_of(&self.output, &kinds)?;
        let analysed = self.target.coherent_with(&self.measure.set, console)?;
        let job =
            Job::Plot(job::Plot { measure: self.measure.job(), kind, title: self.title.clone() });
        let bytes = job.run(analysed, console)?;
        let (path, replacing) = (&self.output, self.replacing);
        writer.write(replacing.output(path, kind.file(), bytes, &self.target))
    }
}
