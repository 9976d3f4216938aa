//! Limits that requirements would keep.

use super::{NewNumbers, Repair, edits};
use crate::digits::significant;
use crate::model::{Condition, Formula, Model, Requirement};
use crate::structure::Witness;
use crate::syntax::{Source, StatementText};
use std::ops::Range;

/// Limits are written with so many digits; with fewer if that is too near.
const DIGITS: [i32; 2] = [4, 3];

/// The nearest limit that a requirement keeps, in place of the one that it breaks; nothing if that is no number of the text. `holds` tells
/// whether the requirement, by its number, is met in a changed mechanism.
pub(crate) fn nearest_limit(
    model: &Model,
    source: &Source,
    number: usize,
    witness: &Witness,
    holds: impl Fn(&Model) -> bool,
) -> Option<Repair> {
    let proved = witness.proved?;
    let requirement = &model.requirements[number];
    let tokens = source.tokens();
    let statements = tokens.statements().into_iter();
    let statement = statements.filter(|one| one.is("expect")).nth(number)?;
    let limit = limit_of(requirement, witness.is_upper)?;
    let written = find(&statement, limit)?;
    let proved = if written.is_in_degrees { proved.to_degrees() } else { proved };
    let words = written.words.clone().map(|index| statement.word(index));
    let old: String = words.collect();
    let mut changes = DIGITS.iter().map(|digits| {
        let value = significant(proved, *digits, Some(witness.is_upper));
        Repair::Numbers(NewNumbers {
            tokens: statement.token(written.words.start)..statement.token(written.words.end),
            old: old.clone(),
            new: format!("{value}"),
            statement: format!("expect {}", requirement.written),
        })
    });
    changes.find(|change| {
        let edits = edits(std::slice::from_ref(change), model, tokens);
        let changed = edits.and_then(|edits| source.model_with(&edits));
        changed.is_some_and(|changed| holds(&changed))
    })
}

/// The limit of a requirement on one side, if it is a constant.
fn limit_of(requirement: &Requirement, is_upper: bool) -> Option<f64> {
    let Condition::Bounds { bounds, .. } = &requirement.condition else {
        return None;
    };
    let bound = bounds.iter().find(|bound| bound.is_upper == is_upper)?;
    match requirement.formulas.all()[bound.limit.index()] {
        Formula::Constant(number) => Some(number.get()),
        _ => None,
    }
}

/// A number in a statement.
struct Written {
    /// Its sign and its digits, by the numbers of the words.
    words: Range<usize>,
    is_in_degrees: bool,
}

/// Finds a number that is the whole of one side of a condition.
fn find(statement: &StatementText<'_>, limit: f64) -> Option<Written> {
    (1..statement.len()).find_map(|index| {
        let value: f64 = statement.word(index).parse().ok()?;
        let is_negative = statement.word(index - 1) == "-";
        let words = index - usize::from(is_negative)..index + 1;
        let is_in_degrees = statement.word(words.end) == "deg";
        let after = statement.word(words.end + usize::from(is_in_degrees));
        let begins = ["expect", "<", ">", "=", "in"].contains(&statement.word(words.start - 1));
        let ends = ["<", ">", ",", ";", "for", "at", "."].contains(&after);
        let value = if is_negative { -value } else { value };
        let value = if is_in_degrees { value.to_radians() } else { value };
        let is_it = (value - limit).abs() <= 4.0 * f64::EPSILON * limit.abs();
        (is_it && begins && ends).then_some(Written { words, is_in_degrees })
    })
}
