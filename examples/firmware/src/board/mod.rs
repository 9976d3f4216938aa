//! What differs from one processor to another: where a program begins, a clock, and the stack.

#[cfg(target_arch = "arm")]
mod cortex_m;
#[cfg(target_arch = "riscv32")]
mod riscv;

#[cfg(target_arch = "arm")]
pub use cortex_m::entry;
#[cfg(target_arch = "arm")]
pub(crate) use cortex_m::{Clock, stack_of};
#[cfg(target_arch = "riscv32")]
pub use riscv::entry;
#[cfg(target_arch = "riscv32")]
pub(crate) use riscv::{Clock, stack_of};

/// Ends the program: with a failure if it did not do what it should.
pub fn exit(done: bool) -> ! {
    semihosting::process::exit(if done { 0 } else { 1 })
}
