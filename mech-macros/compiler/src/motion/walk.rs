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
/// So often is a step halved that does not close: a part of it as small as rounding is left.
const HALVINGS: usize = 48;
/// A move that nothing foretells begins with this part of it.
const FIRST: f64 = 0.25;
/// The most that moves in a step which nothing foretells, as a part of itself.
const BEGUN: f64 = 0.1;
const BEGUN_SINE: f64 = 0.75;
/// What is found lies no farther from what was foretold than this part of the way there.
const ASTRAY: f64 = 0.4;
/// Near a dead point each step comes so near to it, as a part of what is left, until this part of a move is left, or on a rough way.
const NEARER: f64 = 0.9;
const NEAREST: [f64; 2] = [1e-13, 1e-4];
/// Steps of a move at most, and so often is one halved before a journey is made instead; before a rough way ends.
const MOST_STEPS: usize = 96;
const MOST_FAILED: [usize; 2] = [6, 3];
/// A step that was foretold lets the next one be so many times as long.
const LONGER: f64 = 3.0;
/// What moves less than this part of what moves most is not looked at so closely.
const SLOW: f64 = 0.02;
/// A sine is zero that is less than this part of what it was before.
const FLAT: f64 = 0.02;
/// An angle that is followed is foretold by so much: half a turn is lost else.
const ANGLE: f64 = 1.0;
/// Motors that lie on a line with others, within this part of the way.
const ALIGNED: f64 = 1e-9;
/// What foretells is so far apart, as a part of the way.
const APART: f64 = 1.0 / 64.0;
/// So many positions foretell the next one, beside that from which it goes.
const TRAIL: usize = 3;

/// What became of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Arrival {
    /// It came to where it should.
    There,
    /// It came as far as the mechanism moves.
    Blocked,
    /// It was not made: too little is left, or an iteration did not come so far in one step.
    Unpaid,
}

/// A mechanism that is moved as long as there is something left to pay with.
pub(crate) struct Walker<'p> {
    program: &'p Program,
    machine: Machine<'p, f64>,
    /// The operations of one position.
    pub(crate) price: usize,
    /// Positions near the present one, the nearest last.
    trail: Vec<Rc<Position<f64>>>,
    /// Those that the last move came past.
    pub(crate) passed: Vec<Rc<Position<f64>>>,
    /// Whether it made a step on this way that nothing foretold.
    pub(crate) is_unsure: bool,
    /// Whether it may end where nothing foretells how it goes on.
    is_rough: bool,
    /// How long a step may be, after those before it.
    reach: f64,
    /// The operations that are left, and those of them that journeys on this way may take.
    left: usize,
    of_way: usize,
}

