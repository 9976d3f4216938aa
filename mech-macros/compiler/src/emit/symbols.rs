//! The symbols of a diagram as expressions.

use super::emitter::Emitter;
use super::tokens::integer;
use crate::bug::bug;
use crate::model::LinkId;
use crate::symbols::{Side, Spot, Symbol};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// A symbol.
pub(super) fn symbol(emitter: &Emitter<'_>, symbol: &Symbol) -> TokenStream {
    let (n, pair) = (|value| emitter.number(value), |pair| emitter.pair(pair));
    let direction = |line| emitter.direction(line);
    let spot = |spot| self::spot(emitter, spot);
    let at_spot = |name: &str, at| {
        let (name, spot) = (format_ident!("{name}"), spot(at));
        quote!(#name(#spot))
    };
    let between = |name: &str, ends: [Spot; 2], side: Side| {
        let (name, [a, b]) = (format_ident!("{name}"), ends.map(spot));
        let beside = Literal::f32_unsuffixed(side.pixels());
        quote!(#name { ends: [#a, #b], beside: #beside })
    };
    let symbol = match *symbol {
        Symbol::Bar { link, ends } => {
            let (link, [from, to]) = (
                link_number(emitter, link),
                ends.map(|end| emitter.place(end.axis)),
            );
            quote!(Bar { link: #link, ends: [#from, #to] })
        }
        Symbol::Wheel { center, radius } => {
            let (center, radius) = (spot(center), n(radius));
            quote!(Wheel { center: #center, radius: #radius })
        }
        Symbol::Belt { centers, radii } => {
            let ([a, b], radii) = (centers.map(spot), pair(radii));
            quote!(Belt { centers: [#a, #b], radii: #radii })
        }
        Symbol::Rack {
            pinion,
            radius,
            bar,
            along,
        } => {
            let (pinion, radius) = (spot(pinion), n(radius));
            let (bar, along) = (spot(bar), direction(along));
            quote!(Rack { pinion: #pinion, radius: #radius, bar: #bar, along: #along })
        }
        Symbol::Line { at, along } => {
            let (at, along) = (spot(at), direction(along));
            quote!(Line { at: #at, along: #along })
        }
        Symbol::Slide {
            guide,
            along,
            block,
        } => {
            let (guide, along, block) = (spot(guide), direction(along), spot(block));
            quote!(Slide { guide: #guide, along: #along, block: #block })
        }
        Symbol::LinearMotor {
            block,
            guide,
            along,
        } => {
            let (block, guide, along) =
                (spot(block), link_number(emitter, guide), direction(along));
            quote!(LinearMotor { block: #block, guide: #guide, along: #along })
        }
        Symbol::Spring { ends, side } => between("Spring", ends, side),
        Symbol::Damper { ends, side } => between("Damper", ends, side),
        Symbol::TorsionSpring(at) => at_spot("TorsionSpring", at),
        Symbol::TorsionDamper(at) => at_spot("TorsionDamper", at),
        Symbol::Cam(at) => at_spot("Cam", at),
        Symbol::Wedge { at, along } => {
            let (at, along) = (spot(at), direction(along));
            quote!(Wedge { at: #at, along: #along })
        }
        Symbol::Mark(at) => at_spot("Mark", at),
        Symbol::Point(at) => at_spot("Point", at),
        Symbol::Weld(at) => at_spot("Weld", at),
        Symbol::Pivot(at) => at_spot("Pivot", at),
        Symbol::RotaryMotor(at) => at_spot("RotaryMotor", at),
    };
    quote!(Symbol::#symbol)
}

/// A place on a link.
pub(super) fn spot(emitter: &Emitter<'_>, spot: Spot) -> TokenStream {
    let (link, at) = (link_number(emitter, spot.link), emitter.place(spot.axis));
    quote!(Spot { link: #link, at: #at })
}

/// The number of a link in a table.
fn link_number(emitter: &Emitter<'_>, link: LinkId) -> Literal {
    let number = emitter.link_number(link);
    integer(number.unwrap_or_else(|| bug!("link {} has no pose", link.index())))
}
