//! What differs from one processor to another: how instructions and bytes of stack are counted.

#[cfg(target_arch = "arm")]
mod cortex_m;
#[cfg(target_arch = "riscv32")]
mod riscv;

#[cfg(target_arch = "arm")]
pub(crate) use cortex_m::{Clock, stack_of};
#[cfg(target_arch = "riscv32")]
pub(crate) use riscv::{Clock, stack_of};
