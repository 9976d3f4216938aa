//! Which loops are watched while a mechanism moves: all that are not proved to stay clear of dead points and change points.
//!
//! A loop is looked at by itself: of the directions and ways that it is made from, each may be anything that motors or earlier
//! loops can make it. If its dyad closes on all of that by more than rounding, it needs no watching. If not, it is looked at
//! together with the free loops before it, from the motors on, through as many turns as bring everything back to where it was.
//! Loops without such a proof are watched, with bounds on how fast they can change.

mod boxes;
mod domain;
mod free;
mod guess;
mod influence;
mod most;
mod pace;

pub(crate) use domain::{Domain, InputReads};

use crate::certify::Interval;
use crate::certify::always::halves;
use crate::certify::cone::{Cuts, Variable};
use crate::certify::slope::Slopes;
use crate::model::{AtChangePoints, Model};
use crate::plan::{Bound, Plan, Turning};
use crate::program::{AtZero, Choice, ClosedForm, Growth, Program, Solver, Watching, build_as};
use pace::Paces;

/// Below this square of the distance of pins, as a part of the product of lengths, rounding stretches links.
const NEAR_PINS: f64 = 0.1;

/// The decisions about every loop, and about every angle that is followed over whole turns.
pub(crate) struct Decisions {
    pub(crate) choices: Vec<Choice>,
    /// The bound on the rate of each angle whose turns are counted.
    pub(crate) turning: Vec<(Turning, Bound)>,
}

/// Decides for every loop how it is watched; how it is solved is decided already.
pub(crate) fn decide(model: &Model, plan: &Plan, choices: Vec<Choice>) -> Decisions {
    // All dyads in closed form, each on the side on which it starts.
    let closed: Vec<Choice> = choices
        .iter()
        .map(|choice| Choice {
            solver: Solver::ClosedForm,
            predictor: 0,
            watching: None,
            proved: false,
            pins_near: false,
            side: choice.side,
        })
        .collect();
    let program = build_as(model, plan, &closed);
    let mut domain = Domain::new(model, &program, choices.len());
    free::prove(&mut domain, &influence::motors_of_loops(model, plan));
    let mut paces = Paces::new(&domain);
    let all_free =
        program.closed_forms().all(|(_, closed)| domain.known[closed.number].free.is_some());
    if !(all_free && program.followed.is_empty()) {
        paces.look_at_all();
    }
    let mut decided = choices;
    for (_, closed) in program.closed_forms() {
        let choice = &mut decided[closed.number];
        if let Some(free) = &domain.known[closed.number].free {
            choice.pins_near = free.least_distance_square < NEAR_PINS;
            continue;
        }
        let varies = domain.varying.contains(&closed.number);
        let passes = if closed.has_branches {
            varies || !only_ends(&domain, closed)
        } else {
            // Two lines may lie on each other, and go on.
            !varies
        };
        let at_zero = match (passes, model.change_points) {
            (true, AtChangePoints::GoOn) => AtZero::ChangeBranch,
            (true, AtChangePoints::Stop) => AtZero::Stop,
            (true, AtChangePoints::KeepBranch) | (false, _) => AtZero::Stay,
        };
        // An iteration fails where its equations are singular.
        choice.solver = Solver::ClosedForm;
        choice.pins_near = true;
        choice.watching = Some(Watching { bound: paces.of_sine(closed), at_zero });
    }
    // Where rolling ties unknowns, or loops are coupled, there is no closed form, and nothing is proved.
    let at_zero = match model.change_points {
        AtChangePoints::GoOn => AtZero::ChangeBranch,
        AtChangePoints::Stop => AtZero::Stop,
        AtChangePoints::KeepBranch => AtZero::Stay,
    };
    for (closing, choice) in plan.loops().zip(&mut decided) {
        let is_coupled = closing.rings.len() > 1;
        let passes = at_zero != AtZero::Stay && !closing.ties.is_empty();
        if !is_coupled && !passes {
            continue;
        }
        // An iteration keeps no branch at a change point of coupled loops: rounding would choose one.
        let at_zero = match at_zero {
            AtZero::Stay => AtZero::Stop,
            passed => passed,
        };
        choice.watching = Some(Watching { bound: paces.of_tied(&closing.ties), at_zero });
    }
    let turning = program.followed.iter();
    let turning = turning.map(|(what, angle)| (*what, paces.of_angle(*angle))).collect();
    watch_nearly_stuck(&mut paces, &program, &mut decided);
    Decisions { choices: decided, turning }
}

