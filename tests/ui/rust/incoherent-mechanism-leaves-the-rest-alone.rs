//! Likewise for a mechanism that can be read but does not move.

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
}

fn main() {
    let mut four_bar = FourBar::new();
    four_bar.move_to([0.5]).unwrap();
    println!("{} {} {}", four_bar.coupler(), four_bar.rocker_pin(), four_bar.c());
}
