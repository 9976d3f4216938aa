//! **If it compiles, it moves.** Planar mechanisms, declared in Rust source, analysed at compile time, solved loop by
//! loop in straight-line `no_std` code.
//!
//! Everything begins with [`mechanism!`], whose documentation describes the language. It makes a struct; what a struct can
//! do is also in the trait [`Mechanism`], for code that takes any. [`raster`] paints it.
//!
//! The crate is `no_std`, needs no allocator and has no `unsafe` code. Large pictures are for the heap, with feature `std`: [`raster`]
//! says what pictures take. Angles are in radians, lengths in scene units, y points up.
#![cfg_attr(doctest, doc = include_str!("../../README.md"))]
#![no_std]

#[cfg(feature = "std")]
extern crate std;

// The derive-like macro of this crate is called by path from the code it generates, here in our own tests too.
extern crate self as mech_runtime;

mod blocked;
mod columns;
mod cost;
#[cfg(feature = "std")]
pub mod files;
mod force;
mod gauss_legendre;
#[doc(hidden)]
pub mod generated;
mod joint;
mod mechanism;
pub mod overlay;
mod pose;
mod range;
pub mod raster;
mod rate;
mod scalar;
mod shape;
mod trace;

pub use blocked::{Blocked, BlockedOf, Cause, Place, Reached, Values};
pub use columns::{BlockedAt, Columns};
pub use cost::Cost;
pub use force::{Forces, Reaction};
pub use gauss_legendre::GaussLegendre;
pub use joint::{Anchor, Coordinate, JointInfo, JointKind};
pub use mech_core::{Phase, Real};
pub use mechanism::Mechanism;
pub use nalgebra::{Isometry2, Point2, Vector2};
pub use overlay::Overlay;
pub use pose::Pose;
pub use range::InRange;
pub use raster::{Canvas, Frame, Palette, Smooth, Stage, View};
#[cfg(feature = "std")]
pub use raster::{HeapFrame, HeapSmooth, HeapStage};
pub use rate::{Acceleration, Velocity};
pub use scalar::Scalar;
pub use shape::{Outline, Shape};
pub use trace::Trace;

#[doc(hidden)]
pub use mech_macros::mechanism as expand_mechanism;

