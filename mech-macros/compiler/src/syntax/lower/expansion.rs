//! The text with all instances of parts in it.

use super::constant::Constants;
use super::draft::Draft;
use super::name::Names;
use super::reader::{Located, Reader};
use super::report::{Report, StatementPlace};
use super::scope::Scopes;
use crate::model::Params;
use crate::syntax::ast::{Part, Statement, Text};

/// The text with all instances of parts in it, and what has a name there. Whoever comes later reads these names.
pub(super) struct Expansion<'t> {
    pub(super) text: &'t Text,
    pub(super) names: Names,
    pub(super) draft: Draft,
    pub(super) params: Params,
    pub(super) report: Report,
}

impl<'t> Expansion<'t> {
    /// Nothing but the names of constants.
    pub(super) fn of(text: &'t Text) -> Self {
        Self {
            text,
            names: Names::new(Scopes::new(Constants::of(&text.statements))),
            draft: Draft::of(text),
            params: Params::default(),
            report: Report::default(),
        }
    }

    /// Reading in a scope, and the model that is made from it.
    pub(super) fn read(&mut self, scope: usize) -> (Reader<'_>, &mut Draft) {
        let reader = Reader::new(&self.names, scope, &mut self.params, &mut self.report);
        (reader, &mut self.draft)
    }

    /// From now on messages are about this statement.
    pub(super) fn enter(&mut self, located: &Located) {
        let instance = self.names.scope(located.scope).instance();
        self.report.enter(located.place, instance);
    }
}

/// Statements in a scope: those of the mechanism, or in an instance those of the part whose own statement has this number.
pub(super) fn locate(
    statements: &[Statement],
    scope: usize,
    part: Option<usize>,
) -> impl DoubleEndedIterator<Item = Located<'_>> {
    let place = move |number| match part {
        None => StatementPlace::of_mechanism(number),
        Some(outer) => StatementPlace { outer, inner: Some(number) },
    };
    let numbered = statements.iter().enumerate();
    numbered.map(move |(index, statement)| Located {
        scope,
        place: place(index + 1),
        statement,
        is_named: false,
    })
}

/// The parts of a mechanism, each with the number of its statement.
pub(super) fn parts(text: &Text) -> impl Iterator<Item = (usize, &Part)> {
    let statements = (1..).zip(&text.statements);
    statements.filter_map(|(number, statement)| match statement {
        Statement::Part(part) => Some((number, &**part)),
        _ => None,
    })
}
