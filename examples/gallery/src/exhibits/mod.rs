//! The exhibits.

mod andrews;
mod antikythera;
mod crane;
mod diagram;
mod excavator;
mod four_bar;
mod geared_piston;
mod jansen;
mod rocker_arm;
mod skeleton;
mod velocities;
mod walker;
mod watt;

use crate::Exhibit;

/// All exhibits, in the order in which they hang.
#[must_use]
pub fn exhibits() -> Vec<Box<dyn Exhibit>> {
    vec![
        geared_piston::exhibit(),
        diagram::exhibit(),
        four_bar::exhibit(),
        velocities::exhibit(),
        watt::exhibit(),
        andrews::exhibit(),
        jansen::exhibit(),
        rocker_arm::exhibit(),
        crane::exhibit(),
        excavator::exhibit(),
        walker::exhibit(),
        antikythera::exhibit(),
        skeleton::exhibit(),
    ]
}
