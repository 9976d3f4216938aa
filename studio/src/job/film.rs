//! Films.

use super::picture::{Picture, Sitter};
use super::{Analysed, Listener};
use crate::failure::Failure;
use crate::motion::{Drive, Paths, Span};
use crate::output::OutputKind;
use mech_runtime::files::{AnimatedSvg, Apng, Gif};
use mech_runtime::{HeapFrame, HeapSmooth};
use std::f64::consts::PI;
use std::time::Duration;

/// A film of a mechanism while one of its motors moves.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Film {
    pub(crate) picture: Picture,
    pub(crate) kind: FilmKind,
    /// The motor that moves; without, the first, or all by their laws.
    pub(crate) motor: Option<String>,
    /// Where it begins, and where it ends or turns back.
    pub(crate) span: Span,
    pub(crate) seconds: u32,
    /// The number of frames in a second. Moving SVG has no frames.
    pub(crate) rate: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum FilmKind {
    Gif,
    Apng,
    Svg,
}

impl FilmKind {
    pub(crate) const fn file(self) -> OutputKind {
        match self {
            Self::Gif => OutputKind::Gif,
            Self::Apng => OutputKind::Png,
            Self::Svg => OutputKind::Svg,
        }
    }
}

/// The moments of an SVG that moves.
const MOMENTS: u32 = 720;

impl Film {
    /// The default duration, in seconds.
    pub(crate) const SECONDS: u32 = 4;
    /// The default number of frames in a second.
    pub(crate) const RATE: u32 = 25;

    /// A film of the motion that the mechanism makes if nobody says which.
    #[cfg(feature = "editor")]
    pub(crate) fn of_kind(kind: FilmKind) -> Self {
        Self {
            picture: Picture::default(),
            kind,
            motor: None,
            span: Span::default(),
            seconds: Self::SECONDS,
            rate: Self::RATE,
        }
    }

    pub(super) fn run(
        &self,
        analysed: Analysed,
        listener: &mut dyn Listener,
    ) -> Result<Vec<u8>, Failure> {
        let sitter = self.picture.sitter(analysed, None);
        let Analysed { model, compiled } = &sitter.analysed;
        let motor = self.motor.as_deref();
        let drive = Drive::new(model, compiled, motor, self.span, &self.picture.at)?;
        let drive = if self.span.to.is_none() {
            drive.completed(model, compiled)
        } else {
            drive
        };
        if let Some([from, to]) = drive.open_times().filter(|_| self.span.to.is_none()) {
            listener.note(&format!(
                "no time is known after which all is back: the film is from t = {from} to {to}; say others by `--from` and `--to`"
            ));
        }
        let frames = self.seconds * self.rate;
        drive.attempt(|drive| {
            let mut shoot = Shoot {
                sitter: &sitter,
                is_cyclic: drive.is_cyclic(model),
                drive: drive.clone(),
                listener: &mut *listener,
            };
            match self.kind {
                FilmKind::Gif => self.gif(&mut shoot, frames),
                FilmKind::Apng => self.apng(&mut shoot, frames),
                FilmKind::Svg => self.svg(&mut shoot),
            }
        })
    }

    fn gif(&self, shoot: &mut Shoot<'_>, frames: u32) -> Result<Vec<u8>, Failure> {
        let sitter = shoot.sitter;
        let [width, height] = sitter.size;
        let mut frame = HeapFrame::new(width, height)?;
        frame.set_palette(sitter.palette.clone());
        frame.look_at(sitter.painting.view(sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Gif<&mut Vec<u8>>> = None;
        shoot.run(frames, |poses, paths| {
            frame.clear();
            sitter.painting.paint(poses, paths, &mut frame);
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

    fn apng(&self, shoot: &mut Shoot<'_>, frames: u32) -> Result<Vec<u8>, Failure> {
        let sitter = shoot.sitter;
        let [width, height] = sitter.size;
        let mut picture = HeapSmooth::new(width, height)?;
        picture.set_palette(sitter.palette.clone());
        picture.look_at(sitter.painting.view(sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Apng<&mut Vec<u8>>> = None;
        shoot.run(frames, |poses, paths| {
            picture.clear();
            sitter.painting.paint(poses, paths, &mut picture);
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

    fn svg(&self, shoot: &mut Shoot<'_>) -> Result<Vec<u8>, Failure> {
        let sitter = shoot.sitter;
        let period = Duration::from_secs(self.seconds.into());
        let mut svg = AnimatedSvg::new(sitter.sheet.clone(), period);
        shoot.run(MOMENTS, |poses, paths| {
            svg.add(|canvas| sitter.painting.paint(poses, paths, canvas));
            Ok(())
        })?;
        Ok(svg.finish().into_bytes())
    }

    /// Returns the time for which a frame is shown.
    fn delay(&self) -> Duration {
        Duration::from_secs(1) / self.rate
    }
}

/// A mechanism and its motion, which is filmed.
struct Shoot<'s> {
    sitter: &'s Sitter,
    drive: Drive,
    is_cyclic: bool,
    listener: &'s mut dyn Listener,
}

impl Shoot<'_> {
    /// Shows so many frames, one after the other. The mechanism makes the motion once before, so that its traces are complete.
    fn run(
        &mut self,
        frames: u32,
        mut show: impl FnMut(&[[f64; 4]], &Paths) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Analysed { model, compiled } = &self.sitter.analysed;
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
        for (done, poses) in (1..).zip(&poses) {
            mech_compiler::cancel::check();
            paths.record(poses);
            show(poses, &paths)?;
            self.listener.progress(done, frames);
        }
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
