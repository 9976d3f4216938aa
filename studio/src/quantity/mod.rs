//! Quantities that can be measured while a mechanism moves: places, angles, coordinates, their rates, and forces.

mod kind;
mod load;
mod meter;
mod naming;
#[cfg(feature = "editor")]
mod offer;
mod position;
mod round;
mod summary;
mod turning;
mod unit;

pub(crate) use kind::Quantity;
pub(crate) use load::Load;
pub(crate) use load::numbers as load_numbers;
pub(crate) use meter::{Measurement, Table, measure};
pub(crate) use naming::{dyads, only_quantity, quantities, usual};
#[cfg(feature = "editor")]
pub(crate) use offer::{Offer, offers};
pub(crate) use round::{round_step, tick};
pub(crate) use summary::{Extreme, FLAT, Summary, summarize};
pub(crate) use unit::Units;
