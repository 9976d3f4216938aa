//! Numbers, places and names, as they were written.

use super::{Message, Place};
use crate::model::{BinaryFunction, Function, Rate, Summary};
use mech_core::MotionLaw;
use proc_macro2::{Ident, Span};
use std::fmt;

/// A part of the text, or what is wrong with it.
pub(super) type Read<T> = Result<T, Message>;

/// `(x, y)`
pub(super) struct Pair {
    /// The first number.
    pub x: Expr,
    /// The second number.
    pub y: Expr,
    /// From bracket to bracket.
    pub place: Place,
}

/// A number to be computed.
pub(super) struct Expr {
    /// Its operation.
    pub kind: ExprKind,
    /// From its first token to its last.
    pub place: Place,
}

/// The operation that computes a number. Chains are flat, so that a long one cannot exhaust the stack.
pub(super) enum ExprKind {
    /// A literal without a decimal point or an exponent: its decimal digits.
    Integer(String),
    /// A literal with one of them.
    Decimal(String),
    /// `PI`
    Pi,
    /// The name of a constant.
    Constant(Ident),
    /// `-a`
    Negative(Box<Expr>),
    /// `a + b - c`; the flag says that the term is taken away.
    Sum(Vec<(bool, Expr)>),
    /// `a * b / c`; the flag says that the factor divides.
    Product(Vec<(bool, Expr)>),
    /// `a deg`
    Degrees(Box<Expr>),
    /// `a rpm`
    Rpm(Box<Expr>),
    /// `sqrt(a)`
    Call(Function, Box<Expr>),
    /// `min(a, b)`
    CallBoth(BinaryFunction, Box<[Expr; 2]>),
    /// `coupler.tip.x`: only where a mechanism says what it is for.
    Measured(Box<MeasuredExpr>),
    /// `rise 9 over 90 deg, dwell`: only as a whole law.
    Motion(Box<MotionExpr>),
}

/// A motion in segments, one after the other.
pub(super) struct MotionExpr {
    /// The number after `from`: where it begins.
    pub from: Option<Expr>,
    /// Its segments: at least one.
    pub segments: Vec<SegmentExpr>,
    /// Whether it ends with `repeat`.
    pub repeats: bool,
}

/// `rise 9 over 90 deg with cycloidal`
pub(super) struct SegmentExpr {
    /// Where it goes.
    pub way: Way,
    /// How long it takes; a last `dwell` may not say.
    pub span: Option<Expr>,
    /// The law after `with`.
    pub law: Option<MotionLaw>,
    /// From its first word to its last.
    pub place: Place,
}

impl MotionExpr {
    /// All numbers in it.
    pub(super) fn numbers(&self) -> impl Iterator<Item = &Expr> {
        let segments = self.segments.iter();
        let numbers =
            segments.flat_map(|segment| segment.height().into_iter().chain(&segment.span));
        self.from.iter().chain(numbers)
    }
}

impl SegmentExpr {
    /// The height after `rise` or `fall`.
    pub(super) fn height(&self) -> Option<&Expr> {
        match &self.way {
            Way::Rise(height) | Way::Fall(height) => Some(height),
            Way::Return | Way::Dwell => None,
        }
    }
}

/// The way of a segment.
pub(super) enum Way {
    /// `rise 9`
    Rise(Expr),
    /// `fall 9`
    Fall(Expr),
    /// `return`
    Return,
    /// `dwell`
    Dwell,
}

