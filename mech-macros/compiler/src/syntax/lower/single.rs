//! Statements of which a mechanism or a part has one.

use super::report::Report;
use super::scope::Scope;
use crate::syntax::Place;
use crate::syntax::ast::Statement;
use proc_macro2::Span;

const LIST: &str = "put everything into the first";
const CHOICE: &str = "remove one of the two";

/// A statement of which there is one.
pub(super) struct Single {
    /// Where it begins.
    pub(super) keyword: Span,
    /// With which words.
    pub(super) word: &'static str,
    /// The remedy for a second.
    remedy: &'static str,
    /// Whether it belongs to the whole mechanism.
    pub(super) is_whole: bool,
}

impl Single {
    /// A statement, if there may be only one of it.
    pub(super) fn of(statement: &Statement) -> Option<Self> {
        let own = |keyword, word, remedy| Self { keyword, word, remedy, is_whole: false };
        let whole = |keyword, word, remedy| Self { is_whole: true, ..own(keyword, word, remedy) };
        Some(match statement {
            Statement::Ground(ground) => own(ground.keyword, "ground", LIST),
            Statement::Start(start) => own(start.keyword, "start", LIST),
            Statement::Effects { keyword, .. } => own(*keyword, "effects", LIST),
            Statement::Continuous { keyword, .. } => {
                own(*keyword, "continuous", "put all joints into the first")
            }
            Statement::Show { keyword, .. } => whole(*keyword, "show", LIST),
            Statement::Follow(follow) => whole(follow.keyword, "follow", CHOICE),
            Statement::Path(path) => whole(path.keyword, "path", CHOICE),
            Statement::Gravity { keyword, .. } => whole(*keyword, "gravity", "remove this one"),
            Statement::Method(method) => whole(method.keyword, "method", CHOICE),
            Statement::Accuracy { keyword, .. } => whole(*keyword, "accuracy", CHOICE),
            Statement::Cost { keyword, .. } => whole(*keyword, "cost", CHOICE),
            Statement::Quality { keyword, .. } => whole(*keyword, "quality", CHOICE),
            Statement::Look { keyword, .. } => whole(*keyword, "look", CHOICE),
            Statement::ChangePoints { keyword, .. } => whole(*keyword, "at change points", CHOICE),
            _ => return None,
        })
    }

    /// Complains about it if its scope has one already, and about a method beside an accuracy, which chooses it.
    pub(super) fn check(&self, scope: &mut Scope, report: &mut Report) {
        let (place, word) = (Place::at(self.keyword), self.word);
        let other = match word {
            "method" => "accuracy",
            "accuracy" => "method",
            _ => word,
        };
        let is_known = scope.singles.contains(&word);
        if !is_known && scope.singles.contains(&other) {
            let text = "`accuracy` chooses the method, so there cannot be both; remove `accuracy` or `method`";
            report.error(place, text);
        }
        if !is_known {
            return scope.singles.push(word);
        }
        let what = scope.part.as_ref().map_or("mechanism", |_| "part");
        let text = format!("a {what} has one `{word}`; {}", self.remedy);
        report.error(place, text);
    }
}
