//! Proofs by intervals: whether motors may move through their ranges without ever being blocked.
//!
//! The program is run on boxes of motor values. A loop closes on a box if its slack is nowhere below zero; a box on which that
//! cannot be told is cut in two. The proof holds for the arithmetic of the program: rounding at run time is smaller than the
//! half of a loop's floor that is left to it.

pub(crate) mod always;
mod boxes;
pub(crate) mod carried;
mod claim;
pub(crate) mod cone;
mod enclosure;
mod form;
mod interval;
mod jump;
mod line;
mod operation;
mod search;
pub(crate) mod slope;
mod stairs;
mod tape;

#[cfg(test)]
mod tests;

pub(crate) use carried::is_same;
pub(crate) use enclosure::motors_of;
pub(crate) use enclosure::{Enclosure, Sight, Sources, side_changes};
pub use interval::Interval;
pub(crate) use jump::first_jump;

use crate::bug::bug;
use crate::program::{BlockId, BlockKind, Op, Program, Value};
use claim::{Group, carried_sides};
use enclosure::groups;
use search::{Search, Share};
use tape::Tape;

/// More loops than this that carry their side are not tried with every side of each.
const MOST_SIDES: usize = 4;

/// The result of a proof about a mechanism whose motors have ranges.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every loop closes wherever the motors are within their ranges. One that was declared to stop at its change points still does
    /// so, where it touches them.
    Proved {
        /// The loops that may come to within rounding of a dead point or change point on the way; all others stay clear of it.
        touching: Vec<BlockId>,
    },
    /// There is a place that certainly cannot be reached.
    Blocked(Blocked),
    /// Neither was proved within the budget, or at all.
    Undecided {
        /// The loop.
        block: BlockId,
        /// The motors that have a part in it, by their numbers.
        motors: Vec<usize>,
        /// For each motor of the mechanism the values at which it could not be told.
        place: Vec<Interval>,
    },
    /// Some loops are solved by iteration: for these there is no proof.
    NoClosedForm {
        /// The first of these.
        block: BlockId,
    },
}

impl Verdict {
    /// Whether it was proved that every loop always closes, and none comes near a dead point or change point.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        matches!(self, Self::Proved { touching } if touching.is_empty())
    }
}

/// Where a mechanism is blocked.
#[derive(Clone, Debug, PartialEq)]
pub struct Blocked {
    /// The loop that does not close.
    pub block: BlockId,
    /// The motors that have a part in it, by their numbers.
    pub motors: Vec<usize>,
    /// For each motor its value at a place where it does not.
    pub at: Vec<f64>,
    /// The motor that is moved to there, by its number, while all others have the values of that place.
    pub motor: usize,
    /// The dead point: the value that this motor reaches, coming from its start value.
    pub limit: f64,
    /// The values of this motor, within its range, from this dead point to where the loop closes again, if it does: as far as
    /// that could be told.
    pub interval: Interval,
}

/// Proves that a mechanism moves wherever its motors are within these ranges, one for each, or that it does not. A motor
/// without a range stays where it is at the start.
#[must_use]
pub fn certify(program: &Program, ranges: &[Interval]) -> Verdict {
    certify_beside(program, ranges, &[])
}

/// The same where some loops are known to close everywhere.
#[must_use]
pub fn certify_beside(program: &Program, ranges: &[Interval], free: &[BlockId]) -> Verdict {
    let mut effort = 0;
    let ranges: Vec<Interval> = program
        .start
        .motors
        .iter()
        .enumerate()
        .map(|(motor, &start)| ranges.get(motor).copied().unwrap_or(Interval::point(start)))
        .collect();
    let groups = groups(program, free);
    let verdict = on_sides(program, (&groups, &[]), &ranges, &mut effort);
    let iterated = program
        .block_ids()
        .find(|block| matches!(program.ssa.blocks[block.index()].kind, BlockKind::Newton(_)));
    match (verdict, iterated) {
        (Verdict::Proved { touching }, None) => {
            on_all_sides(program, &groups, &ranges, touching, &mut effort)
        }
        // A loop that is blocked before an iteration is certainly blocked.
        (verdict @ Verdict::Blocked(_), _) | (verdict, None) => verdict,
        (_, Some(block)) => Verdict::NoClosedForm { block },
    }
}

