//! The rooms of the compiler import each other in one direction only.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms, each with those that it may import: the table in `ARCHITECTURE.md`. A room imports none that stands below it there, so there
/// is no circle.
fn rooms() -> Vec<(String, Vec<String>)> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../ARCHITECTURE.md");
    let page = fs::read_to_string(page).expect("ARCHITECTURE.md");
    let after = page.lines().skip_while(|line| *line != "<!-- rooms -->");
    let rows = after.skip(3).take_while(|line| line.starts_with('|'));
    let rooms = rows.map(|row| {
        // Every second piece of a row stands between backquotes.
        let mut names = row.split('`').skip(1).step_by(2).map(str::to_owned);
        (names.next().expect("a room"), names.collect())
    });
    rooms.collect()
}

/// All source files below a folder, but tests.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name");
        if name == "tests" {
            continue;
        }
        if path.is_dir() {
            sources(&path, found);
        } else {
            found.push(path);
        }
    }
}

/// The room in which a file stands; none for the crate's root.
fn room_of(path: &Path, root: &Path) -> Option<String> {
    let inside = path.strip_prefix(root).expect("a path in the root");
    let first = inside.components().next().expect("a component");
    let name = Path::new(&first).file_stem().expect("a name");
    let name = name.to_str().expect("a name in UTF-8");
    (name != "lib").then(|| name.to_owned())
}

/// The names that follow `crate::` in a text, those in braces too.
fn imported(text: &str) -> Vec<String> {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let code: String = code.collect::<Vec<_>>().join("\n");
    let mut names = Vec::new();
    for after in code.split("crate::").skip(1) {
        match after.strip_prefix('{') {
            Some(list) => {
                let mut depth = 0;
                let mut first = String::new();
                for letter in list.chars() {
                    match letter {
                        '{' => depth += 1,
                        '}' if depth == 0 => break,
                        '}' => depth -= 1,
                        ',' if depth == 0 => first.push(','),
                        _ if depth == 0 => first.push(letter),
                        _ => {}
                    }
                }
                names.extend(first.split(',').map(leading_name));
            }
            None => names.push(leading_name(after)),
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// The identifier at the beginning of a text.
fn leading_name(text: &str) -> String {
    let text = text.trim_start();
    text.chars().take_while(|&letter| letter == '_' || letter.is_alphanumeric()).collect()
}

#[test]
fn rooms_import_what_the_table_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = Vec::new();
    sources(&root, &mut paths);
    let rooms = rooms();
    let allowed: BTreeMap<_, _> = rooms.iter().cloned().collect();
    let mut wrong = Vec::new();
    let mut used = BTreeSet::new();
    for path in &paths {
        let Some(room) = room_of(path, &root) else {
            continue;
        };
        let text = fs::read_to_string(path).expect("a source");
        let Some(may) = allowed.get(&room) else {
            wrong.push(format!("{room} is not in the table"));
            continue;
        };
        for name in imported(&text) {
            if name != room && !may.contains(&name) {
                wrong.push(format!("{}: {room} imports {name}", path.display()));
            }
            used.insert((room.clone(), name));
        }
    }
    for (room, may) in rooms {
        for other in may {
            if !used.contains(&(room.clone(), other.clone())) {
                wrong.push(format!("{room} need not import {other}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_table_has_no_circle() {
    let rooms = rooms();
    assert!(rooms.len() > 20, "{rooms:?}");
    for (index, (room, may)) in rooms.iter().enumerate() {
        for other in may {
            let above = rooms[..index].iter().any(|(name, _)| name == other);
            assert!(above, "{room} imports {other}");
        }
    }
}
