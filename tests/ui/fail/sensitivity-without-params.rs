// There is nothing that it could follow.
mech_runtime::mechanism! {
    struct Crank;
    ground { point shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    joint a = revolute(ground.shaft, crank.shaft);
    motor a;
    effects { velocity; sensitivity; }
}

fn main() {}
