//! Jumps: places at which a value jumps, or may do so as far as intervals tell.

use super::Interval;
use super::carried::made_from;
use super::claim::HeldValues;
use super::enclosure::Enclosure;
use crate::program::{Op, Program, Value};
use mech_core::MotionLaw;

/// Boxes narrower than this part of the whole range are one place.
const NARROW: f64 = 1e-12;

/// A value that changes at one place by less than this part of the greatest does not jump: rounding makes that.
const SHARP: f64 = 1e-9;

/// So many places show how great a value is.
const SAMPLES: u32 = 64;

/// So many boxes are looked at.
const MOST: usize = 100_000;

/// The first place, in a range of the only input that it is made from, at which a value jumps.
pub(crate) fn first_jump(
    program: &Program,
    value: Value,
    (input, range): (usize, Interval),
) -> Option<f64> {
    let ops = made_from(program, vec![value], &HeldValues::new());
    let deciding = ops.iter().map(|one| (*one, program.node(*one).op));
    let deciding: Vec<(Value, Op)> = deciding.filter(|(_, op)| may_jump(*op)).collect();
    if deciding.is_empty() {
        return None;
    }
    let asked: Vec<Value> = ops.into_iter().collect();
    let mut place = vec![Interval::ZERO; program.inputs()];
    let Some(mut enclosure) = Enclosure::new(program, &[], &[], &asked) else {
        return Some(range.low());
    };
    let mut greatest = 0.0_f64;
    for sample in 0..=SAMPLES {
        let part = f64::from(sample) / f64::from(SAMPLES);
        place[input] = Interval::point(range.low() + part * range.width());
        enclosure.run(&place);
        let size = enclosure.on_box(value).abs().high();
        greatest = greatest.max(if size.is_finite() { size } else { 0.0 });
    }
    // The first part is looked at first.
    let mut waiting = vec![range];
    for _ in 0..MOST {
        let part = waiting.pop()?;
        place[input] = part;
        enclosure.run(&place);
        let mut deciding = deciding.iter();
        if !deciding.any(|(one, op)| is_open(*one, *op, &enclosure)) {
            continue;
        }
        let middle = part.middle();
        let can_be_cut = part.low() < middle && middle < part.high();
        if part.width() > NARROW * range.width() && can_be_cut {
            waiting.push(Interval::new(middle, part.high()));
            waiting.push(Interval::new(part.low(), middle));
        } else if enclosure.on_box(value).width() > SHARP * greatest {
            let unit = SHARP * range.width();
            return Some((middle / unit).round() * unit);
        }
    }
    waiting.pop().map(Interval::low)
}

/// Whether an operation jumps somewhere.
fn may_jump(op: Op) -> bool {
    match op {
        Op::Choose(..) | Op::CopySign(..) | Op::Round(_) | Op::Atan2(..) => true,
        Op::Stairs(stairs, ..) => stairs.order > 1 || stairs.order == 1 && is_sudden(stairs.law),
        _ => false,
    }
}

/// Whether a motion law begins with a velocity.
fn is_sudden(law: MotionLaw) -> bool {
    law == MotionLaw::Linear
}

/// Whether an operation may jump on the box that was looked at last.
fn is_open(value: Value, op: Op, enclosure: &Enclosure<'_>) -> bool {
    let of = |value: Value| enclosure.on_box(value);
    let is_split = |test: Interval| test.low() < 0.0 && test.high() >= 0.0;
    let is_decided = match op {
        Op::Choose(test, ..) => !is_split(of(test)),
        Op::CopySign(_, sign) => !of(sign).contains(0.0),
        Op::Atan2(sin, cos) => of(cos).low() > 0.0 || !of(sin).contains(0.0),
        _ => false,
    };
    let own = of(value);
    let is_narrow = own.is_bounded() && own.width() <= SHARP * NARROW.max(own.abs().high());
    !is_decided && !is_narrow
}
