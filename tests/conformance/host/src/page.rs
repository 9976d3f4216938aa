//! The figures where people read them.

use crate::board::Board;
use crate::error::Error;
use crate::figures::{Figures, is_method};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Between these lines of the page the figures stand.
const MARKS: [&str; 2] = ["<!-- figures -->\n", "<!-- /figures -->"];

/// Writes the figures: those of all compilers as a table for programs, and those of the first into the page for people.
pub(crate) fn write(docs: &Path, all: &[Figures]) -> Result<(), Error> {
    put(&docs.join("embedded.csv"), &Figures::table(all))?;
    let Some(figures) = all.first() else {
        return Ok(());
    };
    let path = docs.join("embedded.md");
    let page = get(&path)?;
    let errors = get(&docs.join("accuracy.csv"))?;
    let parts = page.split_once(MARKS[0]).and_then(|(before, others)| {
        let (_, after) = others.split_once(MARKS[1])?;
        Some((before, after))
    });
    let (before, after) = parts
        .ok_or_else(|| Error::Line { text: format!("{}: no marks for figures", path.display()) })?;
    let [start, end] = MARKS;
    let tables = format!(
        "\nBy {}, `opt-level = \"s\"`, bytes and instructions:\n\n{}\n{}\n",
        figures.compiler,
        methods(figures, &errors),
        gallery(figures)
    );
    put(&path, &format!("{before}{start}{tables}{end}{after}"))
}

fn get(path: &Path) -> Result<String, Error> {
    fs::read_to_string(path).map_err(|source| Error::File { path: path.to_owned(), source })
}

fn put(path: &Path, text: &str) -> Result<(), Error> {
    fs::write(path, text).map_err(|source| Error::File { path: path.to_owned(), source })
}

/// The four-bar by every method: the embedded column of the price list.
fn methods(figures: &Figures, errors: &str) -> String {
    let mut text = String::from(
        "| four-bar | error at 1° | state | M4F: flash | stack | instructions | M0+: flash | stack | instructions |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for method in ["exact", "newton", "newton_3", "newton_2", "newton_1", "linear"] {
        for precision in ["f32", "f64"] {
            let image = format!("{method}_{precision}");
            let [Some(float), Some(whole)] = Board::ALL.map(|board| figures.row(board, &image))
            else {
                continue;
            };
            let title = match method.split_once('_') {
                None => method.to_owned(),
                Some((method, rounds)) => format!("{method}({rounds})"),
            };
            let error = error(errors, &title, precision).unwrap_or_default();
            let [flash, state, stack, instructions, ..] = float.values;
            let [whole_flash, _, whole_stack, whole_instructions, ..] = whole.values;
            // Writing into a string cannot fail.
            let _ = writeln!(
                text,
                "| `{title}` {precision} | {error} | {state} | {flash} | {stack} | {instructions} | {whole_flash} | \
                 {whole_stack} | {whole_instructions} |"
            );
        }
    }
    text
}

/// The error of the four-bar by a method, from the price list of accuracy.
fn error(errors: &str, method: &str, precision: &str) -> Option<String> {
    let start = format!("four-bar,{method},{precision},1,");
    let line = errors.lines().find_map(|line| line.strip_prefix(&start))?;
    let (error, _) = line.split_once(',')?;
    Some(error.to_owned())
}

/// The gallery.
fn gallery(figures: &Figures) -> String {
    let mut text = String::from(
        "| | state | M4F: flash | stack, to move | instructions, to move | stack, to draw | instructions, to move and draw | M0+: \
         instructions, to move | to move and draw |\n|---|---|---|---|---|---|---|---|---|\n",
    );
    let rows = figures.rows.iter().filter(|row| {
        row.board == Board::CortexM4F.name() && !is_method(&row.image) && row.values[1] > 0
    });
    for row in rows {
        let [flash, state, stack, instructions, drawing, frame] = row.values;
        let whole = figures.row(Board::CortexM0, &row.image).map(|row| row.values);
        let [_, _, _, whole, _, whole_frame] = whole.unwrap_or_default();
        // What has no shapes is not drawn.
        let [drawing, frame, whole_frame] =
            [drawing, frame, whole_frame].map(|value| match value {
                0 => String::new(),
                value => value.to_string(),
            });
        let title = row.image.replace('_', " ");
        let _ = writeln!(
            text,
            "| {title} | {state} | {flash} | {stack} | {instructions} | {drawing} | {frame} | {whole} | {whole_frame} |"
        );
    }
    text
}
