//! What the images of this package have in common: a printer, and what is measured. The board is that of the `firmware` examples.
//!
//! Nothing here can panic. An image says so itself by `use panic_never as _;`, which makes a panic that can be reached an error of the
//! linker.
#![no_std]
#![forbid(unsafe_code)]

mod clock;
mod figures;
mod printer;
mod subject;

pub use figures::figures;
pub use firmware::{entry, exit};
pub use printer::Printer;
pub use subject::{Drawn, Moved, Nothing, Reaching, Subject};

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
