//! A point is led, and motors follow: as the generated code does it, in any precision.

use super::inverse::{Unreachable, place};
use super::least;
use crate::bug::bug;
use crate::compiled::{Compiled, InverseMechanism};
use crate::evaluate::Machine;
use crate::kinematics::LinkFrames;
use crate::model::{Inverse, Model};
use crate::program::{Position, Program, Real};
use mech_core::journey::Standing;
use mech_core::pieces::in_pieces;

/// So many whole turns of an angle that gears follow are tried.
const MOST_TURNS: i32 = 32;

/// Leads the point of `follow` to a place on the straight way, and moves the motors after it. What is given is x and y, and the angle of
/// the link where that is given. `inverse` is a machine of the program of [`Compiled::leading`], wherever it is.
///
/// # Errors
/// The obstacle to the point; the mechanism then stays where it was.
pub fn lead<T: Real>(
    model: &Model,
    compiled: &Compiled,
    (mechanism, inverse): (&mut Machine<'_, T>, &mut Machine<'_, T>),
    place: &[f64],
) -> Result<(), Unreachable> {
    let Some(led) = &model.inverse else {
        bug!("no motors follow a point");
    };
    let start = mechanism.position().clone();
    if led.is_least {
        let both = (&mut *mechanism, inverse);
        let done = least::lead(model, led, &compiled.program, both, place);
        if done.is_err() {
            mechanism.put_back(start);
        }
        return done;
    }
    let Some(inverted) = &compiled.inverse else {
        bug!("motors follow a point, and their mechanism is not there");
    };
    let mut way = Way {
        model,
        led,
        inverted,
        programs: [&compiled.program, &inverted.compiled.program],
        mechanism,
        inverse,
    };
    let done = way.lead_to(place);
    if done.is_err() {
        mechanism.put_back(start);
    }
    done
}

/// The present value of what `follow` gives: the place of the point, and the angle of its link if that is given, too.
#[must_use]
pub fn led_place(model: &Model, program: &Program, poses: &[[f64; 4]]) -> Option<Vec<f64>> {
    let inverse = model.inverse.as_ref()?;
    let frames = LinkFrames::of_some(model, &program.stored, poses);
    let given = place(model, inverse, &frames).into_iter();
    Some(given.take(inverse.given().len()).collect())
}

/// A way on which a point is led.
struct Way<'w, 'm, 'i, T: Real> {
    model: &'w Model,
    led: &'w Inverse,
    inverted: &'w InverseMechanism,
    /// Those of the mechanism and of its inverse.
    programs: [&'w Program; 2],
    mechanism: &'w mut Machine<'m, T>,
    inverse: &'w mut Machine<'i, T>,
}

impl<'w, T: Real> Way<'w, '_, '_, T> {
    /// Goes to a place in as many pieces as it takes.
    fn lead_to(&mut self, place: &[f64]) -> Result<(), Unreachable> {
        let poses: Vec<[f64; 4]> = in_double(&self.mechanism.position().poses);
        let Some(start) = led_place(self.model, self.programs[0], &poses) else {
            bug!("a point that is led has no place");
        };
        let mut end = place.to_vec();
        if let (Some(end), Some(start)) = (end.get_mut(Inverse::ANGLE), start.get(Inverse::ANGLE)) {
            // The shorter way.
            let turn = T::TURN.to_f64();
            *end -= turn * ((*end - *start) / turn).round();
        }
        self.stand(&start).ok_or(Unreachable::Apart)?;
        let between = |part: f64| {
            if part >= 1.0 {
                return end.clone();
            }
            let both = start.iter().zip(&end);
            both.map(|(from, end)| from + (end - from) * part).collect()
        };
        let done = in_pieces(Unreachable::Apart, |part| self.go_at_once(&between(part)))?;
        done.map_err(|(trouble, _)| trouble)
    }

