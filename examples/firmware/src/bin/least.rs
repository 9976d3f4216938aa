//! The least there is: a four-bar in `f32` that is turned by a counter, and nothing else.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use core::hint::black_box;
use mech_probes::four_bar::ExactSingle;
use mech_runtime::Phase;

#[firmware::entry]
fn main() -> ! {
    let mut four_bar = ExactSingle::new();
    let mut count = 0_u64;
    loop {
        count = count.wrapping_add(1 << 52);
        let moved = four_bar.turn_to(Phase::new(0, black_box(count))).is_ok();
        black_box((moved, four_bar.rocker()));
    }
}
