//! The motion that a command gives the motors of a mechanism.

mod drive;
mod obstacle;
mod paths;
mod setting;

pub(crate) use drive::{Drive, Moment};
pub(crate) use obstacle::obstacle;
pub(crate) use paths::Paths;
pub(crate) use setting::{Setting, Span, motor_of, posed, read_value, turns};