/// The verdict over all groups. Each loop that carries its side has the side of the start, or the other one if it is among `turned`.
fn on_sides(
    program: &Program,
    (groups, turned): (&[Group], &[BlockId]),
    ranges: &[Interval],
    effort: &mut usize,
) -> Verdict {
    let mut all = Vec::new();
    let mut undecided = None;
    for (number, group) in groups.iter().enumerate() {
        let tape = Tape::new(program, group, turned);
        let share = Share::of(*effort, groups.len() - number);
        match Search::new(tape, program, group, ranges).verdict(effort, share) {
            Verdict::Proved { touching } => all.extend(touching),
            blocked @ Verdict::Blocked(_) => return blocked,
            // Another group may tell that it is blocked.
            other => undecided = undecided.or(Some(other)),
        }
    }
    all.sort_unstable();
    all.dedup();
    undecided.unwrap_or(Verdict::Proved { touching: all })
}

/// A loop that carries its side may change it where its slack touches zero: then everything must close on either side.
fn on_all_sides(
    program: &Program,
    groups: &[Group],
    ranges: &[Interval],
    mut touching: Vec<BlockId>,
    effort: &mut usize,
) -> Verdict {
    let carries = |block: BlockId| carried_sides(program).any(|(carrier, _)| carrier == block);
    // More loops may turn out to change sides when others have.
    let mut tried: Vec<Vec<BlockId>> = vec![Vec::new()];
    loop {
        let crossing: Vec<BlockId> =
            touching.iter().copied().filter(|&block| carries(block)).collect();
        if let Some(&block) = crossing.get(MOST_SIDES) {
            let of = |group: &&Group| group.tests.iter().any(|(other, _)| *other == block);
            let Some(group) = groups.iter().find(of) else {
                bug!("a loop whose discriminant touches zero is tested in no group");
            };
            return Verdict::Undecided {
                block,
                motors: group.motors.clone(),
                place: ranges.to_vec(),
            };
        }
        let Some(turned) = subsets(&crossing).find(|turned| !tried.contains(turned)) else {
            return Verdict::Proved { touching };
        };
        match on_sides(program, (groups, &turned), ranges, effort) {
            Verdict::Proved { touching: more } => {
                touching.extend(more);
                touching.sort_unstable();
                touching.dedup();
            }
            // Whether it ever comes there on these sides is not known.
            Verdict::Blocked(Blocked { block, motors, at, .. }) => {
                let place = at.into_iter().map(Interval::point).collect();
                return Verdict::Undecided { block, motors, place };
            }
            verdict => return verdict,
        }
        tried.push(turned);
    }
}

/// All ways to take some of a few.
fn subsets(of: &[BlockId]) -> impl Iterator<Item = Vec<BlockId>> {
    (0..1_usize << of.len().min(MOST_SIDES)).map(move |set| {
        let taken = |index: &usize| set >> index & 1 == 1;
        let indices = (0..of.len()).filter(taken);
        indices.map(|index| of[index]).collect()
    })
}

/// An angle that is followed over whole turns. It lies within half a turn of a reference, wherever the branch cut of its arc tangent is.
#[derive(Clone, Copy, Debug)]
struct WholeAngle {
    value: Value,
    /// The numbers whose arc tangent it is, but for whole turns.
    sin: Value,
    cos: Value,
    reference: Interval,
}

impl WholeAngle {
    /// The angle that is carried under this number, if it is followed over whole turns.
    fn carried(program: &Program, state: usize, reference: Interval) -> Option<Self> {
        let mut angles = program.follows.iter().zip(&program.followed);
        let (_, (_, principal)) = angles.find(|(follow, _)| follow.angle == state)?;
        let Op::Atan2(sin, cos) = program.node(*principal).op else {
            return None;
        };
        Some(Self { value: program.state[state], sin, cos, reference })
    }

    /// Whether it is this value.
    fn is(self, value: Value) -> bool {
        self.value == value
    }

    /// Its enclosure, from those of all values.
    fn range(self, values: &[Interval]) -> Interval {
        let [sin, cos] = [self.sin, self.cos].map(|value| values[value.index()]);
        let [across, along] = [self.reference.sin(), self.reference.cos()];
        let beyond = (sin * along - cos * across).atan2(cos * along + sin * across);
        self.reference + beyond
    }
}
