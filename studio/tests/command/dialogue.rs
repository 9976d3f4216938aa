//! `mech run` and the dialogue: what they answer, refuse and write.

use crate::run::{Answer, FOUR_BAR, Folder, repository};
use std::fs;
use std::io::Write;
use std::process::{Child, Command, Stdio};

/// Begins `mech` alone, which waits for lines from elsewhere.
fn begin(folder: &Folder) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
    command.current_dir(folder.path(""));
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command.spawn().expect("the command runs")
}

/// Runs `mech` alone, with lines from elsewhere.
fn say(folder: &Folder, lines: &str) -> Answer {
    let mut child = begin(folder);
    let mut input = child.stdin.take().expect("an input");
    input.write_all(lines.as_bytes()).expect("it listens");
    drop(input);
    let output = child.wait_with_output().expect("it ends");
    Answer {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).expect("UTF-8"),
        err: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

#[test]
fn the_session_to_figure_1_of_the_paper_is_replayed() {
    let script = fs::read_to_string(repository("studio/sessions/figure_1.txt")).expect("a script");
    let folder = Folder::new().with("figure_1.txt", script);
    let done = folder.mech("run figure_1.txt").done();
    assert!(
        done.contains("GearedPiston moves: 4 moving links, 6 joints, 1 motor, 1 loop\n"),
        "{done}"
    );
    assert_eq!(
        folder.names(),
        ["figure_1.mech", "figure_1.png", "figure_1.txt"]
    );
    // The same mechanism as that of the gallery: the piston is at the same places.
    let gallery = repository("examples/gallery/src/mechanisms/geared_piston.rs");
    let gallery = gallery.to_str().expect("UTF-8");
    let table = |file: &str| {
        folder
            .mech(&format!("table {file} piston.pin --steps 12"))
            .done()
    };
    assert_eq!(table("figure_1.mech"), table(gallery));
    let joints = |file: &str| {
        let report = folder.mech(&format!("report {file}")).done();
        let trunk = report
            .lines()
            .find(|line| line.trim_start().starts_with("trunk"));
        trunk.expect("a trunk").to_owned()
    };
    assert_eq!(joints("figure_1.mech"), joints(gallery));
}

#[test]
fn a_script_changes_a_file_when_all_its_lines_are_done() {
    let folder = Folder::new().with("a.mech", FOUR_BAR).with(
        "script.txt",
        "# longer\nmove a to (0.125, 0) # to the right\nrename coupler rod\n\nsave\n",
    );
    let done = folder.mech("run script.txt a.mech").done();
    assert_eq!(
        done,
        "move a\n  FourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop\n\
         rename coupler to rod: 3 places\n  FourBar moves: 3 moving links, 4 joints, 1 motor, 1 loop\n\
         saved `a.mech`\n"
    );
    let expected = FOUR_BAR
        .replace("(0, 0)", "(0.125, 0)")
        .replace("coupler", "rod");
    assert_eq!(folder.text("a.mech"), expected);
}

#[test]
fn a_script_that_is_refused_writes_nothing() {
    let script =
        "open a.mech\nmove a to (0.125, 0)\nsave\ndraw a.png\nremove joint z\nsave b.mech\n";
    let folder = Folder::new()
        .with("a.mech", FOUR_BAR)
        .with("script.txt", script);
    let answer = folder.mech("run script.txt");
    assert_eq!(answer.code, Some(1));
    assert_eq!(
        answer.err,
        "error: line 5: there is no joint `z` in this text\n"
    );
    assert_eq!(folder.text("a.mech"), FOUR_BAR);
    assert_eq!(folder.names(), ["a.mech", "script.txt"]);
}

#[test]
fn exit_codes_tell_what_a_script_was_refused_for() {
    let run = |script: &str| {
        let folder = Folder::new()
            .with("script.txt", script)
            .with("a.mech", FOUR_BAR);
        let Answer { code, err, .. } = folder.mech("run script.txt");
        (code, err)
    };
    let refused = |code, text: &str| (Some(code), text.to_owned());
    assert_eq!(run(""), (Some(0), String::new()));
    assert_eq!(run("quit\nnonsense"), (Some(0), String::new()));
    assert_eq!(
        run("nonsense"),
        refused(
            2,
            "error: line 1: unknown command `nonsense`; `help` lists all\n"
        )
    );
    assert_eq!(
        run("\nreport"),
        refused(
            2,
            "error: line 2: there is no mechanism yet; begin with `mechanism NAME`, or `open FILE`\n"
        )
    );
    assert_eq!(
        run("link a"),
        refused(
            1,
            "error: line 1: there is no mechanism yet; begin with `mechanism NAME`\n"
        )
    );
    let (code, err) = run("open nothing.mech");
    assert_eq!(code, Some(3));
    assert!(
        err.starts_with("error: line 1: cannot read `nothing.mech`: "),
        "{err}"
    );
    // What is there already is not written over.
    let (code, err) = run("mechanism A\nsave a.mech");
    assert_eq!(
        (code, &*err),
        (
            Some(3),
            "error: `a.mech` is there already; `open` it to change it\n"
        )
    );
    let (code, err) = run("mechanism A\nlink a\ncheck");
    assert_eq!(code, Some(1));
    assert!(
        err.ends_with("error: line 3: `check` was refused\n"),
        "{err}"
    );
    let answer = Folder::new().mech("run nothing.txt").refused(3);
    assert!(
        answer.starts_with("error: cannot read `nothing.txt`: "),
        "{answer}"
    );
}

#[test]
fn lines_that_do_not_fit_are_told_what_would() {
    let folder = Folder::new();
    let said = |line: &str| say(&folder, line).err;
    assert_eq!(
        said("lnik a"),
        "error: unknown command `lnik`; did you mean `link`?\n"
    );
    assert_eq!(
        said("point crank.pin (1, 0)"),
        "error: expected `at`, found `(1, 0)`; say `point PATH at (x, y)`\n"
    );
    assert_eq!(
        said("motor"),
        "error: expected a joint; say `motor JOINT [= LAW] [in LOW ..= HIGH] [by STEP]`\n"
    );
    assert_eq!(
        said("undo now"),
        "error: expected the end of the line, found `now`; say `undo`\n"
    );
    assert_eq!(
        said("point a.b at (1, 0"),
        "error: `(` is not closed in `(1, 0`\n"
    );
    assert_eq!(
        said("point a.b at (1)"),
        "error: expected a place as `(1, 2)`, found `(1)`\n"
    );
    assert_eq!(said("move a.b to (1, inf)"), "error: `inf` is not finite\n");
    assert_eq!(
        said("help nothing"),
        "error: there is no command `nothing`; `help` lists all\n"
    );
    assert_eq!(said("undo"), "error: there is nothing to undo\n");
    assert_eq!(
        said("save"),
        "error: the text has no file yet; say `save FILE`\n"
    );
    // Every code is that of the last line that was refused.
    assert_eq!(say(&folder, "undo\n").code, Some(2));
    assert_eq!(
        say(&folder, "mechanism A\nremove joint a\nundo\n").code,
        Some(1)
    );
}

#[test]
fn steps_are_undone_and_done_again() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let lines = "open a.mech\nremove joint d\nrename coupler rod\nundo\nsteps\nredo\nundo\nundo\ntext\nredo\nundo\nlink spare\nredo\n";
    let answer = say(&folder, lines);
    assert_eq!(answer.err, "error: there is nothing to redo\n");
    assert!(
        answer.out.contains(
            "undone: rename coupler to rod\nremove joint d\ndone again: rename coupler to rod\n"
        ),
        "{}",
        answer.out
    );
    // The very bytes.
    assert!(
        answer
            .out
            .contains(&format!("undone: remove joint d\n{FOUR_BAR}")),
        "{}",
        answer.out
    );
    assert_eq!(folder.text("a.mech"), FOUR_BAR);
}

