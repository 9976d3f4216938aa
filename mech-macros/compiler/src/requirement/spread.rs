//! The values of a motor for which a requirement does not hold, as far as samples show: for pictures, not for proofs.

use super::Verdicts;
use super::case::Case;
use super::circumstances::Setting;
use super::details::details;
use super::sides::Ways;
use super::with_plain;
use crate::compiled::Compiled;
use crate::evaluate::Machine;
use crate::model::{Condition, Measured, Model, MotorId, RequiredBound, Requirement};
use crate::program::{Gauge, Position, Program, Value, computing};

/// So many places are sampled on each way; fewer if more than this many details are measured at each.
const PLACES: usize = 360;
const MANY: usize = 16;

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
        // At each value of a motor another time would be.
        let setting = match Setting::of(model, compiled, requirement) {
            Ok(setting) if setting.timed().is_none() => setting,
            _ => return Vec::new(),
        };
        let verdicts = Verdicts::new(&compiled.program);
        let ways = Ways::new(&compiled.program);
        let details = details(model, compiled, requirement);
        let places = PLACES * MANY / details.len().max(MANY);
        let gauges = details.into_iter().filter_map(|detail| {
            let case = Case {
                model,
                compiled,
                verdicts: &verdicts,
                ways: &ways,
                requirement,
                setting: &setting,
                detail,
            };
            case.gauge().ok()
        });
        let program = &compiled.program;
        let wanted = gauges.map(|gauge| Wanted::new(&gauge, program.state.len(), bounds));
        let wanted: Vec<Wanted> = wanted.collect();
        let rounding = ROUNDING * model.size().max(1.0);
        let start = &program.start.motors;
        let mut from = start.clone();
        for (other, value) in place {
            from[other.index()] = *value;
        }
        let number = motor.index();
        from[number] = start[number].max(ends[0]).min(ends[1]);
        let mut samples = Vec::new();
        for end in ends {
            let mut machine = Machine::<f64>::new(program);
            let mut meters: Vec<Meter<'_>> = wanted.iter().map(Meter::new).collect();
            let mut breaks = |motors: &[f64]| {
                machine.move_to(motors).ok()?;
                let at = machine.position();
                let least = meters.iter_mut().filter_map(|meter| meter.least(at));
                Some(least.fold(f64::INFINITY, f64::min) < -rounding)
            };
            let mut to = from.clone();
            to[number] = end;
            // Angles over whole turns are followed from the start.
            if from != *start
                && !places_between(start, &from, places).all(|motors| breaks(&motors).is_some())
            {
                continue;
            }
            let half = 0.5 * (end - from[number]).abs() * part_of(1, places);
            for motors in places_between(&from, &to, places) {
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

/// The part of a way at a place of so many.
#[expect(clippy::cast_precision_loss, reason = "a few hundred")]
fn part_of(place: usize, places: usize) -> f64 {
    place as f64 / places.max(1) as f64
}

/// So many places on the straight way from one to another.
fn places_between(from: &[f64], to: &[f64], places: usize) -> impl Iterator<Item = Vec<f64>> {
    let parts = (0..=places).map(move |place| part_of(place, places));
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
        let [low, high] = [value - half, value + half].map(|end| end.max(ends[0]).min(ends[1]));
        match intervals.last_mut() {
            Some(last) if low <= last[1] + half => last[1] = high,
            _ => intervals.push([low, high]),
        }
    }
    intervals
}

/// What a requirement measures.
struct Wanted {
    program: Program,
    /// The margins of its bounds, and then how far angles over whole turns are from their references.
    values: Vec<Value>,
    margins: usize,
    /// The states in which references of angles are.
    references: Vec<usize>,
}

impl Wanted {
    /// Of a gauge with so many states before it measured anything.
    fn new(gauge: &Gauge, own: usize, bounds: &[RequiredBound]) -> Self {
        let margins = bounds.iter();
        let margins = margins.map(|bound| gauge.formulas[bound.margin.index()]);
        let mut values: Vec<Value> = margins.collect();
        let margins = values.len();
        // The program itself follows the others.
        let angles = gauge.angles.iter().filter(|angle| angle.reference >= own);
        let (references, beyond): (Vec<usize>, Vec<Value>) =
            angles.map(|angle| (angle.reference, angle.beyond)).unzip();
        values.extend(beyond);
        Self {
            program: computing(&gauge.program, &[&values, &gauge.program.state[..]].concat()),
            values,
            margins,
            references,
        }
    }
}

/// It is measured, from place to place on a way.
struct Meter<'w> {
    wanted: &'w Wanted,
    machine: Machine<'w, f64>,
    /// The references of angles.
    references: Vec<f64>,
}

impl<'w> Meter<'w> {
    fn new(wanted: &'w Wanted) -> Self {
        let state = &wanted.program.start.state;
        let references = wanted.references.iter();
        Self {
            machine: Machine::new(&wanted.program),
            references: references.map(|reference| state[*reference]).collect(),
            wanted,
        }
    }

    /// The least margin at the next position on the way; none where it is not known.
    fn least(&mut self, position: &Position<f64>) -> Option<f64> {
        let Wanted { program, values, margins, references } = self.wanted;
        let mut whole = position.clone();
        whole.state.clone_from(&program.start.state);
        whole.state[..position.state.len()].copy_from_slice(&position.state);
        for (state, reference) in references.iter().zip(&self.references) {
            whole.state[*state] = *reference;
        }
        self.machine.put_back(whole);
        let measured = self.machine.look_at(&position.motors, values)?;
        let (margins, beyond) = measured.split_at(*margins);
        for (reference, beyond) in self.references.iter_mut().zip(beyond) {
            *reference += beyond;
        }
        margins.iter().copied().reduce(f64::min)
    }
}
