//! The cost of effects: zero where they are not declared.
//!
//! `cargo effects` measures four mechanisms with and without effects, prints the table and renews
//! `docs/effects.md`.

mod measure;
mod motion;
mod subjects;

use measure::{Row, measure_all};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

/// The beginning of the page.
const HEAD: &str = "# What effects cost\n\n\
    Written by `cargo effects`, which measures everything on this page anew; do not edit it by hand.\n\n\
    Each mechanism is compiled from one text, with its masses and gravity in it: with nothing asked of it, and with one effect \
    after another. `trace` keeps the last 256 places of a point; the last row shows one link only. What was not asked for is not \
    there. The step to a position is the same, token for token, in all of them (`tests/tests/expand.rs` holds it to that).\n\n\
    **Operations** are those of a position and, after the plus, what the effect adds. For motion under forces that is added each of \
    the about ten times that a step of time looks at its forces. **Time** is that of one such move, sine and cosine included, the \
    next needing the last. It is the median of many rounds in which all take turns. **State** is the size of the struct. **Code** \
    is the size of the functions that make such \
    moves, without those that are only called when something is in the way.\n\n\
    The last mechanism shows what watching costs. A loop that may come to a dead point is watched: each move compares how near it is. \
    A range that keeps it away is proved at compile time, and nothing is watched then.\n\n";

fn main() -> ExitCode {
    match run(&env::args().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), String> {
    let quick = match &arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--quick"] => true,
        _ => return Err("there is only `--quick`: measure briefly, and write nothing".to_owned()),
    };
    let rounds = if quick { 5 } else { 201 };
    let mut table = String::new();
    for (title, subjects) in subjects::subjects() {
        let rows = measure_all(&subjects, rounds)?;
        table += &section(title, &rows);
    }
    table += &motion::section(if quick { 20 } else { 1000 })?;
    writeln!(io::stdout(), "{table}").map_err(|error| error.to_string())?;
    if quick {
        return Ok(());
    }
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/effects.md");
    fs::write(&page, format!("{HEAD}{table}"))
        .map_err(|error| format!("{}: {error}", page.display()))
}

/// The table of one mechanism.
fn section(title: &str, rows: &[Row]) -> String {
    let mut text = format!(
        "## {title}\n\n| | operations | ns | beside the first | state, bytes | code, bytes |\n|---|---|---|---|---|---|\n"
    );
    let first = rows.first().map_or(f64::NAN, |row| row.nanoseconds);
    for row in rows {
        let code = row.code.map_or("not known here".to_owned(), |code| code.to_string());
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {} | {:.1} | {:.2} | {} | {code} |",
            row.name,
            row.operations,
            row.nanoseconds,
            row.nanoseconds / first,
            row.state
        );
    }
    text + "\n"
}
