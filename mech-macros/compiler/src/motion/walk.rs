//! Moves by which the compiler looks at a mechanism: they take so many operations and no more, whatever the mechanism.
//!
//! A journey as at run time looks closely at loops near change points, and takes many positions. Here one step is enough where the positions
//! before foretell what it finds: no loop then went to another side unseen.

use crate::evaluate::Machine;
use crate::motion::sweep::interpolate;
use crate::program::{AtZero, Follow, Position, Program, Watch};
use std::rc::Rc;

/// A journey may take so many times the operations of one position.
const MOST_OF_JOURNEY: usize = 64;
/// A step that does not close is halved so often: then no more than rounding is left of it.
const HALVINGS: usize = 48;
/// A move that nothing foretells begins with this part of it.
const FIRST: f64 = 0.25;
/// A step that nothing foretells may move poses by this part of the greatest one, and change a sine by this part of it.
const BEGUN: f64 = 0.1;
const BEGUN_SINE: f64 = 0.75;
/// The position after a step may differ from the foretold one by this part of the step.
const ASTRAY: f64 = 0.4;
/// Towards a dead point each step covers at most this part of what is left until there. When less than the second number is left of the
/// move, and nothing closes beyond, the end is foretold.
const NEARER: f64 = 0.97;
const END: f64 = 1e-8;
/// Towards a zero beyond which the loop closes, steps go on until this part of the move is left. Nearer than the second number, they may
/// fail by rounding.
const NEAREST: f64 = 1e-13;
const ROUNDED: f64 = 1e-9;
/// The most steps of a move. The second numbers say how often a step may fail before a journey is made instead, and before a rough way
/// ends.
const MOST_STEPS: usize = 96;
const MOST_FAILED: [usize; 2] = [6, 3];
/// The greatest and the least factor by which the next step may be longer than the last. Of the factor that the error would allow, it is
/// given the third number as its part.
const LONGER: f64 = 4.0;
const SHORTER: f64 = 0.1;
const RESERVE: f64 = 0.7;
/// Poses that move less than this part of the one that moves most are compared less strictly.
const SLOW: f64 = 0.02;
/// A sine counts as zero if it is below this part of what it was before.
const FLAT: f64 = 0.02;
/// A followed angle may differ from what was foretold by so many radians: half a turn off, its whole turns would be lost.
const ANGLE: f64 = 1.0;
/// Motors are on one line with others if they are off it by no more than this part of the way.
const ALIGNED: f64 = 1e-9;
/// Positions that foretell the next one are at least this part of the way apart.
const APART: f64 = 1.0 / 64.0;
/// So many positions foretell the next one, beside that from which it goes.
const TRAIL: usize = 3;

/// The outcome of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arrival {
    /// It came to where it should.
    There,
    /// It came as far as the mechanism moves.
    Blocked,
    /// The move was not made: the budget is too small, or an iteration failed in one step.
    Unpaid,
}

/// A mechanism that moves within a budget of operations.
pub(crate) struct Walker<'p> {
    program: &'p Program,
    machine: Machine<'p, f64>,
    /// The operations of one position.
    pub(crate) price: usize,
    /// Positions near the present one, the nearest last.
    trail: Vec<Rc<Position<f64>>>,
    /// Those that the last move came past.
    pub(crate) passed: Vec<Rc<Position<f64>>>,
    /// The position at the dead point where the last move ends. It is foretold; the mechanism came almost there.
    end: Option<Position<f64>>,
    /// Whether it made a step on this way that nothing foretold.
    pub(crate) is_unsure: bool,
    /// Whether it may end where nothing foretells how it goes on.
    is_rough: bool,
    /// The greatest length of the next step, as the steps before it allow.
    reach: f64,
    /// The operations that are left, and those of them that journeys on this way may use.
    left: usize,
    of_way: usize,
}

impl<'p> Walker<'p> {
    /// A mechanism at its start, with a budget of so many operations.
    pub(crate) fn new(program: &'p Program, left: usize) -> Self {
        Self {
            program,
            machine: Machine::new(program),
            price: price(program),
            trail: Vec::new(),
            passed: Vec::new(),
            end: None,
            reach: f64::INFINITY,
            is_rough: false,
            is_unsure: false,
            left,
            of_way: 0,
        }
    }

