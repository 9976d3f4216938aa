//! It moves only because its lengths match, and needs a motor to do so.

use mech_runtime::mechanism;

mechanism! {
    struct ThreeCranks;
    link first;
    link second;
    link third;
    link rail;
    joint a = revolute(ground, first) at (0, 0);
    joint b = revolute(ground, second) at (2, 0);
    joint c = revolute(ground, third) at (4, 0);
    joint d = revolute(first, rail) at (0.5, 1);
    joint e = revolute(second, rail) at (2.5, 1);
    joint f = revolute(third, rail) at (4.5, 1);
}

fn main() {}
