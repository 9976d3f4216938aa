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
        let Analysed { model, compiled } = &analysed;
        let motor = self.motor.as_deref();
        let drive = Drive::new(model, compiled, motor, self.span, &self.picture.at)?;
        let drive = if self.span.to.is_none() { drive.completed(model, compiled) } else { drive };
        if let Some([from, to]) = drive.open_times().filter(|_| self.span.to.is_none()) {
            listener.note(&format!(
                "no time is known after which all is back: the film is from t = {from} to {to}; say others by `--from` and `--to`"
            ));
        }
        let parts = self.parts(drive.is_cyclic(model));
        let sitter = self.picture.sitter(analysed, Some([&drive; 2]), &parts)?;
        drive.attempt(|drive| {
            let mut shoot =
                Shoot { sitter: &sitter, drive, parts: &parts, listener: &mut *listener };
            match self.kind {
                FilmKind::Gif => self.gif(&mut shoot),
                FilmKind::Apng => self.apng(&mut shoot),
                FilmKind::Svg => self.svg(&mut shoot),
            }
        })
    }

    /// The parts of the motion that the frames show, one after the other: what does not come round goes to and fro.
    fn parts(&self, is_cyclic: bool) -> Vec<f64> {
        let frames = match self.kind {
            FilmKind::Svg => MOMENTS,
            FilmKind::Gif | FilmKind::Apng => self.seconds * self.rate,
        };
        let parts = (0..frames).map(|number| {
            let time = f64::from(number) / f64::from(frames);
            if is_cyclic { time } else { 0.5 - 0.5 * (2.0 * PI * time).cos() }
        });
        parts.collect()
    }

    fn gif(&self, shoot: &mut Shoot<'_>) -> Result<Vec<u8>, Failure> {
        let sitter = shoot.sitter;
        let [width, height] = sitter.size;
        let mut frame = HeapFrame::new(width, height)?;
        frame.set_palette(sitter.palette.clone());
        frame.look_at(sitter.painting.view(sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Gif<&mut Vec<u8>>> = None;
        shoot.run(|number, poses, paths| {
            frame.clear();
            sitter.painting.paint(poses, paths, &mut frame);
            sitter.board.paint(number, &mut frame);
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

    fn apng(&self, shoot: &mut Shoot<'_>) -> Result<Vec<u8>, Failure> {
        let sitter = shoot.sitter;
        let [width, height] = sitter.size;
        let mut picture = HeapSmooth::new(width, height)?;
        picture.set_palette(sitter.palette.clone());
        picture.look_at(sitter.painting.view(sitter.size));
        let mut bytes = Vec::new();
        let mut sink = Some(&mut bytes);
        let mut file: Option<Apng<&mut Vec<u8>>> = None;
        let frames = self.seconds * self.rate;
        shoot.run(|number, poses, paths| {
            picture.clear();
            sitter.painting.paint(poses, paths, &mut picture);
            sitter.board.paint(number, &mut picture);
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
        shoot.run(|number, poses, paths| {
            svg.add(|canvas| {
                sitter.painting.paint(poses, paths, canvas);
                sitter.board.paint(number, canvas);
            });
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
    drive: &'s Drive,
    parts: &'s [f64],
    listener: &'s mut dyn Listener,
}

impl Shoot<'_> {
    /// Shows its frames, one after the other. The mechanism makes the motion once before, so that its traces are complete.
    fn run(
        &mut self,
        mut show: impl FnMut(usize, &[[f64; 4]], &Paths) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let Analysed { model, compiled } = &self.sitter.analysed;
        let mut poses = vec![Vec::new(); self.parts.len()];
        self.drive.visit(model, compiled, self.parts, |number, at| {
            poses[number].clone_from(&at.poses);
            Ok(())
        })?;
        let mut paths = Paths::new(model, compiled)?;
        if !paths.is_empty() {
            for poses in &poses {
                paths.record(poses);
            }
        }
        let frames = u32::try_from(poses.len()).unwrap_or(u32::MAX);
        for ((number, poses), done) in poses.iter().enumerate().zip(1..) {
            mech_compiler::cancel::check();
            paths.record(poses);
            show(number, poses, &paths)?;
            self.listener.progress(done, frames);
        }
        Ok(())
    }
}
