//! `mech draw`.

use super::CODES;
use super::picture::{Picture, kind_of};
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{self, Job, StillKind};
use crate::motion::Goal;
use crate::output::Writer;
use clap::Args;

/// Draws a mechanism as it is assembled, or where its motors are put: PNG or SVG.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Draw {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    picture: Picture,
    /// Leads the point of `follow` there, from where the motors are put: `--reach 1.5,2`; with three motors `--reach 1.5,2,30`, in degrees.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    reach: Option<Goal>,
}

const EXAMPLES: &str = "\
Examples:
  mech draw four_bar.mech -o four_bar.png
  mech draw four_bar.mech -o four_bar.svg --at a=30 --overlay
  mech draw four_bar.mech -o centres.svg --names --centres
  mech draw four_bar.mech -o polygons.svg --names --velocities --accelerations
  mech draw plotter.mech -o there.png --reach 1.5,2
  mech draw src/main.rs --mechanism FourBar -o wide.png --size 1920x1080 --look diagram --night";

impl Draw {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let path = &self.picture.output;
        let kind = kind_of(path, &[("png", StillKind::Png), ("svg", StillKind::Svg)])?;
        let analysed = self.target.coherent_with(&self.picture.set, console)?;
        let picture = self.picture.job();
        let reach = self.reach.clone();
        let job = Job::Draw(job::Draw { picture, reach, kind });
        let bytes = job.run(analysed, console)?;
        let replacing = self.picture.replacing;
        writer.write(replacing.output(path, kind.file(), bytes, &self.target))
    }
}
