//! Assembly and its rules.

use super::{NAMED, done_to, refused, revolute};
use mech_studio::{Assembly, Command, JointForm, Rule};

#[test]
fn assembly_obeys_its_rules() {
    let joined =
        |text: &str, name: &str, ends: [&str; 2]| refused(text, &revolute(name, ends)).rule();
    assert_eq!(
        joined(NAMED, "e", ["crank.o", "crank.b"]),
        Some(Rule::TwoLinks)
    );
    assert_eq!(
        joined(NAMED, "e", ["rocker.c", "coupler.c"]),
        Some(Rule::Once)
    );
    // A bar that cannot reach from one to the other.
    let text = NAMED
        .replace("joint d = revolute(ground.p, rocker.p);\n", "")
        .replace("(4, 0)", "(40, 0)");
    assert_eq!(
        joined(&text, "d", ["ground.p", "rocker.p"]),
        Some(Rule::Coincidence)
    );
    // A brace leaves no freedom.
    let text = format!(
        "{NAMED}link brace {{ point a = (0, 0); point b = (2, 0); }}\njoint e = revolute(ground.o, brace.a);\n"
    );
    let rule = joined(&text, "f", ["crank.b", "brace.b"]);
    assert!(
        matches!(rule, Some(Rule::Freedom | Rule::HeldOnce)),
        "{rule:?}"
    );
    let refusal = refused(&text, &revolute("f", ["crank.b", "brace.b"]));
    assert!(
        refusal
            .to_string()
            .starts_with("a rule of assembly forbids it: "),
        "{refusal}"
    );
    // What is no rule of assembly is a text that cannot be read.
    let refusal = refused(NAMED, &revolute("e", ["crank.nothing", "rocker.c"]));
    assert_eq!(refusal.rule(), None);
    assert!(
        refusal
            .to_string()
            .starts_with("the text could not be read any more: "),
        "{refusal}"
    );
}

#[test]
fn a_part_jumps_into_coincidence() {
    let text = "struct A;\nground { point o = (1, 2); }\nlink bar { point a = (0, 0); }\nlink tool { point t = (0, 0); }\njoint j = revolute(ground.o, bar.a);\nmotor j;\n";
    let applied = done_to(
        text,
        &Command::Join(Assembly {
            name: "w".to_owned(),
            kind: JointForm::Weld,
            ends: ["bar.a", "tool.t"].map(ToOwned::to_owned),
            at: None,
            along: None,
        }),
    );
    assert_eq!(applied.notes, ["tool stands at (1, 2), turned 0 deg"]);
}
