//! Errors and times of one mechanism.

use crate::contestant::{Block, Contestant};
use crate::method::{Method, Precision};
use crate::reference::Reference;
use crate::subject::Subject;

/// The motor's steps, in tenths of a degree.
pub(crate) const STEPS: [Step; 3] = [Step(1), Step(10), Step(50)];

/// A motor's step, in tenths of a degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step(u16);

impl Step {
    /// The step in degrees.
    pub(crate) fn degrees(self) -> f64 {
        f64::from(self.0) / 10.0
    }
}

/// The extent of the measurement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    /// Rounds in which every contestant has its turn.
    pub(crate) rounds: u32,
    /// The least number of positions in a turn.
    pub(crate) positions: usize,
}

/// The measurement of a mechanism.
pub(crate) struct Measurement {
    /// The mechanism.
    pub(crate) subject: Subject,
    /// The greatest distance between two of its axes at the start, in scene units.
    pub(crate) size: f64,
    /// One row for each method, precision and step.
    pub(crate) rows: Vec<Row>,
}

/// A method in a precision at a step.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// The method.
    pub(crate) method: Method,
    /// The precision.
    pub(crate) precision: Precision,
    /// The step of the motor.
    pub(crate) step: Step,
    /// The cost and the error, or the place where it was blocked.
    pub(crate) outcome: Result<Figures, Stuck>,
}

/// The cost and the error of a method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Figures {
    /// The worst error of any axis in any position, in scene units.
    pub(crate) error: f64,
    /// The time of a position, in nanoseconds.
    pub(crate) nanoseconds: f64,
}

/// The place where a method was blocked.
#[derive(Clone, Debug)]
pub(crate) struct Stuck {
    /// The loop.
    pub(crate) place: &'static str,
    /// The target of the motor, relative to the start, in degrees.
    pub(crate) degrees: f64,
    /// The error of the mechanism.
    pub(crate) words: String,
}

/// A contestant at a step that is not blocked.
struct Entry {
    row: usize,
    contestant: Contestant,
    values: Vec<f64>,
    sweeps: u32,
    times: Vec<f64>,
}

/// Measures a mechanism.
///
/// # Errors
/// The messages of the compiler about the reference.
pub(crate) fn measure(subject: Subject, effort: Effort) -> Result<Measurement, String> {
    let reference = Reference::new(subject.text)?;
    let mut rows = Vec::new();
    let mut entries = Vec::new();
    for step in STEPS {
        let degrees = there_and_back(subject.travel, step);
        for precision in [Precision::Single, Precision::Double] {
            let values = degrees.iter().map(|degrees| {
                let value = reference.start + degrees.to_radians();
                precision.round(value)
            });
            let values: Vec<f64> = values.collect();
            let truth = reference.trace(&values)?;
            let contestants = subject.contestants.iter();
            for &contestant in contestants.filter(|one| one.precision == precision) {
                let outcome = match contestant.trace(&values) {
                    Ok(trace) => {
                        entries.push(Entry {
                            row: rows.len(),
                            contestant,
                            values: values.clone(),
                            sweeps: sweeps(effort.positions, values.len()),
                            times: Vec::new(),
                        });
                        Ok(Figures { error: reference.error(&trace, &truth), nanoseconds: 0.0 })
                    }
                    Err(Block { place, position, words }) => {
                        Err(Stuck { place, degrees: degrees[position], words })
                    }
                };
                rows.push(Row { method: contestant.method, precision, step, outcome });
            }
        }
    }
    // In turn, because a machine's speed drifts.
    for _ in 0..effort.rounds {
        for entry in &mut entries {
            let time = entry.contestant.time(&entry.values, entry.sweeps);
            entry.times.push(time);
        }
    }
    for entry in entries {
        if let Ok(figures) = &mut rows[entry.row].outcome {
            figures.nanoseconds = median(entry.times);
        }
    }
    Ok(Measurement { size: reference.size, subject, rows })
}

/// The motor's targets from the start to its limit and back, in degrees.
fn there_and_back(travel: u16, Step(tenths): Step) -> Vec<f64> {
    let steps = travel * 10 / tenths;
    let values = (1..=steps).chain((0..steps).rev());
    values.map(|step| f64::from(step * tenths) / 10.0).collect()
}

/// The number of sweeps there and back for so many positions.
fn sweeps(positions: usize, values: usize) -> u32 {
    u32::try_from(positions.div_ceil(values.max(1))).unwrap_or(u32::MAX)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
