mech_runtime::mechanism! {
    struct Lever;
    link disk;
    link lever;
    link rod;
    joint s = revolute(ground, disk) at (0, 0);
    joint f = revolute(ground, lever) at (3, 0);
    joint r = revolute(lever, rod) at (3, 1);
    joint c = cam(s, f, 0.2 * sin(q));
    motor f;
    motor r;
}

fn main() {}
