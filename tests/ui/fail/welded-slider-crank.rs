//! The coupler is welded to the sliding block: the crank cannot turn, though it stands square to the guide and so seems to
//! be free to begin with.

use mech_runtime::mechanism;

mechanism! {
    struct Slider;

    link crank;
    link coupler;
    link block;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.0, 1.0);
    joint c = weld(coupler, block) at (3.0, 0.0);
    joint d = prismatic(ground, block) at (3.0, 0.0) along (1.0, 0.0);

    motor a;
}

fn main() {}
