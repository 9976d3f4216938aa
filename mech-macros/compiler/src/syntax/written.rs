//! Numbers as they were written, for messages that offer them again.

use super::ast::{
    Expr, ExprKind, MeasuredExpr, MotionExpr, SegmentExpr, SpotExpr, VectorPart, Way,
};
use std::fmt::{self, Display, Formatter};

/// The precedence of an expression, the weakest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Bond {
    Sum,
    Product,
    Sign,
    Unit,
    Whole,
}

impl Display for Expr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        match &self.kind {
            ExprKind::Integer(digits) | ExprKind::Decimal(digits) => write!(formatter, "{digits}"),
            ExprKind::Pi => write!(formatter, "PI"),
            ExprKind::Constant(name) => write!(formatter, "{name}"),
            ExprKind::Negative(inner) => {
                write!(formatter, "-")?;
                part(inner, Bond::Unit, formatter)
            }
            ExprKind::Sum(terms) => chain(terms, [" + ", " - "], Bond::Product, formatter),
            ExprKind::Product(factors) => chain(factors, [" * ", " / "], Bond::Sign, formatter),
            ExprKind::Degrees(inner) => {
                part(inner, Bond::Whole, formatter)?;
                write!(formatter, " deg")
            }
            ExprKind::Rpm(inner) => {
                part(inner, Bond::Whole, formatter)?;
                write!(formatter, " rpm")
            }
            ExprKind::Call(function, argument) => {
                write!(formatter, "{}({argument})", function.name())
            }
            ExprKind::CallBoth(function, parts) => {
                let [a, b] = &**parts;
                write!(formatter, "{}({a}, {b})", function.name())
            }
            ExprKind::Measured(measured) => write!(formatter, "{measured}"),
            ExprKind::Motion(motion) => write!(formatter, "{motion}"),
        }
    }
}

impl Display for MotionExpr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        let from = self.from.iter().map(|from| format!("from {from}"));
        let segments = self.segments.iter().map(ToString::to_string);
        let repeat = self.repeats.then(|| "repeat".to_owned());
        let all: Vec<String> = from.chain(segments).chain(repeat).collect();
        formatter.write_str(&all.join(", "))
    }
}

impl Display for SegmentExpr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        match &self.way {
            Way::Rise(height) => write!(formatter, "rise {height} over")?,
            Way::Fall(height) => write!(formatter, "fall {height} over")?,
            Way::Return => write!(formatter, "return over")?,
            Way::Dwell => write!(formatter, "dwell")?,
        }
        if let Some(span) = &self.span {
            write!(formatter, " {span}")?;
        }
        match self.law {
            Some(law) => write!(formatter, " with {}", law.name()),
            None => Ok(()),
        }
    }
}

impl Display for MeasuredExpr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        match self {
            Self::Moving(None, of) => write!(formatter, "{of}"),
            Self::Moving(Some(rate), of) => write!(formatter, "{}:{of}", rate.word()),
            Self::Transmission(joint) => write!(formatter, "transmission({joint})"),
            Self::Pressure(cam) => write!(formatter, "pressure({cam})"),
            Self::Curvature(cam) => write!(formatter, "curvature({cam})"),
            Self::Angle(link, None) => write!(formatter, "angle({link})"),
            Self::Angle(from, Some(to)) => write!(formatter, "angle({from}, {to})"),
            Self::Distance([from, to]) => write!(formatter, "distance({from}, {to})"),
            Self::Clearance([first, second]) => write!(formatter, "clear({first}, {second})"),
            Self::Centre([first, second], part) => {
                write!(formatter, "centre({first}, {second})")?;
                part.map_or(Ok(()), |part| write!(formatter, ".{}", part.word()))
            }
            Self::Summary(_, word, of) => write!(formatter, "{word}({of})"),
            Self::Dwell([of, width]) => write!(formatter, "dwell({of}, {width})"),
            Self::Influence(of, motor) => write!(formatter, "d({of}, {motor})"),
            Self::Torque(motor) => write!(formatter, "torque:{motor}"),
            Self::Power(motor) => write!(formatter, "power:{motor}"),
            Self::Reaction(reaction) => write!(formatter, "reaction:{}", reaction.whole),
            Self::Advantage(load, motor) => write!(formatter, "advantage({load}, {motor})"),
            Self::Shaking(None) => write!(formatter, "shaking:force"),
            Self::Shaking(Some(VectorPart::Torque)) => write!(formatter, "shaking:moment"),
            Self::Shaking(Some(part)) => write!(formatter, "shaking:force.{}", part.word()),
        }
    }
}

impl Display for SpotExpr {
    fn fmt(&self, formatter: &mut Formatter) -> fmt::Result {
        match self {
            Self::Axis(end) => write!(formatter, "{end}"),
            Self::At(place) => write!(formatter, "({}, {})", place.x, place.y),
        }
    }
}

/// A number as it is written where it is multiplied or divided.
pub(super) fn in_product(expr: &Expr) -> String {
    in_brackets(expr, Bond::Unit)
}

/// A number as it is written when it is given in degrees.
pub(super) fn with_degrees(expr: &Expr) -> String {
    match &expr.kind {
        // A sign before the number binds less than the unit after it.
        ExprKind::Negative(inner) => format!("-{}", with_degrees(inner)),
        _ => format!("{} deg", in_brackets(expr, Bond::Whole)),
    }
}

/// A number: in brackets if it is held together less tightly than this.
fn in_brackets(expr: &Expr, bond: Bond) -> String {
    if bond_of(expr) < bond { format!("({expr})") } else { expr.to_string() }
}

fn chain(
    parts: &[(bool, Expr)],
    [one, other]: [&str; 2],
    bond: Bond,
    formatter: &mut Formatter,
) -> fmt::Result {
    for (number, (inverse, expr)) in parts.iter().enumerate() {
        if number > 0 {
            write!(formatter, "{}", if *inverse { other } else { one })?;
        }
        part(expr, bond, formatter)?;
    }
    Ok(())
}

fn part(expr: &Expr, bond: Bond, formatter: &mut Formatter) -> fmt::Result {
    formatter.write_str(&in_brackets(expr, bond))
}

fn bond_of(expr: &Expr) -> Bond {
    match expr.kind {
        // It stands nowhere but alone.
        ExprKind::Sum(_) | ExprKind::Motion(_) => Bond::Sum,
        ExprKind::Product(_) => Bond::Product,
        ExprKind::Negative(_) => Bond::Sign,
        ExprKind::Degrees(_) | ExprKind::Rpm(_) => Bond::Unit,
        ExprKind::Integer(_)
        | ExprKind::Decimal(_)
        | ExprKind::Pi
        | ExprKind::Constant(_)
        | ExprKind::Call(..)
        | ExprKind::CallBoth(..)
        | ExprKind::Measured(_) => Bond::Whole,
    }
}
