//! What is expected of a mechanism, and whether it was proved.

use crate::failure::Failure;
use mech_compiler::model::Model;
use mech_compiler::requirement::{Proof, judge};
use mech_compiler::{Compiled, catch, reporter};

/// Each requirement, as a line of a report: a label and a text.
pub(super) fn lines(model: &Model, compiled: &Compiled) -> Result<Vec<(String, String)>, Failure> {
    let judged = catch(|| judge(model, compiled)).map_err(Failure::internal)?;
    let requirements = model.requirements.iter().zip(judged);
    let lines = requirements.map(|(requirement, judged)| {
        let text = match judged {
            Ok(Proof { effort: 0 }) => format!("`{}`: proved", requirement.written),
            Ok(Proof { effort }) => {
                format!("`{}`: proved, by {effort} intervals", requirement.written)
            }
            Err(unmet) => {
                let text = reporter::text(&unmet, model);
                text.lines().next().unwrap_or_default().to_owned()
            }
        };
        ("expects".to_owned(), text)
    });
    Ok(lines.collect())
}
