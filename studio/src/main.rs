//! The command `mech`.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    mech_studio::run(std::env::args_os(), &mut mech_studio::Console::standard())
}

/// In a browser there is no command line: the package `mech-page` shows the window alone.
#[cfg(target_arch = "wasm32")]
fn main() {}
