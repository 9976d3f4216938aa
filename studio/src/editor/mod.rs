//! The studio: mechanisms are drawn, mended and played in a window, natively or in a browser.
//!
//! An [`Editor`] is the whole state; it knows no window and no clock. It is made of groups, none of which knows it: whoever touches one or
//! two of them takes these alone. The text is its only document: what the user does becomes a [`Gesture`] of commands, whose replacements are
//! tried before they are accepted. A worker analyses beside the window. [`Studio`] shows the editor by egui; every handle in the drawing is
//! an accessible node, so that tests and screen readers find what the mouse does.

mod action;
mod analysis;
mod arrow;
mod canvas;
mod clipboard;
mod colors;
mod constructed;
mod curves;
mod desk;
mod drag;
mod drawing;
mod example;
#[cfg(not(target_arch = "wasm32"))]
mod files;
mod gesture;
#[cfg(not(target_arch = "wasm32"))]
mod guard;
mod index;
mod item;
mod names;
mod opening;
mod order;
mod panel;
mod pending;
mod placement;
mod playing;
mod plotted;
mod question;
mod range;
mod selection;
mod settings;
mod sight;
mod snap;
mod snapshot;
mod state;
mod studio;
mod talk;
mod tool;
mod worker;

pub use arrow::{Arrow, ArrowKind};
pub use drawing::{Drawing, Handle};
pub use example::first_example;
pub use gesture::Gesture;
pub use index::HandleKind;
pub use item::Item;
pub use sight::Sight;
pub use state::Editor;
pub use studio::Studio;
pub use talk::Notice;
pub use tool::Tool;
#[cfg(feature = "transfer")]
pub use worker::{Port, Server};
