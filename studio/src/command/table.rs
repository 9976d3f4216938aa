//! `mech table`.

use super::CODES;
use super::measure::{Measure, QUANTITIES};
use super::target::{Replacing, Target};
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{self, Job};
use crate::motion::{Goal, read_value};
use crate::output::{OutputKind, Writer};
use clap::Args;
use std::path::PathBuf;

/// Measures a mechanism through the motion of a motor, as CSV.
#[derive(Args, Clone, Debug)]
#[command(after_help = [QUANTITIES, "\n\n", EXAMPLES].concat(), after_long_help = [QUANTITIES, "\n\n", EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Table {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    measure: Measure,
    /// Tells the extremes and means of each quantity, and where, in place of the table. Extremes are looked for between the steps, too.
    #[arg(long, conflicts_with = "over")]
    summary: bool,
    /// Measures where the point of `follow` is led, and nowhere else: `--reach 1.5,2`; with three motors `--reach 1.5,2,30`, in degrees.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, conflicts_with_all = ["motor", "from", "to", "steps", "over", "summary"])]
    reach: Option<Goal>,
    /// In a summary, tells the longest dwell of each quantity: the way of the motor on which it stays within this width, in its own unit.
    #[arg(long, value_name = "WIDTH", requires = "summary", value_parser = read_value)]
    dwell: Option<f64>,
    /// The file to write; without, the table is the answer.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replacing: Replacing,
}

const EXAMPLES: &str = "\
Examples:
  mech table four_bar.mech
  mech table four_bar.mech coupler.tip velocity:coupler.tip.norm --steps 72 -o tip.csv
  mech table plotter.mech lm rm torque:lm --reach 1.5,2
  mech table shaper.mech x velocity:x --summary --dwell 0.01
  mech table press.mech torque:crank transmission --from 0 --to 180 --rate 10.5 --length m --force N";

impl Table {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let analysed = self.target.coherent_with(&self.measure.set, console)?;
        if self.dwell.is_some_and(|width| width < 0.0) {
            return Err(Failure::usage("the width of a dwell is not negative"));
        }
        let measure =
            job::Measure { dwell: self.dwell, reach: self.reach.clone(), ..self.measure.job() };
        let job = if self.summary { Job::Summary(measure) } else { Job::Table(measure) };
        let text = job.run(analysed, console)?;
        match &self.output {
            Some(path) => {
                let replacing = self.replacing;
                writer.write(replacing.output(path, OutputKind::Csv, text, &self.target))
            }
            None => console.deliver(text),
        }
    }
}
