//! The machine that measures.

use std::num::NonZero;
use std::{env, fs, thread};

/// The name of the machine.
pub(crate) fn description() -> String {
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    let (arch, system) = (env::consts::ARCH, env::consts::OS);
    let name = name().map(|name| format!("{name}, ")).unwrap_or_default();
    let processors = match processors {
        1 => "1 processor".to_owned(),
        more => format!("{more} processors"),
    };
    format!("{name}{processors}, {arch}, {system}")
}

/// The processor's name, where the system has it in a file.
fn name() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