/// Declares a planar mechanism: a struct that moves, or a compile error that says what to change.
///
/// ```
/// use mech_runtime::mechanism;
///
/// mechanism! {
///     /// A piston driven through a pair of gears.
///     pub struct GearedPiston: f64;               // f32 or f64; f64 if left out
///
///     const THROW = 1.0;                          // numbers: + - * / ( ), PI, functions such as sqrt, `deg`
///
///     ground {
///         point pinion_shaft = (-3.0, 0.0);       // an axis of rotation: origin, and a direction if wanted: -> (1, 0)
///         point wheel_shaft = (0.0, 0.0);
///         line bore = (0.0, 0.0) -> (1.0, 0.0);   // an axis of sliding
///         polygon [(4.0, 0.6), (8.0, 0.6), (8.0, 0.8), (4.0, 0.8)] on plane 0 color 1;
///     }
///     link pinion { point shaft = (0.0, 0.0); circle (0.0, 0.0) radius 1.0 on plane 2 color 3; }
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
///     start { d = 0 deg; rod near 0 deg; }        // where it is assembled; `near` picks one of several ways
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
/// # Two ways to declare
///
/// Links may be given in frames of their own, with named axes, as above; joints make axes coincide, and where that leaves
/// several assemblies, `near` says which one is meant. Or a mechanism is declared as in a drawing: links without axes, and
/// joints placed in the scene. The frame of such a link is the scene's at the start, its points and shapes are given in
/// scene coordinates, and the coordinate of every joint so placed is 0 at the start. One `at` suffices: from then on the link's own
/// points and lines are in scene coordinates, too, and the law of a cam whose follower is so placed is 0 at the start:
///
/// ```
/// mech_runtime::mechanism! {
///     struct SliderCrank;
///     link crank;
///     link rod;
///     link block;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (1, 0.5);
///     joint c = revolute(rod, block) at (4, 0);
///     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
///     motor a;
/// }
/// let mut slider_crank = SliderCrank::new();
/// assert!(slider_crank.move_to([0.5]).is_ok());
/// assert!(slider_crank.move_to([f64::NAN]).is_err()); // and it is still where it was
/// assert_eq!(slider_crank.motors(), [0.5]);
/// ```
///
/// # Joints
///
/// | joint | what it does |
/// |---|---|
/// | `revolute(a.point, b.point)` | two points coincide; the coordinate is the angle from the first's direction to the second's |
/// | `prismatic(a.line, b.line)` | two lines coincide; the coordinate is the way from the first's origin to the second's |
/// | `slot(a.point, b.line)` | a pin in a slot: it turns and slides; the coordinate is its way along the line |
/// | `weld(a, b)`, `weld(a.point, b.point)` | the two links are one: their frames coincide, or the points with their directions |
/// | `gear(a, b, 20 : 40)` | two wheels roll on each other: teeth, or pitch radii; `20 : -60` is internal |
/// | `belt(a, b, 1.0 : 3.0)` | the same with a belt: in the same sense |
/// | `rack(pinion, bar, radius 0.5)` | a wheel rolls on a bar: the bar's coordinate grows by the radius for each radian; a negative radius is a bar on the other side |
/// | `cam(shaft, follower, 0.2 * (1 - cos(q)))` | the coordinate of one joint is a law of that of another, `q`; both join something to one link |
///
/// The first four may be placed in the drawing: `slot(a, b) at (x, y) along (dx, dy)`, `weld(a, b) at (x, y)`. A direction may also be
/// an angle, counter-clockwise from the x axis: `along 30 deg`, `line slot = (0, 0) -> 30 deg;`. What rolls is
/// carried by the link in which both parts keep their place, directly or through a coaxial joint; where several links would do,
/// `on LINK` after the ratio or radius says which.
///
/// A cam takes joints, revolute or prismatic, and goes one way: its shaft has to be known, from a motor or by loops, before its
/// follower, which then may drive whatever it likes. Where the law is periodic, whole turns of the shaft do not matter at all; where
/// it goes on with them (`0.001 * q` is a screw) they count, an angle that loops have solved beginning between −π and π. Where the
/// law has no value a move is an error, [`Cause::Overflow`]. What laws are made of is said [below](#laws).
///
/// Motors count whole turns, and so do joints that motors turn by way of gears and belts. The coordinate of any other joint that turns is
/// between −π and π, unless it is asked to go on:
///
/// ```
/// mech_runtime::mechanism! {
///     struct DragLink;
///     link crank; link coupler; link rocker;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, coupler) at (0, 2);
///     joint c = revolute(coupler, rocker) at (2.4, 1.6);
///     joint d = revolute(ground, rocker) at (0.8, 0);
///     motor a;
///     continuous d;                               // `continuous b, d;` for several
/// }
/// let turn = core::f64::consts::TAU;
/// let mut drag_link = DragLink::new();
/// drag_link.move_to([3.0 * turn])?;
/// assert!((drag_link.d() - 3.0 * turn).abs() < 1e-12);
/// assert!(drag_link.b().abs() < 1e-12);           // not asked
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// It is exact however far a move goes: where the joint may turn by half a turn or more, the move is made in pieces. It takes a number of
/// memory, an arc tangent a move, and what the pieces take.
///
/// `allow redundant;` lets a mechanism pass that moves only because its lengths match exactly; `allow coupled;` solves loops
/// together that wait for each other.
///
/// # How it is computed, and how exactly
///
/// | statement | what it says |
/// |---|---|
/// | `method exact;` | each dyad in closed form, whatever has none by Newton's iteration; the default |
/// | `method linear;` | one linear step of each loop from the last position: the paper's |
/// | `method newton(2);`, `method newton;` | so many rounds of Newton's iteration, or until each loop closes to rounding; `newton(1) predictor(3)` starts from the differences of the motion |
/// | `accuracy 1e-6;` | the cheapest of these whose predicted error of any position, in scene units, is not greater |
/// | `cost cortex_m4f;` | whose operations are counted for that: `x86_64` if left out |
/// | `motor d in 0 deg ..= 90 deg by 1 deg;` | a range that is proved to be free, and the greatest step |
/// | `at change points keep branch;` | or `stop`, or `go on`, the default: velocities are continuous |
///
/// A loop that comes to dead points or change points in its motion is solved in closed form whatever was wished: an iteration fails
/// where its equations are singular. The report says how each loop is solved and what it costs; so do the constants `COST` and
/// `LOOP_COSTS`.
///
/// A move goes the straight way in the motors. What is in the way stops it: `move_to` returns [`Blocked`] with the motor values
/// up to which it could have gone and leaves everything where it was, `move_toward` goes there. Printed, the error names what stopped it,
/// and each motor with its value: `crank = 1.2 rad (68.755°)`. Its type is [`BlockedOf`] the struct. `turn_to` takes a [`Phase`] for each
/// motor, `turn_to([phase])`: exact after any number of turns. Where some motors slide it takes the phases of those that turn, and then
/// the values of the others: `turn_to([phase], [0.2])`. With declared ranges `range(values)` tests them, and `move_within` cannot fail:
///
/// ```
/// mech_runtime::mechanism! {
///     struct Wiper;
///     link crank; link rod; link arm;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (0, 0.5);
///     joint c = revolute(rod, arm) at (3, 1);
///     joint d = revolute(ground, arm) at (3, 0);
///     motor a in 0 deg ..= 360 deg;
/// }
/// let mut wiper = Wiper::new();
/// if let Some(values) = Wiper::range([2.0]) {
///     wiper.move_within(values); // no `Result`: it was proved
/// }
/// assert_eq!(wiper.motors(), [2.0]);
/// assert!(wiper.move_to([7.0]).is_err()); // beyond its range
/// ```
///
/// # Laws
///
/// A motor may follow a law, an expression in the time `t`, in whatever unit of time. Then `at_time(t)` moves it there; motors
/// without a law stay where they are. It starts where its law has it at the time 0. Laws are differentiated symbolically: with effects
/// `at_time` finds exact velocities and accelerations, as `move_with` does that is given the law's rates. The law does not bind
/// `move_to` and the others, which take any values. Where a law or its rate has no value (the root of a negative number, a
/// division by zero at that time) `at_time` is an error that names the motor, [`Cause::NotFinite`]. Laws are computed in double
/// precision also where the mechanism is not, with whole turns apart.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Shaker;
///     link crank; link rod; link block;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (1, 0.5);
///     joint c = revolute(rod, block) at (4, 0);
///     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
///     motor a = 0.3 * sin(2 * PI * t) + max(0, t - 1);
///     effects { acceleration; }
/// }
/// let mut shaker = Shaker::new();
/// shaker.at_time(0.25)?;
/// assert_eq!(shaker.a(), 0.3);
/// assert!(shaker.a_rate().abs() < 1e-12);             // it turns back there
/// assert!(shaker.a_acceleration() < -11.8);           // −0.3 (2π)²
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # Numbers
///
/// Constants, params and laws are made of `+ - * / ( )`, `PI`, other constants and params, `deg` after a number, and functions:
///
/// | function | its value | its slope |
/// |---|---|---|
/// | `sqrt(a)`, `exp(a)`, `abs(a)` | the root, e to a power, the absolute value | of `abs` at 0, that of the positive side |
/// | `sin(a)`, `cos(a)`, `tan(a)` | of an angle | |
/// | `asin(a)`, `acos(a)`, `atan(a)` | the angle: between −π/2 and π/2, of `acos` between 0 and π | of `asin` and `acos` at ±1, none |
/// | `atan2(y, x)` | the angle of a vector, between −π and π; `atan2(0, 0)` has none | where it jumps by a turn, that of its vector |
/// | `hypot(a, b)` | the root of `a * a + b * b` | at `hypot(0, 0)`, none |
/// | `min(a, b)`, `max(a, b)` | the lesser, the greater | that of whichever it is |
/// | `floor(a)`, `sign(a)` | the greatest whole number that is not greater; 1, 0 or −1 | 0, also where they jump |
/// | `mod(a, b)` | what is left of `a` beyond whole times `b`: `a - b * floor(a / b)` | that of `a`, less `floor(a / b)` times that of `b` |
///
/// What has no value at compile time, such as `asin(2)`, is an error there. At run time it stops the move.
///
/// A number has no type and no other unit. An angle without `deg` is in radians: a start of more than a turn in plain digits, such as
/// `60`, is an error. Constants of Rust outside of the mechanism are unknown to it; declare them inside by `const`.
///
/// # Shapes and pictures
///
/// | shape | what is seen |
/// |---|---|
/// | `circle (x, y) radius r` | a disc |
/// | `ring (x, y) radius r hole h` | a disc with a hole |
/// | `polygon [(x, y), ...]` | a polygon, by the even-odd rule |
/// | `bar [(x, y), ...] width w` | a link as textbooks draw it: a thick line with round ends and an eye at each pin |
///
/// Each is followed by `on plane n` and `color c`, which may be left out: plane 0, and a colour for each link. Planes are painted from
/// the least to the greatest. `draw` paints them on any [`Canvas`]: a [`Frame`], a [`Smooth`], a [`Stage`], a file. `EXTENT` is the box
/// that all of it needs for its whole motion, found at compile time; `picture()` gives an empty picture that looks at that, a `Frame`, or
/// with `quality smooth;` a `Smooth`, whose edges are anti-aliased. A large one would overflow the stack: `HeapFrame::of` and
/// `HeapSmooth::of` make the same on the heap, of a size told at run time (feature `std`).
///
/// ```
/// mech_runtime::mechanism! {
///     struct Rocker;
///     ground { point a = (0, 0); point d = (4, 0); ring (0, 0) radius 0.4 hole 0.25; }
///     link crank { point a = (0, 0); point b = (1, 0); bar [(0, 0), (1, 0)] width 0.4 on plane 2; }
///     link coupler { point b = (0, 0); point c = (3.5, 0); bar [(0, 0), (3.5, 0)] width 0.4 on plane 1; }
///     link rocker { point d = (0, 0); point c = (3, 0); bar [(0, 0), (3, 0)] width 0.4; }
///     joint a = revolute(ground.a, crank.a);
///     joint b = revolute(crank.b, coupler.b);
///     joint c = revolute(coupler.c, rocker.c);
///     joint d = revolute(ground.d, rocker.d);
///     motor a;
///     start { coupler near 50 deg; }
///     quality smooth;
/// }
/// let mut rocker = Rocker::new();
/// let mut picture = Rocker::picture::<200, 160>();
/// rocker.move_to([0.5])?;
/// rocker.draw(&mut picture);
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # What it is made of
///
/// `JOINTS` tells of each joint its name and kind, its links, where each of them has it, its motor, and what its coordinate is:
/// [`JointInfo`]. `joints()` gives all coordinates in the same order. Both are in the trait [`Mechanism`] too, so that a table or a plot
/// can take any mechanism; nothing of it costs anything where it is not used.
///
/// # Many positions
///
/// `solve_many` finds many positions at once, into [`Columns`].
///
/// # Only what is needed
///
/// `show` names the links, the points and the joints that are asked for; without it everything is. What they do not depend on is
/// not solved, not kept and not painted, and costs nothing:
///
/// ```
/// use mech_runtime::Mechanism;
///
/// mech_runtime::mechanism! {
///     struct Press;
///     link crank; link rod; link block;
///     link arm { point tip = (-2, 1); }
///     link lever;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (1, 0.5);
///     joint c = revolute(rod, block) at (4, 0);
///     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
///     joint d = revolute(crank, arm) at (0.5, 1);
///     joint e = revolute(arm, lever) at (-2, 1);
///     joint f = revolute(ground, lever) at (-2, -1);
///     motor a;
///     show block, c;                              // `arm.tip` would be shown by the method `arm_tip`
/// }
/// let mut press = Press::new();
/// press.move_to([0.5])?;
/// let (pose, angle) = (press.block(), press.c());
/// assert_eq!(Press::LINKS, ["rod", "block"]);     // what the angle at `c` takes is kept too
/// assert_eq!(Press::LOOP_COSTS.len(), 1);         // the loop of the lever is left out
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// A link comes with its points, its shapes and its method; a point or a joint is only a method. Everything is checked as before: the
/// whole mechanism has to be coherent and to be assembled. But a loop that is not solved cannot block a move: what is shown moves
/// on where the whole mechanism could not. Motors that nothing needs keep their place in `move_to`. [`Mechanism::LINKS`] tells which
/// links [`Mechanism::poses`] gives: besides those shown, those that tell where shown points and joints are, and those from whose
/// last pose an iteration begins.
///
/// # Effects
///
/// What is not asked for is not there: no field, no instruction, no method. With `effects { velocity; acceleration; }` (either, or
/// both; accelerations bring velocities with them) `move_with` takes the rates and second rates of the motors besides their
/// values, and the mechanism tells how everything moves: `crank_velocity()` of a link (a [`Velocity`]), `rod_small_end_velocity()`
/// of a named point, `h_rate()` of a joint, the same with `acceleration`; `influence_coefficients()` are the velocities for a rate of one of
/// each motor alone. They are exact: every loop's rates solve the linear system that its positions come from. At a dead point or a
/// change point, where they are not determined, `move_with` is an error, [`Cause::Singular`], not a large number. After a move
/// without rates the mechanism rests.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Crank;
///     ground { point o = (0, 0); }
///     link crank { point shaft = (0, 0); point pin = (2, 0); }
///     joint a = revolute(ground.o, crank.shaft);
///     motor a;
///     effects { velocity; acceleration; }
/// }
/// let mut crank = Crank::new();
/// crank.move_with([0.0], [3.0], [0.0])?; // its value, its rate, its second rate
/// assert_eq!(crank.crank_pin_velocity().y, 6.0);
/// assert_eq!(crank.crank_pin_acceleration().x, -18.0); // towards the shaft
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// ## Forces
///
/// A link has a mass if it is said: `mass 0.4 at (0.1, 0) inertia 2e-3;` (its centre in the link's frame, at its origin if left out;
/// the moment of inertia about that, zero if left out) or `density 7.8;`, mass a unit of area, by its shapes. What acts is declared
/// beside links and joints: `gravity (0, -9.81);`, `spring s = linear(a.p, b.q) stiffness 40 rest 0.5;` and `torsional(JOINT)`,
/// `damper d = … damping 0.1;`, and loads that are set at run time: `load push = force(rod.small_end);` and `load twist =
/// torque(crank);`. None of it costs anything by itself. A torsional spring follows its joint over any number of turns, as the joint's
/// coordinate then does, and may rest at any angle: `torsional(hinge) stiffness 2 rest 20`.
///
/// With `effects { force; }` there are `hold_at`, which moves as `move_to` does and gives the torques of the motors (the forces of
/// those that slide) that hold it there at rest, by virtual work; `torques()`, the same where it is; and `forces(rates, second rates)`:
/// what it takes to move in that way from where it is, by the equilibrium of each link, with the reaction in every joint ([`Forces`]) and
/// the transmission angles. `push_advantage(direction)` is the mechanical advantage over a load. Teeth push across the line of
/// centres, without a pressure angle; a belt only passes its torque on, since its pull hangs on how it was tensioned. Where joints hold
/// links more than once, reactions are not determined and `forces` is not there; the report says so.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Press;
///     ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); }
///     link crank { point shaft = (0, 0); point pin = (0.5, 0); }
///     link rod { point big = (0, 0); point small = (2, 0); }
///     link ram { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
///     joint turn = revolute(ground.shaft, crank.shaft);
///     joint big = revolute(crank.pin, rod.big);
///     joint small = revolute(rod.small, ram.pin);
///     joint bed = prismatic(ground.bed, ram.axis);
///     motor turn;
///     start { turn = 60 deg; rod near -10 deg; }
///     load work = force(ram.pin);
///     effects { force; }
/// }
/// let mut press = Press::new();
/// press.set_work([-100.0, 0.0])?;
/// let [torque] = press.hold_at([1.0])?;
/// let [advantage] = press.work_advantage([1.0, 0.0])?;
/// assert!((advantage * torque + 100.0).abs() < 1e-9);
/// let forces = press.forces([0.0], [0.0])?;        // rates and second rates of the motor
/// assert!((forces.torques[0] - torque).abs() < 1e-9);
/// assert_eq!(Press::JOINTS[2].name, "small");      // of which forces.reactions[2] tells
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// ## Motion under forces
///
/// With `effects { dynamics; }` the mechanism has rates, and `simulate(time, torques)` lets it move for a step of time under torques of
/// its motors, which may be zero, and everything that acts. `simulate_by` takes a method ([`GaussLegendre`]): what is more exact takes longer.
/// Each is symmetric in time, so that energy does not drift. `energy()` is kinetic and potential, `motor_accelerations(torques)` how the
/// motors are accelerated. A step that is blocked or too long is an error, and leaves everything as it was.
///
/// ```
/// mech_runtime::mechanism! {
///     struct Pendulum;
///     ground { point pivot = (0, 0); }
///     link bob { point pivot = (0, 0); mass 2 at (1.5, 0); }
///     joint swing = revolute(ground.pivot, bob.pivot);
///     motor swing;
///     gravity (0, -9.81);
///     effects { dynamics; }
/// }
/// let mut pendulum = Pendulum::new();
/// let before = pendulum.energy()?;
/// for _ in 0..1000 {
///     pendulum.simulate(0.01, [0.0])?;
/// }
/// let after = pendulum.energy()?;
/// assert!((after[0] + after[1] - before[0] - before[1]).abs() < 1e-6);
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// ## Traces
///
/// `trace LINK.POINT LENGTH;` keeps the last places of a named point, one for each move that succeeds, in the struct itself: a
/// [`Trace`], told by `rod_middle_trace()` and forgotten by `clear_traces()`. At the start it is empty. The point's link is solved
/// even if `show` leaves it out. `draw` paints it as a line of 1.5 pixels, behind all links; `on plane 1` says otherwise (in that plane
/// it lies above the ground and below the links), `color 5` chooses another colour than ink.
///
/// ```
/// mech_runtime::mechanism! {
///     struct SliderCrank;
///     link crank;
///     link rod { point middle = (2.5, 0.25); }
///     link block;
///     joint a = revolute(ground, crank) at (0, 0);
///     joint b = revolute(crank, rod) at (1, 0.5);
///     joint c = revolute(rod, block) at (4, 0);
///     joint x = prismatic(ground, block) at (4, 0) along (1, 0);
///     motor a;
///     effects { trace rod.middle 64; }
/// }
/// let mut slider_crank = SliderCrank::new();
/// for step in 0..100 {
///     slider_crank.move_to([f64::from(step) * 0.1])?;
/// }
/// assert_eq!(slider_crank.rod_middle_trace().len(), 64);
/// assert_eq!(slider_crank.rod_middle_trace().iter().next_back(), Some(slider_crank.rod_middle()));
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// ## Diagrams
///
/// `overlay;` adds `draw_overlay`, which draws what a textbook draws: joint symbols, motors, and if the [`Overlay`] wants it links as
/// bars with pitch circles, and axes. With `velocity` and `acceleration` there are `draw_velocities` and `draw_accelerations` too: an
/// arrow at every named point and every revolute joint that moves. All of it goes to any [`Canvas`], in sizes given in pixels; what lies
/// on links that `show` leaves out is left out. The symbols are listed in [`overlay`].
///
/// # Params
///
/// `param rod_length = 4.0;` is a number that can be changed at run time. These may depend on it, also through constants
/// (`const HALF = rod_length / 2;`): the places of points, lines and drawn joints; the directions of lines, also of drawn ones
/// (`along tilt`); shapes; and laws. Everything else (ratios, starts, masses, springs, colors) may not. A gear, belt or rack keeps its
/// ratio, so that it counts whole turns exactly; a cam may have a ratio in its law (`cam(first, second, -radius / 2 * q)`). A mechanism
/// with params has no declared ranges, because what is proved holds for one shape only. It is analysed and assembled with the values
/// that are declared.
///
/// `draw` paints shapes as the params have them; [`Mechanism::SHAPES`] and [`Mechanism::EXTENT`] are as at the start. A shape whose
/// length is no longer positive is not seen. Wheels stay in mesh where a param turns a slide.
///
/// Forces, motions under forces and laws go with params. What they tell is for the present values. A motor that follows a law stays
/// where it is when a param of its law is changed, until `at_time` moves it.
///
/// `rod_length()` tells it, `set_rod_length(value)` changes it, `params()` and `set_params([…])` all of them. The motors keep their
/// values, and everything is assembled anew by a continuous change: change points are passed and wheels roll on as in a move. What
/// does not close on the way is [`Blocked`], with the value up to which the param could have been changed, and leaves everything as
/// it was; so does what is not a number, such as the root of a length that became negative. Changes by more than about a thousand
/// times the size are to be made in steps ([`Cause::TooFar`]).
///
/// With `effects { sensitivity; }` the mechanism tells how everything follows the params where it is: `coupler_tip_sensitivity()` of
/// a named point gives for each param the rate of its place if that param alone changes, at a rate of one; so do
/// `coupler_sensitivity()` of a link and `d_sensitivity()` of the coordinate of a joint that no motor drives; `sensitivities()` are
/// those of all links. They are derivatives, exact to rounding. At a dead point or a change point they are not determined:
/// [`Cause::Singular`].
///
/// ```
/// mech_runtime::mechanism! {
///     struct FourBar;
///     param rod_length = 3.5;
///     ground { point a = (0, 0); point d = (4, 0); }
///     link crank { point a = (0, 0); point b = (1, 0); }
///     link rod { point b = (0, 0); point c = (rod_length, 0); point tip = (rod_length / 2, 1); }
///     link rocker { point d = (0, 0); point c = (3, 0); }
///     joint a = revolute(ground.a, crank.a);
///     joint b = revolute(crank.b, rod.b);
///     joint c = revolute(rod.c, rocker.c);
///     joint d = revolute(ground.d, rocker.d);
///     motor a;
///     start { rod near 50 deg; }
///     effects { sensitivity; }
/// }
/// let mut four_bar = FourBar::new();
/// four_bar.move_to([0.7])?;
/// let (tip, [slope]) = (four_bar.rod_tip(), four_bar.rod_tip_sensitivity()?);
/// four_bar.set_rod_length(3.5001).expect("it closes");
/// assert!((four_bar.rod_tip() - tip - slope * 0.0001).norm() < 1e-8);
/// assert!(four_bar.set_rod_length(0.1).is_err()); // too short to reach the rocker
/// assert_eq!(four_bar.rod_length(), 3.5001);      // and it is as it was
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// # What is checked
///
/// Names, kinds of axes and numbers; that everything is connected to the ground; that the motors take exactly the freedom
/// the joints leave (blocked, overdetermined, undetermined, too many motors); that the loops can be solved one after the
/// other; that it can be assembled, and in one way only. Every error stands at the place it is about, and repairs are
/// tried before they are offered. A mechanism with errors still yields the struct and its methods, so that nothing else
/// turns red. The catalogue of what can be found wrong is `docs/diagnoses.md` in the repository.
#[macro_export]
macro_rules! mechanism {
    ($($body:tt)*) => {
        $crate::expand_mechanism! { $crate; $($body)* }
    };
}
