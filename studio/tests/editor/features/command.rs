//! The command `mech`: what its help, its answers and its complaints list.

use std::path::Path;
use std::process::{Command, Stdio};
use std::{env, fs};

const STILL: &str = "struct FourBar; link crank; link coupler { point tip = (2.5, 3); }
link rocker; joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, coupler) at (0.8, 0.6);
joint c = revolute(coupler, rocker) at (3.3, 2.9); joint d = revolute(ground, rocker) at (4, 0);";

/// Returns the output of the command, in a folder with some files.
fn mech(words: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("features");
    fs::create_dir_all(&folder).expect("a folder");
    let write = |name, text: &str| fs::write(folder.join(name), text).expect("a file");
    write("a.mech", &format!("{STILL} motor a;"));
    write("still.mech", STILL);
    write("a.zyx", "zyx\n");
    write("help", "help\n");
    write("numbers", "numbers\n");
    write("everything.mech", include_str!("everything.mech"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_mech"));
    command.args(words.split(' ')).stdin(Stdio::null());
    let output = command.current_dir(folder).output();
    let output = output.expect("the command runs");
    String::from_utf8([output.stdout, output.stderr].concat()).expect("UTF-8")
}

/// Commands, and options with their values.
pub(super) fn helps() -> Vec<String> {
    let help = mech("-h");
    let (_, commands) = help.split_once("Commands:\n").expect("commands");
    let commands = commands.lines().map_while(|line| line.split_whitespace().next());
    let mut found = Vec::new();
    for command in ["-h"].into_iter().chain(commands) {
        let help = mech(&format!("{command} -h"));
        let is_option = |line: &&str| line.starts_with(['-', '<', '[', 'U']);
        let lines = help.lines().map(str::trim_start).filter(is_option);
        // As wide as it is, not as the longest option makes it.
        let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        found.extend(lines.map(|line| format!("{command} {}", words(line))));
    }
    found
}

/// Lists the dialogue's lines, the roles of numbers that it sets, the endings of written files, imported formats, and keys of JSON answers.
pub(super) fn answers() -> Vec<String> {
    let all = "run help|run numbers everything.mech|draw a.mech -o a.zyx|film a.mech -o a.zyx|plot a.mech -o a.zyx\
        |play a.mech --picture a.zyx|import a.zyx|check still.mech --json";
    let mut found: Vec<String> = Vec::new();
    for words in all.split('|') {
        for line in mech(words).lines().filter(|line| !line.trim().is_empty()) {
            let (key, _) = line.trim().split_once("\": ").unwrap_or((line, ""));
            let line = format!("{words}: {key}");
            found.extend((!found.contains(&line)).then_some(line));
        }
    }
    found
}

/// Lists the quantities that `mech table` measures of a four-bar linkage.
pub(super) fn quantities() -> Vec<String> {
    let complaint = mech("table a.mech zyx:a");
    let kinds = complaint.split('`').skip(3).step_by(2);
    let mut found = Vec::new();
    for kind in kinds.map(|kind| format!("{kind}:")).chain([String::new()]) {
        for subject in ["a", "coupler", "coupler.tip", "transmission", "t"] {
            for part in ["", ".x", ".y", ".norm", ".torque"] {
                let name = format!("{kind}{subject}{part}");
                let table = mech(&format!("table a.mech {name} --steps 1"));
                let columns = table.lines().next().unwrap_or_default();
                found.extend((!columns.starts_with("error")).then(|| format!("{name}: {columns}")));
            }
        }
    }
    found
}
