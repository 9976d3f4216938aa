//! The program and its surroundings as Rust tokens.

mod block;
mod costs;
mod effects;
mod flow;
mod items;
mod iteration;
mod many;
mod motion;
mod moves;
mod overlay;
mod rates;
mod scope;
mod shapes;
mod step;
mod stub;
mod traces;

pub(crate) use items::items;
pub(crate) use stub::stub;
