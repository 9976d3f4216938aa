//! A slider-crank driven at its piston.

use mech_runtime::mechanism;

mechanism! {
    pub struct Slider;

    ground { point o = (0.0, 0.0); line bore = (0.0, 0.0) -> (1.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (3.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, piston.pin);
    joint d = prismatic(ground.bore, piston.axis);

    motor d;
    start { d = 3.0; crank near 60 deg; }
}

fn main() {
    let mut m = Slider::new();
    m.move_to([3.5]).expect("it moves");
    assert_eq!(m.d(), 3.5);
    assert!(m.a() > 0.0);
    m.move_to([4.5]).expect_err("it is out of reach");
    assert_eq!(m.d(), 3.5);
}
