//! Files on a disk.

mod draft;
mod fence;
#[cfg(feature = "editor")]
mod hidden;
mod place;
mod rights;
mod writer;

pub(crate) use fence::Fence;
#[cfg(feature = "editor")]
pub(crate) use hidden::{create_like, hidden_beside, keep, remove};
#[cfg(feature = "editor")]
pub(crate) use place::words;
pub(crate) use writer::Writer;
