//! Statements of which a mechanism or a part has one.

use super::name::Names;
use super::reader::Located;
use super::report::Report;
use crate::syntax::Place;
use crate::syntax::ast::Statement;
use proc_macro2::Span;

const LIST: &str = "put everything into the first";
const CHOICE: &str = "remove one of the two";

/// Where such a statement begins, its words, and what to do with a second.
fn single(statement: &Statement) -> Option<(Span, &'static str, &'static str)> {
    Some(match statement {
        Statement::Ground(ground) => (ground.keyword, "ground", LIST),
        Statement::Start(start) => (start.keyword, "start", LIST),
        Statement::Effects { keyword, .. } => (*keyword, "effects", LIST),
        Statement::Show { keyword, .. } => (*keyword, "show", LIST),
        Statement::Continuous { keyword, .. } => {
            (*keyword, "continuous", "put all joints into the first")
        }
        Statement::Gravity { keyword, .. } => (*keyword, "gravity", "remove this one"),
        Statement::Method(method) => (method.keyword, "method", CHOICE),
        Statement::Accuracy { keyword, .. } => (*keyword, "accuracy", CHOICE),
        Statement::Cost { keyword, .. } => (*keyword, "cost", CHOICE),
        Statement::Quality { keyword, .. } => (*keyword, "quality", CHOICE),
        Statement::Look { keyword, .. } => (*keyword, "look", CHOICE),
        Statement::ChangePoints { keyword, .. } => (*keyword, "at change points", CHOICE),
        _ => return None,
    })
}

/// Complains about a statement of which there is one already, and about a method beside an accuracy, which chooses it.
pub(super) fn check(located: &Located, names: &mut Names, report: &mut Report) {
    let Some((keyword, word, remedy)) = single(located.statement) else {
        return;
    };
    let place = Place::at(keyword);
    let scope = names.scopes.get_mut(located.scope);
    let other = match word {
        "method" => "accuracy",
        "accuracy" => "method",
        _ => word,
    };
    if scope.singles.contains(&other) && !scope.singles.contains(&word) {
        let text =
            "`accuracy` chooses the method, so there cannot be both; remove `accuracy` or `method`";
        report.error(place, text);
    }
    if scope.singles.contains(&word) {
        let what = scope.part.as_ref().map_or("mechanism", |_| "part");
        let text = format!("a {what} has one `{word}`; {remedy}");
        report.error(place, text);
    } else {
        scope.singles.push(word);
    }
}
