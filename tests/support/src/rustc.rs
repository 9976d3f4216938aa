//! Crates beside the tests, compiled against the runtime that the tests were built with.

use std::fs;
use std::path::Path;
use std::process::Command;

/// A call of the compiler that knows `mech_runtime`, and leaves what it makes in this folder.
///
/// # Panics
/// If the folder cannot be made, or the runtime is not beside this executable.
#[must_use]
pub fn rustc(out: &Path) -> Command {
    fs::create_dir_all(out).expect("a folder");
    let this = std::env::current_exe().expect("the path of this executable");
    let folder = this.parent().expect("its folder");
    let built = |path: &Path| path.metadata().and_then(|file| file.modified());
    let linked = built(&this).expect("its time");
    let files = fs::read_dir(folder).expect("the folder of libraries");
    // Other builds leave their runtimes there too. This one was built before this executable, which is linked with it.
    let runtime = files
        .filter_map(|file| {
            let path = file.ok()?.path();
            let is_runtime = path.file_stem()?.to_str()?.starts_with("libmech_runtime-");
            let is_library = path.extension().is_some_and(|end| end == "rlib");
            let time = built(&path).ok()?;
            (is_runtime && is_library && time <= linked).then_some((time, path))
        })
        .max();
    let (_, library) = runtime.expect("the runtime was built");
    let mut command = Command::new("rustc");
    command
        .args(["--edition", "2024", "--extern"])
        .arg(format!("mech_runtime={}", library.display()))
        .arg("-L")
        .arg(format!("dependency={}", folder.display()))
        .arg("--out-dir")
        .arg(out);
    command
}
