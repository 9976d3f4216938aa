//! `mech fix` shows repairs, and makes the one that is picked.

use crate::run::{FOUR_BAR, Folder, rust};

/// A four-bar without a motor, with comments and an order of its own.
const LOOSE: &str = "struct FourBar; // of Grashof
link crank; link coupler; link rocker;

    // Turns all the way round.
    joint a = revolute(ground, crank) at (0, 0);   // shaft
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
";

#[test]
fn repairs_are_shown_as_differences() {
    let folder = Folder::new().with("a.mech", LOOSE);
    let answer = folder.mech("fix a.mech");
    assert_eq!(answer.code, Some(1));
    assert!(
        answer.err.starts_with("error: there is no motor"),
        "{}",
        answer.err
    );
    let first = "1: add `motor a;`
--- a.mech
+++ a.mech
@@ -7,2 +7,3 @@
     joint c = revolute(coupler, rocker) at (3.3, 2.9);
     joint d = revolute(ground, rocker) at (4, 0);
+    motor a;

2: ";
    assert!(answer.out.starts_with(first), "{}", answer.out);
    assert_eq!(folder.text("a.mech"), LOOSE);
}

#[test]
fn a_repair_that_is_picked_is_made() {
    let folder = Folder::new().with("a.mech", LOOSE);
    let done = folder.mech("fix a.mech --pick 1").done();
    assert!(done.starts_with("--- a.mech\n+++ a.mech\n"), "{done}");
    assert!(
        done.ends_with("FourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop\n"),
        "{done}"
    );
    assert_eq!(folder.text("a.mech"), format!("{LOOSE}    motor a;\n"));
    folder.mech("check a.mech").done();
    // Then there is nothing left to do.
    assert!(
        folder
            .mech("fix a.mech")
            .done()
            .starts_with("FourBar moves")
    );
    assert_eq!(folder.names(), ["a.mech"]);
}

#[test]
fn one_of_several_assemblies_is_chosen() {
    let text = "struct FourBar;
ground { point o = (0, 0); point p = (3.5, 0); }
link crank { point o = (0, 0); point b = (1, 0); }
link coupler { point b = (0, 0); point c = (3, 0); }
link rocker { point p = (0, 0); point c = (2.5, 0); }
joint a = revolute(ground.o, crank.o); joint b = revolute(crank.b, coupler.b);
joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.p, rocker.p);
motor a; START
";
    for (start, added) in [
        ("", "motor a; \nstart { coupler near "),
        ("start { a = 60 deg; }", "start { a = 60 deg; coupler near "),
        ("start { }", "start { coupler near "),
    ] {
        let folder = Folder::new().with("a.mech", text.replace("START", start));
        let offered = folder.mech("fix a.mech").out;
        assert!(offered.starts_with("1: add `"), "{offered}");
        assert!(offered.contains("\n2: add `"), "{offered}");
        for number in [1, 2] {
            let folder = Folder::new().with("a.mech", text.replace("START", start));
            folder.mech(&format!("fix a.mech --pick {number}")).done();
            let text = folder.text("a.mech").replace("  ", " ");
            assert!(text.contains(&added.replace("  ", " ")), "{text}");
        }
    }
}

#[test]
fn only_the_mechanism_that_is_named_is_changed() {
    let folder = Folder::new().with("a.rs", rust());
    let refusal = folder.mech("fix a.rs").refused(2);
    assert!(refusal.contains("several mechanisms"), "{refusal}");
    folder.mech("fix a.rs -m Loose -p 1").done();
    let expected = rust().replace("at (4, 0);\n\n }", "at (4, 0);\nmotor a;\n\n }");
    assert_eq!(folder.text("a.rs"), expected);
}

#[test]
fn a_repair_that_there_is_not() {
    let folder = Folder::new()
        .with("a.mech", LOOSE)
        .with("b.mech", "struct A; link b");
    let refusal = folder.mech("fix a.mech --pick 99").refused(2);
    assert!(
        refusal.contains("there is no repair 99; the last is "),
        "{refusal}"
    );
    folder.mech("fix a.mech --pick 0").refused(2);
    let refusal = folder.mech("fix b.mech --pick 1").refused(1);
    assert!(refusal.contains("error: no repair is known"), "{refusal}");
    let refusal = folder.mech("fix b.mech").refused(1);
    assert!(refusal.ends_with("note: no repair is known\n"), "{refusal}");
    assert_eq!(folder.text("a.mech"), LOOSE);
}

#[test]
fn a_part_is_not_changed_for_one_of_its_uses() {
    let text = "struct Two;
part Arm { port frame { point pin = (0, 0); } link bar { point pin = (0, 0); }
    joint pivot = revolute(frame.pin, bar.pin); }
use one: Arm { frame = ground };
use two: Arm { frame = one.bar at (1, 0) };
motor one.pivot;
";
    let folder = Folder::new().with("a.mech", text);
    let answer = folder.mech("fix a.mech");
    assert_eq!(answer.code, Some(1));
    // A motor of an instance is a statement of the whole.
    assert!(answer.out.contains("+motor two.pivot;"), "{}", answer.out);
    assert_eq!(folder.text("a.mech"), text);
}

#[test]
#[cfg(unix)]
fn a_file_that_may_not_be_written_stays() {
    use std::fs::{Permissions, set_permissions};
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new().with("a.mech", LOOSE);
    set_permissions(folder.path("a.mech"), Permissions::from_mode(0o640)).expect("it is ours");
    folder.mech("fix a.mech --pick 1").done();
    let mode = std::fs::metadata(folder.path("a.mech"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
    // A link stays one.
    let folder = Folder::new().with("b.mech", LOOSE);
    std::os::unix::fs::symlink("b.mech", folder.path("c.mech")).expect("a link");
    folder.mech("fix c.mech --pick 1").done();
    assert!(folder.path("c.mech").is_symlink());
    assert_ne!(folder.text("b.mech"), LOOSE);
    // FOUR_BAR has its motor.
    let folder = Folder::new().with("d.mech", FOUR_BAR);
    folder.mech("fix d.mech --pick 1").done();
    assert_eq!(folder.text("d.mech"), FOUR_BAR);
}
