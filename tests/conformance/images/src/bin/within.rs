//! The four-bar of the image `least` with a declared range, in which it is moved without an error there could be.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use core::hint::black_box;
use mech_runtime::mechanism;
use panic_never as _;

mechanism! {
    /// A crank-rocker.
    struct FourBar: f32;
    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point crank_pin = (0, 0); point rocker_pin = (3.5, 0); }
    link rocker { point shaft = (0, 0); point pin = (3, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a in -60 deg ..= 60 deg;
    start { a = 0 deg; rocker near 110 deg; }
}

#[images::entry]
fn main() -> ! {
    let mut four_bar = FourBar::new();
    loop {
        if let Some(values) = FourBar::range([black_box(0.0)]) {
            four_bar.move_within(values);
        }
        black_box(four_bar.rocker());
    }
}
