//! Numbers that cannot be mixed up.

use crate::bug::bug;
macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            /// The id of the `index`-th in its list.
            #[must_use]
            pub fn new(index: usize) -> Self {
                // A list of 2^32 entries would not have fitted into the source that declares it.
                Self(u32::try_from(index).unwrap_or_else(|_| bug!("id {index} has more than 32 bits")))
            }

            /// The position in its list.
            #[must_use]
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id! {
    /// A link of a [`Model`](super::Model).
    LinkId
}
id! {
    /// An axis of a [`Model`](super::Model).
    AxisId
}
id! {
    /// A joint of a [`Model`](super::Model).
    JointId
}
id! {
    /// A motor of a [`Model`](super::Model).
    MotorId
}
id! {
    /// A law of a [`Model`](super::Model).
    LawId
}
id! {
    /// A param of a [`Model`](super::Model).
    ParamId
}
id! {
    /// A formula of a [`Model`](super::Model).
    FormulaId
}

impl LinkId {
    /// The fixed link, which every mechanism has.
    pub const GROUND: Self = Self(0);
}

/// Where something was declared: an opaque number that whoever made the model can map back to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Origin(pub u32);
