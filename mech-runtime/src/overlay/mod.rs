//! Diagrams over a mechanism: joint symbols, links as bars, pitch circles, motors, axes, and arrows for velocities, accelerations and
//! forces.
//!
//! A mechanism with `effects { overlay; }` has the method `draw_overlay`. With `effects { overlay; velocity; }` it also has
//! `draw_velocities`, and so on. These draw on any [`Canvas`]. Lines and symbols have the same size in pixels at any scale.
//!
//! ```
//! use mech_runtime::{Frame, Overlay, Palette, View, mechanism, overlay::Arrows};
//!
//! mechanism! {
//!     struct SliderCrank;
//!     link crank; link rod; link block;
//!     joint a = revolute(ground, crank) at (0, 0);
//!     joint b = revolute(crank, rod) at (1, 0.5);
//!     joint c = revolute(rod, block) at (4, 0);
//!     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
//!     motor a;
//!     effects { velocity; overlay; }
//! }
//! let mut slider_crank = SliderCrank::new();
//! slider_crank.move_with([0.4], [1.0])?;
//! let mut frame = Frame::<320, 200>::new();
//! frame.look_at(View::fit([-1.5, -1.5], [5.5, 1.5], 320, 200, 20.0));
//! slider_crank.draw_overlay(&mut frame, &Overlay::new().links(true));
//! slider_crank.draw_velocities(&mut frame, &Arrows::new(0.5, Palette::BLUE));
//! assert!(frame.pixels().as_flattened().contains(&Palette::BLUE));
//! # Ok::<(), mech_runtime::Blocked>(())
//! ```
//!
//! | symbol | meaning |
//! |---|---|
//! | small circle | a revolute joint |
//! | the same on a triangle with a hatched base | a fixed pivot |
//! | block on a hatched rail | a prismatic joint on the ground |
//! | block on a line | a prismatic joint between moving links; with a circle in it, a pin in a slot |
//! | thin circles that touch, each with a tick | the pitch circles of gears; of a belt, with its strands; of a pinion, with the rack's pitch line |
//! | thin circle beside its shaft, wedge | a cam that turns, one that slides |
//! | full square | a weld |
//! | zigzag, cylinder with a piston | a spring, a damper; side by side between the same points |
//! | spiral, the same cylinder bent about a joint | a torsional spring, a torsional damper |
//! | curved arrow, double arrow | a motor that turns, one that slides |
//! | line, triangle, polygon | a link |
//! | full dot | a named point of a link without a joint |
//! | small cross, chain line | the axes: points and lines as declared |
//! | arrow | a velocity, an acceleration, a force |

mod arrow;
mod elastic;
mod pen;
mod symbol;

pub use arrow::{Arrows, arrow, moment};
#[doc(inline)]
pub use mech_core::{Spot, Symbol};

use crate::{Canvas, Palette, Pose, Scalar};
use pen::Pen;
use symbol::Kind;

/// The kinds of symbols that are drawn over a mechanism, their size and their colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlay {
    /// Whether each kind of symbol is drawn.
    wanted: [bool; 4],
    size: f32,
    ink: u8,
    paper: u8,
}

impl Overlay {
    /// The symbols of joints and motors in ink, for a mechanism whose links have shapes.
    #[must_use]
    pub const fn new() -> Self {
        Self { wanted: [false; 4], size: 1.0, ink: Palette::INK, paper: Palette::EYE }
            .joints(true)
            .motors(true)
    }

    /// Chooses whether links are drawn as bars between their joints and gears as pitch circles, for a diagram without shapes.
    #[must_use]
    pub const fn links(self, links: bool) -> Self {
        self.with(Kind::Link, links)
    }

    /// Chooses whether the symbols of joints are drawn.
    #[must_use]
    pub const fn joints(self, joints: bool) -> Self {
        self.with(Kind::Joint, joints)
    }

    /// Chooses whether motors are drawn as arrows.
    #[must_use]
    pub const fn motors(self, motors: bool) -> Self {
        self.with(Kind::Motor, motors)
    }

    /// Chooses whether the declared points and lines are drawn as crosses and chain lines.
    #[must_use]
    pub const fn axes(self, axes: bool) -> Self {
        self.with(Kind::Axis, axes)
    }

    const fn with(mut self, kind: Kind, wanted: bool) -> Self {
        self.wanted[kind as usize] = wanted;
        self
    }

    /// Sets the size of all symbols relative to the usual size, 1. A size that is not finite and positive becomes 1.
    #[must_use]
    pub const fn size(self, size: f32) -> Self {
        let size = usable(size);
        Self { size, ..self }
    }

    /// Sets the entries of the palette for lines and for the inside of symbols. The defaults are [`Palette::INK`] and [`Palette::EYE`].
    #[must_use]
    pub const fn colors(self, ink: u8, paper: u8) -> Self {
        Self { ink, paper, ..self }
    }

    /// Draws the chosen symbols of links at these poses.
    pub fn draw<T: Scalar>(
        &self,
        symbols: &[Symbol<T>],
        poses: &[Pose<T>],
        canvas: &mut impl Canvas<T>,
    ) {
        let pen = Pen::new(canvas, self.size, self.ink, self.paper);
        for symbol in symbols {
            if self.wanted.get(symbol::kind(symbol) as usize) == Some(&true) {
                // A symbol on a link without a pose is left out.
                let _ = symbol::draw(symbol, poses, &pen, canvas);
            }
        }
    }
}

impl Default for Overlay {
    fn default() -> Self {
        Self::new()
    }
}

/// The size, or 1 if it is not finite and positive.
const fn usable(size: f32) -> f32 {
    if size.is_finite() && size > 0.0 { size } else { 1.0 }
}
