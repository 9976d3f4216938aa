//! Tests of generated code: each mechanism that they share is expanded once.

mod agreement;
mod bad;
mod blocked;
mod cams;
mod changed;
mod dynamics;
pub mod hygiene;
mod joints;
mod laws;
mod mesh;
mod overlay;
mod parts_library;
mod pictures;
mod reference;
mod shapes;
mod special;
mod statics;
mod trace;
mod turns;
mod velocity;
mod zoo;