    pub(crate) fn position(&self) -> &Position<f64> {
        self.machine.position()
    }

    /// The position at the end of the last move.
    pub(crate) fn seen(&self) -> &Position<f64> {
        self.end.as_ref().unwrap_or(self.position())
    }

    /// Its position, to be kept.
    pub(crate) fn here(&self) -> Rc<Position<f64>> {
        Rc::new(self.seen().clone())
    }

    /// Puts the mechanism at a position that it had before, from where a new way begins. `positions` limits what journeys may cost on it.
    pub(crate) fn begin(&mut self, from: &Position<f64>, positions: usize) {
        self.machine.put_back(from.clone());
        self.end = None;
        self.trail.clear();
        self.reach = f64::INFINITY;
        self.is_rough = false;
        self.is_unsure = false;
        self.of_way = self.price.saturating_mul(positions);
    }

    /// The same, but the way ends where nothing foretells how it goes on.
    pub(crate) fn begin_roughly(&mut self, from: &Position<f64>) {
        self.begin(from, 0);
        self.is_rough = true;
    }

    /// Adds a position to those that foretell the next one. From there to here nothing was passed unseen.
    pub(crate) fn know(&mut self, position: Rc<Position<f64>>) {
        if self.trail.len() == TRAIL {
            self.trail.remove(0);
        }
        self.trail.push(position);
    }

    /// Takes operations from the budget that something else has used.
    pub(crate) fn pay(&mut self, operations: usize) {
        self.left = self.left.saturating_sub(operations);
    }

    /// Moves as far towards these values of the motors as it can; [`passed`](Self::passed) tells by what way.
    pub(crate) fn visit(&mut self, target: &[f64]) -> Arrival {
        self.passed.clear();
        self.end = None;
        if self.program.is_function() {
            return self.travel_or_leap(target);
        }
        let mut way = Way::new(self.position(), target);
        if way.whole == 0.0 {
            return Arrival::There;
        }
        let known = self.places(&self.here(), &way.vector);
        way.part = (self.reach / way.whole).min(1.0);
        way.part = match known.get(1) {
            Some((nearest, _)) => way.part.min(LONGER * nearest.abs()),
            None => FIRST * way.part,
        };
        for _ in 0..MOST_STEPS {
            if let Some(arrival) = self.go_on(&mut way) {
                return arrival;
            }
        }
        self.travel_or_leap(target)
    }

    /// Makes one step on a way, or shortens the next one; tells if the way is at its end.
    fn go_on(&mut self, way: &mut Way<'_>) -> Option<Arrival> {
        let before = self.here();
        let zero = self.zero_ahead(&way.vector);
        let near = zero.filter(|_| way.comes_near);
        if let Some(zero) = near
            && zero < END
            && (self.is_rough || !self.closes(&way.motors(way.after(4.0 * END))))
        {
            self.foretell_end(way, before, zero);
            return Some(Arrival::Blocked);
        }
        if near.is_some_and(|zero| zero < NEAREST) {
            return self.go_past(way, before, way.after(4.0 * NEAREST));
        }
        let length = near.map_or(way.part, |zero| way.part.min(NEARER * zero));
        let next = way.after(length);
        let Some(astray) = self.try_step(way, &before, (next, near)) else {
            return Some(Arrival::Unpaid);
        };
        let factor = factor(self.trail.len(), astray);
        if astray <= 1.0 {
            let most = if way.failed == 0 { LONGER } else { 1.0 };
            way.part = (next - way.done) * factor.min(most);
            self.reach = way.part * way.whole;
            self.know(Rc::clone(&before));
            return self.came(way, before, next);
        }
        if !way.comes_near && zero.is_some_and(|zero| zero < 2.0 * length) {
            way.comes_near = true;
            return None;
        }
        let is_rounded = near.is_some_and(|zero| zero < ROUNDED);
        if !is_rounded && way.failed < MOST_FAILED[usize::from(self.is_rough)] {
            way.failed += 1;
            way.part = length * factor.clamp(SHORTER, 0.5);
            return None;
        }
        let past = zero.filter(|zero| 4.0 * zero < length);
        let next = past.map_or(next, |zero| way.after(4.0 * zero.max(NEAREST)));
        self.go_past(way, before, next)
    }

