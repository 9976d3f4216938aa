//! The texts that are mangled: those of the tests, and those of folders that the command line names.

use crate::language::Language;
use crate::pieces::words;
use fastrand::Rng;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Longer texts are left out: they take long, and find no more.
const LONGEST: usize = 5000;

/// Texts of a language.
pub(crate) struct Corpus {
    pub(crate) language: &'static Language,
    texts: Vec<String>,
    words: Vec<String>,
}

impl Corpus {
    pub(crate) fn new(language: &'static Language, mut texts: Vec<String>) -> Self {
        texts.retain(|text| text.len() <= LONGEST);
        let all = texts.iter().flat_map(|text| words(text));
        let mut words: Vec<String> = all.map(str::to_owned).collect();
        words.sort();
        words.dedup();
        Self { language, texts, words }
    }

    /// One of the texts.
    pub(crate) fn text(&self, rng: &mut Rng) -> &str {
        &self.texts[rng.usize(..self.texts.len())]
    }

    /// One of the words in them.
    pub(crate) fn word(&self, rng: &mut Rng) -> &str {
        &self.words[rng.usize(..self.words.len())]
    }
}

/// The texts in files with one of these endings, in folders and all that is in them.
pub(crate) fn texts(folders: &[PathBuf], endings: &[&str]) -> Result<Vec<String>, String> {
    let mut files = Vec::new();
    for folder in folders {
        let read = collect(folder, endings, &mut files);
        read.map_err(|error| format!("cannot read `{}`: {error}", folder.display()))?;
    }
    files.sort();
    // What is no text was not made for this.
    let texts = files.iter().filter_map(|file| fs::read_to_string(file).ok());
    Ok(texts.collect())
}

fn collect(folder: &Path, endings: &[&str], files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, endings, files)?;
        } else if path
            .extension()
            .is_some_and(|ending| endings.iter().any(|known| ending == *known))
        {
            files.push(path);
        }
    }
    Ok(())
}
