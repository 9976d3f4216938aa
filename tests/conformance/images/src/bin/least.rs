//! The least there is: a four-bar in `f32` that is moved to what a register says, and nothing else.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use core::hint::black_box;
use mech_probes::four_bar::ExactSingle;
use panic_never as _;

#[images::entry]
fn main() -> ! {
    let mut four_bar = ExactSingle::new();
    loop {
        let moved = four_bar.move_to([black_box(0.0)]).is_ok();
        black_box((moved, four_bar.rocker()));
    }
}