    /// Makes a step. Near a dead point the prediction is a polynomial in the root of what is left until there, else in the way. Gives how
    /// far off the prediction was.
    fn try_step(
        &mut self,
        way: &mut Way<'_>,
        before: &Rc<Position<f64>>,
        (next, near): (f64, Option<f64>),
    ) -> Option<f64> {
        let motors = way.motors(next);
        let zero = near.map(|zero| zero / (next - way.done));
        let mut astray = self.step(before, &motors, zero)?;
        if astray > 1.0 && near.is_some() {
            // Before a change point everything is smooth in the motors.
            astray = self.step(before, &motors, None)?;
            way.comes_near = astray > 1.0;
        }
        Some(astray)
    }

    /// Goes on where nothing foretells how, by a journey as at run time. A rough way ends there, and so does a way beyond which nothing
    /// closes.
    fn go_past(
        &mut self,
        way: &mut Way<'_>,
        before: Rc<Position<f64>>,
        next: f64,
    ) -> Option<Arrival> {
        let motors = way.motors(next);
        let is_there = next - way.done <= 4.0 * NEAREST;
        let arrival = if self.is_rough || is_there && !self.closes(&motors) {
            self.doubt(&before);
            Arrival::Blocked
        } else {
            self.travel_or_leap(&motors)
        };
        if arrival != Arrival::There {
            self.passed.push(before);
            return Some(arrival);
        }
        (way.comes_near, way.part) = (false, LONGER * (next - way.done));
        self.trail.clear();
        self.came(way, before, next)
    }

    /// Notes that the way was done up to here. Tells if that is its end.
    fn came(&mut self, way: &mut Way<'_>, before: Rc<Position<f64>>, next: f64) -> Option<Arrival> {
        self.passed.push(before);
        (way.done, way.failed) = (next, 0);
        (next >= 1.0).then_some(Arrival::There)
    }

    /// Notes where a way ends, if a zero is this near: the position there is foretold.
    fn foretell_end(&mut self, way: &Way<'_>, before: Rc<Position<f64>>, zero: f64) {
        self.doubt(&before);
        let motors = way.motors(way.done + zero);
        let places = self.places(&before, &between(&before.motors, &motors));
        let mut end = self.foretell(&places, Some(1.0));
        for watch in &self.program.watches {
            // It stays on its side.
            let (sine, side) = (&mut end.state[watch.sine], before.state[watch.sine]);
            *sine = sine.abs().max(f64::EPSILON).copysign(side);
        }
        end.motors = motors;
        // Parts that fly away may be foretold beyond all numbers.
        let mut numbers = end.poses.as_flattened().iter().chain(&end.state);
        self.end = numbers.all(|number| number.is_finite()).then_some(end);
        self.passed.push(before);
    }

    /// Notes that not everything beyond was seen, if several loops come to their ends together.
    fn doubt(&mut self, end: &Position<f64>) {
        let watches = self.program.watches.iter();
        let flat = watches.filter(|watch| end.state[watch.sine].abs() < FLAT);
        self.is_unsure |= flat.count() > 1;
    }

    /// Goes there in one step, and stays there only if that finds what was foretold. Gives how far off the prediction was, as a part of
    /// what is allowed; none if the budget is used up. If a dead point is `zero` away, everything is smooth in the root of what is left
    /// until there.
    fn step(
        &mut self,
        before: &Rc<Position<f64>>,
        motors: &[f64],
        zero: Option<f64>,
    ) -> Option<f64> {
        let places = self.places(before, &between(&before.motors, motors));
        let foretold = self.foretell(&places, zero);
        let leap = |machine: &mut Machine<'_, f64>| machine.leap_from(&foretold, motors).is_ok();
        if !self.paid(self.left, leap)? {
            return Some(f64::INFINITY);
        }
        let astray = self.astray(before, &foretold, places.len() > 1);
        if astray <= 1.0 {
            // Of loops that pass change points together, nothing tells that each passes its own.
            let sine = |watch: &&Watch| {
                let [then, now] = [before, self.position()].map(|at| at.state[watch.sine]);
                then * now <= 0.0
            };
            self.is_unsure |= self.program.watches.iter().filter(sine).count() > 1;
        } else {
            self.machine.put_back(Position::clone(before));
        }
        Some(astray)
    }

