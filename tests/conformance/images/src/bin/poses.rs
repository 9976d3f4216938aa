//! Prints where the links of every mechanism are, bit by bit, and check sums of pictures.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use images::Printer;
use mech_probes::{Probe, Probed, ask_all, pictures, poses};
use panic_never as _;

struct Everything(Printer);

impl Probe for Everything {
    fn ask<M: Probed>(&mut self) {
        poses::<M>(&mut self.0);
        pictures::<M>(&mut self.0);
    }
}

#[images::entry]
fn main() -> ! {
    let mut everything = Everything(Printer::new());
    ask_all(&mut everything);
    images::exit(everything.0.is_heard())
}
