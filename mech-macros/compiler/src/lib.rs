//! The compiler of `mechanism!`: it turns the text of a mechanism into the code that moves it.
//!
//! Data flows in one direction: `syntax → model → structure → plan → program → emit | evaluate | certify | cost`. The driver `compile`
//! builds a program, lets [`motion`] watch it move, and builds it again with the results.
//!
//! There are three entries. The macro calls [`expand`](fn@expand). Programs that read texts call [`analyse`], and those that make a
//! [`Model`](model::Model) of their own [`compile`](fn@compile).

mod analysis;
mod api;
mod bug;
pub mod cancel;
pub mod certify;
mod compile;
mod compiled;
pub mod cost;
mod digits;
mod emit;
pub mod evaluate;
mod expand;
pub mod graphs;
mod kinematics;
mod looks;
pub mod model;
pub mod motion;
pub mod plan;
pub mod program;
pub mod repair;
pub mod report;
pub mod reporter;
pub mod requirement;
pub mod structure;
pub mod symbols;
pub mod syntax;

pub use analysis::{Analysis, Faults, analyse};
pub use api::Asked;
pub use bug::catch;
pub use compile::{Unreachable, compile, lead, led_place};
pub use compiled::{Compiled, ForcePrograms, InverseMechanism};
pub use expand::{Import, PartText, expand, expand_part, macro_calls, write};
pub use looks::{Looks, Outline, Painted, Points, Symbols, Toothed, looks};
pub use syntax::limits;
