//! What is told of cams with rollers: pressure angles, the sharpest curve, undercut discs.

use crate::compiled::Compiled;
use crate::model::{JointId, Model};
use crate::program::{CamContact, CamNumbers};
use std::f64::consts::TAU;

/// Angles of the shaft at which a contact is looked at, before the worst is sought between two of them.
const SAMPLES: u32 = 7200;
/// Of so many of these the neighbourhood is searched.
const PEAKS: usize = 8;
/// Rounds of that search.
const ROUNDS: u32 = 60;
/// A step inwards from an end: as much as keeps the longer part in proportion.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// A cam over a whole turn of its shaft: the worst of what is asked for, and where.
struct Turn {
    radius: f64,
    pressure: (f64, f64),
    /// None where the law's rate jumps: there the disc has a corner.
    curvature: Option<(f64, f64)>,
}

impl Turn {
    fn of(model: &Model, compiled: &Compiled, cam: JointId) -> Option<Self> {
        let (.., law) = model.cams().find(|(one, ..)| *one == cam)?;
        // Of a law that goes on over its turns nobody knows the worst.
        law.winding().filter(|winding| *winding == 0.0)?;
        let contact = CamContact::new(model, &compiled.program, cam)?;
        let params: Vec<f64> = model.params.values().collect();
        let step = TAU / f64::from(SAMPLES);
        let angles = (0..SAMPLES).map(|sample| f64::from(sample) * step);
        let samples: Vec<CamNumbers> = angles.map(|angle| contact.at(angle)).collect();
        let greatest =
            |number: fn(CamNumbers) -> f64| greatest(&samples, step, number, |at| contact.at(at));
        let is_smooth = law.first_jump_in_turn(&params, false).is_none();
        Some(Self {
            radius: contact.radius,
            pressure: greatest(|numbers| numbers.pressure)?,
            curvature: is_smooth.then(|| greatest(|numbers| numbers.curvature)).flatten(),
        })
    }

    /// The least radius of the disc where it is convex; not positive where it is undercut.
    fn of_disc(&self) -> Option<(f64, f64)> {
        let (at, curvature) = self.curvature?;
        (curvature > 0.0).then(|| (at, 1.0 / curvature - self.radius))
    }
}

/// Where a number is greatest in a turn, and how great: about the greatest of its samples.
fn greatest(
    samples: &[CamNumbers],
    step: f64,
    number: fn(CamNumbers) -> f64,
    at: impl Fn(f64) -> CamNumbers,
) -> Option<(f64, f64)> {
    let value = |index: usize| number(samples[index % samples.len()]);
    let count = samples.len();
    let is_peak = |index: &usize| {
        let own = value(*index);
        own.is_finite() && own >= value(index + count - 1) && own >= value(index + 1)
    };
    let mut peaks: Vec<usize> = (0..count).filter(is_peak).collect();
    peaks.sort_by(|a, b| value(*b).total_cmp(&value(*a)));
    peaks.truncate(PEAKS);
    let found = peaks.into_iter().map(|index| {
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let angle = index as f64 * step;
        let (mut low, mut high) = (angle - step, angle + step);
        for _ in 0..ROUNDS {
            let inwards = GOLDEN * (high - low);
            if number(at(low + inwards)) > number(at(high - inwards)) {
                high -= inwards;
            } else {
                low += inwards;
            }
        }
        let middle = 0.5 * (low + high);
        let best = number(at(middle));
        if best > value(index) { (middle, best) } else { (angle, value(index)) }
    });
    found.max_by(|(_, a), (_, b)| a.total_cmp(b))
}

fn degrees(angle: f64) -> String {
    format!("{:.2} deg", angle.rem_euclid(TAU).to_degrees())
}

/// The line about the contact of a cam; none if its roller is not declared.
pub(super) fn line(model: &Model, compiled: &Compiled, cam: JointId) -> Option<String> {
    let turn = Turn::of(model, compiled, cam)?;
    let (at, pressure) = turn.pressure;
    let mut text = format!(
        "pressure angle of `{}` at most {} at q = {}",
        model.joint(cam).name,
        degrees(pressure),
        degrees(at)
    );
    if let Some((at, radius)) = turn.of_disc().filter(|(_, radius)| *radius > 0.0) {
        text += &format!("; radius of the disc at least {radius:.4} at q = {}", degrees(at));
    }
    Some(text)
}

/// Returns the notes on discs that are undercut.
pub(super) fn notes(model: &Model, compiled: &Compiled) -> Vec<String> {
    let notes = model.rollers.iter().filter_map(|roller| {
        let turn = Turn::of(model, compiled, roller.cam)?;
        let (at, radius) = turn.of_disc().filter(|(_, radius)| *radius <= 0.0)?;
        Some(format!(
            "the disc of cam `{}` is undercut at q = {}: the roller, of radius {}, runs on a curve of radius {:.4} there",
            model.joint(roller.cam).name,
            degrees(at),
            turn.radius,
            radius + turn.radius
        ))
    });
    notes.collect()
}
