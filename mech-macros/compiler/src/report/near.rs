//! Notes about loops that come near change points.

use crate::compiled::Compiled;
use crate::model::{JointKind, Model};
use crate::motion::near_miss::NearMiss;

/// More notes than these say nothing new.
const MOST: usize = 8;

/// Returns the notes on loops that come near change points.
pub(super) fn notes(model: &Model, compiled: &Compiled) -> Vec<String> {
    let all = &compiled.near_misses;
    let mut notes: Vec<String> = all
        .iter()
        .take(MOST)
        .map(|miss| note(model, miss))
        .collect();
    if all.len() > MOST {
        notes.push(format!("so do {} other loops", all.len() - MOST));
    }
    notes
}

/// ``the loop `b`, `c` passes within 5e-11 of a change point at a = -70.53 deg``.
fn note(model: &Model, miss: &NearMiss) -> String {
    let NearMiss {
        place,
        motor,
        at,
        distance,
        passes,
        ..
    } = miss;
    let joint = model.joint(model.motor(*motor).joint);
    let at = match joint.kind {
        JointKind::Revolute(..) => format!("{:.2} deg", at.to_degrees()),
        _ => format!("{at:.4}"),
    };
    let verb = if *passes { "passes" } else { "stops" };
    format!(
        "the loop {place} {verb} within {distance:.0e} of a change point at {} = {at}",
        joint.name
    )
}
