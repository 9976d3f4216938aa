//! Dragging of links.
//!
//! The motors bring a place on a link as near to the pointer as they can. Each round moves every motor a little to either side, which gives
//! the influence coefficients of the place. The damped least squares of Levenberg and Marquardt give a step towards the pointer. The round
//! takes all of the step, or half, or a quarter, until the place is nearer. If it never is, the round takes the steepest way. Each step is
//! a move of the motors, so no link leaps into another assembly. A place that cannot reach the pointer moves to the nearest place that it
//! reaches.

use super::{Mechanism, Obstacle};
use mech_runtime::overlay::Spot;

/// The most steps for one movement of the pointer.
const ROUNDS: usize = 40;
/// The most halvings of a step.
const HALVINGS: i32 = 12;
/// The longest step, as a part of a motor's reach.
const LONGEST: f64 = 1.0 / 24.0;
/// The step to either side that finds an influence, as a part of a motor's reach.
const PROBE: f64 = 1e-6;
/// Damping, as a part of the greatest influence.
const DAMPING: f64 = 1e-4;
/// The distance that is near enough, as a part of the distance at first.
const ENOUGH: f64 = 1e-4;

/// A motor that may be moved, and its reach: the displacement in a whole motion, by which steps are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Free {
    /// The number of the motor.
    pub motor: usize,
    /// In radians or scene units.
    pub reach: f64,
}

/// A held place on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// The held place.
    pub spot: Spot<f64>,
}

impl Grip {
    /// Moves these motors so that the held place comes as near to `aim` as it can. Returns what it met on the way, if anything.
    pub fn follow(
        self,
        mechanism: &mut Mechanism,
        free: &[Free],
        aim: [f64; 2],
    ) -> Option<Obstacle> {
        let mut met = None;
        let first = length(self.offset(mechanism, aim)?);
        for _ in 0..ROUNDS {
            let Some(offset) = self.offset(mechanism, aim) else {
                break;
            };
            if length(offset) <= ENOUGH * first {
                break;
            }
            let Some(motors) = self.nearer(mechanism, free, aim, offset) else {
                break;
            };
            met = mechanism.move_toward(&motors);
        }
        met
    }

    /// The vector from the held place to `aim`.
    fn offset(self, mechanism: &Mechanism, aim: [f64; 2]) -> Option<[f64; 2]> {
        Some(difference(aim, mechanism.place(self.spot)?))
    }

    /// Motor values with which the place is nearer.
    fn nearer(
        self,
        mechanism: &Mechanism,
        free: &[Free],
        aim: [f64; 2],
        offset: [f64; 2],
    ) -> Option<Vec<f64>> {
        let motors = mechanism.motors();
        let influences = (0..free.len()).map(|index| self.influence(mechanism, free, index));
        let influences: Vec<Influence> = influences.collect::<Option<_>>()?;
        // Where a motor is at its limit, the least squares of the others may lead nowhere, but the steepest way does.
        let rules = [least_squares, steepest];
        rules.iter().find_map(|rule| {
            let step = step(&influences, offset, *rule)?;
            let shares = (0..HALVINGS).map(|halving| 0.5_f64.powi(halving));
            let mut tries = shares.map(|share| displace(motors, free, &step, share));
            tries.find(|motors| {
                let place = mechanism.place_toward(self.spot, motors);
                place.is_some_and(|place| length(difference(aim, place)) < length(offset))
            })
        })
    }

    /// Computes the velocity of the place for a motor, in parts of the motor's reach.
    fn influence(self, mechanism: &Mechanism, free: &[Free], index: usize) -> Option<Influence> {
        let motors = mechanism.motors();
        let here = mechanism.place(self.spot)?;
        let mut unit = vec![0.0; free.len()];
        *unit.get_mut(index)? = 1.0;
        let moved = |share: f64| {
            let there = mechanism.place_toward(self.spot, &displace(motors, free, &unit, share))?;
            Some(difference(there, here).map(|part| part / share))
        };
        Some(Influence { back: moved(-PROBE)?, forth: moved(PROBE)? })
    }
}

/// The thing that the pointer holds.
#[derive(Clone, Copy)]
pub(super) enum Held {
    Link {
        grip: Grip,
        aim: [f64; 2],
    },
    /// The paper, at the last pixel of the pointer.
    Paper([f64; 2]),
}

