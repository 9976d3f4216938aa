//! A script that a stranger has sent writes in its folder, and nowhere else. What is on the disk afterwards is the judge.

use crate::run::{Answer, FOUR_BAR, Folder, mech_in, mech_said};
use proptest::prelude::*;
use proptest::sample::select;
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

/// All files below a folder with their bytes, and links with where they lead.
fn tree(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let known = path.symlink_metadata().expect("it is there");
            if known.is_dir() {
                folders.push(path.clone());
                found.insert(path, Vec::new());
            } else if known.is_symlink() {
                let to = fs::read_link(&path).expect("a link");
                found.insert(path, to.into_os_string().into_encoded_bytes());
            } else {
                let bytes = fs::read(&path).expect("a file");
                found.insert(path, bytes);
            }
        }
    }
    found
}

const TABLE: &str = "motor a [deg],a [deg]\n0,0\n";

/// A home with what is worth something, and beside it the folder of a script with ways out.
fn houses() -> Folder {
    let folder = Folder::new();
    let path = |name: &str| folder.path(name);
    for name in ["home", "home/.config", "scripts", "scripts/sub", "scripts/.git"] {
        fs::create_dir(path(name)).expect("a folder");
    }
    for (name, text) in [
        ("home/.bashrc", "PATH=/bin"),
        ("home/victim.csv", TABLE),
        ("home/secret.mech", FOUR_BAR),
        ("scripts/opened.mech", FOUR_BAR),
        ("scripts/.hidden.mech", FOUR_BAR),
        ("scripts/victim.csv", TABLE),
        ("scripts/notes.txt", "mine"),
    ] {
        fs::write(path(name), text).expect("a file");
    }
    for (name, to) in [
        ("out", "../home"),
        ("link.csv", "../home/victim.csv"),
        ("link.mech", "../home/secret.mech"),
        ("dangling.mech", "../home/new.mech"),
        ("dangling.csv", "../home/new.csv"),
        ("hidden.csv", ".git/new.csv"),
        ("null.csv", "/dev/null"),
    ] {
        symlink(to, path("scripts").join(name)).expect("a link");
    }
    let hard = path("scripts/hard.mech");
    fs::hard_link(path("home/secret.mech"), hard).expect("a link");
    folder
}

fn run(folder: &Folder, script: &str, words: &[&str]) -> Answer {
    let file = folder.path("scripts/script.txt");
    fs::write(file, script).expect("a script");
    mech_in(&folder.path("scripts"), &[&["run", "script.txt"], words].concat())
}

/// Lines that a script may not say; `HERE` is the folder of all, and `\n` the end of a line. Those with `#` say why.
fn hostile(here: &str) -> impl Iterator<Item = String> {
    let lines = include_str!("hostile.txt").lines().filter(|line| !line.starts_with('#'));
    lines.map(move |line| line.replace("HERE", here).replace("\\n", "\n"))
}

#[test]
fn a_hostile_script_writes_nothing_that_it_may_not() {
    let folder = houses();
    let here = folder.path("");
    let here = here.to_str().expect("UTF-8").trim_end_matches('/');
    fs::write(folder.path("scripts/script.txt"), "").expect("a script");
    let before = tree(&folder.path(""));
    for line in hostile(here) {
        // What comes first is not written either.
        for first in ["open opened.mech\n", "open opened.mech\ndraw first.svg\nsave first.mech\n"] {
            let answer = run(&folder, &format!("{first}{line}\n"), &[]);
            assert!(matches!(answer.code, Some(2 | 3)), "{line}: {answer:?}");
            assert!(answer.err.contains("error: line "), "{line}: {answer:?}");
            fs::write(folder.path("scripts/script.txt"), "").expect("a script");
            assert_eq!(tree(&folder.path("")), before, "{line}");
        }
    }
}

