//! The sides on which loops lie that pass change points: where each is reached.

use crate::certify::Interval;
use crate::evaluate::Machine;
use crate::program::{BlockId, Position, Program, Watch};

/// After so many turns of a motor everything should be back.
const MOST_TURNS: i32 = 4;

/// The sides of the loops that may change them.
pub(super) struct Sides<'p> {
    program: &'p Program,
    /// The loops that may change their side.
    crossing: Vec<BlockId>,
    /// Those of them that are on the other side than at the start.
    turned: Vec<BlockId>,
    /// The only motor that has a part, and the turn after which it comes to the same place: zero if it does not go round. With several
    /// motors, the way there decides, and nothing is told.
    motor: Option<(usize, f64)>,
}

impl<'p> Sides<'p> {
    /// Sides of a program, of which these are turned; `motor` is the only one that has a part, with the values it goes round.
    pub(super) fn new(
        program: &'p Program,
        [crossing, turned]: [Vec<BlockId>; 2],
        motor: Option<(usize, Option<Interval>)>,
    ) -> Self {
        let motor = motor.map(|(motor, round)| (motor, round.map_or(0.0, Interval::width)));
        Self {
            program,
            crossing,
            turned,
            motor,
        }
    }

    /// The loops that may change their side.
    pub(super) fn crossing(&self) -> &[BlockId] {
        &self.crossing
    }

    /// Those of them that are on the other side than at the start.
    pub(super) fn turned(&self) -> &[BlockId] {
        &self.turned
    }

    /// Whether it can be told where these sides are reached, and that matters.
    pub(super) fn are_told(&self) -> bool {
        !self.crossing.is_empty() && self.motor.is_some()
    }

    /// Whether the mechanism comes to a place with the loops on these sides, as far as that can be told.
    pub(super) fn are_reached(&self, place: &[f64]) -> bool {
        let (false, Some((motor, round))) = (self.crossing.is_empty(), self.motor) else {
            return true;
        };
        let turns = if round == 0.0 { 0 } else { MOST_TURNS };
        (-turns..=turns).any(|turn| {
            let mut goal = place.to_vec();
            goal[motor] += f64::from(turn) * round;
            let mut machine = Machine::<f64>::new(self.program);
            match machine.move_to(&goal) {
                Ok(()) => self.are_those_of(machine.position()),
                // It should come there.
                Err(_) => turn == 0,
            }
        })
    }

    fn are_those_of(&self, position: &Position<f64>) -> bool {
        let start = &self.program.start;
        let is_as_wanted = |watch: &Watch| {
            let side = |position: &Position<f64>| position.state[watch.sine].is_sign_positive();
            let stays = side(position) == side(start);
            stays != self.turned.contains(&watch.block)
        };
        let mut watches = self.program.watches.iter();
        watches.all(|watch| !self.crossing.contains(&watch.block) || is_as_wanted(watch))
    }
}
