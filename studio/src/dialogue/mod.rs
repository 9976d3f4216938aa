//! The dialogue: lines in plain words, each of which changes the mechanism or asks for something.

mod completion;
#[cfg(feature = "editor")]
mod heard;
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
pub(crate) use heard::hear;
#[cfg(feature = "editor")]
pub(crate) use line::{help, request};
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use prompt::converse;
#[cfg(feature = "editor")]
pub(crate) use request::Request;
#[cfg(feature = "editor")]
pub(crate) use session::answer;
pub(crate) use session::{Session, Turn};