    /// Puts the inverse where the mechanism is, with the point at this place. Nothing if it cannot be.
    fn stand(&mut self, place: &[f64]) -> Option<()> {
        let at = self.mechanism.position();
        let mut from = self.inverse.position().clone();
        from.turns.clone_from(&at.turns);
        let mut inputs = at.motors.clone();
        for (motor, value) in self.led.motors.iter().zip(place) {
            inputs[motor.index()] = T::from_f64(*value);
            from.turns[motor.index()] = 0;
        }
        from.motors.clone_from(&inputs);
        // Only its poses are known: a beginning of its own keeps the digits that whole turns would take.
        for follow in &self.programs[1].follows {
            let angle = &mut from.state[follow.angle];
            let turns = T::from_f64((angle.to_f64() / T::TURN.to_f64()).round());
            *angle = *angle - T::TURN * turns;
        }
        let poses = at.poses[..self.shared()].to_vec();
        let found = beside(self.inverse, self.program(1), from, &inputs, &poses)?;
        self.inverse.put_back(found);
        Some(())
    }

    /// The program of one of both, and the size of the links: rounding is a part of it.
    fn program(&self, which: usize) -> (&'w Program, f64) {
        (self.programs[which], self.inverted.model.size())
    }

    /// The number of links that both have: the first of each.
    fn shared(&self) -> usize {
        self.model.declared_links().count()
    }

    /// Goes to a place in one piece. Gives the reason if both stay where they are, as the piece is too long.
    fn go_at_once(&mut self, place: &[f64]) -> Result<Option<Unreachable>, Unreachable> {
        let start = self.inverse.position().clone();
        let before = self.coordinates();
        let whole = |(value, turns): (&T, &i32)| *value + T::TURN * T::from_i32(*turns);
        let mut inputs: Vec<T> = start.motors.iter().zip(&start.turns).map(whole).collect();
        for (motor, value) in self.led.motors.iter().zip(place) {
            inputs[motor.index()] = T::from_f64(*value);
        }
        self.inverse.move_to(&inputs).map_err(Unreachable::Stopped)?;
        let stop = self.carry(&before);
        if stop.is_some() {
            self.inverse.put_back(start);
        }
        Ok(stop)
    }

    /// Moves the mechanism to where its inverse has come, from where the joints of its motors had these coordinates. Gives the reason if it
    /// stays.
    fn carry(&mut self, before: &[f64]) -> Option<Unreachable> {
        let after = self.coordinates();
        let start = self.mechanism.position().clone();
        let mut motors = start.motors.clone();
        for ((motor, before), after) in self.led.motors.iter().zip(before).zip(after) {
            let number = motor.index();
            let joint = self.model.motor(*motor).joint;
            let turned = if self.model.turns(joint) {
                // Both count whole turns from a beginning of their own.
                let turn = T::TURN.to_f64();
                turn * ((motors[number].to_f64() - before) / turn).round()
            } else {
                0.0
            };
            let value = after + turned;
            if let Some(range) = &self.model.motor(*motor).range {
                let total = value + T::TURN.to_f64() * f64::from(start.turns[number]);
                if !(range.low..=range.high).contains(&total) {
                    return Some(Unreachable::OutOfRange(*motor));
                }
            }
            motors[number] = T::from_f64(value);
        }
        let poses = self.inverse.position().poses[..self.shared()].to_vec();
        let Some(mut found) =
            beside(self.mechanism, self.program(0), start.clone(), &motors, &poses)
        else {
            return Some(Unreachable::Apart);
        };
        let quarter = 0.25 * T::TURN.to_f64();
        let mut follows = self.programs[0].follows.iter();
        if !follows.all(|follow| {
            let [before, after] = [&start, &found].map(|at| at.state[follow.angle].to_f64());
            (after - before).abs() <= quarter
        }) {
            return Some(Unreachable::Apart);
        }
        stand_away(self.programs[0], &mut found);
        self.mechanism.put_back(found);
        None
    }

