//! One leg of Jansen's and a walker on four, in both precisions: loops that are alike share one function on every machine.

use crate::{Probe, Probed};
use mech_runtime::{Real, mechanism};

macro_rules! walkers {
    ($($visibility:vis $name:ident: $scalar:ident, $slug:literal, { $($legs:tt)* })*) => {
        $(
            mechanism! {
                /// A walker.
                $visibility struct $name: $scalar;
                use mech_runtime::parts::JansenLeg;
                ground { point shaft = (0, 0); }
                link axle { point shaft = (0, 0); }
                joint main = revolute(ground.shaft, axle.shaft);
                motor main;
                $($legs)*
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

walkers! {
    pub OneSingle: f32, "one-leg", { use leg: JansenLeg { frame = ground, crank = axle }; }
    pub OneDouble: f64, "one-leg", { use leg: JansenLeg { frame = ground, crank = axle }; }
    pub FourSingle: f32, "four-legs", {
        use left[2]: JansenLeg(phase = k * 180 deg) { frame = ground, crank = axle };
        use right[2]: JansenLeg(phase = k * 180 deg) mirrored { frame = ground, crank = axle };
    }
    pub FourDouble: f64, "four-legs", {
        use left[2]: JansenLeg(phase = k * 180 deg) { frame = ground, crank = axle };
        use right[2]: JansenLeg(phase = k * 180 deg) mirrored { frame = ground, crank = axle };
    }
}
