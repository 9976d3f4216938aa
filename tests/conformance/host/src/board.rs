//! The processors that firmware is run on.

/// A processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Board {
    /// With floats of 32 bits.
    CortexM4F,
    /// Without floats. What is built for it runs on an emulated Cortex-M3, which knows all its instructions.
    CortexM0,
}

impl Board {
    /// All of them.
    pub(crate) const ALL: [Self; 2] = [Self::CortexM4F, Self::CortexM0];

    /// What rustc calls it.
    pub(crate) const fn target(self) -> &'static str {
        match self {
            Self::CortexM4F => "thumbv7em-none-eabihf",
            Self::CortexM0 => "thumbv6m-none-eabi",
        }
    }

    /// What people call it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::CortexM4F => "Cortex-M4F",
            Self::CortexM0 => "Cortex-M0+",
        }
    }
}
