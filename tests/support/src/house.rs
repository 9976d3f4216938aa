//! Crates in a workspace of their own, which cargo builds as a user has them; and crates beside the tests, which rustc compiles.

use crate::repository;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Instant, SystemTime};

/// A workspace.
pub struct House {
    root: PathBuf,
    dependencies: String,
}

impl House {
    /// A workspace in this folder with crates of these names. They may use these packages of ours, by their names and folders, and others as
    /// they stand in a manifest. It has a profile `whole`, which is not incremental.
    ///
    /// # Panics
    /// If it cannot be written.
    #[must_use]
    pub fn new(root: &Path, members: &[&str], ours: &[(&str, &str)], others: &str) -> Self {
        let ours = ours.iter().map(|(name, folder)| {
            let path = repository().join(folder);
            format!("{name} = {{ path = '{}' }}\n", path.display())
        });
        let dependencies = ours.collect::<String>() + others;
        let house = Self { root: root.to_owned(), dependencies };
        house.write(
            "Cargo.toml",
            &format!(
                "[workspace]\nresolver = \"3\"\nmembers = {members:?}\n[profile.whole]\ninherits = \"dev\"\nincremental = false\n"
            ),
        );
        // The same versions of everything, all of which are here already: nothing is asked of the network.
        let lock = repository().join("Cargo.lock");
        fs::copy(lock, root.join("Cargo.lock")).expect("the lock file");
        house
    }

    /// Writes a file.
    ///
    /// # Panics
    /// If it cannot be written.
    pub fn write(&self, path: &str, text: &str) {
        let path = self.root.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }

    /// Puts a program into one of the crates.
    ///
    /// # Panics
    /// If it cannot be written.
    pub fn put(&self, name: &str, program: &str) {
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[dependencies]\n{}",
            self.dependencies
        );
        self.write(&format!("{name}/Cargo.toml"), &manifest);
        self.write(&format!("{name}/src/main.rs"), program);
    }

    /// Builds a crate.
    ///
    /// # Panics
    /// If it is not Rust.
    pub fn cargo(&self, name: &str, profile: &str, flags: &str) {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args(["build", "--offline", "--quiet", "-p", name])
            .args(["--profile", profile])
            .current_dir(&self.root)
            .env("CARGO_TARGET_DIR", self.root.join("target"))
            .env("RUSTFLAGS", flags)
            .status();
        assert!(status.expect("cargo runs").success(), "{name} is built");
    }

    /// The program that was built.
    #[must_use]
    pub fn binary(&self, name: &str, profile: &str) -> PathBuf {
        let folder = if profile == "dev" { "debug" } else { profile };
        let program = self.root.join("target").join(folder).join(name);
        program.with_extension(std::env::consts::EXE_EXTENSION)
    }

    /// Runs the program with these words, and gives what it prints.
    ///
    /// # Panics
    /// If it fails.
    #[must_use]
    pub fn run(&self, name: &str, profile: &str, words: &[PathBuf]) -> String {
        let program = self.binary(name, profile);
        let output = Command::new(program).args(words).output();
        let output = output.expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name} runs: {said}");
        eprint!("{said}");
        String::from_utf8(output.stdout).expect("text")
    }

    /// Milliseconds from a change in the crate to the new program.
    ///
    /// # Panics
    /// If it cannot be changed, or is not Rust.
    #[must_use]
    pub fn rebuild(&self, name: &str, profile: &str) -> f64 {
        let main = self.root.join(name).join("src/main.rs");
        let file = File::options().append(true).open(main);
        file.expect("the program").set_modified(SystemTime::now()).expect("a new date");
        let start = Instant::now();
        self.cargo(name, profile, "");
        start.elapsed().as_secs_f64() * 1e3
    }
}

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
