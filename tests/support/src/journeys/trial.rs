//! One mechanism, move by move, beside the judge.

use super::{Fault, Judged, Subject, Track, apart};
use crate::judge::{Judge, Place};
use crate::{Dice, worst_gap};
use mech_compiler::evaluate::{Machine, Stop};
use mech_compiler::model::Precision;
use mech_compiler::program::Real;
use std::f64::consts::{PI, TAU};

/// Whether it goes on from here, or what is wrong.
type Verdict = Result<bool, (Fault, String)>;

/// Moves, as far as it goes; and why no farther.
fn move_to<T: Real>(machine: &mut Machine<'_, T>, to: &[T]) -> Option<Stop> {
    let stop = machine.move_to(to).err()?;
    let _ = machine.move_toward(to);
    Some(stop)
}

/// What is off by this counts as elsewhere, unless so many roundings explain it.
const ELSEWHERE: f64 = 0.02;
const ROUNDINGS: f64 = 16.0;

/// All that one motor can do.
pub(super) struct Line<'a> {
    pub(super) track: Track<'a>,
    start: f64,
    reach: f64,
}

impl<'a> Line<'a> {
    /// From where a motor starts so far to both sides.
    pub(super) fn new(judge: &'a Judge<'a>, start: f64, reach: f64) -> Self {
        Self { track: Track::new(judge, start, reach), start, reach }
    }
}

/// One mechanism on trial.
pub(super) struct Trial<'a> {
    subject: &'a Subject,
    judge: &'a Judge<'a>,
    pub(super) found: Vec<(Fault, String)>,
    pub(super) moves: usize,
}

/// The numbers of a position's motors.
pub(super) fn motors<T: Real>(machine: &Machine<'_, T>) -> Vec<f64> {
    machine.position().motors.iter().map(|value| value.to_f64()).collect()
}

impl<'a> Trial<'a> {
    pub(super) fn new(subject: &'a Subject, judge: &'a Judge<'a>) -> Self {
        Self { subject, judge, found: Vec::new(), moves: 0 }
    }

    pub(super) fn find(&mut self, fault: Fault, what: String) {
        self.found.push((fault, what));
    }

    pub(super) fn is_single(&self) -> bool {
        self.subject.model.precision == Precision::F32
    }

    /// Moves the one motor and judges it. Whether it may go on from there.
    pub(super) fn judged<T: Real>(
        &mut self,
        line: &Line<'_>,
        machine: &mut Machine<'_, T>,
        to: f64,
        path: &mut Vec<f64>,
    ) -> bool {
        let (from, to) = (motors(machine)[0], T::from_f64(to));
        let stop = move_to(machine, &[to]);
        path.push(to.to_f64());
        let at = motors(machine)[0];
        let loose = 1.0 + at.abs();
        let verdict = self.verdict(&line.track, machine, [at, to.to_f64()], stop, loose);
        self.conclude(verdict, || format!("path {path:?}: from {from} at {at}"))
    }

    fn conclude(&mut self, verdict: Verdict, story: impl Fn() -> String) -> bool {
        self.moves += 1;
        match verdict {
            Ok(goes_on) => goes_on,
            Err((fault, what)) => {
                self.find(fault, format!("{}: {what}", story()));
                false
            }
        }
    }

