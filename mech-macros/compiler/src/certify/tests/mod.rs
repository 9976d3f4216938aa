//! Intervals against points, and mechanisms whose ranges are known.

mod interval;
mod mechanisms;
mod models;
mod stairs;
mod tape;
