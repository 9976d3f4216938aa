//! Journeys of random mechanisms, held against the judge.

mod subject;

pub use subject::{Judged, Subject, Track, apart};

use crate::sketch::Sketch;
use crate::{Dice, grow, symmetric, worst_gap};
use mech_compiler::evaluate::Machine;
use mech_compiler::program::Real;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Four-bars with equal pairs and what hangs on them.
    Symmetric,
    /// Equal cranks under a rail.
    Rows,
    /// Trains of gears, guides and four-bars.
    Fast,
    /// Anything, with one motor.
    Generic,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Symmetric, Self::Rows, Self::Fast, Self::Generic];

    fn text(self, dice: &mut Dice, single: bool) -> String {
        let mut sketch: Sketch = match self {
            Self::Symmetric => symmetric::symmetric(dice),
            Self::Rows => symmetric::row(dice),
            Self::Fast => symmetric::fast(dice),
            Self::Generic => {
                let additions = 2 + dice.below(5);
                let text = crate::text(&grow(dice, additions).model);
                return if single { text.replacen(';', ": f32;", 1) } else { text };
            }
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
pub fn tally(kind: Kind, family: Family, seeds: std::ops::Range<u64>, single: bool, examples: usize) -> Tally {
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
        if subject.model.motors.len() != 1 {
            continue;
        }
        tally.mechanisms += 1;
        let found = if single { journeys::<f32>(kind, &subject, &mut dice, &mut tally) } else { journeys::<f64>(kind, &subject, &mut dice, &mut tally) };
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

/// What is off by this counts as elsewhere.
const ELSEWHERE: f64 = 0.02;

fn journeys<T: Real>(kind: Kind, subject: &Subject, dice: &mut Dice, tally: &mut Tally) -> Vec<(Fault, String)> {
    let judge = subject.judge();
    let mut machine = Machine::<T>::new(&subject.compiled.program);
    let start = machine.position().motors[0].to_f64();
    let mut found = Vec::new();
    let gap = judge.gap(&judge.start(), &[start]);
    if gap > if subject.model.precision == mech_compiler::model::Precision::F32 { 1e-3 } else { 1e-7 } {
        found.push((Fault::Torn, format!("it is torn by {gap:.1e} of a link where it starts")));
        return found;
    }
    let reach = if subject.slides(0) { 2.0 * crate::size(&subject.model) } else { 2.5 * TAU };
    let track = Track::new(&judge, start, reach);
    if let Some(why) = track.gave_up() {
        *tally.reasons.entry(why.to_owned()).or_default() += 1;
    }
    let mut trial = Trial { subject, track: &track, start, reach, found, moves: 0 };
    match kind {
        Kind::Steps => trial.steps(&mut machine),
        Kind::Leaps => trial.leaps(&mut machine, dice),
        Kind::Stops => trial.stops(&mut machine, dice),
    }
    tally.moves += trial.moves;
    trial.found
}

/// One mechanism on trial.
struct Trial<'a> {
    subject: &'a Subject,
    track: &'a Track<'a>,
    start: f64,
    reach: f64,
    found: Vec<(Fault, String)>,
    moves: usize,
}

impl Trial<'_> {
    fn find(&mut self, fault: Fault, what: String) {
        self.found.push((fault, what));
    }

    fn is_single(&self) -> bool {
        self.subject.model.precision == mech_compiler::model::Precision::F32
    }

    /// Makes a move and judges it. Whether it may go on from there.
    fn judged<T: Real>(&mut self, machine: &mut Machine<'_, T>, to: f64, path: &mut Vec<f64>) -> bool {
        self.moves += 1;
        let to = T::from_f64(to);
        let from = machine.position().motors[0].to_f64();
        let outcome = machine.move_to(&[to]);
        if outcome.is_err() {
            let _ = machine.move_toward(&[to]);
        }
        let (goal, at) = (to.to_f64(), machine.position().motors[0].to_f64());
        path.push(goal);
        let story = |what: String| format!("path {path:?}: {what}");
        let loose = if self.is_single() { 1e-3 } else { 1e-6 } * (1.0 + at.abs());
        let poses = self.subject.poses(machine.position());
        let extent = poses.iter().map(|[_, _, x, y]| x.hypot(*y)).fold(crate::size(&self.subject.model), f64::max);
        let gap = worst_gap(&self.subject.model, &poses) / extent;
        if gap > if self.is_single() { 1e-4 } else { 1e-9 } {
            let what = story(format!("at {at} it is torn by {gap:.1e}"));
            self.find(Fault::Torn, what);
            return false;
        }
        // Whether rounding decides how it goes on where curves nearly cross, is nobody's mistake.
        let unsure = self.track.nearest() < if self.is_single() { 0.05 } else { 2e-5 };
        let blame = |fault| if unsure { Fault::Unknown } else { fault };
        match self.track.judge(at) {
            Judged::Reached(there, condition) => {
                let least = if self.is_single() { [2e-4, 1e-5] } else { [1e-6, 1e-9] };
                let allowed = least[0].max(least[1] * condition).min(ELSEWHERE);
                let off = apart(&self.subject.model, &poses, &there);
                if off > allowed {
                    let fault = if off > ELSEWHERE { Fault::Elsewhere } else { Fault::Off };
                    let what = story(format!("from {from} to {goal} it is at {at}, off by {off:.2e} (condition {condition:.1e})"));
                    self.find(blame(fault), what);
                    return false;
                }
            }
            Judged::Beyond(end) if (at - end).abs() > loose => {
                let what = story(format!("from {from} to {goal} it is at {at}, the judge stops at {end}"));
                self.find(blame(Fault::Passes), what);
                return false;
            }
            Judged::Beyond(_) => {}
            Judged::Unknown => {
                let what = story(format!("at {at} the judge gives up: {:?}", self.track.gave_up()));
                self.find(Fault::Unknown, what);
                return false;
            }
        }
        if let Err(stop) = outcome {
            let end = match self.track.judge(goal) {
                Judged::Beyond(end) => end,
                Judged::Reached(..) => goal,
                Judged::Unknown => return false,
            };
            if (at - end).abs() > loose {
                let what = story(format!("from {from} to {goal} it stops at {at} by {stop:?}, the judge at {end}"));
                self.find(blame(Fault::StopsEarly), what);
            }
            return false;
        }
        true
    }

    fn leaps<T: Real>(&mut self, machine: &mut Machine<'_, T>, dice: &mut Dice) {
        let begin = machine.position().clone();
        let mut path = Vec::new();
        for _ in 0..12 {
            let far = *dice.pick(&[0.3, 1.0, 1.0, 1.0]) * self.reach;
            let to = self.start + dice.between(-far, far);
            if !self.judged(machine, to, &mut path) {
                machine.put_back(begin.clone());
                path.clear();
            }
        }
    }

    fn stops<T: Real>(&mut self, machine: &mut Machine<'_, T>, dice: &mut Dice) {
        let begin = machine.position().clone();
        let mut path = Vec::new();
        let crossings = self.track.crossings();
        let unit = if self.subject.slides(0) { self.reach / 12.0 } else { 1.0 };
        for _ in 0..24 {
            let at = machine.position().motors[0].to_f64();
            let by = *dice.pick(&[1e-7, 1e-7, 1e-5, 1e-3, 1e-3, 0.1, 1.0, 1.0, PI]) * unit * *dice.pick(&[1.0, -1.0]);
            let to = if crossings.is_empty() || dice.once_in(2) {
                at + by
            } else {
                *dice.pick(&crossings) + if dice.once_in(3) { 0.0 } else { by }
            };
            if (to - self.start).abs() < self.reach && !self.judged(machine, to, &mut path) {
                machine.put_back(begin.clone());
                path.clear();
            }
        }
    }

    fn steps<T: Real>(&mut self, machine: &mut Machine<'_, T>) {
        let begin = machine.position().clone();
        let step = if self.subject.slides(0) { self.reach / 14_400.0 } else { TAU / 7200.0 };
        for sign in [1.0, -1.0] {
            machine.put_back(begin.clone());
            let mut rows = vec![self.subject.poses(&begin)];
            let mut path = Vec::new();
            for number in 1..14_400_u32 {
                let to = self.start + sign * step * f64::from(number);
                if number % 500 == 0 {
                    path.clear();
                    if !self.judged(machine, to, &mut path) {
                        break;
                    }
                } else if machine.move_to(&[T::from_f64(to)]).is_err() {
                    self.judged(machine, to, &mut path);
                    break;
                }
                self.moves += 1;
                rows.push(self.subject.poses(machine.position()));
            }
            if let Some(what) = jump(&rows) {
                let what = format!("steps of {}: {what}, from {}", sign * step, self.start);
                self.find(Fault::Jumped, what);
            }
        }
    }
}

/// Whether a link jumps between two rows while its neighbours in time hardly move.
fn jump(rows: &[Vec<[f64; 4]>]) -> Option<String> {
    let wrapped = |angle: f64| angle - TAU * (angle / TAU).round();
    for link in 1..rows[0].len() {
        let angle = |row: &Vec<[f64; 4]>| row[link][1].atan2(row[link][0]);
        let turns: Vec<f64> = rows.windows(2).map(|pair| wrapped(angle(&pair[1]) - angle(&pair[0])).abs()).collect();
        for (number, turn) in turns.iter().enumerate() {
            if *turn > 20.0_f64.to_radians() {
                let mut near = turns[number.saturating_sub(8)..(number + 9).min(turns.len())].to_vec();
                near.sort_by(f64::total_cmp);
                if *turn > 12.0 * near[near.len() / 2] {
                    return Some(format!("link {link} jumps by {:.0} deg in step {number}", turn.to_degrees()));
                }
            }
        }
    }
    None
}
