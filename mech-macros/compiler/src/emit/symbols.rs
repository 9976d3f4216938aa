//! The symbols of a diagram as expressions.

use super::emitter::Emitter;
use super::expression::{Expression, expressions};
use crate::symbols::Symbol;
use proc_macro2::TokenStream;
use quote::quote;

expressions! {
    Symbol:
    Bar { link, ends },
    Mark(at),
    Wheel { center, radius },
    Belt { centers, radii },
    Rack { pinion, radius, bar, along },
    Line { at, along },
    Point(at),
    Slide { guide, along, block },
    Weld(at),
    Pivot(at),
    Spring { ends, beside },
    Damper { ends, beside },
    TorsionSpring(at),
    TorsionDamper(at),
    Cam(at),
    Wedge { at, along },
    RotaryMotor(at),
    LinearMotor { block, guide, along }
}
