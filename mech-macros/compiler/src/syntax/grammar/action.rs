//! The actions on links: `gravity`, `spring`, `damper`, `load`.

use super::beginning::STATEMENTS;
use super::ending::refuse_misspelt;
use super::expression::{expression, one_of, pair};
use super::path::{end, path};
use super::recover::{read_declared, read_setting, to_semicolon};
use super::tokens::{in_parens, symbol, take, take_word, word};
use crate::syntax::ast::{BetweenEnds, Elastic, ElasticBody, Load, LoadOn, Read, Statement};
use proc_macro2::Span;
use syn::parse::ParseStream;

/// Whether what lies between is along a line or about a joint.
#[derive(Clone, Copy)]
enum Kind {
    Linear,
    Torsional,
}

#[derive(Clone, Copy)]
enum On {
    Point,
    Link,
}

const KINDS: [(&str, Kind); 2] = [("linear", Kind::Linear), ("torsional", Kind::Torsional)];
const LOADS: [(&str, On); 2] = [("force", On::Point), ("torque", On::Link)];

/// Reads `(0, -9.81);`
pub(super) fn gravity(input: ParseStream, keyword: Span) -> Statement {
    read_setting(input, |input| {
        let value = pair(input)?;
        Ok(Statement::Gravity { keyword, value })
    })
}

/// Reads `name = linear(a.p, b.q) stiffness 4530 rest 0.08;`
pub(super) fn spring(input: ParseStream) -> Statement {
    read_declared(input, "the name of a spring", |input, name| {
        let body = to_semicolon(input, &STATEMENTS, |input| {
            let (between, strength) = body(input, "stiffness")?;
            refuse_misspelt(input, &["rest"])?;
            let rest = take_word(input, "rest").map(|_| expression(input)).transpose()?;
            Ok(ElasticBody { between, strength, rest })
        });
        Statement::Spring(Box::new(Elastic { name, body }))
    })
}

/// Reads `name = torsional(joint) damping 0.1;`
pub(super) fn damper(input: ParseStream) -> Statement {
    read_declared(input, "the name of a damper", |input, name| {
        let body = to_semicolon(input, &STATEMENTS, |input| {
            let (between, strength) = body(input, "damping")?;
            Ok(ElasticBody { between, strength, rest: None })
        });
        Statement::Damper(Box::new(Elastic { name, body }))
    })
}

fn body(input: ParseStream, strength: &str) -> Read<(BetweenEnds, crate::syntax::ast::Expr)> {
    symbol(input, "=")?;
    let (_, kind) = one_of(input, "`linear` or `torsional`", &KINDS)?;
    let (between, _) = in_parens(input, "`(`", |input| match kind {
        Kind::Linear => {
            let first = end(input)?;
            symbol(input, ",")?;
            let second = end(input)?;
            take(input, ",");
            Ok(BetweenEnds::Points([first, second]))
        }
        Kind::Torsional => Ok(BetweenEnds::Joint(path(input, "the name of a joint")?)),
    })?;
    word(input, strength)?;
    Ok((between, expression(input)?))
}

/// Reads `name = force(link.point);`
pub(super) fn load(input: ParseStream) -> Statement {
    read_declared(input, "the name of a load", |input, name| {
        let on = to_semicolon(input, &STATEMENTS, on);
        Statement::Load(Box::new(Load { name, on }))
    })
}

fn on(input: ParseStream) -> Read<LoadOn> {
    symbol(input, "=")?;
    let (_, kind) = one_of(input, "`force` or `torque`", &LOADS)?;
    let (on, _) = in_parens(input, "`(`", |input| match kind {
        On::Point => end(input).map(LoadOn::Force),
        On::Link => path(input, "the name of a link").map(LoadOn::Torque),
    })?;
    Ok(on)
}