impl<'p> Walker<'p> {
    /// A mechanism at its start, which may be moved by so many operations.
    pub(crate) fn new(program: &'p Program, left: usize) -> Self {
        Self {
            program,
            machine: Machine::new(program),
            price: price(program),
            trail: Vec::new(),
            passed: Vec::new(),
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

    /// The same, to be kept.
    pub(crate) fn here(&self) -> Rc<Position<f64>> {
        Rc::new(self.position().clone())
    }

    /// Lets it begin a way from a position that it had before. When journeys took so many positions on the way, steps that nothing foretells
    /// are made all the same.
    pub(crate) fn begin(&mut self, from: &Position<f64>, positions: usize) {
        self.machine.put_back(from.clone());
        self.trail.clear();
        self.reach = f64::INFINITY;
        self.is_rough = false;
        self.is_unsure = false;
        self.of_way = self.price.saturating_mul(positions);
    }

    /// The same of a way that ends where nothing foretells how it goes on.
    pub(crate) fn begin_roughly(&mut self, from: &Position<f64>) {
        self.begin(from, 0);
        self.is_rough = true;
    }

    /// Tells it a position that it can come to from where it is without passing anything.
    pub(crate) fn know(&mut self, position: Rc<Position<f64>>) {
        if self.trail.len() == TRAIL {
            self.trail.remove(0);
        }
        self.trail.push(position);
    }

    /// Takes the operations of something else.
    pub(crate) fn pay(&mut self, operations: usize) {
        self.left = self.left.saturating_sub(operations);
    }

    /// Whether so many positions can be paid.
    pub(crate) fn can_pay(&self, positions: usize) -> bool {
        self.left >= self.price.saturating_mul(positions)
    }

    /// Moves as far towards these values of the motors as it can; [`passed`](Self::passed) tells by what way.
    pub(crate) fn visit(&mut self, target: &[f64]) -> Arrival {
        self.passed.clear();
        if self.program.is_function() {
            return self.travel_or_leap(target);
        }
        let start = self.position().motors.clone();
        let way = between(&start, target);
        let whole: f64 = way.iter().map(|part| part * part).sum::<f64>().sqrt();
        if whole == 0.0 {
            return Arrival::There;
        }
        let is_begun = self.places(&self.here(), &way).len() > 1;
        let (mut done, mut part) = (0.0, self.reach / whole);
        if !is_begun {
            part = FIRST * part.min(1.0);
        }
        let (mut comes_near, mut failed) = (false, 0);
        for _ in 0..MOST_STEPS {
            let zero = self.zero_ahead(&way);
            let length = match zero {
                Some(zero) if comes_near => part.min(NEARER * zero),
                _ => part,
            };
            let (mut next, mut motors) = (1.0, target.to_vec());
            if done + 1.5 * length < 1.0 {
                next = done + length;
                motors = interpolate(&start, &way, next);
            }
            let nearest = NEAREST[usize::from(self.is_rough)];
            let is_there = comes_near && zero.is_some_and(|zero| zero < nearest);
            let before = self.here();
            let mut came = Some(false);
            if !is_there {
                let zero = zero.filter(|_| comes_near);
                came = self.step(&before, &motors, zero.map(|zero| zero / (next - done)));
                if came == Some(false) && comes_near {
                    // Before a change point everything is smooth in the motors.
                    came = self.step(&before, &motors, None);
                    comes_near = came != Some(true);
                }
            }
            match came {
                None => return Arrival::Unpaid,
                Some(true) => {
                    self.know(Rc::clone(&before));
                    part = next - done;
                    if failed == 0 {
                        part *= LONGER;
                    }
                    self.reach = part * whole;
                }
                Some(false) if !comes_near && zero.is_some_and(|zero| zero < 2.0 * length) => {
                    comes_near = true;
                    continue;
                }
                Some(false) if !is_there && failed < MOST_FAILED[usize::from(self.is_rough)] => {
                    failed += 1;
                    part = 0.5 * length;
                    continue;
                }
                Some(false) => {
                    if let Some(zero) = zero.filter(|zero| 4.0 * zero < length || is_there) {
                        next = 1.0_f64.min(done + 4.0 * zero.max(nearest));
                        motors = interpolate(&start, &way, next);
                    }
                    // So near to a zero beyond which nothing closes it is at its end.
                    if self.is_rough || is_there && !self.closes(&motors) {
                        let sines = self
                            .program
                            .watches
                            .iter()
                            .map(|watch| before.state[watch.sine]);
                        self.is_unsure |= sines.filter(|sine| sine.abs() < FLAT).count() > 1;
                        self.passed.push(before);
                        return Arrival::Blocked;
                    }
                    match self.travel_or_leap(&motors) {
                        Arrival::There => {}
                        end => {
                            self.passed.push(before);
                            return end;
                        }
                    }
                    (comes_near, part) = (false, LONGER * (next - done));
                    self.trail.clear();
                }
            }
            self.passed.push(before);
            (done, failed) = (next, 0);
            if done >= 1.0 {
                return Arrival::There;
            }
        }
        self.travel_or_leap(target)
    }

    /// Goes there in one step if that finds what was foretold, and else stays; none if that cannot be paid. At a dead point so far away as
    /// `zero` says everything is smooth in the root of what is left until there.
    fn step(
        &mut self,
        before: &Rc<Position<f64>>,
        motors: &[f64],
        zero: Option<f64>,
    ) -> Option<bool> {
        let places = self.places(before, &between(&before.motors, motors));
        let foretold = self.foretell(&places, zero);
        self.machine.put_back(foretold.clone());
        let came = self.paid(self.left, |machine| machine.leap(motors).is_ok());
        let is_foretold =
            came == Some(true) && self.is_foretold(before, &foretold, places.len() > 1);
        if is_foretold {
            // Of loops that pass change points together, nothing tells that each passes its own.
            let sine = |watch: &&Watch| {
                let [then, now] = [before, self.position()].map(|at| at.state[watch.sine]);
                then * now <= 0.0
            };
            self.is_unsure |= self.program.watches.iter().filter(sine).count() > 1;
        } else {
            self.machine.put_back(Position::clone(before));
        }
        came.map(|_| is_foretold)
    }

    /// The known positions on the line of a way, each with its part of the way from a position, and that first.
    fn places(&self, from: &Rc<Position<f64>>, way: &[f64]) -> Vec<(f64, Rc<Position<f64>>)> {
        let square: f64 = way.iter().map(|part| part * part).sum();
        let mut places = vec![(0.0, Rc::clone(from))];
        for other in self.trail.iter().rev() {
            let apart = between(&from.motors, &other.motors);
            let pairs = || apart.iter().zip(way);
            let place = pairs().map(|(apart, way)| apart * way).sum::<f64>() / square;
            let aside = pairs().map(|(apart, way)| (apart - place * way).powi(2));
            let is_on = aside.sum::<f64>() <= (ALIGNED * place).powi(2) * square;
            if is_on && places.iter().all(|known| (known.0 - place).abs() > APART) {
                places.push((place, Rc::clone(other)));
            }
        }
        places
    }

    /// The part of the way where first the sine of a watched loop comes to zero, if its square goes on as between the last two positions.
    fn zero_ahead(&self, way: &[f64]) -> Option<f64> {
        let here = self.position();
        let square: f64 = way.iter().map(|part| part * part).sum();
        let before = self.trail.last()?;
        let pairs = between(&here.motors, &before.motors);
        let place = pairs
            .iter()
            .zip(way)
            .map(|(apart, way)| apart * way)
            .sum::<f64>()
            / square;
        let zero = |watch: &Watch| {
            let [now, then] = [here, before].map(|position| position.state[watch.sine].powi(2));
            let zero = place * now / (now - then);
            (zero > 0.0).then_some(zero)
        };
        let zeros = self.program.watches.iter().filter_map(zero);
        zeros.min_by(f64::total_cmp)
    }

    /// What a polynomial through known places comes to at the end of a way: from there an iteration begins, and past a change point a loop is
    /// on its other side.
    fn foretell(&self, places: &[(f64, Rc<Position<f64>>)], zero: Option<f64>) -> Position<f64> {
        let root = |place: f64| zero.map_or(place, |zero| (zero - place).max(0.0).sqrt());
        let roots: Vec<f64> = places.iter().map(|place| root(place.0)).collect();
        let weight = |(number, own): (usize, &f64)| {
            let others = roots.iter().enumerate().filter(|other| other.0 != number);
            others
                .map(|(_, other)| (root(1.0) - other) / (own - other))
                .product::<f64>()
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
            if watch.at_zero != AtZero::ChangeBranch && now * *then <= 0.0 {
                *then = now;
            }
        }
        foretold
    }

    /// Whether the mechanism is where it was foretold to be; where nothing was, whether it is near.
    fn is_foretold(&self, from: &Position<f64>, foretold: &Position<f64>, is_begun: bool) -> bool {
        let to = self.position();
        // Of directions and of places.
        let is_near = [0, 2].into_iter().all(|part| {
            let square = |x: f64, y: f64| x * x + y * y;
            let apart = |[a, b]: [&Position<f64>; 2], link: usize| {
                let [a, b] = [a, b].map(|position| &position.poses[link]);
                square(a[part] - b[part], a[part + 1] - b[part + 1])
            };
            let gone: Vec<f64> = (0..to.poses.len())
                .map(|link| apart([from, to], link))
                .collect();
            let least = SLOW * SLOW * gone.iter().copied().fold(0.0, f64::max);
            let sizes = to
                .poses
                .iter()
                .map(|pose| square(pose[part], pose[part + 1]));
            let size = sizes.fold(0.0, f64::max).sqrt();
            gone.iter().enumerate().all(|(link, gone)| {
                let allowed = if is_begun {
                    ASTRAY * gone.max(least).sqrt() + f64::EPSILON.sqrt() * size
                } else {
                    BEGUN * size
                };
                apart([foretold, to], link) <= allowed * allowed
            })
        });
        let is_on_its_side = |watch: &Watch| {
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
            (found - foretold).abs() <= allowed && (foretold * found > 0.0 || is_flat)
        };
        let is_in_its_turn = |follow: &Follow| {
            let [foretold, found] = [foretold, to].map(|position| position.state[follow.angle]);
            (found - foretold).abs() <= ANGLE
        };
        is_near
            && self.program.watches.iter().all(is_on_its_side)
            && self.program.follows.iter().all(is_in_its_turn)
    }

    /// Whether loops close there in one step; it stays where it is.
    fn closes(&mut self, motors: &[f64]) -> bool {
        let before = self.position().clone();
        let came = self.paid(self.left, |machine| machine.leap(motors).is_ok());
        self.machine.put_back(before);
        came == Some(true)
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
        let came = self.paid(allowed, |machine| {
            machine.move_toward(target).ok().flatten().is_none()
        });
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

    /// Does something that takes no more than so many operations; none if it would take more.
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

/// The way of the motors from some values to others.
fn between(from: &[f64], to: &[f64]) -> Vec<f64> {
    to.iter().zip(from).map(|(to, from)| to - from).collect()
}

/// The operations of one position.
pub(crate) fn price(program: &Program) -> usize {
    program.live.iter().filter(|live| **live).count() + 1
}
