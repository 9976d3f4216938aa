//! The crates of a program, as cargo tells them.

use crate::text::Text;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::{self, Display, Formatter};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A crate by somebody else.
pub(crate) struct Package {
    name: String,
    version: String,
    /// An expression of SPDX; empty if it has only a text.
    license: String,
    authors: Vec<String>,
    repository: String,
    /// The folder of its sources.
    folder: PathBuf,
    /// The file that it calls its licence.
    license_file: Option<PathBuf>,
}

impl Package {
    /// The crates that are in a program of this workspace, in the order of their names.
    pub(crate) fn all_in(program: &str, target: Option<&str>) -> Result<Vec<Self>, String> {
        let mut tree = vec!["tree", "--locked", "--package", program];
        tree.extend(["--edges", "normal", "--prefix", "none", "--format", "{p}"]);
        tree.extend(target.map(|target| ["--target", target]).into_iter().flatten());
        let tree = cargo(&tree)?;
        // Those of this workspace have a path.
        let others = tree.lines().filter(|line| !line.contains('/'));
        let name = |line: &str| line.split(' ').take(2).collect::<Vec<_>>().join(" ");
        let contained: BTreeSet<String> =
            others.filter(|line| !line.is_empty()).map(name).collect();
        let known: Value =
            serde_json::from_str(&cargo(&["metadata", "--locked", "--format-version", "1"])?)
                .map_err(|e| e.to_string())?;
        let known = known["packages"].as_array().into_iter().flatten();
        let packages = known.map(Self::read);
        let mut packages: Vec<Self> = packages
            .filter(|package| {
                contained.contains(&*format!("{} v{}", package.name, package.version))
            })
            .collect();
        if packages.len() != contained.len() {
            return Err("cargo tells of crates of which it does not know more".to_owned());
        }
        packages.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
        Ok(packages)
    }

    fn read(told: &Value) -> Self {
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let manifest = text(&told["manifest_path"]);
        let folder = Path::new(&manifest).parent().unwrap_or(Path::new(""));
        Self {
            name: text(&told["name"]),
            version: text(&told["version"]),
            license: text(&told["license"]),
            authors: told["authors"].as_array().into_iter().flatten().map(text).collect(),
            repository: text(&told["repository"]),
            license_file: told["license_file"].as_str().map(|file| folder.join(file)),
            folder: folder.to_owned(),
        }
    }

    /// Its licence, who wrote it, and where it is.
    pub(crate) fn terms(&self) -> String {
        let is_named = !self.license.is_empty();
        let license = if is_named { &self.license } else { "its own" };
        let registry = format!("https://crates.io/crates/{}", self.name);
        let is_known = !self.repository.is_empty();
        let place = if is_known { &self.repository } else { &registry };
        let mut words = vec![license, place];
        words.extend(self.authors.iter().map(String::as_str));
        words.join(", ")
    }

    /// The texts of its licences; where it has none, those that its licences usually have.
    pub(crate) fn texts(&self) -> Result<Vec<Text>, String> {
        let own = Text::all_in(&self.folder, self.license_file.as_deref());
        let own = own.map_err(|error| format!("cannot read the texts of {self}: {error}"))?;
        if !own.is_empty() {
            return Ok(own);
        }
        let usual = Text::usual(&self.license);
        usual.map_err(|error| format!("the licence of {self} has no text: {error}"))
    }
}

impl Display for Package {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name, self.version)
    }
}

/// What cargo answers.
fn cargo(words: &[&str]) -> Result<String, String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo).args(words).output();
    let output = output.map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    String::from_utf8(output.stdout).map_err(|error| error.to_string())
}
