//! Tests of a moving mechanism at compile time: which loops must be watched at run time, how exact each method is, whether declared ranges
//! are free, and how much room the mechanism takes.

pub mod accuracy;
pub(crate) mod extent;
pub mod near_miss;
pub(crate) mod proof;
pub(crate) mod sweep;
pub(crate) mod walk;
pub(crate) mod watching;
