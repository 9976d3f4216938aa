//! The command `mech`: every answer that the macro gives, for the text of a mechanism in any file.
//!
//! A [`Document`] is a file with mechanisms; a [`Reading`] is what the compiler makes of one of them. The compiler's interpreter moves
//! what the macro would emit, so nothing has to be built. Each subcommand is a file in `command`.
//!
//! `import` makes texts of what other programs wrote.
//!
//! A [`Command`] is a change of a mechanism; [`apply`] turns it into replacements in the text, and tries these. The dialogue, `mech run` and
//! programs with a window all change mechanisms by commands alone. In [`play`] they move.

// In a browser there is no command line, and nobody asks for what only that needs.
#![cfg_attr(target_arch = "wasm32", allow(dead_code, unused_imports))]

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod chart;
mod check;
#[cfg(not(target_arch = "wasm32"))]
mod command;
mod console;
mod construction;
mod dialogue;
mod document;
mod edit;
#[cfg(feature = "editor")]
pub mod editor;
mod failure;
mod import;
mod input;
mod job;
mod mend;
mod motion;
mod output;
mod painting;
pub mod play;
mod quantity;
mod report;
mod text;

#[cfg(not(target_arch = "wasm32"))]
pub use command::run;
pub use console::Console;
pub use document::{
    Declaration, Document, Faults, LONGEST, Listing, Message, NameText, NumberText, Reading,
    Source, Spot,
};
pub use edit::{
    ActionKind, Applied, Assembly, Command, Drag, Dragged, Expression, Follower, History,
    JointForm, Kind, Known, Pair, Refusal, Rule, Step, Workspace, apply, apply_all,
};
pub use failure::{Failure, FailureKind};
pub use mend::{Mending, Remainder, mendings};
pub use text::Replacement;
