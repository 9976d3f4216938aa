//! Moves by which the compiler looks at a mechanism: they take so many operations and no more, whatever the mechanism.

use crate::evaluate::Machine;
use crate::motion::sweep::interpolate;
use crate::program::{Position, Program};

/// A move may take so many times the operations of one position.
const MOST_OF_MOVE: usize = 256;
/// So often is a step halved that does not close: a part of it as small as rounding is left.
const HALVINGS: usize = 48;

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
    machine: Machine<'p, f64>,
    /// The operations of one position.
    pub(crate) price: usize,
    /// Whether a step that fails may work in smaller ones.
    iterates: bool,
    /// The operations that are left, and those of them that moves on this way may take which go in pieces.
    left: usize,
    of_way: usize,
}

impl<'p> Walker<'p> {
    /// A mechanism at its start, which may be moved by so many operations.
    pub(crate) fn new(program: &'p Program, left: usize) -> Self {
        Self {
            machine: Machine::new(program),
            price: price(program),
            iterates: program.subdivides(),
            left,
            of_way: 0,
        }
    }

    pub(crate) fn position(&self) -> &Position<f64> {
        self.machine.position()
    }

    /// Lets it begin a way from a position that it had before. When so many positions were found on the way, each next one is found in one
    /// step from that before it, as if nothing were between them.
    pub(crate) fn begin(&mut self, from: Position<f64>, positions: usize) {
        self.machine.put_back(from);
        self.of_way = self.price.saturating_mul(positions);
    }

    /// Takes the operations of something else.
    pub(crate) fn pay(&mut self, operations: usize) {
        self.left = self.left.saturating_sub(operations);
    }

    /// Whether so many positions can be paid.
    pub(crate) fn can_pay(&self, positions: usize) -> bool {
        self.left >= self.price.saturating_mul(positions)
    }

    /// Moves as far towards these values of the motors as it can.
    pub(crate) fn visit(&mut self, target: &[f64]) -> Arrival {
        let before = self.position().clone();
        let allowed = self.left.min(self.of_way).min(MOST_OF_MOVE * self.price);
        let came = self.paid(allowed, |machine| {
            machine.move_toward(target).ok().flatten().is_none()
        });
        self.of_way -= (allowed - self.machine.left()).min(self.of_way);
        match came {
            Some(true) => return Arrival::There,
            Some(false) => return Arrival::Blocked,
            None => self.machine.put_back(before),
        }
        self.of_way = 0;
        self.leap(target)
    }

    /// Goes there in one step, or as far as steps close.
    fn leap(&mut self, target: &[f64]) -> Arrival {
        let start = self.position().motors.clone();
        let way: Vec<f64> = target
            .iter()
            .zip(&start)
            .map(|(to, from)| to - from)
            .collect();
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
        if self.iterates {
            return Arrival::Unpaid;
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

/// The operations of one position.
pub(crate) fn price(program: &Program) -> usize {
    program.live.iter().filter(|live| **live).count() + 1
}
