//! `joint name = kind(first, second, size) at (x, y) along (dx, dy);`

use super::expression::{expression, one_of, pair};
use super::recover::{at_beginning, to_semicolon};
use super::statement::{BEGINNINGS, declared};
use super::tokens::{in_parens, name, symbol, take, take_word, unexpected, word};
use crate::syntax::ast::{
    Clause, End, Expr, Joint, JointBody, JointWord, Read, Rolling, Size, Statement,
};
use proc_macro2::Ident;
use syn::parse::ParseStream;

const WORDS: [(&str, JointWord); 8] = [
    ("revolute", JointWord::Revolute),
    ("prismatic", JointWord::Prismatic),
    ("gear", JointWord::Gear),
    ("slot", JointWord::Slot),
    ("rack", JointWord::Rack),
    ("belt", JointWord::Belt),
    ("weld", JointWord::Weld),
    ("cam", JointWord::Cam),
];

/// Reads a joint after its keyword.
pub(super) fn joint(input: ParseStream) -> Statement {
    declared(input, "the name of a joint", |input, name| {
        let body = to_semicolon(input, &BEGINNINGS, body);
        Statement::Joint(Box::new(Joint { name, body }))
    })
}

fn body(input: ParseStream) -> Read<JointBody> {
    symbol(input, "=")?;
    let (word, kind) = one_of(input, "a kind of joint", &WORDS)?;
    let ((ends, (rolling, law)), _) = in_parens(input, "`(`", |input| parts(input, kind))?;
    let at = clause(input, "at")?;
    let along = clause(input, "along")?;
    Ok(JointBody {
        word,
        kind,
        ends,
        rolling,
        law,
        at,
        along,
    })
}

/// What stands in the brackets: the ends, what rolls, and a cam's law.
type Parts = ([End; 2], (Option<Rolling>, Option<Expr>));

fn parts(input: ParseStream, kind: JointWord) -> Read<Parts> {
    let first = end(input)?;
    let next = match kind {
        JointWord::Cam => "the joint of the follower",
        _ => "the second link",
    };
    comma(input, next)?;
    let second = end(input)?;
    let law = match kind {
        JointWord::Cam => {
            let what = "the follower's coordinate by the shaft's, `q`, as `0.2 * (1 - cos(q))`";
            comma(input, what)?;
            Some(expression(input)?)
        }
        _ => None,
    };
    let size = match kind {
        JointWord::Gear | JointWord::Belt => Some(ratio(input)?),
        JointWord::Rack => Some(radius(input)?),
        JointWord::Revolute
        | JointWord::Prismatic
        | JointWord::Slot
        | JointWord::Weld
        | JointWord::Cam => None,
    };
    let rolling = match size {
        Some(size) => Some(Rolling {
            size,
            carrier: carrier(input)?,
        }),
        None => None,
    };
    take(input, ",");
    Ok(([first, second], (rolling, law)))
}

/// Reads `link` or `link.axis`.
pub(super) fn end(input: ParseStream) -> Read<End> {
    let link = name(input, "the name of a link")?;
    let axis = take(input, ".")
        .map(|_| name(input, "the name of a point or line"))
        .transpose()?;
    Ok(End { link, axis })
}

/// A comma, and what is missing after it if there is none.
fn comma(input: ParseStream, next: &str) -> Read<()> {
    match take(input, ",") {
        Some(_) => Ok(()),
        None => Err(unexpected(input, &format!("`,` and {next}"))),
    }
}

fn ratio(input: ParseStream) -> Read<Size> {
    comma(input, "the teeth of both wheels, as `20 : 40`")?;
    let first = expression(input)?;
    symbol(input, ":")?;
    let second = expression(input)?;
    Ok(Size::Ratio([first, second]))
}

fn carrier(input: ParseStream) -> Read<Option<Ident>> {
    take_word(input, "on")
        .map(|_| name(input, "the name of a link"))
        .transpose()
}

fn radius(input: ParseStream) -> Read<Size> {
    comma(input, "the radius of the pinion, as `radius 0.5`")?;
    word(input, "radius")?;
    Ok(Size::Radius(expression(input)?))
}

fn clause(input: ParseStream, keyword: &str) -> Read<Option<Clause>> {
    // A joint without its `;` may stand before `at change points`.
    if at_beginning(input, &BEGINNINGS) {
        return Ok(None);
    }
    let Some(keyword) = take_word(input, keyword) else {
        return Ok(None);
    };
    Ok(Some(Clause {
        keyword,
        value: pair(input)?,
    }))
}