/// Lines from a pipe are a script, too: each is tried, and none writes out of the present folder.
#[test]
fn hostile_lines_from_a_pipe_write_nothing_that_they_may_not() {
    let folder = houses();
    let here = folder.path("");
    let here = here.to_str().expect("UTF-8").trim_end_matches('/');
    let before = tree(&folder.path("home"));
    let mut input = "open opened.mech\n".to_owned();
    input.extend(hostile(here).map(|line| line + "\n"));
    let answer = mech_said(&folder.path("scripts"), &[""; 0], &input);
    assert!(matches!(answer.code, Some(2 | 3)), "{answer:?}");
    assert_eq!(tree(&folder.path("home")), before);
    let allowed = ["--allow-write", "../home"];
    let input = "open opened.mech\nsave ../home/new.mech\nsave ../home/.new.mech\n";
    let answer = mech_said(&folder.path("scripts"), &allowed, input);
    assert_eq!(answer.out, "saved `../home/new.mech`\n");
    assert!(answer.err.contains("is hidden"), "{}", answer.err);
}

#[test]
fn a_script_writes_in_its_folder_and_says_what() {
    let folder = houses();
    let before = tree(&folder.path("home"));
    let script = "open opened.mech\nrename coupler rod\nsave\nsave new.mech\ndraw sub/a.svg\ndraw sub/a.svg with --night
rename rod bar\nsave\ntable a --steps 1 -o a.csv\ngraph -o ./sub/../a.dot\nopen hard.mech\nrename coupler rod\nsave\n";
    let said = run(&folder, script, &[]).done();
    let written: Vec<&str> = said.lines().filter(|line| line.contains('`')).collect();
    assert_eq!(
        written,
        [
            "saved `opened.mech`",
            "saved `new.mech`",
            "wrote `sub/a.svg`",
            "wrote `a.csv`",
            "wrote `./sub/../a.dot`",
            "saved `hard.mech`"
        ]
    );
    let text = |name: &str| fs::read_to_string(folder.path("scripts").join(name)).expect("a file");
    assert!(text("opened.mech").contains("link rod"));
    assert!(text("new.mech").contains("link bar"));
    assert!(text("sub/a.svg").contains("<svg"));
    assert!(text("a.dot").starts_with("graph"));
    assert!(text("hard.mech").contains("link rod"));
    // A second name of a file outside was its own afterwards.
    assert_eq!(tree(&folder.path("home")), before);
    // What it has made is there now: it would be replaced.
    let answer = run(&folder, "open new.mech\ntable a -o a.csv", &[]);
    assert!(answer.err.contains("--allow-write a.csv"), "{answer:?}");
}

#[test]
fn the_user_allows_more() {
    let folder = houses();
    let secret = "rename coupler rod\nsave\n";
    // A file that the user names is saved.
    run(&folder, secret, &["../home/secret.mech"]).done();
    assert!(folder.text("home/secret.mech").contains("link rod"));
    // But nothing else is put in its place.
    let before = tree(&folder.path("home"));
    run(&folder, "graph -o ../home/secret.mech --replace\n", &["../home/secret.mech"]).refused(3);
    assert_eq!(tree(&folder.path("home")), before);
    let open = "open opened.mech\n";
    for (line, allowed, written) in [
        ("save ../home/new.mech", "../home", "home/new.mech"),
        ("save out/b.mech", "out/b.mech", "home/b.mech"),
        ("table -o out/victim.csv", "../home/victim.csv", "home/victim.csv"),
        ("table b -o link.csv", "../home", "home/victim.csv"),
        ("table -o victim.csv", "victim.csv", "scripts/victim.csv"),
        ("table -o notes.txt --replace", "notes.txt", "scripts/notes.txt"),
        ("save .git/new.mech", ".git", "scripts/.git/new.mech"),
        ("save ../home/.bash_aliases", "../home/.bash_aliases", "home/.bash_aliases"),
    ] {
        let before = tree(&folder.path(""));
        run(&folder, &[open, line].concat(), &["--allow-write", allowed]).done();
        let mut after = tree(&folder.path(""));
        let script = folder.path("scripts/script.txt");
        let changed = |path: &PathBuf, bytes: &Vec<u8>| before.get(path) != Some(bytes);
        after.retain(|path, bytes| *path != script && changed(path, bytes));
        let changed: Vec<_> = after.into_keys().collect();
        assert_eq!(changed, [folder.path(written)], "{line}");
    }
    for (line, allowed) in [
        // A folder is not what is hidden in it.
        ("save ../home/.bashrc.mech", "../home"),
        ("save ../home/.config/a.mech", "../home"),
        // Nor is a file of another kind replaced without a word.
        ("table -o notes.txt", "notes.txt"),
        ("table -o ../home/a.sh", "../home"),
    ] {
        let before = tree(&folder.path("home"));
        run(&folder, &[open, line].concat(), &["--allow-write", allowed]).refused(3);
        assert_eq!(tree(&folder.path("home")), before, "{line}");
    }
    let answer = run(&folder, open, &["--allow-write", "nowhere/x"]);
    assert!(answer.refused(3).contains("cannot find `nowhere/x`"));
}