    /// The known positions on the line of a way that begins at a position, each with its part of the way; that position first.
    fn places(&self, from: &Rc<Position<f64>>, way: &[f64]) -> Vec<(f64, Rc<Position<f64>>)> {
        let mut places = vec![(0.0, Rc::clone(from))];
        for other in self.trail.iter().rev() {
            if let Some(place) = place_on(way, from, other)
                && places.iter().all(|known| (known.0 - place).abs() > APART)
            {
                places.push((place, Rc::clone(other)));
            }
        }
        places
    }

    /// The part of the way where first the sine of a watched loop comes to zero, if its square goes on as between the last positions.
    fn zero_ahead(&self, way: &[f64]) -> Option<f64> {
        let here = self.position();
        let on_way =
            |other: &Rc<Position<f64>>| Some((place_on(way, here, other)?, Rc::clone(other)));
        let known: Vec<_> = self.trail.iter().rev().map_while(on_way).take(2).collect();
        let zero = |watch: &Watch| {
            let square = |position: &Position<f64>| position.state[watch.sine].powi(2);
            let now = square(here);
            let mut zeros = known.iter().map(|(place, position)| {
                let then = square(position);
                (place * now / (now - then), then)
            });
            let (first, then) = zeros.next()?;
            // The place is taken to be a parabola of the square.
            let zero = zeros.next().map_or(first, |(second, earlier)| {
                (first * earlier - second * then) / (earlier - then)
            });
            let is_near = zero > 0.5 * first && zero < 2.0 * first;
            let zero = if is_near { zero } else { first };
            (zero > 0.0).then_some(zero)
        };
        let zeros = self.program.watches.iter().filter_map(zero);
        zeros.min_by(f64::total_cmp)
    }

    /// Extrapolates a polynomial through known places to the end of a way: from there an iteration begins. Past a change point a loop is on
    /// its other side.
    fn foretell(&self, places: &[(f64, Rc<Position<f64>>)], zero: Option<f64>) -> Position<f64> {
        let root = |place: f64| zero.map_or(place, |zero| (zero - place).max(0.0).sqrt());
        let roots: Vec<f64> = places.iter().map(|place| root(place.0)).collect();
        let weight = |(number, own): (usize, &f64)| {
            let others = roots.iter().enumerate().filter(|other| other.0 != number);
            others.map(|(_, other)| (root(1.0) - other) / (own - other)).product::<f64>()
        };
        let weights: Vec<f64> = roots.iter().enumerate().map(weight).collect();
        let sum = |value: &dyn Fn(&Position<f64>) -> f64| -> f64 {
            let parts = places.iter().zip(&weights);
            parts.map(|(place, weight)| weight * value(&place.1)).sum()
        };
        let before = &places[0].1;
        let mut foretold = Position::clone(before);
        for (link, pose) in foretold.poses.iter_mut().enumerate() {
            *pose = std::array::from_fn(|part| sum(&|position| position.poses[link][part]));
        }
        // After these there are signs.
        let signs = self.program.layout.motion_signs;
        let numbers = signs.unwrap_or(foretold.state.len());
        for number in 0..numbers {
            foretold.state[number] = sum(&|position| position.state[number]);
        }
        for watch in &self.program.watches {
            let (now, then) = (before.state[watch.sine], &mut foretold.state[watch.sine]);
            // It goes over to the other side only where it went towards it before.
            let goes_over = places.get(1).is_some_and(|(place, other)| {
                let other = other.state[watch.sine];
                now * other < 0.0 || *place < 0.0 && now.abs() < other.abs()
            });
            if now * *then <= 0.0 && !(watch.at_zero == AtZero::ChangeBranch && goes_over) {
                *then = now;
            }
        }
        foretold
    }