/// Something that is measured.
pub(super) enum MeasuredExpr {
    /// `b`, `coupler.tip.x`, `velocity:b`: what moves, or its rate; without a rate it may be a constant.
    Moving(Option<Rate>, MovingExpr),
    /// `transmission(b)`
    Transmission(Name),
    /// `pressure(profile)`
    Pressure(Name),
    /// `curvature(profile)`
    Curvature(Name),
    /// `angle(coupler)`, `angle(rocker, coupler)`
    Angle(Name, Option<Name>),
    /// `distance(coupler.tip, (1, 2))`
    Distance([SpotExpr; 2]),
    /// `clear(bucket, boom)`
    Clearance([Name; 2]),
    /// `centre(coupler, ground).x`
    Centre([Name; 2], Option<VectorPart>),
    /// `max(coupler.tip.y)`
    Summary(Summary, &'static str, Expr),
    /// `dwell(b, 0.5 deg)`
    Dwell([Expr; 2]),
    /// `d(coupler.tip.y, a)`
    Influence(Expr, Name),
    /// `advantage(push, a)`
    Advantage(Name, Name),
    /// `torque:a`
    Torque(Name),
    /// `power:a`
    Power(Name),
    /// `reaction:b.x`, `reaction:ground`
    Reaction(ReactionExpr),
    /// `shaking:force.x`; `shaking:moment` is the torque.
    Shaking(Option<VectorPart>),
}

/// What moves: `b`, `coupler` or `coupler.tip.x`.
pub(super) struct MovingExpr {
    /// A joint or a link, unless a part is named.
    pub named: Option<Name>,
    /// A point, where several words stand.
    pub point: Option<End>,
    /// The part after it.
    pub part: Option<(VectorPart, Ident)>,
}

/// A joint, perhaps with a part of its reaction after it.
pub(super) struct ReactionExpr {
    /// All words.
    pub whole: Name,
    /// All but the last, where that is the word for a part.
    pub part: Option<(Name, VectorPart)>,
}

/// A part of a vector, or of a reaction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum VectorPart {
    /// `x`
    X,
    /// `y`
    Y,
    /// `norm`: its length.
    Norm,
    /// `torque`: that of a reaction about its joint.
    Torque,
}

impl VectorPart {
    /// The part that a word names.
    pub(super) fn of(word: &Ident) -> Option<Self> {
        let mut all = [Self::X, Self::Y, Self::Norm, Self::Torque].into_iter();
        all.find(|part| word == part.word())
    }

    /// Its word.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Norm => "norm",
            Self::Torque => "torque",
        }
    }
}

/// A place from which a distance is measured.
pub(super) enum SpotExpr {
    /// `coupler.tip`
    Axis(End),
    /// `(1, 2)`
    At(Pair),
}

/// The name of a link or joint, or the path to one: `left[2].foot`.
pub(super) struct Name {
    /// The uses of parts that lead to it, from the outermost inwards.
    pub uses: Vec<Segment>,
    /// Its own name.
    pub name: Ident,
}

/// A use of a part in a path: `left[2]`.
pub(super) struct Segment {
    /// The name of the use.
    pub name: Ident,
    /// Which of its instances is meant, if it has several.
    pub index: Option<Index>,
}

/// The index in the brackets of a path.
pub(super) enum Index {
    /// `[2]`
    At(Expr),
    /// `[*]`: every instance.
    Every(Place),
}

impl Name {
    /// The place of its own name.
    pub(super) fn span(&self) -> Span {
        self.name.span()
    }

    /// From its first word to its last.
    pub(super) fn place(&self) -> Place {
        let first = self.uses.first().map_or(&self.name, |first| &first.name);
        Place { start: first.span(), end: self.name.span() }
    }
}

/// A link, or something fixed to it: `crank`, `crank.pin` or `left[2].crank.pin`.
pub(super) struct End {
    /// The link (in `show` and in cams, possibly a joint).
    pub link: Name,
    /// The point or line.
    pub axis: Option<Ident>,
}

impl End {
    /// From the link's name to the axis's.
    pub(super) fn place(&self) -> Place {
        let link = self.link.place();
        match &self.axis {
            Some(axis) => link.to(Place::at(axis.span())),
            None => link,
        }
    }
}

impl fmt::Display for MovingExpr {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match (&self.named, &self.point) {
            (Some(name), _) => write!(formatter, "{name}")?,
            (None, Some(point)) => write!(formatter, "{point}")?,
            (None, None) => {}
        }
        let part = self.part.iter();
        part.map(|(_, word)| word).try_for_each(|part| write!(formatter, ".{part}"))
    }
}

impl fmt::Display for End {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}", self.link)?;
        self.axis.iter().try_for_each(|axis| write!(formatter, ".{axis}"))
    }
}

impl fmt::Display for Name {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        for segment in &self.uses {
            write!(formatter, "{segment}.")?;
        }
        write!(formatter, "{}", self.name)
    }
}

impl fmt::Display for Segment {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}", self.name)?;
        match &self.index {
            None => Ok(()),
            Some(Index::At(index)) => write!(formatter, "[{index}]"),
            Some(Index::Every(_)) => write!(formatter, "[*]"),
        }
    }
}
