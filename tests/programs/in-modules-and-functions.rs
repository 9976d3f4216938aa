//! Where a mechanism may stand: beside another of the same names, in a module, and inside the body of a function or a closure.

use mech_runtime::mechanism;

mechanism! {
    struct First;
    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 0.8);
    joint c = revolute(coupler, rocker) at (3.0, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);

    motor a;
}

mechanism! {
    struct Second: f32;
    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (0.5, 0.8);
    joint c = revolute(coupler, rocker) at (3.0, 2.0);
    joint d = revolute(ground, rocker) at (3.5, 0.0);

    motor a;
}

/// A mechanism that only its module knows.
mod private {
    mech_runtime::mechanism! {
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

    pub fn turned(angle: f64) -> f64 {
        let mut m = FourBar::new();
        m.move_to([angle]).expect("it moves");
        m.d()
    }
}

/// A mechanism with a restricted visibility, used from outside its module.
mod visible {
    mech_runtime::mechanism! {
        pub(crate) struct FourBar;
        link crank;
        link coupler;
        link rocker;

        joint a = revolute(ground, crank) at (0.0, 0.0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3.0, 2.0);
        joint d = revolute(ground, rocker) at (3.5, 0.0);

        motor a;
    }
}

fn in_a_function() {
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

fn main() {
    First::new().move_to([0.1]).expect("it moves");
    Second::new().move_to([0.1]).expect("it moves");
    assert!(private::turned(0.1) > 0.0);
    let mut m = visible::FourBar::new();
    m.move_to([0.1]).expect("it moves");
    assert!(m.d() > 0.0);
    in_a_function();
}
