//! The sides of loops that pass change points, along the way of the only motor that has a part.

use crate::bug::bug;
use crate::certify::{Enclosure, Interval};
use crate::evaluate::Machine;
use crate::program::{BlockId, Position, Program, Value};
use std::cell::RefCell;
use std::rc::Rc;

/// After so many turns of a motor everything should be back.
const MOST_TURNS: u8 = 4;

/// Shorter parts of the way than this are not cut.
const NARROW: f64 = 1e-7;

/// A way is cut so many times at most.
const MOST_CUTS: usize = 2000;

/// All subsets of some loops, in the order of the loops.
pub(super) fn subsets(loops: &[BlockId]) -> Vec<Vec<BlockId>> {
    let mut all: Vec<Vec<BlockId>> = vec![Vec::new()];
    for one in loops {
        let with = all.iter().map(|rest| with_turned(rest, *one));
        let with: Vec<Vec<BlockId>> = with.collect();
        all.extend(with);
    }
    all
}

/// All sides to which loops may go over from these on, as those that are turned. `touching` gives the loops that may change their side,
/// if some are turned.
pub(super) fn spread(
    from: &[BlockId],
    mut touching: impl FnMut(&[BlockId]) -> Vec<BlockId>,
) -> Vec<Vec<BlockId>> {
    let mut all = vec![from.to_vec()];
    let mut looked = 0;
    while let Some(turned) = all.get(looked).cloned() {
        looked += 1;
        for block in touching(&turned) {
            let over = with_turned(&turned, block);
            if !all.contains(&over) {
                all.push(over);
            }
        }
    }
    all
}

/// The turned loops after this one went over to its other side.
fn with_turned(turned: &[BlockId], block: BlockId) -> Vec<BlockId> {
    let others = turned.iter().copied().filter(|other| *other != block);
    let mut after: Vec<BlockId> = others.collect();
    if after.len() == turned.len() {
        after.push(block);
    }
    after.sort_unstable();
    after
}

/// A part of the way.
pub(super) struct Stretch {
    pub(super) range: Interval,
    /// The sides that loops may have there: for each those that are turned.
    sides: Vec<Vec<BlockId>>,
    /// Whether they certainly have the only ones.
    pub(super) is_sure: bool,
}

impl Stretch {
    fn has(&self, turned: &[BlockId]) -> bool {
        self.sides.iter().any(|own| own == turned)
    }
}

/// Loops where these are turned.
type Sided<'p> = (Vec<BlockId>, Enclosure<'p>);

/// The way of a motor from the start to both ends of its values, while all others stand.
pub(super) struct Way<'p> {
    program: &'p Program,
    /// The loops that may change their side, in order.
    crossing: Vec<BlockId>,
    motor: usize,
    stretches: Vec<Stretch>,
    /// Positions on the way.
    visited: Vec<Position<f64>>,
    /// The start and the ends, with the loops that are turned there.
    ends: Vec<(f64, Vec<BlockId>)>,
}

/// The ways of motors: each is found once for all requirements and their details.
pub(super) struct Ways<'p> {
    program: &'p Program,
    known: RefCell<Vec<KnownWay<'p>>>,
}

/// A way that was looked for, by what it was looked for.
struct KnownWay<'p> {
    crossing: Vec<BlockId>,
    motor: usize,
    ends: Interval,
    way: Option<Rc<Way<'p>>>,
}

impl<'p> Ways<'p> {
    pub(super) fn new(program: &'p Program) -> Self {
        Self { program, known: RefCell::default() }
    }

    /// The way to both ends of some values; nothing if there is none.
    pub(super) fn find(
        &self,
        crossing: &[BlockId],
        motor: usize,
        ends: Interval,
    ) -> Option<Rc<Way<'p>>> {
        let mut known = self.known.borrow_mut();
        let is_same = |one: &&KnownWay<'p>| {
            one.crossing == crossing && one.motor == motor && one.ends == ends
        };
        if let Some(found) = known.iter().find(is_same) {
            return found.way.clone();
        }
        let way = Way::new(self.program, crossing, motor, ends).map(Rc::new);
        known.push(KnownWay { crossing: crossing.to_vec(), motor, ends, way: way.clone() });
        way
    }
}

