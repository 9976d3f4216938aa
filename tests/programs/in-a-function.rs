//! A mechanism inside the body of a function, and of a closure.

use mech_runtime::mechanism;

fn main() {
    mechanism! {
        struct FourBar;
        link crank;
        link coupler;
        link rocker;

        joint a = revolute(ground, crank) at (0.0, 0.0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3.0, 2.0);
        joint d = revolute(ground, rocker) at (3.5, 0.0);

        motor a;
    }
    FourBar::new().move_to([0.1]).expect("it moves");

    let rate = || {
        mechanism! {
            struct FourBar;
            link crank;
            link coupler;
            link rocker;

            joint a = revolute(ground, crank) at (0.0, 0.0);
            joint b = revolute(crank, coupler) at (0.5, 0.8);
            joint c = revolute(coupler, rocker) at (3.0, 2.0);
            joint d = revolute(ground, rocker) at (3.5, 0.0);

            motor a;
        }
        FourBar::new().d()
    };
    assert!(rate().abs() < 1e-12);
}
