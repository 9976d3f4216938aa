//! Numbers that a message offers as they were written.

use super::setting::with_crank;

#[test]
fn a_number_is_offered_as_it_was_written() {
    for (text, offered) in [
        ("90 deg", "90 deg"),
        ("90deg", "90 deg"),
        ("1_000.50", "1000.50"),
        ("2.5e3", "2.5e3"),
        ("2 * PI / 3", "2 * PI / 3"),
        ("1 + 2 - 3 * 4 + 20", "1 + 2 - 3 * 4 + 20"),
        ("(1 + 2) * 3", "(1 + 2) * 3"),
        ("8 / (1 + 1)", "8 / (1 + 1)"),
        ("8 / (2 * 3)", "8 / (2 * 3)"),
        ("9 - (1 - 2)", "9 - (1 - 2)"),
        ("(3)", "3"),
        ("-(-3)", "-(-3)"),
        ("--3", "3"),
        ("3 * -(1 - 2)", "3 * -(1 - 2)"),
        ("(10 + 20) deg", "(10 + 20) deg"),
        ("-(-20) deg", "-(-20) deg"),
        ("(-(-20)) deg", "(-(-20)) deg"),
        (
            "LONG * sqrt(1 + sin(30 deg))",
            "LONG * sqrt(1 + sin(30 deg))",
        ),
        ("cos(0) + tan(45 deg)", "cos(0) + tan(45 deg)"),
    ] {
        let settled = "const LONG = 100; motor shaft in";
        with_crank(
            &format!("{settled} «{text} ..= -1»;"),
            &[&format!(
                "the range of motor `shaft` ends before it begins; write `-1 ..= {offered}`"
            )],
        );
        with_crank(&format!("{settled} -LONG ..= {offered};"), &[]);
    }
}