/// The displacement of a place for a unit of a motor's, as it is backwards and forwards.
struct Influence {
    back: [f64; 2],
    forth: [f64; 2],
}

impl Influence {
    /// The mean of both ways, or the one that is free.
    fn of(&self) -> [f64; 2] {
        if self.is_stuck(1.0) {
            return self.back;
        }
        if self.is_stuck(-1.0) {
            return self.forth;
        }
        [0, 1].map(|part| f64::midpoint(self.back[part], self.forth[part]))
    }

    /// Whether the motor is at a limit in the direction of this step.
    fn is_stuck(&self, step: f64) -> bool {
        let [way, other] =
            if step > 0.0 { [self.forth, self.back] } else { [self.back, self.forth] };
        length(way) < 0.5 * length(other)
    }
}

/// A rule for the step of each motor towards a displacement, in parts of its reach, from the influences of all; none if there is no use
/// in any.
type Rule = fn(&[[f64; 2]], [f64; 2]) -> Option<Vec<f64>>;

/// The step of each motor by a rule. A motor at its limit does not go on.
fn step(influences: &[Influence], offset: [f64; 2], rule: Rule) -> Option<Vec<f64>> {
    let mut stands = vec![false; influences.len()];
    loop {
        let moved = influences.iter().zip(&stands);
        let moved: Vec<[f64; 2]> = moved
            .map(|(influence, stands)| if *stands { [0.0; 2] } else { influence.of() })
            .collect();
        let step = rule(&moved, offset)?;
        let mut parts = step.iter().zip(influences).zip(&mut stands);
        let Some((_, stands)) =
            parts.find(|((part, influence), stands)| !**stands && influence.is_stuck(**part))
        else {
            return Some(step);
        };
        *stands = true;
    }
}

/// The step by which the distance becomes smaller most steeply, as far as it is straight.
fn steepest(influences: &[[f64; 2]], offset: [f64; 2]) -> Option<Vec<f64>> {
    let slopes: Vec<f64> = influences.iter().map(|j| j[0] * offset[0] + j[1] * offset[1]).collect();
    let moved = influences.iter().zip(&slopes);
    let [x, y] = moved.fold([0.0; 2], |[x, y], (j, slope)| [x + j[0] * slope, y + j[1] * slope]);
    let part = (x * offset[0] + y * offset[1]) / (x * x + y * y);
    let step: Vec<f64> = slopes.iter().map(|slope| slope * part).collect();
    usable(&step)
}

/// The step that comes nearest to a displacement, damped where motors do nearly the same; none if there is no use in any.
fn least_squares(influences: &[[f64; 2]], offset: [f64; 2]) -> Option<Vec<f64>> {
    // (J Jᵀ + damping) f = displacement; then the step is Jᵀ f.
    let sum = |entry: fn([f64; 2]) -> f64| influences.iter().map(|&j| entry(j)).sum::<f64>();
    let [xx, xy, yy] = [sum(|j| j[0] * j[0]), sum(|j| j[0] * j[1]), sum(|j| j[1] * j[1])];
    let damping = DAMPING * (xx + yy);
    let [xx, yy] = [xx + damping, yy + damping];
    let determinant = xx * yy - xy * xy;
    let force = [
        (yy * offset[0] - xy * offset[1]) / determinant,
        (xx * offset[1] - xy * offset[0]) / determinant,
    ];
    let step: Vec<f64> = influences.iter().map(|j| j[0] * force[0] + j[1] * force[1]).collect();
    usable(&step)
}

/// A step that is not longer than the longest; none if it is no step.
fn usable(step: &[f64]) -> Option<Vec<f64>> {
    let longest = step.iter().fold(0.0_f64, |most, share| most.max(share.abs()));
    let share = (LONGEST / longest).min(1.0);
    let is_usable = longest > 0.0 && step.iter().all(|share| share.is_finite());
    is_usable.then(|| step.iter().map(|part| part * share).collect())
}

/// The values of motors after a share of a step.
fn displace(motors: &[f64], free: &[Free], step: &[f64], share: f64) -> Vec<f64> {
    let mut motors = motors.to_vec();
    for (free, part) in free.iter().zip(step) {
        if let Some(motor) = motors.get_mut(free.motor) {
            *motor += share * part * free.reach;
        }
    }
    motors
}

/// The vector from one place to another.
fn difference(to: [f64; 2], from: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}
