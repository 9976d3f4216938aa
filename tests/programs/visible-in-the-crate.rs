//! A mechanism with a restricted visibility, used from outside its module.

mod linkage {
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

fn main() {
    let mut m = linkage::FourBar::new();
    m.move_to([0.1]).expect("it moves");
    assert!(m.d() > 0.0);
}
