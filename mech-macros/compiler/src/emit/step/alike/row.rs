//! One of several pieces that are alike, and how it differs from the one that stands for all.

use super::Term;
use super::shape::{Kind, Operand, Operation, Shape};
use crate::program::{Op, Value};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::mem::discriminant;

/// A piece of a class, compared with the first of the class operation by operation: what it has where the first has something else.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    /// For each value that the pieces read from outside, the value that this one reads.
    pub(super) arguments: Vec<Term>,
    /// The numbers in its operations, in their order.
    pub(super) numbers: Vec<f64>,
    /// For each operation, whether it gives the opposite here.
    pub(super) opposite: Vec<bool>,
    /// The operations that make its own values, by position.
    pub(super) positions: BTreeMap<Value, usize>,
}

impl Row {
    /// The row of a piece of this shape among those like `first`; none if they are not alike.
    ///
    /// The root of a dyad may have the other sign: then the dyad lies on its other side. All that is multiplied with it then has the
    /// other sign, too, and no bit of what is added differs.
    pub(super) fn of(first: &Shape, shape: &Shape) -> Option<Self> {
        if first.ends.len() != shape.ends.len() {
            return None;
        }
        let outers = first.outers();
        [false, true].into_iter().find_map(|other_side| {
            let unifier = Unifier {
                first,
                shape,
                outers: &outers,
                other_side,
                known: vec![None; outers.len()],
                partners: vec![None; first.operations.len()],
                trail: Vec::new(),
            };
            unifier.run()
        })
    }

    /// Whether its dyad lies on the other side.
    pub(super) fn is_on_other_side(&self, first: &Shape) -> bool {
        let mut operations = first.operations.iter().zip(&self.opposite);
        operations.any(|(operation, &opposite)| operation.is_root && opposite)
    }
}

/// The operation of a shape that is paired with one of the first shape.
#[derive(Clone, Copy)]
struct Partner {
    position: usize,
    /// Whether it gives the opposite.
    opposite: bool,
    /// Whether its operands are in the other order.
    swapped: bool,
}

/// A pair that the comparison has found. It is forgotten if it leads nowhere.
#[derive(Clone, Copy)]
enum Found {
    Partner(usize),
    Outer(usize),
}

/// A comparison of two shapes, from their ends to what they are made from.
struct Unifier<'u> {
    first: &'u Shape,
    shape: &'u Shape,
    outers: &'u [Value],
    other_side: bool,
    /// For each value that the first piece reads from outside, what stands in its place here, as far as it is known.
    known: Vec<Option<Term>>,
    partners: Vec<Option<Partner>>,
    trail: Vec<Found>,
}

