//! One four-bar linkage by every method in both precisions: that of the price list of accuracy.

use crate::{Probe, Probed};
use mech_runtime::{Real, mechanism};

macro_rules! four_bars {
    ($($visibility:vis $name:ident: $scalar:ident, $slug:literal, { $($method:tt)* })*) => {
        $(
            mechanism! {
                /// A crank-rocker.
                $visibility struct $name: $scalar;
                ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
                link crank { point shaft = (0, 0); point pin = (1, 0); }
                link coupler { point crank_pin = (0, 0); point rocker_pin = (3.5, 0); point tip = (1.75, 1.5); }
                link rocker { point shaft = (0, 0); point pin = (3, 0); }
                joint a = revolute(ground.crank_shaft, crank.shaft);
                joint b = revolute(crank.pin, coupler.crank_pin);
                joint c = revolute(coupler.rocker_pin, rocker.pin);
                joint d = revolute(ground.rocker_shaft, rocker.shaft);
                motor a;
                start { a = 0 deg; rocker near 110 deg; }
                $($method)*
            }

            impl Probed for $name {
                const LABEL: &'static str = $slug;

                fn motion(phase: $scalar) -> [$scalar; 1] {
                    [phase * <$scalar as Real>::TURN]
                }
            }
        )*

        /// Asks all of them.
        pub(crate) fn visit(probe: &mut impl Probe) {
            $(probe.ask::<$name>();)*
        }
    };
}

four_bars! {
    pub ExactSingle: f32, "exact", { method exact; }
    pub ExactDouble: f64, "exact", { method exact; }
    pub LinearSingle: f32, "linear", { method linear; }
    pub LinearDouble: f64, "linear", { method linear; }
    pub OneRoundSingle: f32, "newton-1", { method newton(1); }
    pub OneRoundDouble: f64, "newton-1", { method newton(1); }
    pub TwoRoundsSingle: f32, "newton-2", { method newton(2); }
    pub TwoRoundsDouble: f64, "newton-2", { method newton(2); }
    pub ThreeRoundsSingle: f32, "newton-3", { method newton(3); }
    pub ThreeRoundsDouble: f64, "newton-3", { method newton(3); }
    pub NewtonSingle: f32, "newton", { method newton; }
    pub NewtonDouble: f64, "newton", { method newton; }
}
