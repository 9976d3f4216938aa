//! What can be measured of a mechanism while it moves: places, angles, coordinates, their rates, and forces.

mod kind;
mod load;
mod meter;
mod naming;
mod unit;

pub(crate) use load::Load;
pub(crate) use meter::{Measurement, Table, measure};
pub(crate) use naming::{dyads, quantities, usual};
pub(crate) use unit::Units;
