//! The dialogue: lines in plain words, each of which changes the mechanism or asks for something.

mod completion;
mod line;
#[cfg(target_arch = "wasm32")]
mod page;
mod pattern;
#[cfg(not(target_arch = "wasm32"))]
mod prompt;
mod request;
mod session;
mod table;
mod words;

#[cfg(feature = "editor")]
pub(crate) use completion::complete;
#[cfg(feature = "editor")]
pub(crate) use line::{help, request};
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use prompt::converse;
#[cfg(feature = "editor")]
pub(crate) use request::Request;
pub(crate) use session::{Session, Turn};
#[cfg(feature = "editor")]
pub(crate) use session::{answer, hear, state};
