//! Effects that are not there, or twice; methods that would have one name.

use mech_runtime::mechanism;

mechanism! {
    struct Crank;

    ground { point o = (0.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point velocity = (1.0, 0.0); }
    joint a = revolute(ground.o, crank.shaft);
    joint a_rate = revolute(ground.o, crank.velocity);

    motor a;
    effects { velocitiy; velocity; velocity; heat; }
    effects { acceleration; }
}

fn main() {}
