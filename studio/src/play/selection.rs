//! The choice of the driven motors.

/// The motors that are driven in playing, and that may be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selection {
    /// All motors, in the mechanism's own motion.
    Motion,
    /// One motor alone, by its number.
    Motor(usize),
}

impl Selection {
    /// The next choice for a mechanism with so many motors. A single motor also has two choices: alone it turns on and on.
    #[must_use]
    pub const fn next(self, motors: usize) -> Self {
        match self {
            Self::Motion => Self::at(0, motors),
            Self::Motor(motor) => Self::at(motor + 1, motors),
        }
    }

    /// The previous choice.
    #[must_use]
    pub const fn previous(self, motors: usize) -> Self {
        match self {
            Self::Motion if motors > 0 => Self::Motor(motors - 1),
            Self::Motion | Self::Motor(0) => Self::Motion,
            Self::Motor(motor) => Self::Motor(motor - 1),
        }
    }

    const fn at(motor: usize, motors: usize) -> Self {
        if motor < motors {
            Self::Motor(motor)
        } else {
            Self::Motion
        }
    }
}