impl<'p> Way<'p> {
    /// The way to both ends of some values; nothing if the mechanism does not come there, or nothing can be told of its loops.
    fn new(
        program: &'p Program,
        crossing: &[BlockId],
        motor: usize,
        ends: Interval,
    ) -> Option<Self> {
        let start = program.start.motors[motor];
        let mut way = Self {
            program,
            crossing: crossing.to_vec(),
            motor,
            stretches: Vec::new(),
            visited: Vec::new(),
            ends: vec![(start, Vec::new())],
        };
        let mut sides = way.enclosures()?;
        for end in [ends.low(), ends.high()] {
            let narrow = NARROW * ends.hull(Interval::point(start)).width();
            way.walk(end, narrow, &mut sides)?;
        }
        Some(way)
    }

    /// The loops that may change their side, on all sides that they may have.
    fn enclosures(&self) -> Option<Vec<Sided<'p>>> {
        let program = self.program;
        let closed = self.crossing.iter();
        let closed = closed.filter_map(|block| program.closed_form(*block));
        let found: Vec<Value> = closed.map(|closed| closed.discriminant).collect();
        let sides = subsets(&self.crossing).into_iter().map(|turned| {
            let enclosure = Enclosure::new(program, &turned, &[], &found)?;
            Some((turned, enclosure))
        });
        sides.collect()
    }

    /// Walks from the start to one end.
    fn walk(&mut self, end: f64, narrow: f64, sides: &mut [Sided<'_>]) -> Option<()> {
        let (program, motor) = (self.program, self.motor);
        let mut machine = Machine::<f64>::new(program);
        let mut place = Interval::points(&program.start.motors);
        let mut waiting = vec![end];
        let mut left = MOST_CUTS;
        while let Some(next) = waiting.pop() {
            left = left.checked_sub(1)?;
            let before = machine.position().clone();
            let turned = self.turned_in(&before);
            let range = Interval::new(before.motors[motor], next);
            place[motor] = range;
            let mut within = spread(&turned, |turned| {
                let (_, enclosure) = sides
                    .iter_mut()
                    .find(|(own, _)| own == turned)
                    .unwrap_or_else(|| bug!("loops have sides that they cannot have"));
                enclosure.run(&place);
                let touching = self.crossing.iter().copied();
                touching.filter(|block| !enclosure.is_clear(&[*block])).collect()
            });
            let is_clear = within.len() == 1;
            let middle = range.middle();
            let can_be_cut =
                range.width() > narrow && range.low() < middle && middle < range.high();
            if !is_clear && can_be_cut {
                waiting.extend([next, middle]);
                continue;
            }
            let mut values = before.motors.clone();
            values[motor] = next;
            let has_come = machine.move_to(&values).is_ok();
            let after = self.turned_in(machine.position());
            let is_sure = has_come && is_clear && after == turned;
            if has_come && is_clear && !is_sure && can_be_cut {
                machine.put_back(before);
                waiting.extend([next, middle]);
                continue;
            }
            if has_come {
                if waiting.is_empty() {
                    self.ends.push((next, after.clone()));
                }
                if !within.contains(&after) {
                    within.push(after);
                }
            } else if is_clear || !waiting.is_empty() {
                // The end may be a dead point, but for rounding; nothing else stops it.
                return None;
            }
            self.stretches.push(Stretch { range, sides: within, is_sure });
            self.visited.push(before);
        }
        Some(())
    }

    /// The loops that may change their side.
    pub(super) fn crossing(&self) -> &[BlockId] {
        &self.crossing
    }

    /// Whether these loops, and no others, are turned on some part of the way, or at one of its ends.
    pub(super) fn comes_to(&self, turned: &[BlockId]) -> bool {
        let mut sure = self.stretches.iter().filter(|stretch| stretch.is_sure);
        let mut ends = self.ends.iter();
        sure.any(|stretch| stretch.has(turned)) || ends.any(|(_, own)| own == turned)
    }

    /// Whether these loops, and no others, may be turned where loops change their side.
    pub(super) fn passes(&self, turned: &[BlockId]) -> bool {
        self.stretches.iter().any(|stretch| stretch.has(turned))
    }

    /// The parts of some values where these loops are turned, or may be: those that are next to each other are put together.
    pub(super) fn parts(&self, turned: &[BlockId], values: Interval) -> Vec<Stretch> {
        let mut within: Vec<Stretch> = Vec::new();
        let mut stretches: Vec<&Stretch> = self.stretches.iter().collect();
        stretches.sort_by(|a, b| a.range.low().total_cmp(&b.range.low()));
        for stretch in stretches.into_iter().filter(|stretch| stretch.has(turned)) {
            let Stretch { range, is_sure, .. } = stretch;
            let [low, high] = [range.low().max(values.low()), range.high().min(values.high())];
            if low > high || low == high && values.width() > 0.0 {
                continue;
            }
            let range = Interval::new(low, high);
            match within.last_mut() {
                Some(last) if last.is_sure == *is_sure && last.range.high() == low => {
                    last.range = last.range.hull(range);
                }
                _ => {
                    within.push(Stretch { range, sides: vec![turned.to_vec()], is_sure: *is_sure });
                }
            }
        }
        within
    }

    /// Places within some values where these loops are turned: the start, and ends of parts of the way.
    pub(super) fn places(&self, turned: &[BlockId], values: Interval) -> Vec<Vec<f64>> {
        let parts = self.parts(turned, values);
        let sure = parts.iter().filter(|part| part.is_sure);
        let own = sure.flat_map(|part| [part.range.low(), part.range.high()]);
        let ends = self.ends.iter();
        let ends = ends.filter(|(value, own)| own == turned && values.contains(*value));
        let all = own.chain(ends.map(|(value, _)| *value));
        all.map(|value| {
            let mut place = self.program.start.motors.clone();
            place[self.motor] = value;
            place
        })
        .collect()
    }

    /// The loops that are turned at a place; nothing if the mechanism does not come there.
    pub(super) fn turned_at(&self, place: &[f64]) -> Option<Vec<BlockId>> {
        let value = place[self.motor];
        let mut sure = self.stretches.iter().filter(|stretch| stretch.is_sure);
        if let Some(stretch) = sure.find(|stretch| stretch.range.contains(value)) {
            return stretch.sides.first().cloned();
        }
        let mut machine = Machine::<f64>::new(self.program);
        let start = machine.position().motors[self.motor];
        let far = |position: &&Position<f64>| position.motors[self.motor] - start;
        let is_before = |position: &&Position<f64>| {
            let rest = value - start - far(position);
            rest * far(position) >= 0.0
        };
        let before = self.visited.iter().filter(is_before);
        // The last one before it.
        if let Some(last) = before.max_by(|a, b| far(a).abs().total_cmp(&far(b).abs())) {
            machine.put_back(last.clone());
        }
        machine.move_to(place).ok()?;
        Some(self.turned_in(machine.position()))
    }

    fn turned_in(&self, position: &Position<f64>) -> Vec<BlockId> {
        turned_in(self.program, &self.crossing, position)
    }
}

/// The turns of a motor after which all loops have their sides of the start again; nothing if that is not found.
pub(super) fn turns_until_back(
    program: &Program,
    crossing: &[BlockId],
    motor: usize,
    turn: f64,
) -> Option<f64> {
    let mut machine = Machine::<f64>::new(program);
    for turns in 1..=MOST_TURNS {
        let mut values = program.start.motors.clone();
        values[motor] += f64::from(turns) * turn;
        machine.move_to(&values).ok()?;
        if turned_in(program, crossing, machine.position()).is_empty() {
            return Some(f64::from(turns));
        }
    }
    None
}

/// The loops that are on the other side than at the start.
fn turned_in(program: &Program, crossing: &[BlockId], position: &Position<f64>) -> Vec<BlockId> {
    let side = |position: &Position<f64>, sine: usize| position.state[sine].is_sign_positive();
    let is_turned = |block: &BlockId| {
        let watches = program.watches.iter();
        let mut own = watches.filter(|watch| watch.block == *block);
        own.any(|watch| side(position, watch.sine) != side(&program.start, watch.sine))
    };
    crossing.iter().copied().filter(is_turned).collect()
}
