//! The price list as text: for a terminal, and as comma-separated values.

use crate::frontier::is_worth;
use crate::measurement::{Measurement, Row, STEPS, Stuck};
use std::fmt::Write;

/// The columns of one step in the terminal.
const WIDTH: usize = 27;

/// The table for a terminal: a row for each method and precision, three columns for each step.
pub(crate) fn table(measurement: &Measurement) -> String {
    let mut text = format!(
        "\n{}, size {:.4}, the motor goes {}° and back\n\n{:14}",
        measurement.subject.title, measurement.size, measurement.subject.travel, ""
    );
    for step in STEPS {
        text += &format!("{:^WIDTH$}", format!("{}° a step", step.degrees()));
    }
    text += &format!("\n{:14}", "");
    for _ in STEPS {
        text += &format!("{:>9} {:>8} {:>6}  ", "error", "/ size", "ns");
    }
    text.push('\n');
    for contestant in &measurement.subject.contestants {
        let (method, precision) = (contestant.method, contestant.precision);
        text += &format!("{method:10}{precision:4}");
        for step in STEPS {
            let mut rows = measurement.rows.iter();
            let found = rows
                .find(|row| row.method == method && row.precision == precision && row.step == step);
            text += &found.map_or_else(String::new, |row| cell(measurement, row));
        }
        text.push('\n');
    }
    text
}

fn cell(measurement: &Measurement, row: &Row) -> String {
    let star = if is_worth(measurement, row) { "*" } else { " " };
    match &row.outcome {
        Ok(figures) => format!(
            "{:>9.1e} {:>8.1e} {:>6.1}{star} ",
            figures.error,
            figures.error / measurement.size,
            figures.nanoseconds
        ),
        Err(stuck) => format!("{:>WIDTH$}", format!("{}  ", describe_block(stuck))),
    }
}

/// The place where it was blocked, in a few words.
pub(crate) fn describe_block(stuck: &Stuck) -> String {
    let joints = stuck.place.replace(['`', ' '], "");
    format!("blocked {:.1}° {joints}", stuck.degrees)
}

/// The comma-separated values, one line for each row.
pub(crate) fn csv(measurements: &[Measurement]) -> String {
    let mut text = String::from(
        "mechanism,method,scalar,step_degrees,error,error_by_size,nanoseconds,worth_its_price,blocked\n",
    );
    for measurement in measurements {
        for row in &measurement.rows {
            let figures = match &row.outcome {
                Ok(figures) => format!(
                    "{:.3e},{:.3e},{:.1},{},",
                    figures.error,
                    figures.error / measurement.size,
                    figures.nanoseconds,
                    is_worth(measurement, row)
                ),
                Err(stuck) => format!(",,,false,\"{}\"", stuck.words.replace('"', "\"\"")),
            };
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{figures}",
                measurement.subject.slug,
                row.method,
                row.precision,
                row.step.degrees()
            );
        }
    }
    text
}
