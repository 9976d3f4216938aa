//! Everything that mechanisms and pictures can do, each with a small mechanism that does it: so that nothing is left out where the
//! linker has to see that none of it can panic, and all of it is compared between machines.
#![no_std]

/// Declares mechanisms and what is asked of them, in both precisions: in a module `single` and in a module `double`.
macro_rules! in_both_precisions {
    ({ $($(#[$about:meta])* $name:ident { $($declared:tt)* })* } $($item:item)*) => {
        mod double {
            $(mech_runtime::mechanism! { $(#[$about])* struct $name: f64; $($declared)* })*
            $($item)*
        }

        mod single {
            $(mech_runtime::mechanism! { $(#[$about])* struct $name: f32; $($declared)* })*
            $($item)*
        }

        /// Asks for all of it.
        pub(super) fn ask(listener: &mut impl mech_probes::Listener) {
            double::ask(&mut crate::Recorder::new(listener, "f64"));
            single::ask(&mut crate::Recorder::new(listener, "f32"));
        }
    };
}

mod coupled;
mod diagrams;
mod dynamics;
mod forces;
mod lawful;
mod led;
mod loops;
mod many;
mod methods;
mod moves;
mod paints;
mod params;
mod phases;
mod ranges;
mod rates;
mod recorder;
mod rolling;
mod words;

use mech_probes::Listener;
use recorder::Recorder;

/// Tells what comes of everything that mechanisms and pictures can do, with numbers the compiler cannot foresee: good ones and bad
/// ones.
pub fn abilities(listener: &mut impl Listener) {
    phases::ask(listener);
    loops::ask(listener);
    methods::ask(listener);
    rolling::ask(listener);
    coupled::ask(listener);
    ranges::ask(listener);
    lawful::ask(listener);
    led::ask(listener);
    many::ask(listener);
    rates::ask(listener);
    forces::ask(listener);
    dynamics::ask(listener);
    params::ask(listener);
    diagrams::ask(listener);
    paints::ask(listener);
}
