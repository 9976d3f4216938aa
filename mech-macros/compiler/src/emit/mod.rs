//! The program and its surroundings as Rust tokens.

mod block;
mod costs;
mod flow;
mod items;
mod iteration;
mod many;
mod motion;
mod moves;
mod params;
mod rates;
mod scope;
mod sensitivity;
mod shapes;
mod step;
mod stub;

pub(crate) use items::items;
pub(crate) use stub::stub;
