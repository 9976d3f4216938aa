//! The report's lines about motors that follow a point.

use super::joints;
use super::loops::method_line;
use crate::compiled::Compiled;
use crate::cost;
use crate::model::{JointId, Model};
use std::fmt::Write;

/// Writes what is led, by which motors, and how the loops are solved; nothing if no motors follow.
pub(super) fn inverse_lines(
    text: &mut String,
    model: &Model,
    compiled: &Compiled,
) -> std::fmt::Result {
    let (Some(inverse), Some(inverted)) = (&model.inverse, &compiled.inverse) else {
        return Ok(());
    };
    let motors = inverse.motors.iter().map(|motor| model.motor(*motor).joint);
    let motors: Vec<JointId> = motors.collect();
    let more = cost::of_program(&inverted.compiled.program);
    writeln!(
        text,
        "  follow    {} is led, {} follow: {more} more",
        inverse.name(model),
        joints(model, &motors)
    )?;
    for solved in &inverted.compiled.loops {
        writeln!(text, "            {}", method_line(solved))?;
    }
    Ok(())
}
