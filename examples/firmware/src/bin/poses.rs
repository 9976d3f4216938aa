//! Prints where the links of every mechanism are, bit by bit, and check sums of pictures.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use firmware::Printer;
use mech_probes::{Probe, Probed, ask_all, pictures, poses};
use panic_never as _;

struct Everything(Printer);

impl Probe for Everything {
    fn ask<M: Probed>(&mut self) {
        poses::<M>(&mut self.0);
        pictures::<M>(&mut self.0);
    }
}

#[firmware::entry]
fn main() -> ! {
    let mut everything = Everything(Printer::new());
    ask_all(&mut everything);
    firmware::exit(everything.0.is_heard())
}
