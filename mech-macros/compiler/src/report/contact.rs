//! What is told of cams with rollers: pressure angles, the sharpest curve, undercut discs.

use crate::compiled::Compiled;
use crate::model::{JointId, Model};
use crate::program::{CamContact, CamNumbers};
use std::f64::consts::TAU;

/// Angles of the shaft at which a contact is looked at, before the worst is sought between two of them.
const SAMPLES: u32 = 720;
/// Rounds of that search.
const ROUNDS: u32 = 60;
/// A step inwards from an end: as much as keeps the longer part in proportion.
const GOLDEN: f64 = 0.381_966_011_250_105;

/// A cam over a whole turn of its shaft: the worst of what is asked for, and where.
struct Turn {
    radius: f64,
    pressure: (f64, f64),
    curvature: (f64, f64),
}

impl Turn {
    fn of(model: &Model, compiled: &Compiled, cam: JointId) -> Option<Self> {
        let (.., law) = model.cams().find(|(one, ..)| *one == cam)?;
        // Of a law that is another in each turn nobody knows the worst.
        law.winding()?;
        let contact = CamContact::new(model, &compiled.program, cam)?;
        Some(Self {
            radius: contact.radius,
            pressure: greatest(&contact, |numbers| numbers.pressure)?,
            curvature: greatest(&contact, |numbers| numbers.curvature)?,
        })
    }

    /// The least radius of the disc where it is convex; not positive where it is undercut.
    fn of_disc(&self) -> Option<f64> {
        let curvature = self.curvature.1;
        (curvature > 0.0).then(|| 1.0 / curvature - self.radius)
    }
}

/// Where a number is greatest in a turn, and how great.
fn greatest(contact: &CamContact, number: fn(CamNumbers) -> f64) -> Option<(f64, f64)> {
    let at = |angle: f64| number(contact.at(angle));
    let step = TAU / f64::from(SAMPLES);
    let angles = (0..SAMPLES).map(|sample| f64::from(sample) * step);
    let samples = angles.map(|angle| (angle, at(angle)));
    let samples = samples.filter(|(_, value)| value.is_finite());
    let (angle, value) = samples.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    let (mut low, mut high) = (angle - step, angle + step);
    for _ in 0..ROUNDS {
        let inwards = GOLDEN * (high - low);
        if at(low + inwards) > at(high - inwards) {
            high -= inwards;
        } else {
            low += inwards;
        }
    }
    let middle = 0.5 * (low + high);
    let best = at(middle);
    Some(if best > value {
        (middle, best)
    } else {
        (angle, value)
    })
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
    if let Some(radius) = turn.of_disc().filter(|radius| *radius > 0.0) {
        text += &format!(
            "; radius of the disc at least {radius:.4} at q = {}",
            degrees(turn.curvature.0)
        );
    }
    Some(text)
}

/// Returns the notes on discs that are undercut.
pub(super) fn notes(model: &Model, compiled: &Compiled) -> Vec<String> {
    let notes = model.rollers.iter().filter_map(|roller| {
        let turn = Turn::of(model, compiled, roller.cam)?;
        turn.of_disc().filter(|radius| *radius <= 0.0)?;
        let (at, curvature) = turn.curvature;
        Some(format!(
            "the disc of cam `{}` is undercut at q = {}: the roller, of radius {}, runs on a curve of radius {:.4} there",
            model.joint(roller.cam).name,
            degrees(at),
            turn.radius,
            1.0 / curvature
        ))
    });
    notes.collect()
}
