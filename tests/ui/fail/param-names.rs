// The name of a param is a method, and so is what sets it.
mech_runtime::mechanism! {
    struct Crank;
    param length = 1.0;
    param length = 2.0;
    param motors = 2.0;
    param arm = arm_length;
    ground { point shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (length, 0); }
    link set_length;
    joint a = revolute(ground.shaft, crank.shaft);
    motor a;
}

fn main() {}