    /// Returns the difference between the position and the foretold one, as a part of what is allowed. Without a prediction, `foretold` is
    /// the position before.
    fn astray(&self, from: &Position<f64>, foretold: &Position<f64>, is_begun: bool) -> f64 {
        let to = self.position();
        // Of directions and of places.
        let of_poses = [0, 2].map(|part| {
            let square = |x: f64, y: f64| x * x + y * y;
            let apart = |[a, b]: [&Position<f64>; 2], link: usize| {
                let [a, b] = [a, b].map(|position| &position.poses[link]);
                square(a[part] - b[part], a[part + 1] - b[part + 1])
            };
            let gone: Vec<f64> = (0..to.poses.len()).map(|link| apart([from, to], link)).collect();
            let least = SLOW * SLOW * gone.iter().copied().fold(0.0, f64::max);
            let sizes = to.poses.iter();
            let sizes = sizes.map(|pose| square(pose[part], pose[part + 1]));
            let size = sizes.fold(0.0, f64::max).sqrt();
            let parts = gone.iter().enumerate().map(|(link, gone)| {
                let allowed = if is_begun {
                    ASTRAY * gone.max(least).sqrt() + f64::EPSILON.sqrt() * size
                } else {
                    BEGUN * size
                };
                part_of(apart([foretold, to], link).sqrt(), allowed)
            });
            parts.fold(0.0, f64::max)
        });
        let of_watch = |watch: &Watch| {
            let [before, foretold, found] =
                [from, foretold, to].map(|position| position.state[watch.sine]);
            let gone = (found - before).abs();
            let allowed = if is_begun {
                ASTRAY * gone.max(SLOW * found.abs())
            } else {
                BEGUN_SINE * found.abs().max(before.abs())
            };
            // On a change point its side is that of the next step.
            let is_flat = is_begun && foretold.abs().max(found.abs()) <= FLAT * gone;
            if foretold * found > 0.0 || is_flat {
                part_of((found - foretold).abs(), allowed)
            } else {
                f64::INFINITY
            }
        };
        let of_follow = |follow: &Follow| {
            let [foretold, found] = [foretold, to].map(|position| position.state[follow.angle]);
            (found - foretold).abs() / ANGLE
        };
        let watches = self.program.watches.iter().map(of_watch);
        let follows = self.program.follows.iter().map(of_follow);
        let all = of_poses.into_iter().chain(watches).chain(follows);
        all.fold(0.0, f64::max)
    }

    /// Whether all loops close there in one step. The mechanism stays where it is.
    fn closes(&mut self, motors: &[f64]) -> bool {
        let before = self.position().clone();
        let closes = self.beside(&before, motors).is_some();
        self.machine.put_back(before);
        closes
    }

    /// The position that one step from another position leads to; none if a loop does not close there.
    pub(crate) fn beside(
        &mut self,
        from: &Position<f64>,
        motors: &[f64],
    ) -> Option<&Position<f64>> {
        self.machine.put_back(from.clone());
        let came = self.paid(self.left, |machine| machine.leap(motors).is_ok());
        (came == Some(true)).then(|| self.machine.position())
    }

    /// Moves there as a mechanism does at run time; if that takes too much, in one step.
    fn travel_or_leap(&mut self, motors: &[f64]) -> Arrival {
        match self.travel(motors) {
            Arrival::Unpaid => {
                self.is_unsure = true;
                self.leap(motors)
            }
            arrival => arrival,
        }
    }

    /// Moves there as a mechanism does at run time.
    fn travel(&mut self, target: &[f64]) -> Arrival {
        let before = self.position().clone();
        let allowed = self.left.min(self.of_way).min(MOST_OF_JOURNEY * self.price);
        let came =
            self.paid(allowed, |machine| machine.move_toward(target).ok().flatten().is_none());
        self.of_way -= (allowed - self.machine.left()).min(self.of_way);
        match came {
            Some(true) => Arrival::There,
            Some(false) => Arrival::Blocked,
            None => {
                self.machine.put_back(before);
                self.of_way = 0;
                Arrival::Unpaid
            }
        }
    }

