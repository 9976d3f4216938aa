//! The texts of licences.

use spdx::{Expression, LicenseId, ParseMode};
use std::ffi::OsStr;
use std::fmt::{self, Display, Formatter};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// The text of a licence, or of what else has to be passed on.
pub(crate) struct Text(String);

impl Text {
    /// All in a folder of sources, and in a file that may have another name.
    pub(crate) fn all_in(folder: &Path, named: Option<&Path>) -> io::Result<Vec<Self>> {
        let mut files: Vec<PathBuf> = named.map(Path::to_owned).into_iter().collect();
        collect(folder, &mut files)?;
        files.sort();
        files.dedup();
        files.iter().map(|file| Self::read(file)).collect()
    }

    fn read(file: &Path) -> io::Result<Self> {
        let text = fs::read(file)?;
        let text = String::from_utf8_lossy(&text);
        let lines = text.lines().map(str::trim_end);
        Ok(Self(lines.collect::<Vec<_>>().join("\n").trim_matches('\n').to_owned()))
    }

    /// Those of the licences in an expression, as they usually are.
    pub(crate) fn usual(license: &str) -> Result<Vec<Self>, String> {
        let expression = Expression::parse_mode(license, ParseMode::LAX);
        let expression = expression.map_err(|error| error.to_string())?;
        let ids = expression.requirements().map(|one| one.req.license.id());
        let text = |id: Option<LicenseId>| Some(Self(id?.text().trim_matches('\n').to_owned()));
        let texts: Option<Vec<Self>> = ids.map(text).collect();
        texts.ok_or_else(|| format!("`{license}` has a licence that is not of SPDX"))
    }

    /// What is the same for texts that differ in blanks alone.
    pub(crate) fn key(&self) -> String {
        self.0.split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

impl Display for Text {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Finds what has to be passed on, but of tests and examples.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let entries = entries.collect::<io::Result<Vec<PathBuf>>>()?;
    let has_fonts = entries.iter().any(|path| path.extension() == Some(OsStr::new("ttf")));
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        if path.is_dir() {
            if !matches!(&*name, "tests" | "examples" | "benches" | "target") {
                collect(&path, files)?;
            }
        } else if is_license(&name) || has_fonts && path.extension() == Some(OsStr::new("txt")) {
            files.push(path);
        }
    }
    Ok(())
}

/// Whether a file has to be passed on, by its name in lower case.
fn is_license(name: &str) -> bool {
    let is_code = [".rs", ".toml", ".json", ".hbs"].iter().any(|end| name.ends_with(end));
    let beginnings = ["copying", "copyright", "notice"];
    let begins = beginnings.iter().any(|beginning| name.starts_with(beginning));
    !is_code && (begins || name.contains("license") || name.contains("licence"))
}
