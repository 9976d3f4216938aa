//! The recipes of CONTRIBUTING.md name files that exist, and every file that has to change: those of the library whose code knows what is like it.

use mech_test_support::repository as root;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The library, without its tests.
const LIBRARY: [&str; 4] =
    ["mech-macros/compiler/src", "mech-runtime/src", "mech-runtime/core/src", "studio/src"];

/// `a/{b,c}.rs` written out.
fn written_out(path: &str) -> Vec<String> {
    let Some((before, after)) = path.split_once('{') else {
        return vec![path.to_owned()];
    };
    let (choices, after) = after.split_once('}').expect("a closing brace");
    let choices = choices.split(',');
    choices.flat_map(|choice| written_out(&[before, choice, after].concat())).collect()
}

/// The files and folders that a recipe names, from the root of the repository.
fn named(recipe: &str) -> BTreeSet<PathBuf> {
    let quoted = recipe.split('`').skip(1).step_by(2);
    let paths = quoted.filter(|text| {
        let ending = Path::new(text).extension();
        let is_path = text.contains('/') || ending.is_some_and(|end| end == "rs" || end == "md");
        is_path && !text.contains([' ', '*', '\n'])
    });
    let paths = paths.flat_map(written_out);
    let found = paths.map(|path| {
        let whole = PathBuf::from(&path);
        if root().join(&whole).exists() {
            return whole;
        }
        let inside = Path::new(LIBRARY[0]).join(&path);
        assert!(root().join(&inside).exists(), "there is no `{path}`");
        inside
    });
    found.collect()
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(root().join(folder)).expect("a folder") {
        let name = entry.expect("an entry").file_name();
        let path = folder.join(&name);
        let is_of_tests = ["tests", "tests.rs"].iter().any(|word| name == **word);
        if root().join(&path).is_dir() && !is_of_tests {
            files(&path, found);
        } else if path.extension().is_some_and(|end| end == "rs") && !is_of_tests {
            found.push(path);
        }
    }
}

/// The files of the library in whose code a word stands, whatever its case and its ending.
fn with_word(is_it: impl Fn(&str) -> bool) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for folder in LIBRARY {
        files(Path::new(folder), &mut all);
    }
    all.retain(|path| {
        let text = fs::read_to_string(root().join(path)).expect("a file");
        let lines = text.lines().map(|line| line.split("//").next().unwrap_or(""));
        let mut words = lines.flat_map(|line| line.split(|letter: char| !letter.is_alphanumeric()));
        words.any(|word| is_it(&word.to_lowercase()))
    });
    all
}

#[test]
fn recipes_name_every_file_that_has_to_change() {
    let page = fs::read_to_string(root().join("CONTRIBUTING.md")).expect("the page");
    let recipes: Vec<(&str, BTreeSet<PathBuf>)> = page
        .split("\n## How to add ")
        .skip(1)
        .map(|recipe| {
            let (title, text) = recipe.split_once('\n').expect("a recipe");
            (title, named(text.split("\n## ").next().unwrap_or(text)))
        })
        .collect();
    assert!(recipes.len() >= 6, "{} recipes", recipes.len());
    for (title, is_it) in [
        ("a joint", (|word| word == "rack" || word == "racks") as fn(&str) -> bool),
        ("an effect", |word| word.starts_with("sensitivit")),
    ] {
        let recipe = recipes.iter().find(|(known, _)| *known == title);
        let (_, names) = recipe.unwrap_or_else(|| panic!("no recipe for {title}"));
        let known = with_word(is_it);
        assert!(known.len() > 15, "{title}: {} files", known.len());
        let missing: Vec<&PathBuf> =
            known.iter().filter(|path| !names.iter().any(|name| path.starts_with(name))).collect();
        assert!(missing.is_empty(), "the recipe for {title} does not name {missing:?}");
    }
}
