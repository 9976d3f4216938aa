//! Pieces that are computed in a loop: rows of one class after each other, or of several in turn.

use super::Term;
use super::class::{LEAST, Output};
use super::pieces::{Pieces, Place};
use crate::cancel;
use crate::program::{Program, Value};
use std::collections::BTreeMap;

/// The largest number of pieces that are computed in one round.
const LONGEST_ROUND: usize = 12;

/// The pieces that are computed next.
pub(super) enum Entry {
    /// A piece by itself.
    One(usize),
    /// Several in a loop.
    Roll(Roll),
}

/// Rounds in which pieces of the same classes are computed, with other rows in each.
pub(super) struct Roll {
    /// The pieces of each round, in the order in which they are computed.
    pub(super) rounds: Vec<Vec<usize>>,
    /// For each piece of a round, where its arguments come from.
    pub(super) arguments: Vec<Vec<Argument>>,
}

/// Where the argument of a piece comes from.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Argument {
    /// It is the same in all rounds.
    Same(Term),
    /// It is known before, and differs from round to round.
    Each(Vec<Term>),
    /// An earlier piece of the same round gives it.
    Now(Given),
    /// A piece of the round before gives it. In the first round it is this term.
    Before(Given, Term),
}

/// A result of a piece of a round, or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Given {
    /// The number of the piece in its round.
    pub(super) piece: usize,
    pub(super) output: Output,
    pub(super) negative: bool,
}

/// The entries of a schedule.
pub(super) fn entries(program: &Program, pieces: &Pieces, order: &[usize]) -> Vec<Entry> {
    let sequence = Sequence::new(program, pieces, order);
    let mut entries = Vec::new();
    let mut first = 0;
    while first < order.len() {
        if let Some(roll) = sequence.roll(first) {
            first += roll.rounds.len() * roll.arguments.len();
            entries.push(Entry::Roll(roll));
        } else {
            entries.push(Entry::One(order[first]));
            first += 1;
        }
    }
    entries
}

/// Returns the number of calls in the code of these entries.
pub(super) fn calls(entries: &[Entry]) -> usize {
    let calls = entries.iter().map(|entry| match entry {
        Entry::One(_) => 1,
        Entry::Roll(roll) => roll.arguments.len(),
    });
    calls.sum()
}

/// Where a value is made in a sequence.
#[derive(Clone, Copy)]
struct Made {
    place: usize,
    output: Output,
}

/// Pieces in the order in which they are computed.
struct Sequence<'s> {
    pieces: &'s Pieces,
    order: &'s [usize],
    /// The results of all pieces that are in a class.
    made: BTreeMap<Value, Made>,
}

/// Whence an argument comes, seen from one round.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Whence {
    Known,
    Now(Given),
    Before(Given),
    /// From a round before that, or from a later piece.
    Elsewhere,
}

/// A place in a sequence, and the length of the rounds that begin there.
#[derive(Clone, Copy)]
struct Round {
    first: usize,
    length: usize,
}

impl<'s> Sequence<'s> {
    fn new(program: &Program, pieces: &'s Pieces, order: &'s [usize]) -> Self {
        let mut made = BTreeMap::new();
        for (place, &piece) in order.iter().enumerate() {
            let Some(Place { class, row }) = pieces.all[piece].row else {
                continue;
            };
            for &value in &pieces.all[piece].flow.gives {
                let output = pieces.classes[class].output(program, row, value);
                made.insert(value, Made { place, output });
            }
        }
        Self { pieces, order, made }
    }

    /// The loop that begins at a place, with the length of round that puts most pieces into it.
    fn roll(&self, first: usize) -> Option<Roll> {
        cancel::check();
        let mut best: Option<Roll> = None;
        for length in 1..=LONGEST_ROUND {
            let round = Round { first, length };
            let Some(roll) = self.rounds(round) else {
                continue;
            };
            let size = |roll: &Roll| roll.rounds.len() * roll.arguments.len();
            if best.as_ref().is_none_or(|best| size(best) < size(&roll)) {
                best = Some(roll);
            }
        }
        best
    }

