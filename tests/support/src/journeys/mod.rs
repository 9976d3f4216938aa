//! Journeys of random mechanisms, held against the judge.

mod subject;
mod trial;

pub use subject::{Judged, Subject, Track, apart, off};

use crate::sketch::Sketch;
use crate::{Dice, grow_wild, symmetric, text};
use mech_compiler::evaluate::Machine;
use mech_compiler::model::Precision;
use mech_compiler::program::Real;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;
use trial::{Line, Trial, motors};

/// What is done with a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Small steps over two turns to both sides.
    Steps,
    /// Long moves.
    Leaps,
    /// Moves and tiny moves that stop at crossings, and before and behind them.
    Stops,
}

/// Which mechanisms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Family {
    /// Four-bars with equal pairs and what hangs on them.
    Symmetric,
    /// Equal cranks under a rail.
    Rows,
    /// Trains of gears, guides and four-bars.
    Fast,
    /// Anything.
    Generic,
    /// Anything with racks, cams and what nearly is a parallelogram, in any place or on a lattice.
    Wild,
    /// The same with loops that wait for each other.
    Coupled,
    /// This text, in random journeys.
    Text(String),
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Symmetric, Self::Rows, Self::Fast, Self::Generic, Self::Wild, Self::Coupled];

    /// The text of one of them.
    #[must_use]
    pub fn text(&self, dice: &mut Dice, single: bool) -> String {
        let mut sketch: Sketch = match self {
            Self::Symmetric => symmetric::symmetric(dice),
            Self::Rows => symmetric::row(dice),
            Self::Fast => symmetric::fast(dice),
            Self::Generic => symmetric::generic(dice),
            Self::Wild | Self::Coupled => {
                let mut model = grow_wild(dice, *self == Self::Coupled).model;
                if single {
                    model.precision = Precision::F32;
                }
                return text(&model);
            }
            Self::Text(text) => return text.clone(),
        };
        sketch.single = single;
        sketch.text(dice)
    }
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fault {
    /// On another branch.
    Elsewhere,
    /// Not quite where the judge is.
    Off,
    /// A pin is torn.
    Torn,
    /// A link jumps in a small step.
    Jumped,
    /// It stops where the judge goes on.
    StopsEarly,
    /// It arrives where the judge stops.
    Passes,
    /// The judge does not know.
    Unknown,
}

/// All that was found in a family.
#[derive(Debug, Default)]
pub struct Tally {
    /// How many mechanisms.
    pub mechanisms: usize,
    /// How many did not compile.
    pub refused: usize,
    /// How many moves.
    pub moves: usize,
    /// How often each fault was found, and in how many mechanisms.
    pub faults: BTreeMap<Fault, [usize; 2]>,
    /// Some of them as text.
    pub examples: BTreeMap<Fault, Vec<String>>,
    /// Why the judge gave up.
    pub reasons: BTreeMap<String, usize>,
}

/// Tries so many mechanisms of a family.
///
/// # Panics
/// If a text that was made is none of a mechanism.
#[must_use]
pub fn tally(
    kind: Kind,
    family: &Family,
    seeds: Range<u64>,
    single: bool,
    examples: usize,
) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let mut dice = Dice::new(seed);
        let text = family.text(&mut dice, single);
        let subject = match Subject::read(&text) {
            Ok(subject) => subject,
            Err(why) => {
                assert!(!why.starts_with("no text"), "{why}\n{text}");
                tally.refused += 1;
                continue;
            }
        };
        tally.mechanisms += 1;
        let found = if single {
            journeys::<f32>(kind, &subject, &mut dice, &mut tally)
        } else {
            journeys::<f64>(kind, &subject, &mut dice, &mut tally)
        };
        let mut seen = Vec::new();
        for (fault, what) in found {
            let count = tally.faults.entry(fault).or_default();
            count[0] += 1;
            if !seen.contains(&fault) {
                count[1] += 1;
                seen.push(fault);
                let all = tally.examples.entry(fault).or_default();
                if all.len() < examples {
                    all.push(format!("seed {seed}: {what}\n{text}"));
                }
            }
        }
    }
    tally
}

fn journeys<T: Real>(
    kind: Kind,
    subject: &Subject,
    dice: &mut Dice,
    tally: &mut Tally,
) -> Vec<(Fault, String)> {
    let judge = subject.judge();
    let mut machine = Machine::<T>::new(&subject.compiled.program);
    let mut trial = Trial::new(subject, &judge);
    let start = motors(&machine);
    let gap = judge.gap(&judge.start(), &start);
    if gap > if trial.is_single() { 1e-3 } else { 1e-7 } {
        trial.find(Fault::Torn, format!("it is torn by {gap:.1e} of a link where it starts"));
        return trial.found;
    }
    if start.len() > 1 {
        trial.several(&mut machine, dice);
    } else {
        let reach = if subject.slides(0) { 2.0 * crate::size(&subject.model) } else { 2.5 * TAU };
        let line = Line::new(&judge, start[0], reach);
        if let Some(why) = line.track.gave_up() {
            *tally.reasons.entry(why.to_owned()).or_default() += 1;
        }
        match kind {
            Kind::Steps => trial.steps(&line, &mut machine),
            Kind::Leaps => trial.leaps(&line, &mut machine, dice),
            Kind::Stops => trial.stops(&line, &mut machine, dice),
        }
    }
    tally.moves += trial.moves;
    trial.found
}

/// What is wrong with moves to these targets: each from where the one before ended, if they are in a row, or else from the start.
#[must_use]
pub fn faults(subject: &Subject, targets: &[Vec<f64>], in_a_row: bool) -> Vec<(Fault, String)> {
    let judge = subject.judge();
    let mut machine = Machine::<f64>::new(&subject.compiled.program);
    let begin = machine.position().clone();
    let start = &begin.motors;
    let far = targets.iter().map(|to| (to[0] - start[0]).abs());
    let reach = far.fold(0.0, f64::max);
    let line = (start.len() == 1).then(|| Line::new(&judge, start[0], reach));
    let mut trial = Trial::new(subject, &judge);
    let (mut place, mut path, mut paths) = (judge.start(), Vec::new(), Vec::new());
    for to in targets {
        let next = match &line {
            Some(line) => trial.judged(line, &mut machine, to[0], &mut path).then(|| place.clone()),
            None => trial.leap(&mut machine, &place, to, &mut paths),
        };
        if let Some(next) = next.filter(|_| in_a_row) {
            place = next;
        } else {
            machine.put_back(begin.clone());
            place = judge.start();
            path.clear();
            paths.clear();
        }
    }
    trial.found
}
