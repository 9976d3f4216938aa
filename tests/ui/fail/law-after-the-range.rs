mech_runtime::mechanism! {
    struct Crank;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a in 0 ..= 1 = sin(t);
}

fn main() {
    // The method is there all the same.
    let _ = Crank::new().at_time(1.0);
}
