//! Attributes and doc comments go to the struct.

use mech_runtime::mechanism;

mechanism! {
    /// A linkage.
    ///
    /// Of four bars.
    #[must_use]
    #[allow(dead_code)]
    #[doc(alias = "linkage")]
    pub struct FourBar;

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
    let mut m = FourBar::new();
    m.move_to([0.1]).expect("it moves");
}
