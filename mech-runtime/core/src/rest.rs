//! Positions of rest: where springs, weights and loads bring motors that are let go.
//!
//! The torques that hold a position are the slope of its potential energy. They are followed downhill by a quasi-Newton method: J. Nocedal and
//! S. J. Wright, *Numerical Optimization* (2006), chapters 3 and 6. Each step ends where the slope along it has become small.

use crate::Real;

/// More steps than this are not made.
const MOST_STEPS: u32 = 2000;
/// A step moves no motor by more than so many of its units.
const LONGEST: f64 = 0.05;
/// A slope along a step has become small if it is less than this part of what it was.
const SMALL: f64 = 0.3;
/// A slope along a step that is more than this part of what it was asks for a longer step, up to so many times the first.
const STEADY: (f64, f64) = (0.9, 4.0);
/// So often a step is halved before what stops it is believed.
const HALVINGS: u32 = 40;

/// A mechanism that falls.
pub trait Falling<T>: Clone {
    /// A number for each motor.
    type Numbers: AsRef<[T]> + AsMut<[T]> + Clone;
    /// The reason why it cannot go somewhere.
    type Stop;

    /// The values of the motors.
    fn motors(&self) -> Self::Numbers;

    /// Gives the motors these values, and returns the torques that hold them there.
    ///
    /// # Errors
    /// The reason why it cannot go there, or why torques are not determined there; it then stays where it was.
    fn move_to(&mut self, motors: &Self::Numbers) -> Result<Self::Numbers, Self::Stop>;
}

/// The reason why a mechanism does not come to rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unrest<S> {
    /// It comes to a place where it cannot go on, or is at one where torques are not determined.
    Stopped(S),
    /// Nothing pulls at a motor.
    Unloaded,
    /// Nothing stops what pulls at it.
    Endless,
}

/// Lets a mechanism fall from where it is. `units` are displacements of the motors that compare with each other. `ends` are the ends of their
/// ranges, which may be infinite; those of a motor that is held are the same. `rows` has a row for each motor, whatever is in it.
///
/// Gives the torques that hold motors at an end of their range; zero for motors that rest by themselves.
///
/// # Errors
/// If it does not come to rest; it is then anywhere on its way.
pub fn fall<T: Real, F: Falling<T>>(
    falling: &mut F,
    units: &[T],
    ends: &[[T; 2]],
    rows: &mut [F::Numbers],
) -> Result<F::Numbers, Unrest<F::Stop>> {
    let here = falling.motors();
    let mut torques = falling.move_to(&here).map_err(Unrest::Stopped)?;
    let root = T::from_f64(T::EPSILON).sqrt();
    let mut descent = Descent {
        falling,
        units,
        ends,
        level: root * root.sqrt(),
        scale: T::ONE,
        steepest: T::ZERO,
        inverse: Inverse { rows, is_known: false },
    };
    descent.inverse.forget();
    for _ in 0..MOST_STEPS {
        let slope = descent.slope(&torques);
        let slope = descent.free(&slope);
        if size(&slope) <= descent.level * descent.steepest {
            match descent.leave() {
                Some(beside) => torques = beside,
                None if descent.steepest == T::ZERO => return Err(Unrest::Unloaded),
                None => return Ok(descent.holding(torques)),
            }
            descent.inverse.forget();
            continue;
        }
        let way = descent.inverse.direction(&slope);
        let from = descent.falling.motors();
        let (found, stop) = descent.step(&from, &way, dot(&way, &slope));
        let mut moved = plus(&descent.falling.motors(), -T::ONE, &from);
        for (part, unit) in moved.as_mut().iter_mut().zip(units) {
            *part = *part / *unit;
        }
        let far = size(&moved);
        if far <= descent.level
            && let Some(stop) = stop
        {
            return Err(Unrest::Stopped(stop));
        }
        // A step that changes no number is one of rounding.
        let Some(found) = found.filter(|_| far > T::ZERO) else {
            return Ok(descent.holding(torques));
        };
        torques = found;
        let mut change = plus(&slope, -T::ONE, &descent.slope(&torques));
        for (part, slope) in change.as_mut().iter_mut().zip(slope.as_ref()) {
            if *slope == T::ZERO {
                *part = T::ZERO;
            }
        }
        descent.inverse.learn(&moved, &change);
    }
    Err(Unrest::Endless)
}

