//! The values of a motor for which a requirement does not hold, as far as samples show: for pictures, not for proofs.

use super::details::details;
use super::proof::Case;
use super::with_plain;
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{Condition, Measured, Model, MotorId, RequiredBound, Requirement};
use crate::program::{Gauge, Position, Program, Value, computing};

/// So many places are sampled on each way.
const PLACES: u32 = 360;

/// A margin below zero by no more than this part of the mechanism, or of a radian, is rounding.
const ROUNDING: f64 = 1e-9;

/// The values of a motor between these ends for which a requirement does not hold while the other motors stand at a place: intervals, in
/// ascending order. None of what sums up the motion, as that holds everywhere or nowhere.
#[must_use]
pub fn failing(
    model: &Model,
    compiled: &Compiled,
    requirement: &Requirement,
    (motor, ends): (MotorId, [f64; 2]),
    place: &[(MotorId, f64)],
) -> Vec<[f64; 2]> {
    let Condition::Bounds { bounds, .. } = &requirement.condition else {
        return Vec::new();
    };
    let is_summary = |measured: &Measured| matches!(measured, Measured::Summary(..));
    if requirement.measured.iter().any(is_summary) {
        return Vec::new();
    }
    with_plain(model, compiled, |model, compiled| {
        let details = details(model, compiled, requirement).into_iter();
        let gauges = details.filter_map(|detail| {
            let case = Case {
                model,
                compiled,
                requirement,
                detail,
            };
            case.gauge()
        });
        let gauges: Vec<Gauge> = gauges.collect();
        let program = &compiled.program;
        let rounding = ROUNDING * model.size().max(1.0);
        let start = &program.start.motors;
        let mut from = start.clone();
        for (other, value) in place {
            from[other.index()] = *value;
        }
        let number = motor.index();
        from[number] = start[number].clamp(ends[0], ends[1]);
        let mut samples = Vec::new();
        for end in ends {
            let mut machine = Machine::<f64>::new(program);
            let own = program.state.len();
            let meters = gauges.iter().map(|gauge| Meter::new(gauge, own, bounds));
            let mut meters: Vec<Meter<'_>> = meters.collect();
            let mut breaks = |motors: &[f64]| {
                machine.move_to(motors).ok()?;
                let at = machine.position();
                let least = meters.iter_mut().filter_map(|meter| meter.least(at));
                Some(least.fold(f64::INFINITY, f64::min) < -rounding)
            };
            let mut to = from.clone();
            to[number] = end;
            // Angles over whole turns are followed from the start.
            if !way(start, &from).all(|motors| breaks(&motors).is_some()) {
                continue;
            }
            let half = 0.5 * (end - from[number]).abs() / f64::from(PLACES);
            for motors in way(&from, &to) {
                match breaks(&motors) {
                    Some(true) => samples.push((motors[number], half)),
                    Some(false) => {}
                    None => break,
                }
            }
        }
        joined(samples, ends)
    })
}

/// Places on the straight way from one to another.
fn way(from: &[f64], to: &[f64]) -> impl Iterator<Item = Vec<f64>> {
    let parts = (0..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
    parts.map(move |part| {
        let motors = from.iter().zip(to);
        let motors = motors.map(|(from, to)| from + (to - from) * part);
        motors.collect()
    })
}

/// Samples as intervals: each with what is nearer to it than to the next one.
fn joined(mut samples: Vec<(f64, f64)>, ends: [f64; 2]) -> Vec<[f64; 2]> {
    samples.sort_unstable_by(|(a, _), (b, _)| a.total_cmp(b));
    let mut intervals: Vec<[f64; 2]> = Vec::new();
    for (value, half) in samples {
        let [low, high] = [value - half, value + half].map(|end| end.clamp(ends[0], ends[1]));
        match intervals.last_mut() {
            Some(last) if low <= last[1] + half => last[1] = high,
            _ => intervals.push([low, high]),
        }
    }
    intervals
}

/// What a requirement measures, on the way.
struct Meter<'g> {
    gauge: &'g Gauge,
    program: Program,
    /// The margins of its bounds, and then how far angles over whole turns are from their references.
    wanted: Vec<Value>,
    margins: usize,
    /// The states in which references of angles are, and what these are.
    references: Vec<(usize, f64)>,
}

impl<'g> Meter<'g> {
    /// Of a gauge with so many states before it measured anything.
    fn new(gauge: &'g Gauge, own: usize, bounds: &[RequiredBound]) -> Self {
        let margins = bounds.iter();
        let margins = margins.map(|bound| gauge.formulas[bound.margin.index()]);
        let mut wanted: Vec<Value> = margins.collect();
        let margins = wanted.len();
        let state = &gauge.program.start.state;
        // The program itself follows the others.
        let angles = gauge.angles.iter();
        let angles: Vec<_> = angles.filter(|angle| angle.reference >= own).collect();
        wanted.extend(angles.iter().map(|angle| angle.beyond));
        let references = angles.iter();
        let references = references.map(|angle| (angle.reference, state[angle.reference]));
        Self {
            program: computing(
                &gauge.program,
                &[&wanted, &gauge.program.state[..]].concat(),
            ),
            references: references.collect(),
            gauge,
            wanted,
            margins,
        }
    }

    /// The least margin at the next position on the way; none where it is not known.
    fn least(&mut self, position: &Position<f64>) -> Option<f64> {
        let mut whole = position.clone();
        whole.state.clone_from(&self.gauge.program.start.state);
        whole.state[..position.state.len()].copy_from_slice(&position.state);
        for (state, reference) in &self.references {
            whole.state[*state] = *reference;
        }
        let mut machine = Machine::<f64>::new(&self.program);
        machine.put_back(whole);
        let measured = machine.look_at(&position.motors, &self.wanted)?;
        let (margins, beyond) = measured.split_at(self.margins);
        for ((_, reference), beyond) in self.references.iter_mut().zip(beyond) {
            *reference += beyond;
        }
        margins.iter().copied().reduce(f64::min)
    }
}
