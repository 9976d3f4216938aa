//! Axes of links.

use mech_compiler::model::{Axis, AxisId, AxisKind, LinkId, Model, Origin};

/// Adds an axis without a name to a link, at a place and along a direction of the scene.
pub fn add_axis(
    model: &mut Model,
    link: LinkId,
    kind: AxisKind,
    at: [f64; 2],
    direction: [f64; 2],
) -> AxisId {
    model.axes.push(Axis {
        link,
        name: None,
        port: None,
        origin: Origin::default(),
        kind,
        at,
        formulas: [None; 2],
        direction_formulas: [None; 2],
        direction,
    });
    AxisId::new(model.axes.len() - 1)
}