/// A mechanism on its way down.
struct Descent<'a, T, F: Falling<T>> {
    falling: &'a mut F,
    units: &'a [T],
    ends: &'a [[T; 2]],
    /// A slope of less than this part of the greatest is none.
    level: T,
    /// The first slope that was met, by which all are divided.
    scale: T,
    /// The greatest slope that was met.
    steepest: T,
    inverse: Inverse<'a, F::Numbers>,
}

impl<T: Real, F: Falling<T>> Descent<'_, T, F> {
    /// The slope of the potential energy, downhill, where these torques hold the mechanism.
    fn slope(&mut self, torques: &F::Numbers) -> F::Numbers {
        let (mut slope, mut most) = (torques.clone(), T::ZERO);
        let parts = slope.as_mut().iter_mut().zip(self.units).zip(self.ends);
        for ((part, unit), [low, high]) in parts {
            *part = -(*part * *unit);
            if low < high {
                most = most.max(part.abs());
            }
        }
        if self.steepest == T::ZERO && most > T::ZERO {
            self.scale = most;
        }
        self.steepest = self.steepest.max(most / self.scale);
        for part in slope.as_mut() {
            *part = *part / self.scale;
        }
        slope
    }

    /// The slope as far as motors can follow it: none where one is pulled against an end of its range.
    fn free(&self, slope: &F::Numbers) -> F::Numbers {
        let (mut free, motors) = (slope.clone(), self.falling.motors());
        let parts = free.as_mut().iter_mut().zip(motors.as_ref());
        for ((part, at), [low, high]) in parts.zip(self.ends) {
            if *part < T::ZERO && at <= low || *part > T::ZERO && at >= high {
                *part = T::ZERO;
            }
        }
        free
    }

    /// Those of the torques that hold the mechanism without which it would not rest.
    fn holding(&mut self, torques: F::Numbers) -> F::Numbers {
        let (slope, mut torques) = (self.slope(&torques), torques);
        let free = self.free(&slope);
        let parts = slope.as_ref().iter().zip(free.as_ref());
        for (torque, (slope, free)) in torques.as_mut().iter_mut().zip(parts) {
            if *free != T::ZERO || slope.abs() <= self.level * self.steepest {
                *torque = T::ZERO;
            }
        }
        torques
    }

    /// Goes to a part of a way, within the ranges of the motors.
    fn move_along(
        &mut self,
        from: &F::Numbers,
        part: T,
        way: &F::Numbers,
    ) -> Result<F::Numbers, F::Stop> {
        let mut to = from.clone();
        let ways = way.as_ref().iter().zip(self.units);
        for ((value, (way, unit)), [low, high]) in to.as_mut().iter_mut().zip(ways).zip(self.ends) {
            let there = *value + part * *way * *unit;
            *value = if there < *low {
                *low
            } else if there > *high {
                *high
            } else {
                there
            };
        }
        self.falling.move_to(&to)
    }

    /// Goes a part of a way, on which the slope is so great, until that has become small. Gives the torques there, and what stopped it.
    fn step(
        &mut self,
        from: &F::Numbers,
        way: &F::Numbers,
        along: T,
    ) -> (Option<F::Numbers>, Option<F::Stop>) {
        let (mut found, mut stop) = (None, None);
        let (steady, most) = (T::from_f64(STEADY.0) * along, T::from_f64(STEADY.1));
        // Between what is too short and what is too long.
        let (mut part, mut short, mut long) = (T::ONE, T::ZERO, None);
        for _ in 0..HALVINGS {
            match self.move_along(from, part, way) {
                Err(blocked) => {
                    stop = Some(blocked);
                    long = Some(part);
                }
                Ok(torques) => {
                    let left = dot(way, &self.slope(&torques));
                    found = Some(torques);
                    if left < -T::from_f64(SMALL) * along {
                        long = Some(part);
                    } else if left > steady && part < most && long.is_none() {
                        short = part;
                    } else {
                        break;
                    }
                }
            }
            part = long.map_or(part + part, |long| T::HALF * (short + long));
        }
        (found, stop)
    }

    /// Goes a little aside if it falls on from there: then it gives the torques there.
    fn leave(&mut self) -> Option<F::Numbers> {
        let (here, start) = (self.falling.motors(), self.falling.clone());
        let root = T::from_f64(T::EPSILON).sqrt();
        for number in 0..self.units.len() {
            for sign in [T::ONE, -T::ONE] {
                let mut way = here.clone();
                for (other, part) in way.as_mut().iter_mut().enumerate() {
                    *part = if other == number { sign } else { T::ZERO };
                }
                if let Ok(torques) = self.move_along(&here, root.sqrt(), &way) {
                    let moved = plus(&self.falling.motors(), -T::ONE, &here);
                    let slope = dot(&way, &self.slope(&torques));
                    if dot(&way, &moved) > T::ZERO && slope > root * self.steepest {
                        return Some(torques);
                    }
                }
                self.falling.clone_from(&start);
            }
        }
        None
    }
}

