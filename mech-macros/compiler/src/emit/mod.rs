//! The program and its surroundings as Rust tokens.

mod added;
mod block;
mod coordinate;
mod costs;
mod effects;
mod flow;
mod forces;
mod items;
mod iteration;
mod joints;
mod known;
mod many;
mod module;
mod motion;
mod moves;
mod overlay;
mod params;
mod rates;
mod scope;
mod sensitivity;
mod shapes;
mod stages;
mod step;
mod stub;
mod timing;
mod traces;

pub(crate) use items::items;
pub(crate) use stub::stub;
