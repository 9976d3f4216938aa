//! The law of a cam is not 0 at the start, but its follower is drawn there.

use mech_runtime::mechanism;

mechanism! {
    struct Valve;

    link disk;
    link tappet;

    joint s = revolute(ground, disk) at (0, 0);
    joint f = prismatic(ground, tappet) at (0, 2) along (0, 1);
    joint c = cam(s, f, 1 + 0.2 * sin(q));

    motor s;
}

fn main() {}
