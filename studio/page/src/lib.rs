//! The editor of `mech-studio` as a page for a browser: `studio/page/build` makes it. On every other target this library is empty.

#[cfg(target_arch = "wasm32")]
pub mod entry;
#[cfg(target_arch = "wasm32")]
mod page;
#[cfg(target_arch = "wasm32")]
pub mod worker;
