//! A window, or a terminal, in which the mechanisms of the gallery move. They play, follow the pointer when a link is dragged, and stop and
//! mark their limits.
//!
//! A [`Player`] is the whole state. It takes [`Command`]s and the time that has passed, and knows no window and no clock. A [`Stage`] adds
//! the [`Painter`]. The [`window`] and the [`terminal`] are two thin front ends to it.

mod camera;
mod caption;
mod command;
mod drive;
mod driver;
mod grip;
pub mod half_blocks;
pub mod keys;
mod limit;
mod marks;
mod pace;
mod painter;
mod player;
pub mod request;
mod stage;
pub mod terminal;
pub mod window;

pub use camera::Camera;
pub use command::Command;
pub use drive::Drive;
pub use driver::Driver;
pub use grip::{Free, Grip};
pub use keys::Key;
pub use limit::Limit;
pub use pace::Pace;
pub use painter::Painter;
pub use player::Player;
pub use request::{Medium, Request};
pub use stage::Stage;
