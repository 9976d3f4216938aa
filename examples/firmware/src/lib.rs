//! What the images of this workspace have in common: the board, a way to print, and what is measured.
//!
//! Nothing here can panic. An image says so itself by `use panic_never as _;`, which makes a panic that can be reached an error of the
//! linker; those with drivers of others cannot, and have `panic-halt`.
#![no_std]
#![forbid(unsafe_code)]

mod board;
mod figures;
mod line;
mod printer;
mod subject;
pub mod wiring;

pub use board::{entry, exit};
pub use figures::figures;
pub use line::Line;
pub use printer::Printer;
pub use subject::{Drawn, Moved, Nothing, Subject};

/// An image that measures a [`Subject`].
#[macro_export]
macro_rules! measure {
    ($subject:ty) => {
        use panic_never as _;

        #[$crate::entry]
        fn main() -> ! {
            $crate::figures::<$subject>()
        }
    };
}
