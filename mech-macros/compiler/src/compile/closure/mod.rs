//! The compiler checks its own work: a program that was built is run, and wherever it then is, every joint is measured.
//!
//! The geometry is checked as it was declared: where axes are in their links, and how large wheels are. The check does not use the plan,
//! from which the program was built.

use crate::bug::bug;
use crate::evaluate::Machine;
use crate::kinematics::LinkFrames;
use crate::model::{JointId, JointKind, Model, Motor};
use crate::program::Program;
use crate::structure::{Factor, Rolling, RollingEnd, Structure};
use std::f64::consts::TAU;

/// The distances of motors from the start, one after the other: in radians, or as a part of the mechanism's size. A wrong formula tears a
/// joint wherever it is evaluated, so few positions are enough, and they are reached in single steps.
const DISTANCES: [f64; 3] = [1e-3, 0.05, 0.3];
/// So many motors are moved alone; of more, some go together.
const GROUPS: usize = 4;
/// So many units of rounding, for each link, are rounding: of the extent, or of a radian.
const ROUNDINGS: f64 = 1024.0;
/// Redundant joints may be open by this part of the extent: mechanisms whose lengths match less well were refused before.
const MATCH: f64 = 1e-7;
/// A method with a fixed number of rounds takes so many steps on the spot until it has closed.
const STEPS: usize = 24;
/// So often a wheel may have turned over the least distance.
const TURNS: i32 = 64;
/// Where a wheel turns more than so many times as fast as another, its whole turns over the least distance cannot be told.
const FASTEST: f64 = 1e3;

/// Runs a program at its start and at positions of all its motors beside it, as far as it closes there.
///
/// A joint that is torn there is a mistake of the compiler's, and no code is made.
pub(super) fn check(model: &Model, structure: &Structure, program: &Program) {
    let mut machine = Machine::<f64>::new(program);
    let start = machine.position().clone();
    let judge = Judge::new(model, structure, program);
    judge.look(&mut machine, false);
    let groups = model.motors.len().min(GROUPS);
    for (group, direction) in (0..groups).flat_map(|group| [(group, 1.0), (group, -1.0)]) {
        machine.put_back(start.clone());
        for (number, distance) in DISTANCES.into_iter().enumerate() {
            let moved = |motor: usize| motor % GROUPS == group;
            let goal = goal(model, &start.motors, direction * distance, moved);
            // A single long step may lead loops that are solved together to another assembly, in which redundant joints do not fit.
            let arrived = if structure.redundant.is_empty() {
                machine.step_to(&goal)
            } else {
                machine.move_to(&goal)
            };
            if arrived.is_err() {
                break;
            }
            judge.look(&mut machine, number == 0);
        }
    }
}

/// The values of these motors, displaced from the start, within their declared ranges.
fn goal(
    model: &Model,
    start: &[f64],
    displacement: f64,
    moved: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let mut goal = start.to_vec();
    for (number, motor) in model.motors.iter().enumerate().filter(|(n, _)| moved(*n)) {
        goal[number] += unit(model, motor) * displacement;
        if let Some(range) = motor.range {
            goal[number] = goal[number].clamp(range.low, range.high);
        }
    }
    goal
}

/// The unit in which the displacement of a motor is told: a radian, or the mechanism's size.
pub(super) fn unit(model: &Model, motor: &Motor) -> f64 {
    if slides(model, motor) { model.size() } else { 1.0 }
}

/// Whether a motor's joint slides.
pub(super) fn slides(model: &Model, motor: &Motor) -> bool {
    matches!(model.joint(motor.joint).kind, JointKind::Prismatic(..))
}

/// Measures joints.
struct Judge<'m> {
    model: &'m Model,
    structure: &'m Structure,
    program: &'m Program,
    start: LinkFrames<'m>,
    /// The rounding error of a radian, or of the extent 1.
    rounding: f64,
    /// A bound on the ratio of the speeds of two wheels.
    fastest: f64,
}

/// A joint that is torn.
struct Torn {
    joint: JointId,
    /// By how much: a part of the extent, or radians.
    by: f64,
}

impl<'m> Judge<'m> {
    fn new(model: &'m Model, structure: &'m Structure, program: &'m Program) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "no mechanism has so many links")]
        let links = model.links.len() as f64;
        let ratios = structure.rollings.iter().map(|rolling| {
            let [a, b] = rolling.ends.map(|(_, factor)| size(factor).abs());
            a.max(b) / a.min(b)
        });
        Self {
            model,
            structure,
            program,
            start: LinkFrames::of_some(model, &program.stored, &program.start.poses),
            rounding: ROUNDINGS * model.precision.epsilon() * links,
            fastest: ratios.product(),
        }
    }

    /// Measures all joints where the mechanism is; with `near` also what rolls.
    fn look(&self, machine: &mut Machine<'_, f64>, near: bool) {
        for _ in 0..STEPS {
            let Some(_) = self.torn(machine, near) else {
                return;
            };
            // Loops with a fixed number of rounds close after several steps; a torn joint stays torn.
            let here = machine.position().motors.clone();
            if machine.step_to(&here).is_err() {
                return;
            }
        }
        if let Some(Torn { joint, by }) = self.torn(machine, near) {
            bug!(
                "joint `{}` of the program that was built is torn by {by:e} with its motors at {:?}",
                self.model.joint(joint).name,
                machine.position().motors
            );
        }
    }

