//! The trait of all mechanisms.

use crate::{Blocked, Canvas, Cost, JointInfo, Pose, Reached, Scalar, Shape, Values, View};
use core::fmt::Debug;

/// A mechanism made by [`mechanism!`](crate::mechanism).
///
/// The struct has these as inherent items too, except [`NAME`](Self::NAME), [`MOTORS`](Self::MOTORS), [`LINKS`](Self::LINKS),
/// [`SHAPES`](Self::SHAPES) and [`view`](Self::view). Code that uses those must import the trait.
pub trait Mechanism: Clone {
    /// The type of all numbers: `f32` or `f64`.
    type Scalar: Scalar;
    /// One value for each motor, in the order of their declaration: `[Self::Scalar; n]`.
    type Motors: Copy
        + Debug
        + PartialEq
        + AsRef<[Self::Scalar]>
        + AsMut<[Self::Scalar]>
        + Values<Number = Self::Scalar>;
    /// The coordinates of all joints, in the order of [`JOINTS`](Self::JOINTS): `[Option<Self::Scalar>; n]`.
    type Joints: Copy + Debug + PartialEq + AsRef<[Option<Self::Scalar>]>;

    /// The name of the struct.
    const NAME: &'static str;
    /// A report: mobility, trunk and arms, and the loops in the order in which they are solved.
    const REPORT: &'static str;
    /// The number of operations that a position takes.
    const COST: Cost;
    /// The number of operations of each loop, in the order in which the loops are solved.
    const LOOP_COSTS: &'static [Cost];
    /// The names of the joints that have a motor, in the order of their declaration.
    const MOTORS: &'static [&'static str];
    /// The names of the moving links that have poses, in the order of their declaration. Without `show`, all of them.
    const LINKS: &'static [&'static str];
    /// The joints, in the order of their declaration.
    const JOINTS: &'static [JointInfo<Self::Scalar>];
    /// The shapes, from the farthest plane to the nearest. What depends on params is as at the start; [`draw`](Self::draw) paints it as it
    /// is.
    const SHAPES: &'static [Shape<Self::Scalar>];

    /// The upright box around the shapes throughout the motion: lower left and upper right corner, in scene units. Without shapes, the
    /// box around joints and points.
    ///
    /// It holds everything that is painted wherever the motors go within their ranges. A motor that turns without a range makes all turns. What
    /// moves on with every turn, as a rack does, is followed for one turn either way. Behind gears it is followed for as many as they take until
    /// all wheels stand as before. A motor that slides without a range goes as far as loops let it, at most four sizes of the mechanism either
    /// way. Params are as at the start, and paths of traced points are seen.
    ///
    /// The compiler proves how far links reach at most, by their lengths and ranges, and moves the mechanism within a budget. The box is a proof
    /// where these two meet, as for open chains. Where one motor moves loops, it is what was seen, and what parabolas tell between positions.
    /// Where several do, links are taken outwards by all of them together, but not all positions are tried. Then it is what is proved, if that
    /// is not much wider. Else it is wider than what was seen, by a part of each link's motion. That is a 25th for arms, a tenth where loops
    /// move freely, a fifth where motors block each other. Of random mechanisms one to three in a hundred still come out of it. Mostly a loop
    /// there goes back from a dead point on its other side. Some things nothing bounds, as they fly off where slides come to lie along each
    /// other. They are held as far as 32 sizes of the mechanism beyond the start.
    const EXTENT: [[Self::Scalar; 2]; 2];

    /// The mechanism as assembled at compile time.
    #[must_use]
    fn new() -> Self;

    /// The present values of the motors, in radians or scene units.
    fn motors(&self) -> Self::Motors;

    /// The coordinates of all joints, in the order of [`JOINTS`](Self::JOINTS), in radians or scene units. `None` for a joint without a
    /// [`coordinate`](JointInfo::coordinate).
    fn joints(&self) -> Self::Joints;

    /// Moves the motors to these values, in radians or scene units, and all links with them.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite, a loop does not close during the move, or the move would need more than 65,536 parts. The mechanism
    /// then stays where it was.
    fn move_to(&mut self, motors: Self::Motors) -> Result<(), Blocked<Self::Motors>>;

    /// Moves the motors straight towards these values, in radians or scene units, as far as possible.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite. The mechanism then stays where it was.
    fn move_toward(
        &mut self,
        motors: Self::Motors,
    ) -> Result<Reached<Self::Motors>, Blocked<Self::Motors>>;

    /// The poses of the moving links in the scene, in the order of [`LINKS`](Self::LINKS).
    fn poses(&self) -> &[Pose<Self::Scalar>];

    /// The view that fits the whole motion into a picture of this width and height in pixels. Its margin is a 24th of the shorter side.
    #[must_use]
    fn view(width: usize, height: usize) -> View {
        let [low, high] = Self::EXTENT.map(|corner| corner.map(crate::Real::to_f64));
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
        let margin = width.min(height) as f64 / 24.0;
        View::fit(low, high, width, height, margin)
    }

    /// Paints all shapes, from the farthest plane to the nearest.
    fn draw(&self, canvas: &mut impl Canvas<Self::Scalar>) {
        crate::generated::paint(Self::SHAPES, self.poses(), canvas);
    }
}

/// The error of the mechanism `X`: `Blocked` with the values of all its motors. Stable Rust has no `X::Blocked`.
///
/// ```
/// use mech_runtime::{BlockedOf, mechanism};
///
/// mechanism! {
///     struct Lift;
///     link arm;
///     link cart;
///     joint a = revolute(ground, arm) at (0, 0);
///     joint x = prismatic(arm, cart) at (1, 0) along (1, 0);
///     motor a in 0 deg ..= 90 deg;
///     motor x;
/// }
///
/// fn raise(lift: &mut Lift) -> Result<(), BlockedOf<Lift>> {
///     lift.move_to([2.0, 0.5])
/// }
///
/// let blocked = raise(&mut Lift::new()).unwrap_err();
/// assert_eq!(blocked.at(), mech_runtime::Place::Motor("a"));
/// assert!(blocked.to_string().starts_with("the value for `a` is outside its range"));
/// ```
pub type BlockedOf<X> = Blocked<<X as Mechanism>::Motors>;
