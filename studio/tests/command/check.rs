//! `mech check` says what the macro says, at the same places.

use crate::run::{Folder, mech_in, refused, rust};
use mech_studio::{Document, Source};
use std::path::Path;
use std::{env, fs};

/// Cases in which the Rust compiler says something besides the macro.
const NOT_OF_THE_MACRO: [&str; 1] = ["show-leaves-no-other-methods"];

/// The lines without spaces at their ends.
fn trimmed(text: &str) -> String {
    let lines: Vec<&str> = text.trim_end().lines().map(str::trim_end).collect();
    lines.join("\n")
}

/// The repairs that are listed in a text and do not make it move, or are not offered: `//+ old => new` where it is said to write `new`,
/// `//* old => new` for another way. Where nothing is old, the new is added.
fn unmended(path: &Path, said: &str) -> String {
    let text = fs::read_to_string(path).expect("a text");
    let (comments, code): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with("//"));
    let code = code.join("\n");
    let mut wrong = String::new();
    for line in comments {
        let is_quoted = line.starts_with("//+");
        let repair = line.strip_prefix("//+").or(line.strip_prefix("//*"));
        let Some((old, new)) = repair.and_then(|repair| repair.split_once("=>")) else {
            continue;
        };
        let (old, new) = (old.trim(), new.trim());
        let mended = match old {
            "" => format!("{code}{new}"),
            _ => code.replacen(old, new, 1),
        };
        let found = Folder::new().with("a.mech", &mended).mech("check a.mech");
        if mended == code || found.code != Some(0) || is_quoted && !said.contains(new) {
            wrong += &format!("{line}\n{found:?}\n");
        }
    }
    wrong
}

/// After a wording was changed on purpose, `UPDATE_CASES=1` renews what is said of texts: read it.
#[test]
fn the_same_words_at_the_same_places_as_the_macro() {
    let mut wrong = String::new();
    let mut count = 0;
    for (folder, cases) in refused() {
        for path in cases {
            let name = path.file_stem().expect("a name").to_string_lossy();
            if NOT_OF_THE_MACRO.contains(&&*name) {
                continue;
            }
            let found =
                mech_in(&folder, &["check".as_ref(), path.strip_prefix(&folder).expect("a case")]);
            let (file, is_text) =
                (path.with_extension("stderr"), path.extension() == Some("mech".as_ref()));
            if is_text && env::var_os("UPDATE_CASES").is_some() {
                fs::write(&file, trimmed(&found.err) + "\n").expect("a file");
            }
            if is_text {
                wrong += &unmended(&path, &found.err);
            }
            let expected = fs::read_to_string(&file).unwrap_or_default();
            count += 1;
            if found.code != Some(1) || trimmed(&found.err) != trimmed(&expected) {
                wrong += &format!("{name}: {found:?}\n{}\nexpected:\n{expected}\n", found.err);
            }
        }
    }
    assert!(count > 100, "{count}");
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn declarations_have_their_places_in_the_file() {
    let document = Document::of(Source::new("a.rs", rust()));
    for declaration in document.declarations() {
        let reading = document.analyse(declaration).expect("the compiler works");
        for joint in &reading.model.joints {
            let place = reading.place(joint.origin);
            assert_eq!(rust()[place.clone()], joint.name);
            assert!(declaration.whole.start < place.start && place.end < declaration.whole.end);
        }
        // Nobody declares the ground.
        let ground = reading.place(reading.model.links[0].origin);
        assert_eq!(ground, declaration.whole);
    }
}

#[test]
fn long_runs_keep_their_places() {
    let one = |number: usize| format!("mechanism! {{ struct M{number}; motor a{number}; }}\n");
    let text: String = (0..300).map(one).collect();
    let folder = Folder::new().with("a.rs", &text);
    let complaints = folder.mech("check a.rs").refused(1);
    for number in [0, 150, 299] {
        let place = format!(" --> a.rs:{}:", number + 1);
        assert!(complaints.contains(&place), "{number}");
        assert!(complaints.contains(&format!("`a{number}`")), "{number}");
    }
}

#[test]
fn one_run_checks_mechanisms_with_so_many_links_together() {
    let links: String = (0..999).map(|link| format!("link l{link};")).collect();
    let one = |number: usize| format!("mechanism! {{ struct M{number}; {links} }}\n");
    let folder = Folder::new().with("a.rs", (0..5).map(one).collect::<String>());
    let said = folder.mech("check a.rs").refused(1);
    for line in 1..=5 {
        let is_told = said.contains(&format!("--> a.rs:{line}:"));
        assert_eq!(is_told, line < 5, "{line}");
    }
    assert!(said.contains("this mechanism, and what follows it, is not checked"));
    let alone = folder.mech("check a.rs --mechanism M4").refused(1);
    assert!(alone.contains("--> a.rs:5:") && !alone.contains("not checked"));
}
