//! The command `mech`.

use mech_studio::{Console, run};
use std::process::ExitCode;

fn main() -> ExitCode {
    run(std::env::args_os(), &mut Console::standard())
}
