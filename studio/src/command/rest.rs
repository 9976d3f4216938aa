//! `mech rest`.

use super::CODES;
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{self, Job};
use crate::motion::Setting;
use crate::quantity::Load;
use clap::Args;

/// Tells where springs and weights bring a mechanism whose motors are let go.
///
/// It begins at its start, and goes downhill until nothing pulls any more. Motors with laws are held where these have them at first.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Rest {
    #[command(flatten)]
    pub(super) target: Target,
    /// Holds a motor at a value, in degrees or scene units; all others are let go.
    #[arg(long, value_name = "MOTOR=VALUE")]
    at: Vec<Setting>,
    /// Gives a load its numbers: a force in the directions of the scene, or a torque.
    #[arg(long, value_name = "NAME=NUMBERS", allow_hyphen_values = true)]
    load: Vec<Load>,
}

const EXAMPLES: &str = "\
Examples:
  mech rest lamp.mech
  mech rest lamp.mech --at lower=30 --load shade=0,-2";

impl Rest {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let analysed = self.target.coherent(console)?;
        let job = Job::Rest(job::Rest { at: self.at.clone(), loads: self.load.clone() });
        let text = job.run(analysed, console)?;
        console.deliver(text)
    }
}