/// A path of pieces that lead out, in, round, and through links.
fn hostile_path() -> impl Strategy<Value = String> {
    const PIECES: &[&str] = &[
        "..",
        ".",
        "sub",
        "out",
        "home",
        "scripts",
        ".git",
        ".config",
        "",
        "opened.mech",
        "HERE",
        "link.csv",
        "~",
        "new",
        "$HOME",
        "out/..",
        "sub/..",
        "dangling.csv",
    ];
    const NAMES: &[&str] = &[
        "new.mech",
        "new.csv",
        "new.svg",
        "new.dot",
        "victim.csv",
        "secret.mech",
        ".bashrc",
        ".new.mech",
        "link.csv",
        "link.mech",
        "dangling.mech",
        "dangling.csv",
        "hidden.csv",
        "hard.mech",
        "NEW.MECH",
        "new.mech/",
        "notes.txt",
        " .mech",
        "..mech",
        "...",
        "",
    ];
    let pieces = prop::collection::vec(select(PIECES), 0..5);
    (pieces, select(NAMES)).prop_map(|(pieces, name)| {
        let pieces = pieces.into_iter().chain([name]);
        pieces.collect::<Vec<_>>().join("/")
    })
}

fn hostile_line() -> impl Strategy<Value = String> {
    const LINES: &[&str] = &[
        "save PATH",
        "save \"PATH\"",
        "open PATH",
        "rename coupler rod",
        "rename rod coupler",
        "save",
        "undo",
        "table a --steps 1 -o PATH",
        "table a --steps 1 -oPATH --replace",
        "graph --output=PATH",
        "draw PATH with --size 8",
        "draw \"PATH\" with --replace --size 8",
        "graph --of loops -o PATH --replace",
    ];
    (select(LINES), hostile_path()).prop_map(|(line, path)| line.replace("PATH", &path))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever lines say, nothing outside of their folder changes, nothing hidden, and nothing that they have not opened.
    #[test]
    fn random_lines_write_nothing_that_they_may_not(lines in prop::collection::vec(hostile_line(), 1..60)) {
        let folder = houses();
        let here = folder.path("");
        let here = here.to_str().expect("UTF-8").trim_end_matches('/').trim_start_matches('/');
        let lines: Vec<String> = lines.iter().map(|line| line.replace("HERE", &format!("/{here}"))).collect();
        let before = tree(&folder.path(""));
        let input = format!("open opened.mech\n{}\n", lines.join("\n"));
        // From a pipe all lines are tried; as a script they are written together.
        let answer = mech_said(&folder.path("scripts"), &[""; 0], &input);
        prop_assert!(matches!(answer.code, Some(0..=3)), "{answer:?}");
        run(&folder, &input, &[]);
        let after = tree(&folder.path(""));
        let scripts = folder.path("scripts");
        let may_change = |path: &Path| path.strip_prefix(&scripts).is_ok_and(|below| {
            let is_hidden = below.to_string_lossy().split('/').any(|part| part.starts_with('.'));
            !is_hidden && below != Path::new("notes.txt") && below != Path::new("victim.csv")
        });
        for path in before.keys().chain(after.keys()) {
            prop_assert!(may_change(path) || before.get(path) == after.get(path), "{}", path.display());
        }
    }
}
