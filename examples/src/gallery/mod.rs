//! The exhibits.

pub mod andrews;
pub mod crane;
pub mod diagram;
pub mod four_bar;
pub mod geared_piston;
pub mod jansen;
pub mod rocker_arm;
pub mod velocities;
pub mod watt;

use crate::Exhibit;

/// All of them, in the order in which they hang.
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
    ]
}
