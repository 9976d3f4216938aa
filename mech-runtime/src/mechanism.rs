//! What every mechanism can do, for code that takes any.

use crate::{Blocked, Canvas, Cost, JointInfo, Pose, Reached, Scalar, Shape, Values, View};
use core::fmt::Debug;

/// A mechanism made by [`mechanism!`](crate::mechanism).
///
/// Its struct has most of these as inherent items too: all but [`NAME`](Self::NAME), [`MOTORS`](Self::MOTORS), [`LINKS`](Self::LINKS),
/// [`SHAPES`](Self::SHAPES) and [`view`](Self::view), for which the trait has to be in scope.
pub trait Mechanism: Clone {
    /// `f32` or `f64`.
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
    /// Mobility, trunk and arms, and the loops in the order in which they are solved.
    const REPORT: &'static str;
    /// How many operations it takes to find a position.
    const COST: Cost;
    /// How many of them each loop takes, in the order in which they are solved.
    const LOOP_COSTS: &'static [Cost];
    /// The names of the joints that have a motor, in the order of their declaration.
    const MOTORS: &'static [&'static str];
    /// The names of the moving links whose poses are kept, in the order of their declaration: without a `show` of all.
    const LINKS: &'static [&'static str];
    /// The joints, in the order of their declaration: what they are and where.
    const JOINTS: &'static [JointInfo<Self::Scalar>];
    /// Everything that is seen, from the plane farthest from the eye to the nearest.
    const SHAPES: &'static [Shape<Self::Scalar>];

    /// The smallest upright box around all that is seen, wherever its motors move it: lower left and upper right corner, in scene
    /// units. Found at compile time by moving the mechanism: each motor alone through its range or through whole turns, all of them to
    /// some hundred combinations, and from the outermost positions on outwards. A motor that slides without a range is moved by four
    /// sizes of the mechanism. What is seen are its shapes; of a mechanism without any, its joints and points.
    const EXTENT: [[Self::Scalar; 2]; 2];

    /// The mechanism as it was assembled at compile time.
    #[must_use]
    fn new() -> Self;

    /// The present values of the motors, in radians or scene units.
    fn motors(&self) -> Self::Motors;

    /// The coordinates of all joints, in the order of [`JOINTS`](Self::JOINTS), in radians or scene units. None of joints that have
    /// none or are not shown: those without a [`coordinate`](JointInfo::coordinate), which tells what the others are.
    fn joints(&self) -> Self::Joints;

    /// Gives the motors these values, in radians or scene units, and moves everything accordingly.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite or a loop cannot be closed on the way there; the mechanism then stays where it
    /// was.
    fn move_to(&mut self, motors: Self::Motors) -> Result<(), Blocked<Self::Motors>>;

    /// Moves towards these values of the motors, in radians or scene units, on the straight way from the present ones, as far as
    /// it can.
    ///
    /// # Errors
    /// [`Blocked`] if a value is not finite; the mechanism then stays where it was.
    fn move_toward(
        &mut self,
        motors: Self::Motors,
    ) -> Result<Reached<Self::Motors>, Blocked<Self::Motors>>;

    /// The poses of the moving links in the scene, in the order of [`LINKS`](Self::LINKS).
    fn poses(&self) -> &[Pose<Self::Scalar>];

    /// The view in which all of its motion fits into a picture of this size, with a margin of a 24th of the shorter side.
    #[must_use]
    fn view(width: usize, height: usize) -> View {
        let [low, high] = Self::EXTENT.map(|corner| corner.map(crate::Real::to_f64));
        #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
        let margin = width.min(height) as f64 / 24.0;
        View::fit(low, high, width, height, margin)
    }

    /// Paints every shape, from the plane farthest from the eye to the nearest.
    fn draw(&self, canvas: &mut impl Canvas<Self::Scalar>) {
        crate::generated::paint(Self::SHAPES, self.poses(), canvas);
    }
}
