//! Numbers that cannot be mixed up.

use crate::bug::bug;

/// A place in a list, or a count, in 32 bits: 2^32 entries would not fit into the source that declares them.
pub(crate) fn in_32_bits(number: usize) -> u32 {
    u32::try_from(number).unwrap_or_else(|_| bug!("{number} has more than 32 bits"))
}

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub struct $name(u32);

        impl $name {
            /// The id of the `index`-th in its list.
            #[must_use]
            pub fn new(index: usize) -> Self {
                Self(in_32_bits(index))
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
id! {
    /// An input of a mechanism: a motor's value, by the number of the motor, or a param's. Params come after all motors.
    InputId
}

impl LinkId {
    /// The fixed link, which every mechanism has.
    pub const GROUND: Self = Self(0);
}

impl InputId {
    /// The input of a motor.
    #[must_use]
    pub fn of_motor(motor: MotorId) -> Self {
        Self(motor.0)
    }

    /// The input of a param of a mechanism with so many motors.
    #[must_use]
    pub fn of_param(param: ParamId, motors: usize) -> Self {
        Self::new(motors + param.index())
    }

    /// The motor that this input is, in a mechanism with so many motors; none if it is a param.
    #[must_use]
    pub fn motor(self, motors: usize) -> Option<MotorId> {
        (self.index() < motors).then_some(MotorId(self.0))
    }
}

/// Where something was declared: an opaque number that whoever made the model can map back to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Origin(pub u32);