    /// Goes there in one step, or as far as steps close.
    fn leap(&mut self, target: &[f64]) -> Arrival {
        let start = self.position().motors.clone();
        let way = between(&start, target);
        let (mut done, mut part) = (0.0, 1.0);
        for _ in 0..=HALVINGS {
            let motors = interpolate(&start, &way, done + part);
            match self.paid(self.left, |machine| machine.leap(&motors).is_ok()) {
                None => return Arrival::Unpaid,
                Some(true) if part == 1.0 => return Arrival::There,
                Some(true) => done += part,
                Some(false) => {}
            }
            part *= 0.5;
        }
        Arrival::Blocked
    }

    /// Does something that may use so many operations, and takes what it used from the budget. None if it would use more.
    fn paid<R>(
        &mut self,
        allowed: usize,
        act: impl FnOnce(&mut Machine<'p, f64>) -> R,
    ) -> Option<R> {
        self.machine.allow(allowed);
        let done = act(&mut self.machine);
        let rest = self.machine.left();
        self.pay(allowed - rest);
        (rest > 0).then_some(done)
    }
}

/// A way to values of the motors.
struct Way<'t> {
    start: Vec<f64>,
    target: &'t [f64],
    vector: Vec<f64>,
    /// Its length.
    whole: f64,
    /// The part that is done, and that of the next step.
    done: f64,
    part: f64,
    /// Whether it comes near a dead point, and how often the next step was shortened.
    comes_near: bool,
    failed: usize,
}

impl<'t> Way<'t> {
    fn new(from: &Position<f64>, target: &'t [f64]) -> Self {
        let vector = between(&from.motors, target);
        Self {
            start: from.motors.clone(),
            target,
            whole: vector.iter().map(|part| part * part).sum::<f64>().sqrt(),
            vector,
            done: 0.0,
            part: 0.0,
            comes_near: false,
            failed: 0,
        }
    }

    /// Returns the part that is done after a step of such a part; all of it if little is left.
    fn after(&self, length: f64) -> f64 {
        let next = self.done + length;
        if next + 0.5 * length < 1.0 { next } else { 1.0 }
    }

    /// The motors where this part of the way is done.
    fn motors(&self, done: f64) -> Vec<f64> {
        if done < 1.0 { interpolate(&self.start, &self.vector, done) } else { self.target.to_vec() }
    }
}

/// By what factor the next step may be longer, if the last was so far astray. The error grows with a power of the step, by the number of
/// known positions.
fn factor(known: usize, astray: f64) -> f64 {
    if astray.is_infinite() {
        return 0.5;
    }
    let power = [1.0, 1.0, 2.0, 3.0][known.min(TRAIL)];
    RESERVE * astray.powf(-1.0 / power)
}

/// Returns the part of what is allowed that was used.
fn part_of(found: f64, allowed: f64) -> f64 {
    if found == 0.0 { 0.0 } else { found / allowed }
}

/// The part of a way at which a position lies; none if it is not on the line of the way.
fn place_on(way: &[f64], from: &Position<f64>, other: &Position<f64>) -> Option<f64> {
    let square: f64 = way.iter().map(|part| part * part).sum();
    let apart = between(&from.motors, &other.motors);
    let pairs = || apart.iter().zip(way);
    let place = pairs().map(|(apart, way)| apart * way).sum::<f64>() / square;
    let aside = pairs().map(|(apart, way)| (apart - place * way).powi(2));
    let is_on = aside.sum::<f64>() <= (ALIGNED * place).powi(2) * square;
    is_on.then_some(place)
}

/// The way of the motors from some values to others.
fn between(from: &[f64], to: &[f64]) -> Vec<f64> {
    to.iter().zip(from).map(|(to, from)| to - from).collect()
}

/// The operations of one position.
pub(crate) fn price(program: &Program) -> usize {
    program.live.iter().filter(|live| **live).count() + 1
}
