//! `docs/features.txt` lists what users can do. The compiler is asked which words it takes, the command for its help. The window is asked what
//! can be clicked. The rest is read from sources and pages. Renew it with
//! `UPDATE_FEATURES=1 cargo test -p mech-studio --test editor features`, and read what changed.

mod api;
mod command;
mod language;
mod window;

use similar::TextDiff;
use std::path::{Path, PathBuf};
use std::{env, fs};

#[test]
fn no_feature_disappears_or_appears() {
    let path = repository("docs/features.txt");
    let read = || fs::read_to_string(&path).unwrap_or_default();
    let sections = [
        ("Words of the language", language::words(&read())),
        ("Generated for a mechanism", api::generated()),
        ("Public in mech-runtime", api::runtime()),
        ("The command", command::helps()),
        ("Answers of the command", command::answers()),
        ("Quantities", command::quantities()),
        ("The player", mech_studio::play::keys::help()),
        ("The studio", window::controls()),
        ("Lines of sources and pages", lines()),
    ];
    let sections = sections.map(|(title, lines)| format!("== {title} ==\n{}\n", lines.join("\n")));
    let found = sections.join("\n");
    if env::var_os("UPDATE_FEATURES").is_some() {
        fs::write(&path, &found).expect("the list");
    }
    let there = read().replace("\r\n", "\n");
    assert!(
        there == found,
        "docs/features.txt is stale: renew it with UPDATE_FEATURES=1, and read what changed\n{}",
        TextDiff::from_lines(&there, &found).unified_diff()
    );
}

/// Parts of the library, the table of statements, rules of assembly, mechanisms and programs of the examples, features and commands of cargo,
/// the headings of pages, and the tables about the studio.
fn lines() -> Vec<String> {
    let mut found = Vec::new();
    // A file or a folder, how the names of files end there, and what is in their lines that are taken; `^` stands for the beginning.
    for rule in include_str!("lines.txt").lines() {
        let [folder, ending, words] = rule.split(';').collect::<Vec<_>>()[..] else {
            panic!("{rule}");
        };
        for path in files_in(folder, ending) {
            let (text, mut is_code) = (text_of(&path), false);
            for line in text.lines() {
                is_code ^= line.starts_with("```");
                let mut words = words.split('&').map(|word| word.replace('^', "\n"));
                if !is_code && words.any(|word| format!("\n{line}").contains(&word)) {
                    found.push(format!("{path}: {}", line.trim()));
                }
            }
        }
    }
    found
}

/// A file or folder of the repository.
fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// The files in a folder of the repository whose names end so, as paths in it, sorted; not those of tests, and not what is built.
fn files_in(folder: &str, ending: &str) -> Vec<String> {
    if repository(folder).is_file() {
        return vec![folder.to_owned()];
    }
    let mut found = Vec::new();
    for entry in fs::read_dir(repository(folder)).expect(folder) {
        let entry = entry.expect("an entry");
        let path = format!("{folder}/{}", entry.file_name().display());
        if !entry.path().is_dir() {
            found.extend(path.ends_with(ending).then_some(path));
        } else if !path.ends_with("/tests") && !path.ends_with("/target") {
            found.extend(files_in(&path, ending));
        }
    }
    found.sort();
    found
}

fn text_of(path: &str) -> String {
    let text = fs::read_to_string(repository(path)).expect(path);
    text.replace("\r\n", "\n")
}
