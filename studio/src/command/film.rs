//! `mech film`.

use super::CODES;
use super::picture::{Picture, Sitter, kind_of};
use super::target::Target;
use crate::console::Console;
use crate::failure::Failure;
use crate::motion::{Drive, Paths, Span, Typed};
use crate::output;
use clap::Args;
use mech_runtime::files::{AnimatedSvg, Apng, Gif};
use mech_runtime::{HeapFrame, HeapSmooth};
use std::f64::consts::PI;
use std::time::Duration;

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
    #[arg(long, value_name = "SECONDS", default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=600))]
    seconds: u32,
    /// How many frames a second has. Moving SVG has no frames.
    #[arg(long, value_name = "COUNT", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..=60))]
    rate: u32,
}

const EXAMPLES: &str = "\
Examples:
  mech film four_bar.mech -o four_bar.gif
  mech film four_bar.mech -o four_bar.svg --seconds 2
  mech film crane.mech -o crane.png --motor luff --from 10 --to 70 --overlay";

#[derive(Clone, Copy)]
enum Kind {
    Gif,
    Apng,
    Svg,
}

/// The moments of an SVG that moves.
const MOMENTS: u32 = 720;

impl Film {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let path = &self.picture.output;
        let kinds = [
            ("gif", Kind::Gif),
            ("png", Kind::Apng),
            ("apng", Kind::Apng),
            ("svg", Kind::Svg),
        ];
        let kind = kind_of(path, &kinds)?;
        let sitter = self.picture.sitter(&self.target, console)?;
        let Sitter {
            model, compiled, ..
        } = &sitter;
        let span = Span {
            from: self.from,
            to: self.to,
        };
        let drive = Drive::new(
            model,
            compiled,
            self.motor.as_deref(),
            span,
            &self.picture.at,
        )?;
        let drive = if self.to.is_none() {
            drive.completed(model, compiled)
        } else {
            drive
        };
        if let Some([from, to]) = drive.open_times().filter(|_| self.to.is_none()) {
            console.complain(&format!(
                "note: no time is known after which all is back: the film is from t = {from} to {to}; say others by `--from` and `--to`\n"
            ));
        }
        let frames = self.seconds * self.rate;
        let bytes = drive.attempt(|drive| {
            let shoot = Shoot {
                sitter: &sitter,
                is_cyclic: drive.is_cyclic(model),
                drive: drive.clone(),
            };
            match kind {
                Kind::Gif => self.gif(&shoot, frames),
                Kind::Apng => self.apng(&shoot, frames),
                Kind::Svg => self.svg(&shoot),
            }
        })?;
        output::replace(path, &bytes)
    }

    fn gif(&self, shoot: &Shoot<'_>, frames: u32) -> Result<Vec<u8>, Failure> {
        let [width, height] = shoot.sitter.size;
        let mut frame = HeapFrame::new(width, height)?;
        frame.set_palette(shoot.sitter.palette.clone());
        frame.look_at(shoot.sitter.painting.view(shoot.sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Gif<&mut Vec<u8>>> = None;
        shoot.run(frames, |poses, paths| {
            frame.clear();
            shoot.sitter.painting.paint(poses, paths, &mut frame);
            match (&mut file, sink.take()) {
                (Some(file), _) => file.add(&frame)?,
                (None, Some(sink)) => file = Some(Gif::new(sink, &frame, self.delay())?),
                (None, None) => {}
            }
            Ok(())
        })?;
        file.map_or(Ok(()), Gif::finish)?;
        Ok(bytes)
    }

    fn apng(&self, shoot: &Shoot<'_>, frames: u32) -> Result<Vec<u8>, Failure> {
        let [width, height] = shoot.sitter.size;
        let mut picture = HeapSmooth::new(width, height)?;
        picture.set_palette(shoot.sitter.palette.clone());
        picture.look_at(shoot.sitter.painting.view(shoot.sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Apng<&mut Vec<u8>>> = None;
        shoot.run(frames, |poses, paths| {
            picture.clear();
            shoot.sitter.painting.paint(poses, paths, &mut picture);
            match (&mut file, sink.take()) {
                (Some(file), _) => file.add(&picture)?,
                (None, Some(sink)) => {
                    file = Some(Apng::new(sink, &picture, frames, self.delay())?);
                }
                (None, None) => {}
            }
            Ok(())
        })?;
        file.map_or(Ok(()), Apng::finish)?;
        Ok(bytes)
    }

    fn svg(&self, shoot: &Shoot<'_>) -> Result<Vec<u8>, Failure> {
        let period = Duration::from_secs(self.seconds.into());
        let mut svg = AnimatedSvg::new(shoot.sitter.sheet.clone(), period);
        shoot.run(MOMENTS, |poses, paths| {
            svg.add(|canvas| shoot.sitter.painting.paint(poses, paths, canvas));
            Ok(())
        })?;
        Ok(svg.finish().into_bytes())
    }

    /// How long a frame is seen.
    fn delay(&self) -> Duration {
        Duration::from_secs(1) / self.rate
    }
}

/// A mechanism and its motion, which is filmed.
struct Shoot<'s> {
    sitter: &'s Sitter,
    drive: Drive,
    is_cyclic: bool,
}

impl Shoot<'_> {
    /// Shows so many frames, one after the other. The mechanism makes the motion once before, so that its traces are complete.
    fn run(
        &self,
        frames: u32,
        mut show: impl FnMut(&[[f64; 4]], &Paths) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Sitter {
            model, compiled, ..
        } = self.sitter;
        let parts = (0..frames).map(|number| self.part(f64::from(number) / f64::from(frames)));
        let parts: Vec<f64> = parts.collect();
        let mut poses = vec![Vec::new(); parts.len()];
        self.drive.visit(model, compiled, &parts, |number, at| {
            poses[number].clone_from(&at.poses);
            Ok(())
        })?;
        let mut paths = Paths::new(model, compiled)?;
        if !paths.is_empty() {
            for poses in &poses {
                paths.record(poses);
            }
        }
        let progress = Console::progress(u64::from(frames));
        for poses in &poses {
            paths.record(poses);
            show(poses, &paths)?;
            progress.inc(1);
        }
        progress.finish_and_clear();
        Ok(())
    }

    /// The part of the motion at a part of the film: what does not come round goes to and fro.
    fn part(&self, time: f64) -> f64 {
        if self.is_cyclic {
            time
        } else {
            0.5 - 0.5 * (2.0 * PI * time).cos()
        }
    }
}