    /// Whether a machine is where the judge says, at this value of this track, on its way to that value; or what is wrong.
    fn verdict<T: Real>(
        &self,
        track: &Track<'_>,
        machine: &Machine<'_, T>,
        [at, goal]: [f64; 2],
        stop: Option<Stop>,
        length: f64,
    ) -> Verdict {
        let single = self.is_single();
        let loose = if single { 1e-3 } else { 1e-6 } * length;
        let poses = self.subject.poses(machine.position());
        // Whether rounding decides how it goes on where curves nearly cross, is nobody's mistake.
        let unsure = track.nearest() < if single { 0.05 } else { 2e-5 };
        let blame = |fault, what| Err((if unsure { Fault::Unknown } else { fault }, what));
        let judged = track.judge(at);
        let extent = self.subject.extent(&poses);
        let gap = worst_gap(&self.subject.model, &poses) / extent;
        // What is redundant closes as well as the rest is known.
        let allowed = match (single, self.subject.model.allow.redundant) {
            (true, true) => 3e-4,
            (true, false) => 3e-5,
            (false, _) => 1e-9,
        };
        if gap > allowed {
            return Err((Fault::Torn, format!("torn by {gap:.1e}")));
        }
        match judged {
            Judged::Reached(there, condition) => {
                let least = if single { [2e-4, 1e-5] } else { [1e-6, 1e-9] };
                // What rounding of the motor, as gears make it greater, does to the position: no number of this precision tells more.
                let epsilon = if single { f64::from(f32::EPSILON) } else { f64::EPSILON };
                let turned = 1.0 + at.abs() * self.subject.gain();
                let hidden = ROUNDINGS * epsilon * turned * condition;
                let elsewhere = ELSEWHERE.max(hidden);
                let allowed = least[0].max(least[1] * condition).min(elsewhere);
                let off = apart(&poses, &there, extent);
                if off > allowed {
                    let fault = if off > elsewhere { Fault::Elsewhere } else { Fault::Off };
                    return blame(fault, format!("off by {off:.2e}, condition {condition:.1e}"));
                }
            }
            Judged::Beyond(end) if (at - end).abs() > loose => {
                return blame(Fault::Passes, format!("the judge stops at {end}"));
            }
            Judged::Beyond(_) => {}
            // Whoever goes there, or stops on the way, is not blamed.
            Judged::Far => return Ok(false),
            Judged::Unknown => {
                return Err((Fault::Unknown, format!("the judge gives up: {:?}", track.gave_up())));
            }
        }
        let Some(stop) = stop else {
            return Ok(true);
        };
        let end = match track.judge(goal) {
            Judged::Beyond(end) => end,
            Judged::Reached(..) => goal,
            Judged::Far | Judged::Unknown => return Ok(false),
        };
        if (at - end).abs() > loose {
            return blame(Fault::StopsEarly, format!("it stops by {stop:?}, the judge at {end}"));
        }
        // From a dead point it goes back the way it came.
        Ok(true)
    }

    /// Moves all motors from a place of the judge's. Gives where it may go on from.
    pub(super) fn leap<T: Real>(
        &mut self,
        machine: &mut Machine<'_, T>,
        place: &Place,
        goal: &[T],
        path: &mut Vec<Vec<f64>>,
    ) -> Option<Place> {
        let from = motors(machine);
        let to: Vec<f64> = goal.iter().map(|value| value.to_f64()).collect();
        let track = Track::of_move(self.judge, place, [&from, &to]);
        let stop = move_to(machine, goal);
        let ways = to.iter().zip(&from).map(|(to, from)| to - from);
        let longest = ways.enumerate().max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        let (longest, length) = longest?;
        let at =
            if stop.is_none() { 1.0 } else { (motors(machine)[longest] - from[longest]) / length };
        path.push(to);
        let verdict = self.verdict(&track, machine, [at, 1.0], stop, 1.0 + 1.0 / length.abs());
        let goes_on = self.conclude(verdict, || format!("path {path:?}: from {from:?}, part {at}"));
        track.target().filter(|_| goes_on)
    }

    /// Leaps of several motors, long and short.
    pub(super) fn several<T: Real>(&mut self, machine: &mut Machine<'_, T>, dice: &mut Dice) {
        let (begin, start) = (machine.position().clone(), motors(machine));
        let (mut place, mut path) = (self.judge.start(), Vec::new());
        for _ in 0..12 {
            let from = motors(machine);
            let only = dice.below(2 * from.len());
            let far = *dice.pick(&[0.05, 0.5, 1.0, 1.0]);
            let goal = (0..from.len()).map(|motor| {
                let reach = far
                    * if self.subject.slides(motor) {
                        crate::size(&self.subject.model)
                    } else {
                        TAU
                    };
                let to = dice.between(-reach, reach)
                    + if far < 0.5 { from[motor] } else { start[motor] };
                T::from_f64(if only >= from.len() || only == motor { to } else { from[motor] })
            });
            let goal: Vec<T> = goal.collect();
            if let Some(target) = self.leap(machine, &place, &goal, &mut path) {
                place = target;
            } else {
                machine.put_back(begin.clone());
                place = self.judge.start();
                path.clear();
            }
        }
    }

