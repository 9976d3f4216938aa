//! Programs that use the macro, each a crate of its own: they compile and run.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, thread};

#[test]
fn programs_compile_and_run() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("programs");
    let files = fs::read_dir(folder).expect("programs");
    let programs: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let wrong = thread::scope(|scope| {
        let parts = programs.chunks(programs.len().div_ceil(threads));
        let parts: Vec<_> = parts
            .map(|part| {
                scope.spawn(|| part.iter().filter_map(|program| run(program).err()).collect())
            })
            .collect();
        let wrong = parts.into_iter().map(|part| part.join().expect("no panic"));
        wrong.collect::<Vec<Vec<String>>>().concat()
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Compiles and runs a program: what is wrong with it.
fn run(program: &Path) -> Result<(), String> {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("programs");
    let mut rustc = mech_test_support::rustc(&out);
    let compiled = rustc.arg(program).output().expect("the compiler runs");
    if !compiled.status.success() {
        return Err(String::from_utf8_lossy(&compiled.stderr).into_owned());
    }
    let made = out.join(program.file_stem().expect("a name"));
    match Command::new(made).status() {
        Ok(status) if status.success() => Ok(()),
        other => Err(format!("{}: {other:?}", program.display())),
    }
}
