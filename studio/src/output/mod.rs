//! Files that are written whole or not at all, and never over what nobody meant.
//!
//! One rule holds for all of them. A file that was read is no output. A file that is there is replaced if it is empty, or has an ending
//! and the first bytes of what is written; more, the user has to say. A script, moreover, keeps to its [`Fence`].

#[cfg(not(target_arch = "wasm32"))]
mod disk;
#[cfg(target_arch = "wasm32")]
mod download;
mod kind;

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use disk::{Fence, Writer};
#[cfg(all(not(target_arch = "wasm32"), feature = "editor"))]
pub(crate) use disk::{create_like, hidden_beside, keep, remove, words};
#[cfg(target_arch = "wasm32")]
pub(crate) use download::Writer;
#[cfg(feature = "editor")]
pub(crate) use kind::ends_in;
pub(crate) use kind::{Output, OutputKind, Over};

use crate::failure::Failure;

/// Writes a file at once, for a person.
///
/// # Errors
/// If it may not be written, or cannot be. What is there stays as it is.
pub(crate) fn write(output: Output) -> Result<(), Failure> {
    Writer::default().write(output)
}