    /// So many moves of the one motor, each to where its value leads; none where nothing is known. Where it may not go on, it begins again.
    fn wander<T: Real>(
        &mut self,
        line: &Line<'_>,
        machine: &mut Machine<'_, T>,
        moves: u32,
        mut next: impl FnMut(f64) -> f64,
    ) {
        let (begin, mut path) = (machine.position().clone(), Vec::new());
        for _ in 0..moves {
            let to = next(motors(machine)[0]);
            let is_known = (to - line.start).abs() < line.reach;
            if is_known && !self.judged(line, machine, to, &mut path) {
                machine.put_back(begin.clone());
                path.clear();
            }
        }
    }

    pub(super) fn leaps<T: Real>(
        &mut self,
        line: &Line<'_>,
        machine: &mut Machine<'_, T>,
        dice: &mut Dice,
    ) {
        self.wander(line, machine, 12, |_| {
            let far = *dice.pick(&[0.3, 1.0, 1.0, 1.0]) * line.reach;
            line.start + dice.between(-far, far)
        });
    }

    pub(super) fn stops<T: Real>(
        &mut self,
        line: &Line<'_>,
        machine: &mut Machine<'_, T>,
        dice: &mut Dice,
    ) {
        let crossings = line.track.crossings();
        let unit = if self.subject.slides(0) { line.reach / 12.0 } else { 1.0 };
        self.wander(line, machine, 24, |at| {
            let by = *dice.pick(&[1e-7, 1e-7, 1e-5, 1e-3, 1e-3, 0.1, 1.0, 1.0, PI])
                * unit
                * *dice.pick(&[1.0, -1.0]);
            if crossings.is_empty() || dice.once_in(2) {
                at + by
            } else {
                *dice.pick(&crossings) + if dice.once_in(3) { 0.0 } else { by }
            }
        });
    }

    pub(super) fn steps<T: Real>(&mut self, line: &Line<'_>, machine: &mut Machine<'_, T>) {
        let begin = machine.position().clone();
        let step = if self.subject.slides(0) { line.reach / 14_400.0 } else { TAU / 7200.0 };
        for sign in [1.0, -1.0] {
            machine.put_back(begin.clone());
            let mut rows = vec![self.subject.poses(&begin)];
            let mut path = Vec::new();
            for number in 1..14_400_u32 {
                let to = line.start + sign * step * f64::from(number);
                if number % 500 == 0 {
                    path.clear();
                    if !self.judged(line, machine, to, &mut path) {
                        break;
                    }
                } else if machine.move_to(&[T::from_f64(to)]).is_err() {
                    self.judged(line, machine, to, &mut path);
                    break;
                }
                self.moves += 1;
                rows.push(self.subject.poses(machine.position()));
            }
            if let Some(what) = jump(&rows) {
                let what = format!("steps of {}: {what}, from {}", sign * step, line.start);
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
        let turns: Vec<f64> =
            rows.windows(2).map(|pair| wrapped(angle(&pair[1]) - angle(&pair[0])).abs()).collect();
        for (number, turn) in turns.iter().enumerate() {
            if *turn > 20.0_f64.to_radians() {
                let mut near =
                    turns[number.saturating_sub(8)..(number + 9).min(turns.len())].to_vec();
                near.sort_by(f64::total_cmp);
                if *turn > 12.0 * near[near.len() / 2] {
                    return Some(format!(
                        "link {link} jumps by {:.0} deg in step {number}",
                        turn.to_degrees()
                    ));
                }
            }
        }
    }
    None
}
