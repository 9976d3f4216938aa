//! Generated code: the struct of a mechanism, its methods, and the functions of its programs.
//!
//! `items` and `stub` stand above all other files. `emitter` reads the mechanism for them, and `parts` is what each adds. `step` writes
//! the functions of programs.

mod accessors;
mod advance;
mod coordinate;
mod costs;
mod drawing;
mod emitter;
mod expression;
mod forces;
mod instance_methods;
mod inverse;
mod inverse_rates;
mod items;
mod joints;
mod known;
mod least;
mod led;
mod limits;
mod many;
mod merge;
mod method;
mod module;
mod moves;
mod overlay;
mod params;
mod parts;
mod rate_accessors;
mod rates;
mod sensitivity;
mod shapes;
mod shown;
mod step;
mod stub;
mod symbols;
mod timing;
mod tokens;
mod traces;
mod views;

/// From so many entries on a constant is written as a table, which the Rust compiler reads sooner; fewer stand one by one, as a reader
/// likes them.
const MANY: usize = 64;

pub(crate) use items::items;
pub(crate) use stub::stub;