#[test]
fn repairs_are_listed_and_made() {
    let folder = Folder::new().with("a.mech", FOUR_BAR.replace("motor a;\n", ""));
    let answer = say(
        &folder,
        "open a.mech\nrepairs\nrepair 1\nrepairs\nrepair 1\nsave\n",
    );
    assert!(
        answer.out.starts_with("1: add `motor a;`\n"),
        "{}",
        answer.out
    );
    assert!(
        answer
            .out
            .contains("repair 1: add `motor a;`\n  FourBar moves: "),
        "{}",
        answer.out
    );
    assert!(
        answer.out.ends_with("nothing is wrong\nsaved `a.mech`\n"),
        "{}",
        answer.out
    );
    assert_eq!(answer.err, "error: no repair is known\n");
    assert_eq!(folder.text("a.mech"), FOUR_BAR);
}

#[test]
fn a_file_that_somebody_else_changed_is_not_written_over() {
    let folder = Folder::new()
        .with("a.mech", FOUR_BAR)
        .with("script.txt", "open a.mech\nlink b\n");
    // The dialogue holds the file while it is changed: its second line is only read after that.
    let mut child = begin(&folder);
    let mut input = child.stdin.take().expect("an input");
    let mut output = child.stdout.take().expect("an output");
    input
        .write_all(b"open a.mech\nsteps\nremove joint d\n")
        .expect("it listens");
    input.flush().expect("it listens");
    let mut first = [0; 1];
    // It answers when it has read the file.
    std::io::Read::read_exact(&mut output, &mut first).expect("an answer");
    fs::write(folder.path("a.mech"), "struct Other;").expect("a file");
    input.write_all(b"save\n").expect("it listens");
    drop(input);
    let mut others = String::new();
    std::io::Read::read_to_string(&mut output, &mut others).expect("UTF-8");
    let mut complaint = String::new();
    let mut errors = child.stderr.take().expect("an output");
    std::io::Read::read_to_string(&mut errors, &mut complaint).expect("UTF-8");
    assert_eq!(child.wait().expect("it ends").code(), Some(3));
    assert_eq!(
        complaint,
        "error: `a.mech` was changed by another program after it was read; nothing is written\n"
    );
    assert_eq!(folder.text("a.mech"), "struct Other;");
}

