//! What is not shown has no method; what is shown has them, also where the mechanism fails.

use mech_runtime::mechanism;

mechanism! {
    struct FourBar;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
    show rocker, coupler.right, b;
}

mechanism! {
    struct Loose;

    link crank { point tip = (1.0, 0.0); }
    link spare { point tip = (1.0, 0.0); }
    joint a = revolute(ground, crank) at (0.0, 0.0);
    motor a;
    show crank;
}

fn main() {
    let four_bar = FourBar::new();
    println!("{} {} {}", four_bar.rocker_pin(), four_bar.coupler_right(), four_bar.b());
    println!("{}", four_bar.coupler());
    let loose = Loose::new();
    println!("{} {}", loose.crank_tip(), loose.spare());
}
