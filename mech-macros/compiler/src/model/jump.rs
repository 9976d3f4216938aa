//! Places at which laws jump, or their rates: no force makes anything of mass do that.

use super::formula::Slopes;
use super::{BinaryFunction, Formula, Function, Law};
use mech_core::MotionLaw;
use std::f64::consts::TAU;

/// Places at which a law is looked at first.
const SAMPLES: u32 = 2000;
/// Halvings of the interval between two of these.
const HALVINGS: u32 = 48;
/// What changes between two samples by less than this part of the greatest change is continuous.
const SMOOTH: f64 = 1e-3;
/// So far beside a jump, as a part of the whole range, numbers are those of one side.
const BESIDE: f64 = 1e-9;
/// A jump is as great so much nearer to it, as a part of that.
const NEARER: f64 = 1e-2;
/// What changes by more than this part after all halvings jumps.
const SHARP: f64 = 1e-5;
/// A change of less than this part of the greatest number is rounding.
const ROUNDING: f64 = 1e-9;
/// A turn of a shaft begins a little before zero, where many laws have a corner.
const BEFORE: f64 = 0.0123;

/// A place at which a law jumps, or its rate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jump {
    /// The value of the variable.
    pub at: f64,
    /// Whether it is the rate that jumps; else the value.
    pub is_rate: bool,
    /// The number before and after.
    pub ends: [f64; 2],
}

impl Law {
    /// The first place in one turn of a cam's shaft at which it jumps, or its rate: as far as samples show it. Whole turns of an angle are
    /// no jumps.
    #[must_use]
    pub fn first_jump_in_turn(&self, params: &[f64], is_angle: bool) -> Option<Jump> {
        self.first_jump([-BEFORE, TAU - BEFORE], params, is_angle)
    }

    /// The first place between two values of the variable at which it jumps, or its rate: as far as samples show it. Whole turns of an
    /// angle are no jumps.
    #[must_use]
    pub fn first_jump(
        &self,
        [low, high]: [f64; 2],
        params: &[f64],
        is_angle: bool,
    ) -> Option<Jump> {
        if !self.formulas().all().iter().any(may_jump) {
            return None;
        }
        let place = |number: u32| low + (high - low) * f64::from(number) / f64::from(SAMPLES);
        let at = |variable: f64| {
            let (value, slope) =
                self.evaluate(&mut Slopes { variables: &[(variable, 1.0)], params, by: None });
            [value, slope]
        };
        let samples: Vec<[f64; 2]> = (0..=SAMPLES).map(|number| at(place(number))).collect();
        // A jump of the value is one of the rate, too, or hides one.
        let found = [0, 1].map(|which| {
            let numbers = samples.windows(2).zip(0..);
            let change = |pair: &[[f64; 2]]| (pair[1][which] - pair[0][which]).abs();
            let greatest = samples.windows(2).map(change).filter(|change| change.is_finite());
            let greatest = greatest.fold(0.0, f64::max);
            let sizes = samples.iter().map(|sample| sample[which].abs());
            let size = sizes.filter(|size| size.is_finite()).fold(0.0, f64::max);
            let least = (SHARP * greatest).max(ROUNDING * size);
            let mut steep = numbers.filter(|(pair, _)| change(pair) > SMOOTH * greatest);
            steep.find_map(|(_, number)| {
                let ends = [place(number), place(number + 1)];
                let number = |variable: f64| at(variable)[which];
                let at = halve(number, ends);
                // On both sides: at a corner that is none a slope is another in one place alone.
                let beside = (high - low) * BESIDE;
                let both = |beside: f64| [number(at - beside), number(at + beside)];
                let size = |[before, after]: [f64; 2]| {
                    let change = (after - before).abs();
                    let is_value = is_angle && which == 0;
                    let turns = if is_value { (change / TAU).round() } else { 0.0 };
                    (change - turns * TAU).abs()
                };
                let (ends, nearer) = (both(beside), both(NEARER * beside));
                let stays = size(ends).min(size(nearer)) > least.max(0.5 * size(ends));
                // Before the beginning there is nothing.
                let is_within = at > low + beside;
                let is_rate = which == 1;
                (stays && is_within).then_some(Jump { at, is_rate, ends })
            })
        });
        let [value, rate] = found;
        match (value, rate) {
            (Some(value), Some(rate)) if rate.at < value.at => Some(rate),
            (value, rate) => value.or(rate),
        }
    }
}

/// Where something changes most between two places.
fn halve(at: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> f64 {
    let mut ends = [at(low), at(high)];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        let between = at(middle);
        if (between - ends[0]).abs() > (ends[1] - between).abs() {
            (high, ends[1]) = (middle, between);
        } else {
            (low, ends[0]) = (middle, between);
        }
    }
    high
}

/// Whether this may jump, or have a corner.
fn may_jump(formula: &Formula) -> bool {
    match formula {
        Formula::Of(function, _) => {
            matches!(function, Function::Abs | Function::Floor | Function::Sign)
        }
        Formula::OfBoth(function, ..) => !matches!(function, BinaryFunction::Hypot),
        Formula::Stairs(stairs, ..) => stairs.law == MotionLaw::Linear,
        _ => false,
    }
}