#[test]
fn what_is_asked_is_answered_of_the_text_as_it_is_now() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let answer = say(
        &folder,
        "open a.mech\nmove d to (4.5, 0)\ncheck\ntable coupler.tip --steps 2\nnumbers d\ndraw a.svg with --overlay\nopen a.mech\n",
    );
    assert_eq!(
        answer.err,
        "error: the text has changes; `save` or `undo` them first\n"
    );
    let table = answer.out.split_once("motor a").expect("a table").1;
    let moved = FOUR_BAR.replace("(4, 0)", "(4.5, 0)");
    let folder_of_moved = Folder::new().with("b.mech", moved);
    let expected = folder_of_moved
        .mech("table b.mech coupler.tip --steps 2")
        .done();
    assert!(
        format!("motor a{table}").starts_with(&expected),
        "{}",
        answer.out
    );
    assert!(
        answer.out.ends_with("d x = 4.5\nd y = 0\n"),
        "{}",
        answer.out
    );
    assert_eq!(folder.names(), ["a.mech", "a.svg"]);
    assert_eq!(folder.text("a.mech"), FOUR_BAR);
}

#[test]
fn all_that_can_be_said_is_listed() {
    let help = say(&Folder::new(), "help\n").done();
    for line in [
        "point PATH at (x, y)\n",
        "undo\n",
        "draw|film FILE... [with WORDS...]\n",
    ] {
        assert!(help.contains(line), "{help}");
    }
    let topic = say(&Folder::new(), "help remove\n").done();
    assert_eq!(topic.matches("\n    ").count(), 2, "{topic}");
}

/// The dialogue of README can be had, line by line: what it says is refused is, and nothing else.
#[test]
fn the_dialogue_of_the_readme_can_be_had() {
    let readme = fs::read_to_string(repository("README.md")).expect("a page");
    let lines = readme
        .lines()
        .filter_map(|line| line.strip_prefix("mech> "));
    let lines: Vec<&str> = lines.collect();
    let refused = lines
        .iter()
        .filter(|line| line.contains("# refused"))
        .count();
    assert!(lines.len() > 6 && refused == 1, "{lines:?}");
    let folder = Folder::new().with("four_bar.mech", FOUR_BAR);
    let answer = say(&folder, &(lines.join("\n") + "\n"));
    assert_eq!(
        answer.err.matches("error:").count(),
        refused,
        "{}",
        answer.err
    );
    assert!(answer.err.contains("rule of assembly"), "{}", answer.err);
    assert!(
        folder.text("four_bar.mech").contains("rod.tip")
            || folder.text("four_bar.mech").contains("link rod")
    );
}

#[test]
fn a_load_brings_the_effect_that_asks_for_it() {
    for more in [
        "",
        "effects { velocity; }",
        "effects { force; }",
        "effects { dynamics; }",
    ] {
        let folder = Folder::new().with(
            "a.mech",
            FOUR_BAR.replace("link crank;", "link crank { mass 1 at (1, 0); }") + more,
        );
        say(
            &folder,
            "open a.mech\nload push = force(coupler.tip)\nload twist = torque(rocker)\nsave\n",
        )
        .done();
        folder.mech("check a.mech").done();
        let text = folder.text("a.mech");
        assert_eq!(
            text.matches("force;").count() + text.matches("dynamics;").count(),
            1,
            "{text}"
        );
    }
}
