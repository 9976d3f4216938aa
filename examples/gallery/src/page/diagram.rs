//! Mechanisms with the diagrams of textbooks.

use crate::{Exhibit, Film, Graphs, Scene, Showcase, Stuck};
use mech_runtime::{Blocked, Mechanism};

/// A showcase with functions of its own that move and paint it: with rates, with an overlay.
pub struct Diagram<M: Mechanism<Scalar = f64>> {
    /// The mechanism and its motion.
    pub showcase: Showcase<M>,
    /// Moves it to these values of its motors.
    pub move_to: Move<M>,
    /// Paints it.
    pub paint: fn(&M, &mut Scene),
}

/// A function that moves a mechanism to motor values.
pub type Move<M> =
    fn(&mut M, <M as Mechanism>::Motors) -> Result<(), Blocked<<M as Mechanism>::Motors>>;

impl<M: Mechanism<Scalar = f64> + 'static> Exhibit for Diagram<M> {
    fn slug(&self) -> &'static str {
        self.showcase.slug()
    }

    fn title(&self) -> &'static str {
        self.showcase.title()
    }

    fn caption(&self) -> &'static str {
        self.showcase.caption()
    }

    fn report(&self) -> &'static str {
        self.showcase.report()
    }

    fn graphs(&self) -> Option<Graphs> {
        self.showcase.graphs()
    }

    fn file(&self) -> Option<&'static str> {
        self.showcase.file()
    }

    fn still(&self) -> f64 {
        self.showcase.still()
    }

    fn film(&self) -> Result<Film, Stuck> {
        self.showcase.film_by(self.move_to, self.paint)
    }
}
