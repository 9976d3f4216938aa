//! Tables as text.

use crate::quantity::{Summary, Table, tick};
use mech_compiler::model::Precision;

/// The table as CSV: `motor a [deg],b [deg]`. Where it is over another quantity, that takes the place of the motor.
pub(super) fn csv(table: &Table) -> String {
    let names = table.columns[table.across..].iter();
    let names = names.map(|(name, unit)| cell(&format!("{name} [{unit}]")));
    let mut text = names.collect::<Vec<_>>().join(",") + "\n";
    let columns = table.across..table.columns.len();
    let sizes: Vec<f64> = columns.clone().map(|column| size(table, column)).collect();
    for row in &table.rows {
        let cells = columns.clone().zip(&sizes).map(|(column, size)| {
            let value = row[column];
            value.map_or(String::new(), |value| number(value, *size, table.precision))
        });
        text += &(cells.collect::<Vec<_>>().join(",") + "\n");
    }
    text
}

/// Summaries as CSV: a row for each quantity.
pub(super) fn summaries(summaries: &[Summary], precision: Precision) -> String {
    let mut text =
        "quantity,unit,least,at,greatest,at,extent,mean,rms,time ratio,dwell\n".to_owned();
    for one in summaries {
        let size = one.least.value.abs().max(one.greatest.value.abs());
        let value = |value: f64| number(value, size, precision);
        let cells = [
            cell(&one.name),
            cell(&one.unit),
            value(one.least.value),
            tick(one.least.by),
            value(one.greatest.value),
            tick(one.greatest.by),
            value(one.extent()),
            value(one.mean),
            value(one.rms),
            one.time_ratio.map(tick).unwrap_or_default(),
            one.dwell.map(tick).unwrap_or_default(),
        ];
        text += &(cells.join(",") + "\n");
    }
    text
}

/// The greatest number of a column.
fn size(table: &Table, column: usize) -> f64 {
    let values = table.rows.iter().filter_map(|row| row[column]);
    values.map(f64::abs).fold(0.0, f64::max)
}

/// A number without the digits that only rounding has put there, beside numbers of this size.
fn number(value: f64, size: f64, precision: Precision) -> String {
    if value.abs() < size * precision.epsilon() {
        return "0".to_owned();
    }
    match precision {
        #[expect(clippy::cast_possible_truncation, reason = "that is its precision")]
        Precision::F32 => format!("{}", value as f32 + 0.0),
        Precision::F64 => {
            let rounded: f64 = format!("{value:.15e}").parse().unwrap_or(value);
            format!("{}", rounded + 0.0)
        }
    }
}

/// A text as a cell: in quotes if it needs them.
fn cell(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
