//! **If it compiles, it moves.** Planar mechanisms, declared in Rust source, analysed at compile time, solved loop by
//! loop in straight-line `no_std` code.
//!
//! [`mechanism!`] declares a mechanism and makes a struct of it; [`language`] describes its language. The trait [`Mechanism`] has the
//! struct's methods for code that takes any mechanism. [`raster`] paints pictures, and with feature `std` `files` writes them.
//!
//! The crate is `no_std`, needs no allocator and has no `unsafe` code. Angles are in radians, lengths in scene units; y points up.
//! Feature `std` adds pictures on the heap, of any size.
#![cfg_attr(doctest, doc = include_str!("../../README.md"))]
#![no_std]

#[cfg(feature = "std")]
extern crate std;

// Generated code names this crate by its path, in our own tests too.
extern crate self as mech_runtime;

mod blocked;
mod columns;
#[cfg(feature = "std")]
pub mod files;
mod force;
#[doc(hidden)]
pub mod generated;
mod joint;
pub mod language;
mod mechanism;
pub mod overlay;
pub mod parts;
mod range;
pub mod raster;
mod rate;
mod scalar;
mod trace;

pub use blocked::{Blocked, Cause, Place, Reached, Values};
pub use columns::{BlockedAt, Columns};
pub use force::{Forces, GaussLegendre, Reaction};
pub use joint::{Anchor, JointInfo};
/// The number of operations that a position takes, as generated. An operation whose result is never needed is not counted. An iteration
/// counts once for each round. Where a loop iterates until it closes, three rounds are counted.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Crank;
///     link crank { point pin = (0, 1); }
///     joint a = revolute(ground, crank) at (0, 0);
///     motor a;
/// }
/// assert_eq!(Crank::COST.sine_cosine_pairs, 1);
/// assert_eq!(Crank::LOOP_COSTS, []);
/// ```
#[doc(inline)]
pub use mech_core::Cost;
/// Where a link is.
///
/// `From` converts it to nalgebra's isometry and back. Places and directions, which are arrays here, convert to points and vectors:
///
/// ```
/// use mech_runtime::{Isometry2, Point2, Pose};
///
/// let pose = Pose { cos: 0.0, sin: 1.0, x: 2.0, y: 3.0 };
/// let isometry = Isometry2::from(pose);
/// assert_eq!(Pose::from(isometry), pose);
/// let point = Point2::new(1.0, 0.0);
/// assert_eq!(Point2::from(pose.apply(point.into())), Point2::new(2.0, 4.0));
/// assert_eq!(isometry * point, Point2::new(2.0, 4.0));
/// ```
#[doc(inline)]
pub use mech_core::Pose;
#[doc(inline)]
pub use mech_core::{Coordinate, JointKind};
pub use mech_core::{Phase, Real};
pub use mechanism::{BlockedOf, Mechanism};
pub use nalgebra::{Isometry2, Point2, Vector2};
pub use overlay::Overlay;
pub use range::InRange;
pub use raster::{Canvas, Frame, Palette, Smooth, Stage, View};
#[cfg(feature = "std")]
pub use raster::{HeapFrame, HeapSmooth, HeapStage};
pub use rate::{Acceleration, Velocity};
pub use scalar::Scalar;
pub use trace::Trace;

/// The outline of a shape, in scene units. Its points are borrowed.
pub type Outline<'p, T> = mech_core::Outline<T, &'p [[T; 2]]>;

/// An outline with points of its own, for whoever stores it: [`map`](mech_core::Outline::map) makes one, `borrowed` lends it to a canvas.
#[cfg(feature = "std")]
pub type OwnedOutline<T> = mech_core::Outline<T, std::vec::Vec<[T; 2]>>;

/// A coloured outline in the frame of a link.
pub type Shape<T> = mech_core::Shape<T, &'static [[T; 2]]>;

#[doc(hidden)]
pub use mech_macros::mechanism as expand_mechanism;
/// Declares a part that mechanisms in other files and crates can use: `use path::to::Leg;` in a mechanism imports it.
///
/// A part without `pub` can be used in its own module, one with `pub` everywhere. [`language::parts`] describes parts.
///
/// ```
/// mod legs {
///     mech_runtime::mechanism_part! {
///         /// A rod on a crank.
///         pub(crate) Rod(length = 1) {
///             port crank { point pin = (0, 0); }
///             link rod { point pin = (0, 0); point tip = (length, 0); }
///             joint pin = revolute(crank.pin, rod.pin);
///         }
///     }
/// }
///
/// mech_runtime::mechanism! {
///     struct TwoRods;
///     use crate::legs::Rod;
///     use first: Rod(length = 2) { crank = ground };
///     use second: Rod { crank = first.rod at (2, 0) };
///     motor first.pin;
///     motor second.pin;
/// }
/// # fn main() {
/// let tip = TwoRods::new().second().rod_tip();
/// assert_eq!([tip.x, tip.y], [3.0, 0.0]);
/// # }
/// ```
pub use mech_macros::mechanism_part;

