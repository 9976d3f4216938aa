//! A motor drives the way of a slot, and nothing the angle of its pin.

use mech_runtime::mechanism;

mechanism! {
    struct S;
    link a;
    joint s = slot(a, ground) at (1, 0) along (1, 0);
    motor s;
}

fn main() {}
