//! What a mechanism does, in an engineer's words, before how it is solved.

#[cfg(feature = "editor")]
mod failing;
mod four_bar;
mod motion;
mod requirements;
mod words;

use crate::failure::Failure;
use four_bar::four_bars;
use mech_compiler::Compiled;
use mech_compiler::model::Model;
pub(crate) use requirements::Judged;

/// A mechanism with more joints is not measured for its report.
const MOST_JOINTS: usize = 300;

/// The report: ranges of motors, what they drive, four-bars; then the compiler's own, with a legend.
pub(crate) fn report(model: &Model, compiled: &Compiled) -> Result<String, Failure> {
    let text = compiled.report.trim_end();
    let (name, solution) = text.split_once('\n').unwrap_or((text, ""));
    Ok(format!(
        "{name}\n{}{solution}\n  legend    + additions, × multiplications, ÷ divisions, √ square roots, ≷ comparisons\n",
        motion_and_requirements(model, compiled)?.0
    ))
}

/// What a mechanism does and is for, as the lines of a report, and what is expected of it.
fn motion_and_requirements(
    model: &Model,
    compiled: &Compiled,
) -> Result<(String, Vec<Judged>), Failure> {
    let motion = motion(model, compiled)?;
    let requirements = requirements::judged(model, compiled)?;
    Ok((motion + &lines(requirements::lines(&requirements)), requirements))
}

/// What a mechanism does, and whether it does what it is for.
#[cfg(feature = "editor")]
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Behaviour {
    /// The lines of a report.
    pub(crate) lines: String,
    /// What is expected of it, in the order of declaration.
    pub(crate) requirements: Vec<Judged>,
}

#[cfg(feature = "editor")]
impl Behaviour {
    pub(crate) fn of(model: &Model, compiled: &Compiled) -> Result<Self, Failure> {
        let (lines, mut requirements) = motion_and_requirements(model, compiled)?;
        failing::sample(&mut requirements, model, compiled)?;
        Ok(Self { lines, requirements })
    }
}

/// How far each motor goes, and what ends it, if that is soon known: not of a large mechanism, nor where loops are solved together.
pub(crate) fn ranges(model: &Model, compiled: &Compiled) -> Result<Vec<String>, Failure> {
    let is_coupled = compiled.plan.loops().any(|ring| ring.unknowns().len() > 3);
    if model.joints.len() > MOST_JOINTS || is_coupled {
        return Ok(Vec::new());
    }
    motion::ranges(model, compiled)
}

/// What it does, as the lines of a report.
fn motion(model: &Model, compiled: &Compiled) -> Result<String, Failure> {
    if model.joints.len() > MOST_JOINTS {
        return Ok(format!(
            "  motion    not measured, as there are more than {MOST_JOINTS} joints; ask `mech table --summary`\n"
        ));
    }
    let mut lines = motion::lines(model, compiled)?;
    let four_bars = four_bars(model);
    lines.extend(four_bars.map(|found| ("four-bar".to_owned(), found)));
    Ok(self::lines(lines))
}

/// Labels and texts as the lines of a report.
fn lines(lines: Vec<(String, String)>) -> String {
    let lines = lines.into_iter();
    let lines = lines.map(|(label, text)| format!("  {label:<9} {text}\n"));
    lines.collect()
}
