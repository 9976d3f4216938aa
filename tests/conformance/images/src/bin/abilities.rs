//! Prints what comes of everything that mechanisms and pictures can do, bit by bit.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use images::Printer;
use mech_abilities::abilities;
use panic_never as _;

#[images::entry]
fn main() -> ! {
    let mut printer = Printer::new();
    abilities(&mut printer);
    images::exit(printer.is_heard())
}
