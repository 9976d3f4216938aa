//! The compiler of `mechanism!`: it turns the text of a mechanism into the code that moves it.
//!
//! Data walks down one stair: `syntax → model → structure → plan → program → emit | evaluate | certify | cost`. The driver in
//! `compile` stands beside it: it builds a program, watches it move ([`motion`]), and builds it again with what it learnt.
//! The crate has two users: the macro, which calls [`expand`](fn@expand), and whoever analyses a [`Model`](model::Model) made in another
//! way, by [`compile`](fn@compile).

mod api;
mod bug;
pub mod certify;
mod compile;
mod compiled;
pub mod cost;
mod digits;
mod emit;
pub mod evaluate;
mod expand;
pub mod graphs;
pub mod model;
pub mod motion;
pub mod plan;
pub mod program;
pub mod repair;
pub mod report;
pub mod reporter;
pub mod structure;
pub mod symbols;
pub mod syntax;

pub use compile::compile;
pub use compiled::{Compiled, ForcePrograms};
pub use expand::expand;
