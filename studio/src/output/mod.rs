//! Files that are written whole or not at all.

#[cfg(not(target_arch = "wasm32"))]
mod disk;
#[cfg(target_arch = "wasm32")]
mod download;

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use disk::replace;
#[cfg(all(not(target_arch = "wasm32"), feature = "editor"))]
pub(crate) use disk::{hidden_beside, remove, words};
#[cfg(target_arch = "wasm32")]
pub(crate) use download::replace;
