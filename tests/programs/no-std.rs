//! A crate without the standard library, and without `unsafe`.
#![no_std]
#![forbid(unsafe_code)]

extern crate std;

mod linkage {
    mech_runtime::mechanism! {
        pub struct FourBar: f32;

        link crank;
        link coupler { circle (3.0, 2.0) radius 0.2; }
        link rocker;

        joint a = revolute(ground, crank) at (0.0, 0.0);
        joint b = revolute(crank, coupler) at (0.5, 0.8);
        joint c = revolute(coupler, rocker) at (3.0, 2.0);
        joint d = revolute(ground, rocker) at (3.5, 0.0);

        motor a;
    }
}

fn main() {
    assert!(linkage::FourBar::new().move_to([0.1]).is_ok());
}
