//! Runs the command.

use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::{env, fs};

/// The answer of a command.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Answer {
    /// The answer of a command that has done what it was told.
    #[track_caller]
    pub(crate) fn done(self) -> String {
        assert_eq!((self.code, &*self.err), (Some(0), ""));
        self.out
    }

    /// Returns the complaint of a command that ended with this code, and answered nothing.
    #[track_caller]
    pub(crate) fn refused(self, code: i32) -> String {
        assert_eq!((self.code, &*self.out), (Some(code), ""), "{}", self.err);
        self.err
    }
}

/// Runs the command in a folder.
pub(crate) fn mech_in(folder: &Path, words: &[impl AsRef<OsStr>]) -> Answer {
    mech_said(folder, words, "")
}

/// Begins the command in a folder; it waits for its input.
pub(crate) fn begin(folder: &Path, words: &[impl AsRef<OsStr>]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
    command.current_dir(folder).args(words).stdin(Stdio::piped());
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the command runs")
}

/// Runs the command in a folder, with an input.
pub(crate) fn mech_said(folder: &Path, words: &[impl AsRef<OsStr>], input: &str) -> Answer {
    let mut child = begin(folder, words);
    let mut listener = child.stdin.take().expect("an input");
    // Some read no input, or not all of it.
    let _ = listener.write_all(input.as_bytes());
    drop(listener);
    let output = child.wait_with_output().expect("it ends");
    Answer {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).expect("UTF-8"),
        err: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

/// A folder of a test's own, that is empty.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = Path::new(env!("CARGO_TARGET_TMPDIR"));
        let path = path.join(format!("mech-{}-{number}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    pub(crate) fn with(self, name: &str, text: impl AsRef<[u8]>) -> Self {
        fs::write(self.0.join(name), text).expect("a file");
        self
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).expect("a text")
    }

    /// The names of all files in it.
    pub(crate) fn names(&self) -> Vec<String> {
        let files = fs::read_dir(&self.0).expect("a folder");
        let name = |file: std::io::Result<fs::DirEntry>| {
            let name = file.expect("a file").file_name();
            name.into_string().expect("UTF-8")
        };
        let mut names: Vec<String> = files.map(name).collect();
        names.sort();
        names
    }

    pub(crate) fn mech(&self, words: &str) -> Answer {
        let words: Vec<&str> = words.split_whitespace().collect();
        mech_in(&self.0, &words)
    }

    /// The rows of a table that a command makes there.
    #[track_caller]
    pub(crate) fn rows(&self, words: &str) -> Vec<Vec<f64>> {
        numbers(&self.mech(words).done())
    }
}

/// The cells of a table without its head, as numbers.
pub(crate) fn numbers(table: &str) -> Vec<Vec<f64>> {
    let rows = table.lines().skip(1);
    let cell = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    rows.map(|row| row.split(',').map(cell).collect()).collect()
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// Mechanisms that are refused: texts, and Rust that the tests of the macro hold to the same messages. A folder, and paths within it.
pub(crate) fn refused() -> [(PathBuf, Vec<PathBuf>); 2] {
    [("tests/cases", Some("refused")), ("tests/ui", None)].map(|(root, only)| {
        let root = repository(root);
        let entries = |folder: &Path| {
            let entries = fs::read_dir(folder).expect("a folder");
            entries.map(|entry| entry.expect("an entry").path())
        };
        // Other folders beside it hold texts for other tests.
        let is_meant = |path: &PathBuf| only.is_none_or(|name| path.ends_with(name));
        let folders = entries(&root).filter(|path| path.is_dir() && is_meant(path));
        let mut cases: Vec<PathBuf> = folders
            .flat_map(|folder| entries(&folder).collect::<Vec<_>>())
            .filter(|path| path.extension().is_some_and(|end| end != "stderr"))
            .collect();
        cases.sort();
        (root, cases)
    })
}

pub(crate) const FOUR_BAR: &str = "struct FourBar;
link crank; link coupler { point tip = (2.5, 3); } link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, coupler) at (0.8, 0.6);
joint c = revolute(coupler, rocker) at (3.3, 2.9);
joint d = revolute(ground, rocker) at (4, 0);
motor a;
";

/// The same in Rust, with a second mechanism that lacks a motor.
pub(crate) fn rust() -> String {
    let loose = FOUR_BAR.replace("FourBar", "Loose").replace("motor a;", "");
    format!("fn ( broken\nmech_runtime::mechanism! {{ {FOUR_BAR} }}\nmechanism! {{ {loose} }}\n")
}
