//! `mech film`.

use super::CODES;
use super::picture::{Picture, kind_of};
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::job::{self, FilmKind, Job};
use crate::motion::{Span, Typed};
use crate::output::Writer;
use clap::Args;

/// Films a mechanism while one of its motors moves: GIF, animated PNG, or SVG that moves.
///
/// The motor turns round until everything is back where it was, or goes to and fro through its range or as far as the mechanism lets it. Motors with laws follow these until all are back, or for a unit of time if they never are.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Film {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    picture: Picture,
    /// The motor that moves; without, the first, or all by their laws.
    #[arg(long, value_name = "NAME")]
    motor: Option<String>,
    /// Where it begins: in degrees, scene units, or, with laws, units of time.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<Typed>,
    /// Where it ends, or turns back.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<Typed>,
    /// How long the film takes.
    #[arg(long, value_name = "SECONDS", default_value_t = job::Film::SECONDS, value_parser = clap::value_parser!(u32).range(1..=600))]
    seconds: u32,
    /// How many frames a second has. Moving SVG has no frames.
    #[arg(long, value_name = "COUNT", default_value_t = job::Film::RATE, value_parser = clap::value_parser!(u32).range(1..=60))]
    rate: u32,
}

const EXAMPLES: &str = "\
Examples:
  mech film four_bar.mech -o four_bar.gif
  mech film four_bar.mech -o four_bar.svg --seconds 2
  mech film four_bar.mech -o velocities.gif --names --velocities
  mech film crane.mech -o crane.png --motor luff --from 10 --to 70 --overlay";

impl Film {
    pub(super) fn run(&self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        let path = &self.picture.output;
        let kinds = [
            ("gif", FilmKind::Gif),
            ("png", FilmKind::Apng),
            ("apng", FilmKind::Apng),
            ("svg", FilmKind::Svg),
        ];
        let kind = kind_of(path, &kinds)?;
        let analysed = self.target.coherent_with(&self.picture.set, console)?;
        let job = Job::Film(job::Film {
            picture: self.picture.job(),
            kind,
            motor: self.motor.clone(),
            span: Span { from: self.from, to: self.to },
            seconds: self.seconds,
            rate: self.rate,
        });
        let bytes = job.run(analysed, console)?;
        let replacing = self.picture.replacing;
        writer.write(replacing.output(path, kind.file(), bytes, &self.target))
    }
}
