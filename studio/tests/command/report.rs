//! `mech report`, `mech graph`, `mech completions` and the help.

use crate::run::{FOUR_BAR, Folder, rust};

#[test]
fn the_report_is_that_of_the_macro() {
    let folder = Folder::new().with("a.mech", FOUR_BAR).with("a.rs", rust());
    let report = folder.mech("report a.mech").done();
    assert!(report.starts_with("FourBar"), "{report}");
    assert!(report.contains("mobility"), "{report}");
    assert_eq!(folder.mech("report a.rs -m FourBar").done(), report);
    let refusal = folder.mech("report a.rs -m Loose").refused(1);
    assert!(refusal.starts_with("error: there is no motor"), "{refusal}");
}

#[test]
fn graphs_are_in_dot() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let links = folder.mech("graph a.mech").done();
    assert!(
        links.starts_with("graph \"FourBar: links and joints\" {"),
        "{links}"
    );
    assert!(
        links.contains("n0 -- n1 [label=\"a\\nrevolute\\nmotor\""),
        "{links}"
    );
    let loops = folder.mech("graph a.mech --of loops").done();
    assert!(loops.starts_with("digraph \"FourBar: loops\" {"), "{loops}");
    let common = folder.mech("graph a.mech --of common-joints").done();
    assert!(common.contains("loops with joints in common"), "{common}");
    let refusal = folder.mech("graph a.mech --of knots").refused(2);
    assert!(
        refusal.contains("possible values: links, loops, common-joints"),
        "{refusal}"
    );
}

#[test]
fn a_graph_goes_to_a_file() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let graph = folder.mech("graph a.mech --of loops").done();
    assert_eq!(folder.mech("graph a.mech --of loops -o a.dot").done(), "");
    assert_eq!(folder.text("a.dot"), graph);
}

#[test]
fn the_help_has_examples_and_exit_codes() {
    let folder = Folder::new();
    for command in [
        "check",
        "fix",
        "report",
        "graph",
        "draw",
        "film",
        "table",
        "plot",
        "completions",
    ] {
        let help = folder.mech(&format!("{command} --help")).done();
        assert!(help.contains("Examples:\n  mech "), "{help}");
        assert!(help.contains("Exit codes:"), "{help}");
    }
    assert!(folder.mech("--help").done().contains("Exit codes:"));
    assert!(folder.mech("completions bash").done().contains("_mech"));
    assert!(folder.mech("--version").done().starts_with("mech "));
    folder.mech("mend").refused(2);
}
