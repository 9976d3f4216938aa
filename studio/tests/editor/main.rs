//! The studio, as somebody uses it: through its window's accessible nodes, by mouse and by keys.

mod beside;
mod dead_ends;
mod desk;
mod exhibits;
mod features;
mod folder;
mod pieces;
mod plots;
mod properties;
#[cfg(feature = "transfer")]
mod remote;
mod safety;
mod scripts;
mod stopping;
mod touch;
mod user;
