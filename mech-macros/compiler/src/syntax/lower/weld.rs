//! Links that are one.

use super::Lowering;
use crate::model::{AxisId, AxisKind, Origin};
use crate::syntax::Place;
use crate::syntax::ast::{Joint, JointBody};

impl Lowering {
    /// The axes of a weld: given ones, drawn ones, or those of both frames.
    pub(super) fn weld_axes(
        &mut self,
        joint: &Joint,
        body: &JointBody,
        origin: Origin,
    ) -> Option<[AxisId; 2]> {
        let whole = body.at.is_none() && body.ends.iter().all(|end| end.axis.is_none());
        if !whole {
            return self.axes(joint, body, [AxisKind::Point; 2], origin);
        }
        if let Some(along) = &body.along {
            let text = "a `weld` has no direction; leave `along` out";
            self.report.error(Place::at(along.keyword), text);
        }
        let [a, b] = body.ends.each_ref().map(|end| self.find_link(&end.link));
        let links = [a?, b?];
        self.check_apart(joint, body, links)?;
        Some(links.map(|link| self.frame_axis(link, origin)))
    }
}
