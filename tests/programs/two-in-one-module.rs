//! Two mechanisms of the same names, side by side.

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

fn main() {
    First::new().move_to([0.1]).expect("it moves");
    Second::new().move_to([0.1]).expect("it moves");
}
