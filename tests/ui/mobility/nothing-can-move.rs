//! The joints hold all links, and there is no motor to be blocked.

use mech_runtime::mechanism;

mechanism! {
    struct Truss;

    ground { point o = (0.0, 0.0); point p = (2.0, 0.0); }
    link left { point foot = (0.0, 0.0); point head = (1.5, 0.0); }
    link right { point foot = (0.0, 0.0); point head = (1.5, 0.0); }

    joint a = revolute(ground.o, left.foot);
    joint b = revolute(ground.p, right.foot);
    joint c = revolute(left.head, right.head);
}

fn main() {}
