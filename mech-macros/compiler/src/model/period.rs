//! After what time laws are back where they began.

use super::formula::Now;
use super::{
    Arithmetic, BinaryFunction, FormulaArithmetic, Function, Inverse, Law, Model, MotorId, Number,
    ParamId,
};
use mech_core::Staircase;
use std::f64::consts::TAU;

impl Model {
    /// After what time everything that follows laws is where it was, motors or a point on its path, with the params as they are at the start;
    /// none if nobody knows one. What turns may have made whole turns.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        let turn = |turns: bool| turns.then_some(TAU);
        let turns = |motor| self.turns(self.motor(motor).joint);
        let motors = self.lawful_motors();
        let motors = motors.map(|(motor, law)| (law, turn(turns(motor))));
        let trajectory = self.inverse.iter().flat_map(|inverse| &inverse.trajectory);
        let given = trajectory.enumerate();
        let given = given.map(|(given, law)| (self.law(*law), turn(given == Inverse::ANGLE)));
        self.common_period(motors.chain(given))
    }

    /// After what time these motors are where they were by their laws, or farther by whole rounds; none if nobody knows one. Each has how
    /// far it goes until all is as it was, if it ever is.
    pub(crate) fn period_of_rounds(&self, rounds: &[(MotorId, Option<f64>)]) -> Option<f64> {
        let laws = self.lawful_motors().filter_map(|(motor, law)| {
            let (_, round) = rounds.iter().find(|(other, _)| *other == motor)?;
            Some((law, *round))
        });
        self.common_period(laws)
    }

    fn common_period<'m>(&self, laws: impl Iterator<Item = (&'m Law, Option<f64>)>) -> Option<f64> {
        let params: Vec<f64> = self.params.values().collect();
        let mut courses = Courses(Now { variables: &[], params: &params });
        let mut period = 0.0;
        for (law, round) in laws {
            let course = law.evaluate(&mut courses)?;
            period = common(period, course.period)?;
            if course.rate != 0.0 {
                period = common(period, round? / course.rate.abs())?;
            }
        }
        (period > 0.0).then_some(period)
    }
}

/// The course of a number in time: after each period it is farther, by the rate times the period.
#[derive(Clone, Copy)]
struct Course {
    /// At the time 0.
    value: f64,
    rate: f64,
    /// Zero, if any time is one.
    period: f64,
}

impl Course {
    fn is_fixed(self) -> bool {
        self.rate == 0.0 && self.period == 0.0
    }
}

/// A time after which things with two periods are back; none if that takes long.
fn common(a: f64, b: f64) -> Option<f64> {
    /// So many of the first are tried.
    const MOST: u32 = 64;
    if a == 0.0 || b == 0.0 {
        return Some(a.max(b));
    }
    let mut times = (1..=MOST).map(|count| f64::from(count) * a);
    times.find(|time| {
        let whole = (time / b).round();
        whole > 0.0 && (time - whole * b).abs() < 1e-9 * time
    })
}

/// The arithmetic of courses; none if nothing is known of a number.
struct Courses<'p>(Now<'p>);

impl Courses<'_> {
    /// Joins two courses into one that goes on at this rate.
    fn join(
        [a, b]: [Option<Course>; 2],
        value: impl FnOnce(f64, f64) -> f64,
        rate: impl FnOnce(Course, Course) -> Option<f64>,
    ) -> Option<Course> {
        let (a, b) = a.zip(b)?;
        Some(Course {
            value: value(a.value, b.value),
            rate: rate(a, b)?,
            period: common(a.period, b.period)?,
        })
    }

    /// The rate of a result of two operands: zero if neither of them goes on, else unknown.
    fn still(a: Course, b: Course) -> Option<f64> {
        (a.rate == 0.0 && b.rate == 0.0).then_some(0.0)
    }
}

impl Arithmetic for Courses<'_> {
    type Scalar = Option<Course>;

    fn constant(&mut self, value: f64) -> Option<Course> {
        Some(Course { value, rate: 0.0, period: 0.0 })
    }

    fn neg(&mut self, a: Option<Course>) -> Option<Course> {
        let minus = self.constant(-1.0);
        self.mul(minus, a)
    }

    fn add(&mut self, a: Option<Course>, b: Option<Course>) -> Option<Course> {
        Self::join([a, b], |a, b| a + b, |a, b| Some(sum(a.rate, b.rate)))
    }

    fn sub(&mut self, a: Option<Course>, b: Option<Course>) -> Option<Course> {
        Self::join([a, b], |a, b| a - b, |a, b| Some(sum(a.rate, -b.rate)))
    }

    fn mul(&mut self, a: Option<Course>, b: Option<Course>) -> Option<Course> {
        Self::join(
            [a, b],
            |a, b| a * b,
            |a, b| match (a.is_fixed(), b.is_fixed()) {
                (true, _) => Some(a.value * b.rate),
                (_, true) => Some(a.rate * b.value),
                _ => Self::still(a, b),
            },
        )
    }

    fn div(&mut self, a: Option<Course>, b: Option<Course>) -> Option<Course> {
        Self::join(
            [a, b],
            |a, b| a / b,
            |a, b| {
                if b.is_fixed() { Some(a.rate / b.value) } else { Self::still(a, b) }
            },
        )
    }
}

impl FormulaArithmetic for Courses<'_> {
    fn variable(&mut self, _: usize) -> Option<Course> {
        Some(Course { value: 0.0, rate: 1.0, period: 0.0 })
    }

    fn param(&mut self, param: ParamId) -> Option<Course> {
        let value = self.0.param(param);
        self.constant(value)
    }

    fn of(&mut self, function: Function, a: Option<Course>) -> Option<Course> {
        let a = a?;
        let round = match function {
            _ if a.rate == 0.0 => 0.0,
            Function::Sin | Function::Cos | Function::Tan => TAU / a.rate.abs(),
            _ => return None,
        };
        Some(Course {
            value: self.0.of(function, a.value),
            rate: 0.0,
            period: common(a.period, round)?,
        })
    }

    fn of_both(
        &mut self,
        function: BinaryFunction,
        a: Option<Course>,
        b: Option<Course>,
    ) -> Option<Course> {
        let (first, second) = a.zip(b)?;
        let (rate, round) = match function {
            BinaryFunction::Mod if second.is_fixed() && first.rate != 0.0 => {
                (0.0, (second.value / first.rate).abs())
            }
            BinaryFunction::Min | BinaryFunction::Max if first.rate == second.rate => {
                (first.rate, 0.0)
            }
            _ => (Self::still(first, second)?, 0.0),
        };
        let value = |a, b| self.0.of_both(function, a, b);
        let joined = Self::join([a, b], value, |_, _| Some(rate))?;
        Some(Course { period: common(joined.period, round)?, ..joined })
    }

    fn stairs(
        &mut self,
        stairs: Staircase,
        place: Option<Course>,
        share: Number,
    ) -> Option<Course> {
        let place = place?;
        let round = if place.rate == 0.0 {
            0.0
        } else if stairs.repeats {
            1.0 / place.rate.abs()
        } else {
            return None;
        };
        Some(Course {
            value: self.0.stairs(stairs, place.value, share),
            rate: place.rate,
            period: common(place.period, round)?,
        })
    }
}

/// The sum of two rates; zero, if only rounding is left of them.
fn sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if sum.abs() <= 1e-12 * a.abs() { 0.0 } else { sum }
}
