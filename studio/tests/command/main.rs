//! The command `mech`, run as a user runs it.

mod bad_input;
mod check;
mod numbers;
mod pictures;
mod run;
mod tell;
