//! The page `docs/accuracy.md`, and the machine that measures.

use crate::frontier::{frontier, never_worth};
use crate::measurement::{Effort, Figures, Measurement, STEPS};
use crate::method::Method;
use crate::table::describe_block;
use std::num::NonZero;
use std::{env, fs, thread};

/// The page, in Markdown.
pub(crate) fn article(measurements: &[Measurement], effort: Effort) -> String {
    let mut text = format!(
        "# What a method costs, and how exact it is\n\n\
         Written by `cargo accuracy`, which measures everything on this page anew; do not edit it by \
         hand.\n\n\
         ![Error against time for {} mechanisms](accuracy.png)\n\n\
         ([the same as SVG](accuracy.svg); [all figures](accuracy.csv))\n\n",
        measurements.len()
    );
    text += "## What is measured\n\n";
    text += &format!(
        "Each mechanism is compiled from one text with every method, in `f32` and in `f64`. Its motor goes from the start to a \
         limit and back, in steps of {} degrees. **Error** is the greatest distance, in any position on that way, between an axis \
         of a moving link and where it ought to be. Beside it stands the same divided by the mechanism's size (the greatest \
         distance between two axes at the start). **Time** is that of one `move_to` with a new value of the motor, sine and cosine \
         included, each position needed before the next. It is the median of {} rounds, in which all methods take turns, each with \
         at least {} positions.\n\n",
        steps(),
        effort.rounds,
        effort.positions
    );
    text += "The compiler's own interpreter computes in thirty digits where it ought to be, for the same floats that the motor was \
             given. It is then corrected until the joints, as they are declared, close in all these digits. So an error in `f32` is \
             also that of lengths rounded to `f32`.\n\n";
    text += "A position that does not close well enough is refused. Where that happens on the way, the method is **blocked** at \
             that step and has no price there.\n\n";
    text += "## How to read the picture\n\n\
             Left is cheaper, down is more exact. Colour and shape tell the method, full marks are `f64`, hollow ones `f32`; the \
             larger a mark, the longer the motor's step. The marks of one method hang on a line. The grey steps are the frontier at \
             each step of the motor, darkest for the longest. What lies right of it or above it is beaten by something that is \
             named on it. Loops that are coupled have no closed form: there `exact` is `newton`, and their marks are in one \
             place. How fast they come to a dead point is guessed. So a step of more than a degree is divided into pieces. One of 5 \
             degrees costs some five times as much as one of a degree.\n\n";
    text += "## What is worth its price\n\n\
             What is not beaten at a step of the motor: nanoseconds a position, error, and in brackets error by size. All errors and \
             times are in the [table](accuracy.csv).\n\n";
    text += &worth_list(measurements);
    text += &reading(measurements);
    text += &blocked_list(measurements);
    text += &format!(
        "## The machine\n\n\
         {}. Other builds may have been running on it. Nanoseconds differ from machine to machine and with the load: compare them \
         with each other, and run the command for your own. Times or errors within 4 % count as the same. Errors are the same on \
         every machine.\n",
        machine()
    );
    text
}

fn steps() -> String {
    let steps: Vec<String> = STEPS.iter().map(|step| step.degrees().to_string()).collect();
    match steps.split_last() {
        Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => steps.concat(),
    }
}

/// The section on methods that are worth their price.
fn worth_list(measurements: &[Measurement]) -> String {
    let heads = STEPS.map(|step| format!(" {}° |", step.degrees()));
    let rules = STEPS.map(|_| "---|");
    let mut text = format!("| mechanism | |{}\n|---|---|{}\n", heads.concat(), rules.concat());
    for measurement in measurements {
        let frontiers = STEPS.map(|step| frontier(measurement, step));
        for contestant in &measurement.subject.contestants {
            let (method, precision) = (contestant.method, contestant.precision);
            let cells = frontiers.each_ref().map(|frontier| {
                let mut rows = frontier.iter();
                let row = rows.find(|row| row.method == method && row.precision == precision);
                let figures = row.and_then(|row| row.outcome.as_ref().ok());
                figures.map(|figures| describe_price(figures, measurement.size))
            });
            if cells.iter().any(Option::is_some) {
                let cells = cells.map(|cell| format!(" {} |", cell.unwrap_or_default()));
                let title = measurement.subject.title;
                text += &format!("| {title} | `{method}` {precision} |{}\n", cells.concat());
            }
        }
    }
    text.push('\n');
    text
}

fn describe_price(figures: &Figures, size: f64) -> String {
    format!("{:.0} ns, {:.1e} ({:.0e})", figures.nanoseconds, figures.error, figures.error / size)
}

/// The section on conclusions.
fn reading(measurements: &[Measurement]) -> String {
    let is_exact = |measurement: &&Measurement| {
        let mut worth = STEPS.into_iter().flat_map(|step| frontier(measurement, step));
        worth.all(|row| row.method == Method::Exact)
    };
    let exact: Vec<&str> =
        measurements.iter().filter(is_exact).map(|measurement| measurement.subject.title).collect();
    let mut text = String::new();
    if !exact.is_empty() {
        text += &format!(
            "Nothing but `exact` is worth its price, at any step, in {} of {} mechanisms. These are {}.\n",
            exact.len(),
            measurements.len(),
            exact.join(", ")
        );
    }
    let never: Vec<String> =
        never_worth(measurements).iter().map(|method| format!("`{method}`")).collect();
    if !never.is_empty() {
        text += &format!("Worth its price in none, at no step: {}.\n", never.join(", "));
    }
    text.push('\n');
    text
}

/// The section on blocked methods.
fn blocked_list(measurements: &[Measurement]) -> String {
    let mut text = String::new();
    for measurement in measurements {
        for row in &measurement.rows {
            if let Err(stuck) = &row.outcome {
                text += &format!(
                    "| {} | `{}` {} | {}° | {} |\n",
                    measurement.subject.title,
                    row.method,
                    row.precision,
                    row.step.degrees(),
                    describe_block(stuck)
                );
            }
        }
    }
    if text.is_empty() {
        return text;
    }
    format!(
        "## What was blocked\n\n\
         At this angle from the start the loop did not close well enough. A fixed number of rounds is held to what it promises. The \
         gap after `newton(k)` may be a thousandth of the loop's size, squared k − 1 times, or rounding if that is more. So \
         more rounds can be refused where fewer pass, and `f64` where `f32` passes.\n\n\
         | mechanism | method | step | |\n|---|---|---|---|\n{text}\n"
    )
}

/// The name of the machine.
fn machine() -> String {
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    let (arch, system) = (env::consts::ARCH, env::consts::OS);
    let name = name().map(|name| format!("{name}, ")).unwrap_or_default();
    let processors = match processors {
        1 => "1 processor".to_owned(),
        more => format!("{more} processors"),
    };
    format!("{name}{processors}, {arch}, {system}")
}

/// The processor's name, where the system has it in a file.
fn name() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}
