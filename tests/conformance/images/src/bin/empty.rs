//! What every image takes: it starts, and does nothing.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use core::hint::black_box;
use panic_never as _;

#[images::entry]
fn main() -> ! {
    loop {
        black_box(());
    }
}
