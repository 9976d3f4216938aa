mech_runtime::mechanism! {
    struct Crank;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a in 0 ..= 1 = sin(t);
}

fn main() {}
