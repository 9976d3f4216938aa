//! The dialogue: lines in plain words, each of which changes the mechanism or asks for something.

mod completion;
mod line;
mod pattern;
mod prompt;
mod request;
mod session;
mod table;
mod words;

#[cfg(feature = "editor")]
pub(crate) use completion::complete;
#[cfg(feature = "editor")]
pub(crate) use line::help;
pub(crate) use prompt::converse;
pub(crate) use session::{Session, Turn};
