//! `mech play`: mechanisms that are played, dragged and stopped, with and without a terminal.

mod agreement;
mod attack;
mod drags;
mod gallery;
mod own_motion;
mod player;
#[cfg(target_os = "linux")]
mod terminal;
