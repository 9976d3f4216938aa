//! A Cortex-M.

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// Counts instructions, on an emulator in which each takes a nanosecond (QEMU with `-icount shift=0`): by the system timer.
pub(crate) struct Clock(SYST);

impl Clock {
    /// Nanoseconds to a tick of the system timer, which the board clocks with 25 MHz.
    const TICK: u32 = 40;
    /// The timer has 24 bits.
    const REACH: u32 = 0x00ff_ffff;

    /// The clock, once.
    pub(crate) fn take() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(Self::REACH);
        timer.clear_current();
        timer.enable_counter();
        Some(Self(timer))
    }

    /// How many instructions this takes: at most 6.7e8, and to within 40.
    pub(crate) fn instructions(&mut self, work: impl FnOnce()) -> u32 {
        self.0.clear_current();
        let start = SYST::get_current();
        work();
        let ticks = start.wrapping_sub(SYST::get_current()) & Self::REACH;
        ticks * Self::TICK
    }
}

/// How many bytes of stack this takes.
pub(crate) fn stack_of(work: impl FnOnce()) -> u32 {
    cortex_m_stack::repaint_stack();
    let before = cortex_m_stack::current_stack_free();
    work();
    before.saturating_sub(cortex_m_stack::stack_painted())
}