/// A loop that never comes to its dead point, but nearly, makes later ones fast there: it is watched too, if a bound asks for it.
fn watch_nearly_stuck(paces: &mut Paces<'_>, program: &Program, decided: &mut [Choice]) {
    // Bounds ask for earlier loops only.
    let mut closed: Vec<&ClosedForm> = program.closed_forms().map(|(_, closed)| closed).collect();
    closed.sort_by_key(|closed| std::cmp::Reverse(closed.number));
    for closed in closed {
        let near = Growth::NearZero(closed.number);
        let mut watched = decided.iter().filter_map(|choice| choice.watching.as_ref());
        if !watched.any(|watching| watching.bound.growth.contains(&near)) {
            continue;
        }
        let choice = &mut decided[closed.number];
        if choice.watching.is_none() {
            choice.watching =
                Some(Watching { bound: paces.of_sine(closed), at_zero: AtZero::Stay });
        }
    }
}

/// The proof about a loop in closed form, if there is one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct LoopProof {
    /// Where it always closes, and stays clear of its dead points and change points.
    pub(crate) free: Option<Free>,
}

/// A loop that always closes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Free {
    /// Its sine is never less than this.
    pub(crate) least_sine: f64,
    /// All values of what it finds: the angles of its directions in radians, its ways in scene units.
    pub(crate) ranges: Vec<Option<Interval>>,
    /// The least square of the distance of the pins that two circles are drawn about, as a part of the product of their radii.
    pub(crate) least_distance_square: f64,
}

impl LoopProof {
    /// All values of what the loop finds, by number, if they are known.
    pub(crate) fn range(&self, index: usize) -> Option<Interval> {
        let free = self.free.as_ref()?;
        free.ranges.get(index).copied().flatten()
    }
}

/// The range of the variable is looked at in so many parts at most.
const MOST_PARTS: usize = 512;

/// Whether a loop has dead points only. That can be told only of a loop with one variable, which moves on as long as the motors do. There
/// the discriminant goes through zero instead of touching it.
fn only_ends(domain: &Domain<'_>, closed: &ClosedForm) -> bool {
    let outputs = [closed.discriminant, closed.tolerance, closed.sine, closed.rounding_square];
    let Some(cone) = domain.cutter.cone(&outputs, &Cuts::ALONE) else {
        return false;
    };
    let goes_on = match cone.variables[..] {
        [Variable::Angle(angle)] => domain.cutter.parts(angle).is_some(),
        [Variable::Input(_)] => true,
        _ => false,
    };
    if !goes_on {
        return false;
    }
    let [discriminant, tolerance, sine, rounding_square] =
        [0, 1, 2, 3].map(|output| cone.outputs[output]);
    let mut slopes = Slopes::new(&cone);
    let mut waiting: Vec<Vec<Interval>> =
        vec![cone.variables.iter().map(|variable| domain.of_variable(*variable)).collect()];
    for _ in 0..MOST_PARTS {
        let Some(place) = waiting.pop() else {
            return true;
        };
        slopes.run(&place);
        // Where pins meet but for rounding, the tolerance vanishes with their distance: what rounding hides of the sine does not.
        let hidden = slopes.value(rounding_square).high();
        let is_seen = slopes.value(sine).square().low() > hidden;
        let is_open = slopes.value(discriminant).high() < -slopes.value(tolerance).abs().high();
        let is_away = is_seen || is_open;
        if is_away || !slopes.slope(discriminant, 0).contains(0.0) {
            continue;
        }
        match halves(&place, 0) {
            Some(halves) => waiting.extend(halves),
            None => return false,
        }
    }
    waiting.is_empty()
}
