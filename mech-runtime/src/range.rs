//! Motor values within the declared ranges.

use core::fmt;
use core::marker::PhantomData;

/// Motor values of the mechanism `M` that are within its declared ranges. The compiler has proved that the mechanism moves through these
/// ranges, so a move there cannot fail.
pub struct InRange<M, V> {
    motors: V,
    of: PhantomData<fn() -> M>,
}

impl<M, V: Copy> InRange<M, V> {
    #[doc(hidden)]
    #[must_use]
    pub const fn tested(motors: V) -> Self {
        Self { motors, of: PhantomData }
    }

    /// The values, in the order in which the motors were declared.
    #[must_use]
    pub const fn motors(self) -> V {
        self.motors
    }
}

impl<M, V: Copy> Clone for InRange<M, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M, V: Copy> Copy for InRange<M, V> {}

impl<M, V: PartialEq> PartialEq for InRange<M, V> {
    fn eq(&self, other: &Self) -> bool {
        self.motors == other.motors
    }
}

impl<M, V: fmt::Debug> fmt::Debug for InRange<M, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("InRange").field(&self.motors).finish()
    }
}
