//! A part that is kept for other files is read where it stands.

use mech_runtime::mechanism_part;

mechanism_part! {
    pub(crate) Rod(length = 1) {
        port crank { point pin = (0, 0); }
        link rod { point pin = (0, 0); point tip = (length 0); }
        join pin = revolute(crank.pin, rod.pin);
    }
}

fn main() {}
