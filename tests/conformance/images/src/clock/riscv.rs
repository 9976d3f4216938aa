//! A RISC-V.

use riscv::register::minstret;

/// Counts instructions.
pub(crate) struct Clock;

impl Clock {
    /// The clock.
    pub(crate) fn take() -> Option<Self> {
        Some(Self)
    }

    /// How many instructions this takes.
    pub(crate) fn instructions(&mut self, work: impl FnOnce()) -> u32 {
        let start = minstret::read();
        work();
        (minstret::read().wrapping_sub(start)) as u32
    }
}

/// How many bytes of stack this takes: nobody paints it here.
pub(crate) fn stack_of(work: impl FnOnce()) -> u32 {
    work();
    0
}
