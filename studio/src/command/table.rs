//! `mech table`.

use super::measure::{Measure, QUANTITIES};
use super::{CODES, Target};
use crate::console::Console;
use crate::failure::Failure;
use crate::output;
use crate::quantity;
use clap::Args;
use std::path::PathBuf;

/// Measures a mechanism through the motion of a motor, as CSV.
#[derive(Args, Clone, Debug)]
#[command(after_help = [QUANTITIES, "\n\n", EXAMPLES].concat(), after_long_help = [QUANTITIES, "\n\n", EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Table {
    #[command(flatten)]
    pub(super) target: Target,
    #[command(flatten)]
    measure: Measure,
    /// The file to write; without, the table is the answer.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

const EXAMPLES: &str = "\
Examples:
  mech table four_bar.mech
  mech table four_bar.mech coupler.tip velocity:coupler.tip.norm --steps 72 -o tip.csv
  mech table press.mech torque:crank transmission --from 0 --to 180 --rate 10.5 --length m --force N";

impl Table {
    pub(super) fn run(&self, console: &mut Console) -> Result<(), Failure> {
        let (_, table) = self.measure.table(&self.target, console)?;
        let text = csv(&table);
        match &self.output {
            Some(path) => output::replace(path, text.as_bytes()),
            None => console.answer(text),
        }
    }
}

/// The table as CSV: `motor a [deg],b [deg]`. Where it is over another quantity, that takes the place of the motor.
fn csv(table: &quantity::Table) -> String {
    let names = table.columns[table.across..].iter();
    let names = names.map(|(name, unit)| cell(&format!("{name} [{unit}]")));
    let mut text = names.collect::<Vec<_>>().join(",") + "\n";
    for row in &table.rows {
        let cells = row[table.across..]
            .iter()
            .map(|value| value.map_or(String::new(), |value| format!("{}", value + 0.0)));
        text += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    text
}

/// A text as a cell: in quotes if it needs them.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
