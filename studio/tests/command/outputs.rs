//! What may take the place of what: an output is never an input, and never a file of another kind.

use crate::run::{FOUR_BAR, Folder};
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::process::Command;

/// Commands that write a file, with an ending of its name.
const WRITING: [(&str, &str); 7] = [
    ("table a.mech a --steps 2 -o", "csv"),
    ("graph a.mech -o", "dot"),
    ("plot a.mech -o", "svg"),
    ("plot a.mech -o", "png"),
    ("draw a.mech --size 40 -o", "svg"),
    ("film a.mech --size 40 --seconds 1 --rate 2 -o", "gif"),
    ("play a.mech --picture", "png"),
];

#[test]
fn an_output_is_never_an_input() {
    for (command, ending) in WRITING {
        let folder = Folder::new().with("a.mech", FOUR_BAR);
        let (hard, soft) = (format!("hard.{ending}"), format!("soft.{ending}"));
        fs::hard_link(folder.path("a.mech"), folder.path(&hard)).expect("a link");
        symlink("a.mech", folder.path(&soft)).expect("a link");
        let names = folder.names();
        for name in [&hard, &soft] {
            for replace in ["", "--replace"] {
                let refusal = folder.mech(&format!("{command} {name} {replace}")).refused(3);
                assert!(refusal.contains("is the file that is read"), "{refusal}");
            }
        }
        assert_eq!(folder.text("a.mech"), FOUR_BAR, "{command}");
        assert_eq!(folder.names(), names);
    }
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    for line in ["table a.mech -o a.mech", "graph a.mech -o ./a.mech --replace"] {
        folder.mech(line).refused(3);
        assert_eq!(folder.text("a.mech"), FOUR_BAR);
    }
}

#[test]
fn files_of_another_kind_are_replaced_only_if_that_is_said() {
    for (command, ending) in WRITING {
        let name = format!("x.{ending}");
        let folder = Folder::new().with("a.mech", FOUR_BAR);
        let path = folder.path(&name);
        let write = format!("{command} {name}");
        folder.mech(&write).done();
        let first = fs::read(&path).expect("a file");
        // One of its kind is replaced, and an empty one.
        for before in [&first[..], b""] {
            fs::write(&path, before).expect("a file");
            folder.mech(&write).done();
            assert_eq!(fs::read(&path).expect("a file"), first, "{write}");
        }
        let others: [&[u8]; 3] = [b"Dear Ada,\n", b"\n", b"\x7fELF"];
        for before in others {
            fs::write(&path, before).expect("a file");
            let refusal = folder.mech(&write).refused(3);
            assert!(refusal.contains("`--replace` writes over it"), "{refusal}");
            assert_eq!(fs::read(&path).expect("a file"), before, "{write}");
            assert_eq!(folder.names(), ["a.mech", &name]);
        }
        folder.mech(&format!("{write} --replace")).done();
        assert_eq!(fs::read(&path).expect("a file"), first, "{write}");
    }
    // What ends otherwise is none of its kind, whatever it begins with.
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let folder = folder.with("x.txt", "motor a [deg]\n0\n");
    folder.mech("table a.mech -o x.txt").refused(3);
    assert_eq!(folder.text("x.txt"), "motor a [deg]\n0\n");
}

#[test]
fn devices_stay_for_a_person() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder.mech("table a.mech -o /dev/null").done();
    let direct = folder.mech("table a.mech a").done();
    let by_device = folder.mech("table a.mech a -o /dev/stdout").done();
    assert_eq!(by_device, direct);
    // What stood in the file that a shell has opened stays.
    let folder = folder.with("log.csv", "mine\n");
    let log = fs::OpenOptions::new().append(true).open(folder.path("log.csv"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
    command.args(["table", "a.mech", "a", "-o", "/dev/stdout"]);
    command.current_dir(folder.path("")).stdout(log.expect("a file"));
    assert!(command.status().expect("it runs").success());
    assert_eq!(folder.text("log.csv"), format!("mine\n{direct}"));
}

#[test]
fn drafts_that_a_kill_left_are_removed_and_hinder_nobody() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let folder = folder.with(".a.svg.4711.draft", "<svg").with(".a.svg.x1Yz09.draft", "");
    // These are not ours.
    let folder = folder.with(".a.svg.my-own.draft", "").with(".b.svg.1.draft", "");
    symlink("a.mech", folder.path(".a.svg.2.draft")).expect("a link");
    folder.mech("draw a.mech -o a.svg").done();
    assert_eq!(
        folder.names(),
        [".a.svg.2.draft", ".a.svg.my-own.draft", ".b.svg.1.draft", "a.mech", "a.svg"]
    );
    // Where a name is a folder, nothing can stand in its place, and nothing is left.
    fs::create_dir(folder.path("b.svg")).expect("a folder");
    folder.mech("draw a.mech -o b.svg").refused(3);
    assert_eq!(folder.names().len(), 6);
}

#[test]
fn a_private_file_stays_private() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let mode = |name: &str| {
        let known = fs::metadata(folder.path(name)).expect("a file");
        known.permissions().mode() & 0o777
    };
    folder.mech("table a.mech a --steps 1 -o a.csv").done();
    for private in [0o600, 0o640, 0o666] {
        let rights = fs::Permissions::from_mode(private);
        fs::set_permissions(folder.path("a.csv"), rights).expect("rights");
        folder.mech("table a.mech b --steps 1 -o a.csv").done();
        assert_eq!(mode("a.csv"), private);
    }
    // A new one is as the user's other new files are.
    assert_eq!(mode("a.mech"), {
        folder.mech("table a.mech -o new.csv").done();
        mode("new.csv")
    });
}

#[test]
fn a_file_that_may_not_be_written_stays() {
    let loose = FOUR_BAR.replace("motor a;\n", "");
    let folder = Folder::new().with("a.mech", &loose);
    let rights = fs::Permissions::from_mode(0o640);
    fs::set_permissions(folder.path("a.mech"), rights).expect("it is ours");
    folder.mech("fix a.mech --pick 1").done();
    let mode = fs::metadata(folder.path("a.mech")).expect("a file").permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
    // A link stays one.
    let folder = Folder::new().with("b.mech", &loose);
    symlink("b.mech", folder.path("c.mech")).expect("a link");
    folder.mech("fix c.mech --pick 1").done();
    assert!(folder.path("c.mech").is_symlink());
    assert_eq!(folder.text("b.mech"), FOUR_BAR);
}
