//! Tells the linker where flash and RAM are.

use std::env;
use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let out = env::var("OUT_DIR")?;
    let map = match env::var("CARGO_CFG_TARGET_ARCH")?.as_str() {
        "riscv32" => "memory-riscv.x",
        _ => "memory-cortex-m.x",
    };
    fs::copy(map, Path::new(&out).join("memory.x"))?;
    println!("cargo::rerun-if-changed={map}");
    println!("cargo::rustc-link-search={out}");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    Ok(())
}