    fn torn(&self, machine: &Machine<'_, f64>, near: bool) -> Option<Torn> {
        let position = machine.position();
        let now = LinkFrames::of_some(self.model, &self.program.stored, &position.poses);
        let extent = now.extent();
        let part = if self.structure.redundant.is_empty() {
            self.rounding
        } else {
            self.rounding.max(MATCH)
        };
        let torn = |joint: JointId, by: f64| (by > part).then_some(Torn { joint, by });
        let joints = self.model.joint_ids();
        let mut open = joints.filter_map(|joint| {
            let [apart, askew] = now.misfit(joint)?;
            torn(joint, (apart / extent).max(askew))
        });
        let mut motors = self.model.motors.iter().zip(&position.motors);
        let mut rolling = self.structure.rollings.iter().filter(|_| near);
        open.next()
            .or_else(|| {
                motors.find_map(|(motor, value)| {
                    let off = now.coordinate(motor.joint)? - value;
                    let off = match self.model.joint(motor.joint).kind {
                        JointKind::Prismatic(..) => off.abs() / extent,
                        _ => whole_turns_off(off, TAU) / (1.0 + value.abs()),
                    };
                    torn(motor.joint, off)
                })
            })
            .or_else(|| {
                rolling.find_map(|rolling| {
                    let turns = 1.0 + DISTANCES[0] * self.fastest;
                    torn(rolling.joint, self.slip(rolling, &now, extent)? / turns)
                })
            })
            .or_else(|| self.off_cam(&now, extent, part))
    }

    /// By how much two parts that roll on each other have slipped since the start, up to whole turns: as a part of the greater wheel, or of
    /// the extent. None if that is not known.
    fn slip(&self, rolling: &Rolling, now: &LinkFrames<'_>, extent: f64) -> Option<f64> {
        let [a, b] = rolling.ends;
        let moved = moved(rolling, &self.start, now);
        let sum = moved[0] + moved[1];
        if sum.is_nan() {
            // Not all that it joins is computed.
            return None;
        }
        let is_wheel = |end: RollingEnd| matches!(end, RollingEnd::Wheel(_));
        match ((a.0, a.1), (b.0, b.1)) {
            ((_, Factor::Whole(p)), (_, Factor::Whole(q))) if is_wheel(a.0) && is_wheel(b.0) => {
                let turn = TAU * size(Factor::Whole(greatest_divisor(p, q)));
                Some(whole_turns_off(sum, turn) / size(a.1).abs().max(size(b.1).abs()))
            }
            _ if is_wheel(a.0) && is_wheel(b.0) => {
                let [p, q] = [a.1, b.1].map(size);
                let off = (-TURNS..=TURNS)
                    .map(|turns| whole_turns_off(sum + TAU * f64::from(turns) * p, TAU * q));
                let least = off.fold(f64::INFINITY, f64::min) / p.abs().max(q.abs());
                (self.fastest <= FASTEST).then_some(least)
            }
            _ => {
                let wheel = if is_wheel(a.0) { a.1 } else { b.1 };
                Some(whole_turns_off(sum, TAU * size(wheel)) / extent)
            }
        }
    }

    /// A cam follower that is not where its law has it. Laws that differ from turn to turn are not tested.
    fn off_cam(&self, now: &LinkFrames<'_>, extent: f64, part: f64) -> Option<Torn> {
        self.model.cams().find_map(|(joint, shaft, follower, law)| {
            let winding = law.winding();
            let repeats = if self.model.turns(follower) {
                winding.is_some_and(|turns| turns.fract() == 0.0)
            } else {
                winding == Some(0.0)
            };
            if self.model.turns(shaft) && !repeats {
                return None;
            }
            let at = now.coordinate(shaft)?;
            let unit = if self.model.turns(shaft) { 1.0 } else { extent };
            // A steep law makes more of the shaft's rounding, and so does one that jumps.
            let [low, here, high] =
                [-1.0, 0.0, 1.0].map(|side| self.model.at_start(law, at + side * part * unit));
            let slack = (high - here).abs().max((low - here).abs());
            let off = now.coordinate(follower)? - here;
            let off = if self.model.turns(follower) {
                whole_turns_off(off, TAU) - slack
            } else {
                (off.abs() - slack) / extent
            };
            (off > part).then_some(Torn { joint, by: off })
        })
    }
}

/// Returns the displacements of two parts that roll on each other, on their carrier, as lengths on their rims. Wheels are taken to have
/// turned less than half of a turn.
pub(super) fn moved(rolling: &Rolling, start: &LinkFrames<'_>, now: &LinkFrames<'_>) -> [f64; 2] {
    rolling.ends.map(|(end, factor)| {
        let moved = match end {
            RollingEnd::Wheel(wheel) => {
                let carrier = rolling.carrier;
                let off = now.turn(carrier, wheel) - start.turn(carrier, wheel);
                off - TAU * (off / TAU).round()
            }
            RollingEnd::Bar { slide, forwards, .. } => {
                let [now, start] = [now, start].map(|frames| frames.coordinate(slide));
                let (Some(now), Some(start)) = (now, start) else {
                    bug!("a bar has no slide");
                };
                if forwards { now - start } else { start - now }
            }
        };
        size(factor) * moved
    })
}

/// A number of teeth or a radius.
pub(super) fn size(factor: Factor) -> f64 {
    match factor {
        #[expect(clippy::cast_precision_loss, reason = "a wheel of 2^53 teeth does not exist")]
        Factor::Whole(value) => value as f64,
        Factor::Float(value) => value,
    }
}

/// Returns the distance of a number from the nearest whole number of turns.
fn whole_turns_off(number: f64, turn: f64) -> f64 {
    (number - turn * (number / turn).round()).abs()
}

fn greatest_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { greatest_divisor(b, a % b) }
}

#[cfg(test)]
mod tests;
