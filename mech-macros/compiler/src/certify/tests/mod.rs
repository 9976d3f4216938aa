//! Intervals against points, and mechanisms whose ranges are known.

mod costs;
mod interval;
mod mechanisms;
mod models;
mod tape;
