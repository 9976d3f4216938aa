//! The diagram of a mechanism: its joints, links, motors and axes as a textbook draws them.

mod diagram;
mod elastic;
mod rolling;

use crate::model::{AxisId, LinkId, Measure, Model};
pub(crate) use diagram::elastic_symbols;
pub use diagram::{moving_points, symbols};

/// An element of a diagram: its numbers may depend on params, but for the radii of wheels, which are those at the start.
pub type Symbol = mech_core::Symbol<Measure, LinkId>;

/// A place on a link; on the ground too.
pub type Spot = mech_core::Spot<Measure, LinkId>;

/// The place of an axis.
pub(crate) fn spot(model: &Model, axis: AxisId) -> Spot {
    let axis = model.axis(axis);
    Spot { link: axis.link, at: axis.place() }
}

/// The places between or about which a spring or damper is drawn; none of other symbols.
pub(crate) fn spots(symbol: &Symbol) -> Vec<Spot> {
    match *symbol {
        Symbol::Spring { ends, .. } | Symbol::Damper { ends, .. } => ends.to_vec(),
        Symbol::TorsionSpring(at) | Symbol::TorsionDamper(at) => vec![at],
        _ => Vec::new(),
    }
}
