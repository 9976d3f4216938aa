//! A window, or a terminal, in which mechanisms move. They play, follow the pointer when a link is dragged, and stop and mark their limits.
//!
//! A [`Player`] is the whole state. It takes [`Control`]s and the time that has passed, and knows no window and no clock. A [`Stage`] adds
//! the [`Painter`]. The window and the [`terminal`] are two thin front ends to it. A [`Mechanism`] is moved by the compiler's
//! interpreter.

mod camera;
mod caption;
mod control;
mod distance;
mod driver;
mod grip;
pub mod half_blocks;
pub mod keys;
mod landmarks;
mod layers;
mod marks;
mod mechanism;
mod motion;
mod painter;
mod player;
mod prepared;
mod rates;
mod stage;
#[cfg(not(target_arch = "wasm32"))]
pub mod terminal;
#[cfg(all(feature = "editor", not(target_arch = "wasm32")))]
pub mod window;

pub use camera::Camera;
pub use control::Control;
#[cfg(feature = "editor")]
pub(crate) use distance::{distance_to_line, nearest_on_line};
pub use driver::{Driver, Pace, Selection};
use grip::Held;
pub use grip::{Free, Grip};
pub use keys::Key;
pub use layers::{Layer, Layers, Style};
pub use mechanism::{Limit, Mechanism, Obstacle};
pub use motion::Rates;
pub use painter::Painter;
pub use player::{Player, Revision};
pub use prepared::Derived;
#[cfg(feature = "transfer")]
pub(crate) use prepared::Prepared;
pub use rates::PointRates;
pub use stage::Stage;

/// The size of a picture at first, in pixels.
pub const SIZE: [usize; 2] = [960, 720];
