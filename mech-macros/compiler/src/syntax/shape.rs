//! The shapes of a link, as they are written.

use super::Place;
use super::expr::{Expr, Pair};
use proc_macro2::Span;

/// A coloured spot.
pub(super) struct Shape {
    /// The word it begins with.
    pub keyword: Span,
    /// Its outline.
    pub outline: Outline,
    /// Its plane, if given.
    pub plane: Option<Expr>,
    /// Its colour, if given.
    pub color: Option<Color>,
}

/// `color teal light`
pub(super) struct Color {
    /// Its name, or the number of its entry in the palette.
    pub value: Expr,
    /// The word after it.
    pub shade: Option<(Shade, Span)>,
}

/// A colour beside another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shade {
    Light,
    Dark,
}

/// The outline of a shape.
pub(super) enum Outline {
    /// `circle (x, y) radius r`
    Circle { center: Pair, radius: Expr },
    /// `ring (x, y) radius r hole h`
    Ring { center: Pair, radius: Expr, hole: Expr },
    /// `polygon [(x, y), ...]`
    Polygon { corners: Vec<Pair>, place: Place },
    /// `bar [(x, y), ...] width w`
    Bar { pins: Vec<Pair>, place: Place, width: Expr },
    /// `gear (x, y) radius r teeth n turned a`
    Gear { center: Pair, radius: Option<Expr>, teeth: Expr, turned: Option<Expr> },
    /// `stand (x, y) height h turned a`
    Stand { at: Pair, height: Option<Expr>, turned: Option<Expr> },
    /// `rail [(x, y), (x, y)] width w`
    Rail { ends: Vec<Pair>, place: Place, width: Option<Expr> },
    /// `spring [(x, y), (x, y)] width w`
    Spring { ends: Vec<Pair>, place: Place, width: Expr },
    /// `text (x, y) "what it says" height h turned a`
    Text { at: Pair, text: syn::LitStr, height: Expr, turned: Option<Expr> },
}