    fn class(&self, place: usize) -> Option<usize> {
        let piece = *self.order.get(place)?;
        Some(self.pieces.all[piece].row?.class)
    }

    /// The loop of rounds with this length that begins at a place; none if too few rounds are alike.
    fn rounds(&self, round: Round) -> Option<Roll> {
        let Round { first, length } = round;
        let mut count = 0;
        let is_like_the_first = |number: usize, index: usize| {
            let class = self.class(first + index);
            class.is_some() && class == self.class(first + number * length + index)
        };
        while (0..length).all(|index| is_like_the_first(count, index)) {
            count += 1;
        }
        let mut arguments = Vec::new();
        for index in 0..length {
            if count < LEAST {
                return None;
            }
            let class = self.class(first + index)?;
            let number = self.pieces.classes[class].rows[0].arguments.len();
            let mut of_piece = Vec::new();
            for argument in 0..number {
                let terms = self.terms(round, count, index, argument);
                count = count.min(self.regular(round, index, &terms));
                of_piece.push(terms);
            }
            arguments.push(of_piece);
        }
        if count < LEAST {
            return None;
        }
        let arguments = arguments.into_iter().enumerate().map(|(index, arguments)| {
            let arguments = arguments.into_iter();
            arguments
                .map(|mut terms| {
                    terms.truncate(count);
                    self.argument(round, index, terms)
                })
                .collect()
        });
        let rounds = (0..count).map(|number| {
            let first = first + number * length;
            self.order[first..first + length].to_vec()
        });
        Some(Roll { rounds: rounds.collect(), arguments: arguments.collect() })
    }

    /// An argument of a piece in each round.
    fn terms(&self, round: Round, count: usize, index: usize, argument: usize) -> Vec<Term> {
        let places = (0..count).map(|number| round.first + number * round.length + index);
        let rows = places.filter_map(|place| {
            let Place { class, row } = self.pieces.all[self.order[place]].row?;
            Some(self.pieces.classes[class].rows[row].arguments[argument])
        });
        rows.collect()
    }

    /// In how many rounds an argument comes from the same place.
    fn regular(&self, round: Round, index: usize, terms: &[Term]) -> usize {
        let whence = |number: usize| self.whence(round, number, index, terms[number]);
        let usual = whence(1);
        let begins = match usual {
            Whence::Now(_) => whence(0) == usual,
            Whence::Known | Whence::Before(_) => whence(0) == Whence::Known,
            Whence::Elsewhere => false,
        };
        if begins {
            let others = (1..terms.len()).take_while(|&number| whence(number) == usual);
            1 + others.count()
        } else {
            0
        }
    }

    /// Where the argument of a piece in one round comes from.
    fn whence(&self, round: Round, number: usize, index: usize, term: Term) -> Whence {
        let Some(made) = self.made.get(&term.value) else {
            return Whence::Known;
        };
        if made.place < round.first {
            return Whence::Known;
        }
        let offset = made.place - round.first;
        let given =
            Given { piece: offset % round.length, output: made.output, negative: term.negative };
        if offset / round.length == number && given.piece < index {
            Whence::Now(given)
        } else if offset / round.length + 1 == number {
            Whence::Before(given)
        } else {
            Whence::Elsewhere
        }
    }

    /// Where an argument comes from that has these values, round by round.
    fn argument(&self, round: Round, index: usize, terms: Vec<Term>) -> Argument {
        let first = terms[0];
        match self.whence(round, 1, index, terms[1]) {
            Whence::Now(given) => Argument::Now(given),
            Whence::Before(given) => Argument::Before(given, first),
            _ if terms.iter().all(|term| *term == first) => Argument::Same(first),
            _ => Argument::Each(terms),
        }
    }
}
