//! The motion that a command gives the motors of a mechanism.

mod centre;
mod drive;
mod lead;
mod mover;
mod obstacle;
mod paths;
mod reach;
mod rest;
mod setting;
mod trajectory;

pub(crate) use centre::PlaneMotion;
pub(crate) use drive::{Drive, Moment};
pub(crate) use lead::Goal;
pub(crate) use mover::{Mover, Ready, in_precision, place_of};
pub(crate) use obstacle::{joints_in_the_way, motor_name, obstacle};
pub(crate) use paths::Paths;
pub(crate) use reach::{Basis, Reach};
pub(crate) use rest::find_rest;
pub(crate) use setting::{Setting, Span, Typed, posed, range_of, read_value, show_value, shown};
