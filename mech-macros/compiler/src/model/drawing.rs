//! Axes that the drawing fixes to links and no text names.

use super::{Axis, AxisId, AxisKind, FormulaId, JointKind, LinkId, Model, Origin};

/// The direction of whoever has none of its own: that of the frame.
pub(crate) const FORWARD: [f64; 2] = [1.0, 0.0];

/// Where the drawing puts an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DrawnAxis {
    pub(crate) kind: AxisKind,
    pub(crate) at: [f64; 2],
    pub(crate) formulas: [Option<FormulaId>; 2],
    pub(crate) direction: [f64; 2],
    pub(crate) direction_formulas: [Option<FormulaId>; 2],
}

impl DrawnAxis {
    /// An axis of rotation.
    pub(crate) fn point(at: [f64; 2]) -> Self {
        Self {
            kind: AxisKind::Point,
            at,
            formulas: [None; 2],
            direction: FORWARD,
            direction_formulas: [None; 2],
        }
    }

    /// An axis of sliding.
    pub(crate) fn line(at: [f64; 2], direction: [f64; 2]) -> Self {
        Self { kind: AxisKind::Line, direction, ..Self::point(at) }
    }

    /// Whether an axis of its link is this one.
    pub(crate) fn is(&self, axis: &Axis) -> bool {
        let there = axis.at == self.at && axis.formulas == self.formulas;
        let along =
            axis.direction == self.direction && axis.direction_formulas == self.direction_formulas;
        axis.name.is_none() && axis.kind == self.kind && there && along
    }
}

impl Model {
    /// Puts an axis of the drawing on a link that has no such axis yet.
    pub(crate) fn add_drawn_axis(
        &mut self,
        link: LinkId,
        drawn: DrawnAxis,
        origin: Origin,
    ) -> AxisId {
        let DrawnAxis { kind, at, formulas, direction, direction_formulas } = drawn;
        let id = AxisId::new(self.axes.len());
        self.axes.push(Axis {
            link,
            name: None,
            port: None,
            origin,
            kind,
            at,
            formulas,
            direction,
            direction_formulas,
        });
        id
    }
}

impl JointKind {
    /// The two axes that it makes coincide, if it is a joint between axes.
    #[must_use]
    pub fn axes(self) -> Option<[AxisId; 2]> {
        match self {
            Self::Revolute(a, b) | Self::Prismatic(a, b) | Self::Weld(a, b) => Some([a, b]),
            Self::Gear { .. } | Self::Belt { .. } | Self::Rack { .. } | Self::Cam { .. } => None,
        }
    }
}
