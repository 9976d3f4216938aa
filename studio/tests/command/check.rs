//! `mech check` says what the macro says, at the same places.

use crate::run::{FOUR_BAR, Folder, mech_in, refused, rust};
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
            let found = mech_in(
                &folder,
                &[
                    "check".as_ref(),
                    path.strip_prefix(&folder).expect("a case"),
                ],
            );
            let (file, is_text) = (
                path.with_extension("stderr"),
                path.extension() == Some("mech".as_ref()),
            );
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
fn what_moves_is_told_in_a_line() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let line = "FourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop\n";
    assert_eq!(folder.mech("check a.mech").done(), line);
}

#[test]
fn what_comes_near_a_change_point_moves_and_is_noted() {
    let text = "struct Swing; link a; link b; link c;
        joint p = revolute(ground, a) at (0, 0); joint q = revolute(a, b) at (1, 2);
        joint r = revolute(b, c) at (4, 2.0000001); joint s = revolute(ground, c) at (3, 0); motor p;";
    let folder = Folder::new().with("a.mech", text);
    let answer = folder.mech("check a.mech").done();
    let (line, note) = answer.split_once('\n').expect("two lines");
    assert!(line.starts_with("Swing moves: "), "{answer}");
    assert!(
        note.starts_with("note: the loop `") && note.contains("` passes within "),
        "{answer}"
    );
    assert!(note.contains(" of a change point at p = "), "{answer}");
    let found = folder.mech("check a.mech --json").done();
    assert!(
        found.contains("\"moves\": true") && found.contains("\"level\": \"note\""),
        "{found}"
    );
}

#[test]
fn all_mechanisms_of_a_file_or_one() {
    let folder = Folder::new().with("a.rs", rust());
    let answer = folder.mech("check a.rs");
    assert_eq!(answer.code, Some(1));
    assert!(answer.out.starts_with("FourBar moves"), "{}", answer.out);
    assert!(answer.err.contains("there is no motor"), "{}", answer.err);
    folder.mech("check a.rs --mechanism FourBar").done();
    folder.mech("check a.rs -m Loose").refused(1);
    let refusal = folder.mech("check a.rs -m Four").refused(2);
    assert_eq!(
        refusal,
        "error: `a.rs` has no mechanism `Four`; it has `FourBar`, `Loose`\n"
    );
}

#[test]
fn parts_from_the_same_file_and_from_the_runtime() {
    let text = "mechanism_part! { pub Rod(length = 1) {
    port crank { point pin = (0, 0); }
    link rod { point pin = (0, 0); point tip = (length, 0); }
    joint pin = revolute(crank.pin, rod.pin);
} }
mechanism! { struct TwoRods; use crate::Rod; use one: Rod(length = 2) { crank = ground }; motor one.pin; }
mechanism! { struct Crane; use mech_runtime::parts::Cylinder;
    link boom { point foot = (0, 0); point tip = (4, 0); }
    ground { point foot = (0, 0); }
    joint foot = revolute(ground.foot, boom.foot);
    use ram: Cylinder { base = ground at (2, 0), load = boom at (3, 0) };
    motor ram.stroke in 1.2 ..= 3;
    start { ram.stroke = 2; boom near 40 deg; } }
mechanism! { struct Elsewhere; use other::Leg; }";
    let folder = Folder::new().with("a.rs", text);
    let answer = folder.mech("check a.rs");
    assert_eq!(answer.out.matches(" moves: ").count(), 2, "{answer:?}");
    let expected = "error: part `Leg` is not known here

       note: parts are taken from the same file, and from `mech_runtime::parts`
  --> a.rs:14:36
   |
14 | mechanism! { struct Elsewhere; use other::Leg; }
   |                                    ^^^^^^^^^^";
    assert_eq!(trimmed(&answer.err), expected);
}

#[test]
fn in_json_for_editors() {
    let folder = Folder::new().with("a.rs", rust());
    let answer = folder.mech("check a.rs --json");
    assert_eq!((answer.code, &*answer.err), (Some(1), ""));
    let json: serde_json::Value = serde_json::from_str(&answer.out).expect("JSON");
    assert_eq!(
        (&json["file"], &json["moves"]),
        (&"a.rs".into(), &false.into())
    );
    let [first, second] = &json["mechanisms"].as_array().expect("mechanisms")[..] else {
        panic!("{json}");
    };
    assert_eq!(
        (&first["name"], &first["moves"]),
        (&"FourBar".into(), &true.into())
    );
    let message = &second["messages"][0];
    let text = "there is no motor: the mechanism needs one motor";
    assert_eq!(
        (&message["level"], &message["text"]),
        (&"error".into(), &text.into())
    );
    assert_eq!(message["notes"][0]["level"], "help");
    let place = &message["place"];
    let at = |what: &str| usize::try_from(place[what].as_u64().expect("a number")).expect("small");
    assert_eq!(&rust()[at("start")..at("end")], "Loose");
    assert_eq!(place["from"]["line"], 10);
    assert_eq!(place["to"]["column"], 26);
    // Each repair comes with what makes it: the text that `fix` writes.
    let repair = &second["repairs"][0];
    assert_eq!(repair["text"], "add `motor a;`");
    assert_eq!(repair["remainder"], "nothing");
    let mut text = rust();
    let edits = repair["edits"].as_array().expect("edits");
    for edit in edits.iter().rev() {
        let at = |what: &str| {
            edit["place"][what]
                .as_u64()
                .and_then(|at| usize::try_from(at).ok())
        };
        let range = at("start").expect("a start")..at("end").expect("an end");
        text.replace_range(range, edit["text"].as_str().expect("a text"));
    }
    folder.mech("fix a.rs --mechanism Loose --pick 1").done();
    assert_eq!(text, folder.text("a.rs"));
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

/// The macro and the command say the same of a path that is none, at the same place.
#[test]
fn a_path_of_a_part_that_is_none() {
    let folder = Folder::new().with("a.mech", "struct Elsewhere;\nuse other :: ;\n");
    let told = folder.mech("check a.mech").refused(1);
    assert!(
        told.contains("the name of a part is missing here") && told.contains("a.mech:2:"),
        "{told}"
    );
    // A name that is known does not help.
    let folder = Folder::new().with("a.mech", "struct Elsewhere;\nuse other JansenLeg;\n");
    let told = folder.mech("check a.mech").refused(1);
    assert!(
        told.contains("expected `::` or `;`, found `JansenLeg`"),
        "{told}"
    );
}

/// What is wrong within a part of the library is told at the instance, not at the word that brings the part in.
#[test]
fn a_fault_within_a_part_of_the_library_stands_at_its_instance() {
    let text = "struct Broken;
use mech_runtime::parts::Pantograph;
use first: Pantograph { frame = ground };
use p: Pantograph(arm = 5) { frame = ground at (9, 0) };
motor first.pivot; motor first.elbow; motor p.pivot;
";
    let folder = Folder::new().with("a.mech", text);
    let told = folder.mech("check a.mech").refused(1);
    assert!(
        told.contains("`p.elbow`") && told.contains("--> a.mech:4:5"),
        "{told}"
    );
}