/// Declares a planar mechanism: a struct that moves, or a compile error that says what to change.
///
/// ```
/// use mech_runtime::mechanism;
///
/// mechanism! {
///     /// A piston driven through a pair of gears.
///     pub struct GearedPiston: f64;               // f32 or f64; f64 by default
///
///     const THROW = 1.0;                          // numbers: + - * / ( ), PI, functions such as sqrt, `deg`
///
///     ground {
///         point pinion_shaft = (-3.0, 0.0);       // an axis of rotation; `-> (1, 0)` after it gives it a direction
///         point wheel_shaft = (0.0, 0.0);
///         line bore = (0.0, 0.0) -> (1.0, 0.0);   // an axis of sliding
///         polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8), (4.0, 0.8)] on plane 0 color ground;
///     }
///     link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0 on plane 2 color orange; }
///     link wheel  { point shaft = (0.0, 0.0); point pin = (THROW, 0.0); }
///     link rod    { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
///     link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }
///
///     joint d = revolute(ground.pinion_shaft, pinion.shaft);
///     joint e = revolute(ground.wheel_shaft, wheel.shaft);
///     joint mesh = gear(pinion, wheel, 20 : 40);  // teeth; `20 : -60` is internal (a ring); floats are pitch radii
///     joint f = revolute(wheel.pin, rod.big_end);
///     joint g = revolute(rod.small_end, piston.pin);
///     joint h = prismatic(ground.bore, piston.axis);
///
///     motor d;
///     start { d = 0 deg; rod near 0 deg; }        // where it is assembled; `near` chooses among assemblies
///     method newton;                              // until each loop closes to rounding; or `newton(3)`: three rounds
/// }
///
/// let mut piston = GearedPiston::new();           // assembled at compile time; cannot fail
/// piston.move_to([0.3])?;                         // motors in the order of their declaration
/// let pose = piston.piston();                     // a link in the scene: an `Isometry2<f64>`
/// let tip = piston.rod_small_end();               // a named point of a link: a `Point2<f64>`
/// assert!((tip.x - piston.h()).abs() < 1e-12);    // a joint's coordinate
/// assert!((pose.translation.x - tip.x).abs() < 1e-12);
/// println!("{}", GearedPiston::REPORT);           // mobility, trunk and arms, loops in order
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # Statements
///
/// | statement | chapter |
/// |---|---|
/// | `struct NAME;`, `struct NAME: f32;` | |
/// | `const NAME = …;`, `param NAME = …;` | [`laws`](language::laws), [`params`](language::params) |
/// | `ground { … }`, `link NAME;`, `link NAME { … }`, `show …;` | [`links`](language::links) |
/// | `part NAME(…) { port …; … }`, `use NAME: PART { … };`, `use path::PART;` | [`parts`](language::parts) |
/// | `joint NAME = …;`, `continuous …;`, `allow redundant;`, `allow coupled;` | [`joints`](language::joints) |
/// | `motor NAME;`, `motor NAME in … by …;`, `motor NAME = LAW;` | [`moves`](language::moves), [`laws`](language::laws) |
/// | `start { … }` | [`links`](language::links) |
/// | `method …;`, `accuracy …;`, `cost …;`, `at change points …;` | [`moves`](language::moves) |
/// | `follow … by …;`, `path … = (…, …);` | [`inverse`](language::inverse) |
/// | `expect …;` | [`requirements`](language::requirements) |
/// | `look machine;`, `circle`, `ring`, `polygon`, `bar`, `gear`, `stand`, `rail`, `spring` and `text` in a link | [`looks`](language::looks) |
/// | `quality smooth;` | [`pictures`](language::pictures) |
/// | `mass` and `density` in a link, `gravity`, `spring`, `damper`, `load` | [`forces`](language::forces) |
/// | `effects { velocity; acceleration; force; dynamics; … }` | [`forces`](language::forces) |
/// | `effects { trace …; overlay; … }` | [`pictures`](language::pictures) |
/// | `effects { sensitivity; }` | [`params`](language::params) |
///
/// # Errors
///
/// The compiler checks names, kinds of axes and numbers. It checks that everything is connected to the ground, and that the motors take
/// exactly the freedom that the joints leave. It checks that the loops can be solved one after the other, and that the mechanism
/// assembles in one way only.
///
/// Every error stands at its cause. A repair is offered only if it was tried and takes the error away; another error may be left. A mechanism
/// with errors still yields the struct and its methods, so that other code compiles. What stands in a statement that cannot be read has none.
/// `docs/diagnoses.md` in the repository lists what can be wrong with a mechanism. Errors of the text itself, as unknown names, are not listed.
#[macro_export]
macro_rules! mechanism {
    ($($body:tt)*) => {
        $crate::expand_mechanism! { $crate; $($body)* }
    };
}
