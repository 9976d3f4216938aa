//! What the compiler says about mechanisms, bad ones and good ones. After a wording was changed on purpose:
//! `UPDATE_UI=1 cargo test -p mech-tests --test compiler ui`, and read it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs, thread};

/// Holds each case of a folder to something, on all processors: what is wrong with which.
fn check(folder: &str, wrong: fn(&Path) -> Result<(), String>) {
    let files = fs::read_dir(
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("ui")
            .join(folder),
    );
    let paths = files
        .expect("cases")
        .map(|file| file.expect("a case").path());
    let cases: Vec<PathBuf> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "rs"))
        .collect();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let all = thread::scope(|scope| {
        let parts = cases.chunks(cases.len().div_ceil(threads));
        let parts: Vec<_> = parts
            .map(|part| {
                scope.spawn(move || {
                    part.iter()
                        .map(|case| (case, wrong(case)))
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        parts
            .into_iter()
            .flat_map(|part| part.join().expect("no panic"))
            .collect::<Vec<_>>()
    });
    let failures: String = all
        .into_iter()
        .filter_map(|(case, result)| Some(format!("{}: {}\n", case.display(), result.err()?)))
        .collect();
    assert!(failures.is_empty(), "{failures}");
}

/// Compiles a case; gives the folder of what was made, and what was said.
fn compile(case: &Path, arguments: &[&str]) -> (PathBuf, Output) {
    let folder = case.parent().expect("a folder");
    let name = folder.file_name().expect("a name");
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ui").join(name);
    let mut rustc = mech_tests::rustc(&out);
    rustc.current_dir(folder.parent().expect("its folder"));
    rustc
        .args(arguments)
        .args(["--crate-type", "bin", "--diagnostic-width", "140"]);
    let path = Path::new(name).join(case.file_name().expect("a name"));
    (out, rustc.arg(path).output().expect("the compiler runs"))
}

/// The messages without the compiler's closing words.
fn messages(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr);
    let closing = [
        "error: aborting due to",
        "For more information about",
        "Some errors have detailed",
    ];
    let is_closing = |line: &&str| closing.iter().any(|words| line.starts_with(words));
    let lines = text
        .lines()
        .take_while(|line| !is_closing(line))
        .map(str::trim_end);
    lines.collect::<Vec<_>>().join("\n").trim_end().to_owned() + "\n"
}

#[test]
fn mechanisms_that_do_not_compile() {
    check("fail", |case| {
        let (_, output) = compile(case, &["--emit", "metadata"]);
        let (path, found) = (case.with_extension("stderr"), messages(&output));
        if output.status.success() {
            return Err("it compiles".to_owned());
        }
        if env::var_os("UPDATE_UI").is_some() {
            fs::write(&path, &found).expect("a file");
        }
        match fs::read_to_string(&path) {
            Ok(expected) if expected == found => Ok(()),
            _ => Err(format!("other messages:\n{found}")),
        }
    });
}

#[test]
fn mechanisms_that_compile() {
    check("pass", |case| {
        let (out, output) = compile(case, &["--emit", "link"]);
        if !output.status.success() {
            return Err(messages(&output));
        }
        let program = out.join(case.file_stem().expect("a name"));
        match Command::new(program).status() {
            Ok(status) if status.success() => Ok(()),
            other => Err(format!("{other:?}")),
        }
    });
}
