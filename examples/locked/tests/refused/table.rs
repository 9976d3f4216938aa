//! The table with its lock: a bar from the leg to the knee.

mech_runtime::mechanism! {
    struct Locked;

    link leg;
    link upper;
    link lower;
    link lock;
    joint hinge = revolute(ground, leg) at (0, 0);
    joint pivot = revolute(ground, upper) at (4, 0);
    joint knee = revolute(upper, lower) at (2.6, -1.9);
    joint catch = revolute(upper, lock) at (2.6, -1.9);
    joint foot = revolute(lower, leg) at (0, -3);
    joint bolt = revolute(lock, leg) at (0, -1);
    motor hinge;
}

fn main() {}
