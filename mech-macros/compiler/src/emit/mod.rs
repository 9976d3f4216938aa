//! The program and its surroundings as Rust tokens.

mod block;
mod flow;
mod items;
mod iteration;
mod scope;
mod shapes;
mod step;
mod stub;

pub(crate) use items::items;
pub(crate) use stub::stub;
