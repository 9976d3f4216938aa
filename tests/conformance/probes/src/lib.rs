//! What is asked of mechanisms on every machine: the same code runs on a desktop and on a microcontroller, and what it tells is compared.
//!
//! [`poses`] tells where the links of a mechanism are, bit by bit, [`pictures`] a check sum of each picture of it. [`ask_all`] goes
//! through all mechanisms there are: the gallery's, one [four-bar](four_bar) by every method, and [walkers](legs). A [plotter] is led, and measured alone.
#![no_std]

pub mod four_bar;
pub mod legs;
mod panel;
mod pictures;
pub mod plotter;
mod poses;

pub use panel::{Panel, sum};
pub use pictures::pictures;
pub use poses::poses;

use mech_gallery::{Exhibited, Visitor};
use mech_runtime::{Mechanism, Real};

/// In so many steps a mechanism goes through its motion.
pub const STEPS: u16 = 360;

/// A mechanism with a name and a motion.
pub trait Probed: Mechanism {
    /// Its name. The same in both precisions.
    const LABEL: &'static str;

    /// The values of its motors (radians, scene units) at a phase in `0.0..1.0` of its motion.
    fn motion(phase: Self::Scalar) -> Self::Motors;
}

impl<M: Exhibited> Probed for M {
    const LABEL: &'static str = M::SLUG;

    fn motion(phase: M::Scalar) -> M::Motors {
        <M as Exhibited>::motion(phase)
    }
}

/// Asks a mechanism something.
pub trait Probe {
    /// Asks this one.
    fn ask<M: Probed>(&mut self);
}

/// Asks every mechanism: those of the gallery in both precisions, the four-bar by every method, and walkers.
pub fn ask_all(probe: &mut impl Probe) {
    struct Asking<'p, P>(&'p mut P);

    impl<P: Probe> Visitor for Asking<'_, P> {
        fn visit<M: Exhibited>(&mut self) {
            self.0.ask::<M>();
        }
    }

    let mut asking = Asking(probe);
    mech_gallery::visit_f32(&mut asking);
    mech_gallery::visit_f64(&mut asking);
    four_bar::visit(probe);
    legs::visit(probe);
}

/// Who receives what mechanisms report.
pub trait Listener {
    /// Something begins, about the mechanism with this name.
    fn begin(&mut self, what: &str, name: &str, precision: &str);
    /// A part of it.
    fn word(&mut self, word: u64);
    /// It is complete.
    fn end(&mut self);
}

/// The name of the scalar a mechanism is computed in.
#[must_use]
pub const fn precision<M: Mechanism>() -> &'static str {
    if size_of::<M::Scalar>() == size_of::<f32>() { "f32" } else { "f64" }
}

/// The part of its motion that is done at a step, in the scalar's own arithmetic.
#[must_use]
pub fn phase<T: Real>(step: u16) -> T {
    T::from_i32(step.into()) / T::from_i32(STEPS.into())
}
