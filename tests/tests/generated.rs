//! Tests of generated code: each mechanism that they share is expanded once.

mod agreement;
mod bad;
mod blocked;
mod cams;
mod changed;
mod clock;
mod dynamics;
pub mod hygiene;
mod inverse;
mod joints;
mod laws;
mod literature;
mod mesh;
mod motions;
mod overlay;
mod parts_library;
mod pictures;
mod recorder;
mod reference;
mod rest;
mod shapes;
mod statics;
mod surplus;
mod trace;
mod turns;
mod velocity;
mod zoo;
