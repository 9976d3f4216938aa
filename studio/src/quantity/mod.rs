//! Quantities that can be measured while a mechanism moves: places, angles, coordinates, their rates, and forces.

mod load;
mod measurement;
mod meter;
mod naming;
mod needs;
#[cfg(feature = "editor")]
mod offer;
mod position;
mod round;
mod summary;
mod survey;
mod turning;
mod unit;

pub(crate) use load::Load;
pub(crate) use load::numbers as load_numbers;
pub(crate) use measurement::{Measurement, Table, compiled, measure};
pub(crate) use naming::{body_of, measurands, only_measurand, transmissions, usual};
#[cfg(feature = "editor")]
pub(crate) use offer::{Offer, offers};
pub(crate) use position::Position;
pub(crate) use round::{four_digits, round_step, tick};
pub(crate) use summary::{Extreme, FLAT, Summary, summarize};
pub(crate) use survey::{Survey, Surveyed};
pub(crate) use unit::Units;
