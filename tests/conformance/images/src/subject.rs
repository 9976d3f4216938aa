//! What is measured.

use core::hint::black_box;
use mech_probes::plotter::Led;
use mech_probes::{Probed, phase};
use mech_runtime::{Frame, View};

/// The picture that is drawn: as many small displays have.
pub type Picture = Frame<SIDE, SIDE>;

/// Its width and height in pixels.
const SIDE: usize = 240;

/// What is measured: something that moves, and is perhaps drawn.
pub trait Subject {
    /// The values of its motors.
    type Motors: Copy;

    /// As it is at the start.
    fn new() -> Self;
    /// The values of its motors at a step of its motion.
    fn motion(step: u16) -> Self::Motors;
    /// Moves it. Whether it could.
    fn move_to(&mut self, motors: Self::Motors) -> bool;
    /// How it is seen, in all of its motion.
    fn view() -> View;
    /// Draws it.
    fn draw(&self, picture: &mut Picture);
    /// Bytes of its state.
    fn state() -> usize {
        0
    }
}

/// Nothing: what an image takes that has no mechanism in it.
pub struct Nothing;

impl Subject for Nothing {
    type Motors = ();

    fn new() -> Self {
        Self
    }

    fn motion(_: u16) {}

    fn move_to(&mut self, (): ()) -> bool {
        black_box(true)
    }

    fn view() -> View {
        View::default()
    }

    fn draw(&self, _: &mut Picture) {}
}

/// A mechanism that moves.
pub struct Moved<M>(M);

impl<M: Probed> Subject for Moved<M> {
    type Motors = M::Motors;

    fn new() -> Self {
        Self(M::new())
    }

    fn motion(step: u16) -> M::Motors {
        M::motion(phase(step))
    }

    // One function that is called, as in a program that has other things to do.
    #[inline(never)]
    fn move_to(&mut self, motors: M::Motors) -> bool {
        self.0.move_to(motors).is_ok()
    }

    fn view() -> View {
        View::default()
    }

    fn draw(&self, _: &mut Picture) {
        black_box(self.0.poses());
    }

    fn state() -> usize {
        size_of::<M>()
    }
}

/// A mechanism whose point is led.
pub struct Reaching<M>(M);

impl<M: Led> Subject for Reaching<M> {
    type Motors = M::Place;

    fn new() -> Self {
        Self(M::new())
    }

    fn motion(step: u16) -> M::Place {
        M::place(phase(step))
    }

    // As above.
    #[inline(never)]
    fn move_to(&mut self, place: M::Place) -> bool {
        self.0.lead(place)
    }

    fn view() -> View {
        View::default()
    }

    fn draw(&self, _: &mut Picture) {}

    fn state() -> usize {
        size_of::<M>()
    }
}

/// A mechanism that moves and is drawn.
pub struct Drawn<M>(Moved<M>);

impl<M: Probed> Subject for Drawn<M> {
    type Motors = M::Motors;

    fn new() -> Self {
        Self(Moved::new())
    }

    fn motion(step: u16) -> M::Motors {
        M::motion(phase(step))
    }

    fn move_to(&mut self, motors: M::Motors) -> bool {
        self.0.move_to(motors)
    }

    fn view() -> View {
        M::view(SIDE, SIDE)
    }

    #[inline(never)]
    fn draw(&self, picture: &mut Picture) {
        picture.clear();
        self.0.0.draw(picture);
    }

    fn state() -> usize {
        Moved::<M>::state()
    }
}
