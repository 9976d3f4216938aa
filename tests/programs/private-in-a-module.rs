//! A mechanism that only its module knows.

mod linkage {
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

fn main() {
    assert!(linkage::turned(0.1) > 0.0);
}