/// An estimate of the inverse of the second derivatives.
struct Inverse<'a, N> {
    rows: &'a mut [N],
    is_known: bool,
}

impl<N: Clone> Inverse<'_, N> {
    /// Begins with a unit matrix.
    fn forget<T: Real>(&mut self)
    where
        N: AsMut<[T]>,
    {
        self.is_known = false;
        for (number, row) in self.rows.iter_mut().enumerate() {
            for (other, entry) in row.as_mut().iter_mut().enumerate() {
                *entry = if other == number { T::ONE } else { T::ZERO };
            }
        }
    }

    /// The way to go on this slope: no motor farther than the longest step.
    fn direction<T: Real>(&mut self, slope: &N) -> N
    where
        N: AsRef<[T]> + AsMut<[T]>,
    {
        let mut way = slope.clone();
        for (part, row) in way.as_mut().iter_mut().zip(&*self.rows) {
            // What leans against an end stays there.
            if *part != T::ZERO {
                *part = dot(row, slope);
            }
        }
        let is_down = dot(&way, slope) > T::ZERO;
        if !is_down {
            self.forget();
            way.clone_from(slope);
        }
        let (most, longest) = (size(&way), T::from_f64(LONGEST));
        if most > longest || !self.is_known {
            for part in way.as_mut() {
                *part = *part * (longest / most);
            }
        }
        way
    }

    /// Takes a step by which the slope changed so much (BFGS).
    fn learn<T: Real>(&mut self, step: &N, change: &N)
    where
        N: AsRef<[T]> + AsMut<[T]>,
    {
        let (along, square) = (dot(step, change), dot(change, change));
        let is_convex = along > T::from_f64(64.0 * T::EPSILON) * (square * dot(step, step)).sqrt();
        if !is_convex {
            return;
        }
        if !self.is_known {
            self.is_known = true;
            for entry in self.rows.iter_mut().flat_map(N::as_mut) {
                *entry = *entry * (along / square);
            }
        }
        let mut across = change.clone();
        for (part, row) in across.as_mut().iter_mut().zip(&*self.rows) {
            *part = dot(row, change);
        }
        let both = (T::ONE + dot(change, &across) / along) / along;
        let pairs = || step.as_ref().iter().zip(across.as_ref());
        for (row, (own, left)) in self.rows.iter_mut().zip(pairs()) {
            for (entry, (other, right)) in row.as_mut().iter_mut().zip(pairs()) {
                *entry = *entry + both * *own * *other - (*left * *other + *own * *right) / along;
            }
        }
    }
}

fn dot<T: Real>(a: &impl AsRef<[T]>, b: &impl AsRef<[T]>) -> T {
    let pairs = a.as_ref().iter().zip(b.as_ref());
    pairs.fold(T::ZERO, |sum, (a, b)| sum + *a * *b)
}

fn plus<T: Real, N: AsRef<[T]> + AsMut<[T]> + Clone>(a: &N, factor: T, b: &N) -> N {
    let mut sum = a.clone();
    for (part, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *part = *part + factor * *b;
    }
    sum
}

/// The greatest size of numbers.
fn size<T: Real>(numbers: &impl AsRef<[T]>) -> T {
    let numbers = numbers.as_ref().iter();
    numbers.fold(T::ZERO, |most, number| most.max(number.abs()))
}