impl Unifier<'_> {
    fn run(mut self) -> Option<Row> {
        for (&theirs, &ours) in self.first.ends.iter().zip(&self.shape.ends) {
            // The result of a piece may be the opposite: its reader knows.
            self.operation(theirs, ours)?;
        }
        let partners: Vec<Partner> = self.partners.iter().copied().collect::<Option<_>>()?;
        let mut row =
            Row { arguments: self.known.iter().copied().collect::<Option<_>>()?, ..Row::default() };
        for (position, (theirs, partner)) in self.first.operations.iter().zip(&partners).enumerate()
        {
            let ours = &self.shape.operations[partner.position];
            let pairs = pairs(theirs, ours, partner.swapped);
            row.numbers.extend(pairs.filter_map(|(_, ours)| match ours {
                Operand::Number(number) => Some(number),
                Operand::Inner { .. } | Operand::Outer(_) => None,
            }));
            row.opposite.push(partner.opposite);
            row.positions.insert(ours.value, position);
        }
        Some(row)
    }

    /// Pairs two operations. Gives whether ours has the opposite of their result.
    fn operation(&mut self, theirs: usize, ours: usize) -> Option<bool> {
        if let Some(partner) = self.partners[theirs] {
            return (partner.position == ours).then_some(partner.opposite);
        }
        let [their, our] = [&self.first.operations[theirs], &self.shape.operations[ours]];
        if their.hash != our.hash || their.kind != our.kind {
            return None;
        }
        let mut orders = vec![false];
        if their.kind.commutes() {
            orders.push(true);
            // Pairs that are known already settle the order.
            orders.sort_by_key(|&swapped| Reverse(self.known_pairs(their, our, swapped)));
        }
        for swapped in orders {
            let mark = self.trail.len();
            if let Some(opposite) = self.operands(their, our, swapped) {
                self.trail.push(Found::Partner(theirs));
                self.partners[theirs] = Some(Partner { position: ours, opposite, swapped });
                return Some(opposite);
            }
            self.forget(mark);
        }
        None
    }

    /// Forgets what was found out since.
    fn forget(&mut self, mark: usize) {
        for found in self.trail.drain(mark..) {
            match found {
                Found::Partner(position) => self.partners[position] = None,
                Found::Outer(index) => self.known[index] = None,
            }
        }
    }

    /// Pairs the operands of two operations. Gives whether ours has the opposite of their result.
    fn operands(&mut self, theirs: &Operation, ours: &Operation, swapped: bool) -> Option<bool> {
        let mut is_changed = false;
        let mut changes = 0;
        // Operands from outside come first: they distinguish operations that are made in the same way.
        let (inner, outer): (Vec<_>, Vec<_>) = pairs(theirs, ours, swapped)
            .partition(|(theirs, _)| matches!(theirs, Operand::Inner { .. }));
        for (theirs, ours) in outer.into_iter().chain(inner) {
            if self.operand(theirs, ours)? {
                is_changed = !is_changed;
                changes += 1;
            }
        }
        let division = Kind::Other(discriminant(&Op::Div(theirs.value, theirs.value)));
        if [Kind::Product, division].contains(&theirs.kind) {
            return Some(is_changed);
        }
        (changes == 0).then_some(theirs.is_root && self.other_side)
    }

    /// Pairs two operands. Gives whether ours is the opposite.
    fn operand(&mut self, theirs: Operand, ours: Operand) -> Option<bool> {
        match (theirs, ours) {
            (
                Operand::Inner { position, negative },
                Operand::Inner { position: other, negative: changed },
            ) => {
                let opposite = self.operation(position, other)?;
                Some((negative != changed) != opposite)
            }
            (Operand::Outer(theirs), Operand::Outer(ours)) => {
                let index = self.index(theirs)?;
                let ours = ours.signed(theirs.negative);
                if self.known[index].is_none() {
                    self.trail.push(Found::Outer(index));
                    self.known[index] = Some(ours);
                }
                (self.known[index] == Some(ours)).then_some(false)
            }
            (Operand::Number(_), Operand::Number(_)) => Some(false),
            _ => None,
        }
    }

    fn index(&self, outer: Term) -> Option<usize> {
        self.outers.iter().position(|&value| value == outer.value)
    }

    /// The number of pairs of operands that were met before.
    fn known_pairs(&self, theirs: &Operation, ours: &Operation, swapped: bool) -> usize {
        let is_known = |(theirs, ours): &(Operand, Operand)| match (theirs, ours) {
            (Operand::Outer(theirs), Operand::Outer(ours)) => {
                let index = self.index(*theirs);
                index.and_then(|index| self.known[index]) == Some(ours.signed(theirs.negative))
            }
            _ => false,
        };
        pairs(theirs, ours, swapped).filter(is_known).count()
    }
}

/// The operands of two operations, in pairs.
fn pairs<'o>(
    theirs: &'o Operation,
    ours: &'o Operation,
    swapped: bool,
) -> impl Iterator<Item = (Operand, Operand)> + 'o {
    let last = ours.operands.len().saturating_sub(1);
    let ours = (0..ours.operands.len()).map(move |index| {
        let index = if swapped { last - index } else { index };
        ours.operands[index]
    });
    theirs.operands.iter().copied().zip(ours)
}
