//! Tells the linker to lay out the images as a board wants them: `mech-firmware` says where flash and RAM are.

fn main() {
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
}