    /// The coordinates of the joints whose motors follow, where the inverse is: over whole turns.
    fn coordinates(&self) -> Vec<f64> {
        let at = self.inverse.position();
        let (model, program) = (&self.inverted.model, self.programs[1]);
        let poses = in_double(&at.poses);
        let frames = LinkFrames::of_some(model, &program.stored, &poses);
        let coordinates = self.led.motors.iter().map(|motor| {
            let joint = self.model.motor(*motor).joint;
            let carried = program.angle_state(joint);
            let carried = carried.map(|state| at.state[state].to_f64());
            let Some(value) = carried.or_else(|| frames.coordinate(joint)) else {
                bug!("a joint with a motor has no coordinate");
            };
            value
        });
        coordinates.collect()
    }
}

/// The position of a machine at these inputs, beside another one, in which the first links have these poses, to rounding: on any side
/// of loops, and after whole turns of angles that gears follow. None if there is none.
fn beside<T: Real>(
    machine: &mut Machine<'_, T>,
    (program, size): (&Program, f64),
    from: Position<T>,
    inputs: &[T],
    poses: &[[T; 4]],
) -> Option<Position<T>> {
    let mut try_from = |from: &Position<T>| {
        machine.leap_from(from, inputs).ok()?;
        let found = machine.position().clone();
        let apart = apart(&found.poses, poses, size);
        Some((found, apart))
    };
    let first = try_from(&from);
    if let Some((found, 0)) = first {
        return Some(found);
    }
    let mut known = from;
    known.poses[..poses.len()].copy_from_slice(poses);
    stand_away(program, &mut known);
    let mut least = usize::MAX;
    let mut consider = |known: &mut Position<T>, change: &dyn Fn(&mut [T])| {
        let mut other = known.clone();
        change(&mut other.state);
        let (found, apart) = try_from(&other)?;
        if apart < least {
            (*known, least) = (other, apart);
        }
        (apart == 0).then_some(found)
    };
    if let Some(found) = consider(&mut known, &|_| {}) {
        return Some(found);
    }
    for watch in &program.watches {
        let found = consider(&mut known, &|state| state[watch.sine] = -state[watch.sine]);
        if found.is_some() {
            return found;
        }
    }
    for follow in &program.follows {
        for turns in (1..=MOST_TURNS).flat_map(|turns| [turns, -turns]) {
            let found = consider(&mut known, &|state| {
                state[follow.angle] = state[follow.angle] + T::TURN * T::from_i32(turns);
            });
            if found.is_some() {
                return found;
            }
        }
    }
    None
}
/// Notes that a position is beside no change point to which it came.
fn stand_away<T: Real>(program: &Program, position: &mut Position<T>) {
    if let Some(signs) = program.layout.motion_signs {
        let standings = position.state.iter_mut();
        let standings = standings.skip(signs + position.motors.len());
        standings
            .take(program.watches.len())
            .for_each(|standing| *standing = Standing::Away.number());
    }
}

fn in_double<T: Real>(poses: &[[T; 4]]) -> Vec<[f64; 4]> {
    poses.iter().map(|pose| pose.map(Real::to_f64)).collect()
}

/// The number of links that are elsewhere, by more than rounding tears loops that are nearly straight.
fn apart<T: Real>(poses: &[[T; 4]], wanted: &[[T; 4]], size: f64) -> usize {
    let rounding = 16.0 * T::EPSILON.sqrt();
    let pairs = poses.iter().zip(wanted);
    let is_apart = |(found, wanted): &(&[T; 4], &[T; 4])| {
        let off = [0, 1, 2, 3].map(|part| (found[part] - wanted[part]).to_f64().abs());
        let far = wanted[2].to_f64().abs().max(wanted[3].to_f64().abs());
        // Also true of what is no number.
        !(off[0].max(off[1]) <= rounding && off[2].max(off[3]) <= rounding * size.max(far))
    };
    pairs.filter(is_apart).count()
}
