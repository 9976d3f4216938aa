//! What the programs of this package have in common: the board, a way to print, and stand-ins for what is soldered to it.
//!
//! Nothing here can panic. A program says so itself by `use panic_never as _;`, which makes a panic that can be reached an error of
//! the linker; those with drivers of others cannot, and have `panic-halt`.
#![no_std]
#![forbid(unsafe_code)]

mod board;
mod line;
pub mod wiring;

pub use board::{entry, exit};
pub use line::Line;
