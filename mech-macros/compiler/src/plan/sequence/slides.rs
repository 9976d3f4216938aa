//! Loops of slides alone that rolling holds more than once: two racks on one pinion keep bars still that other racks hold, too.

use super::Search;
use crate::model::JointId;
use crate::plan::linear_relations::float_of;
use crate::plan::step::{Connection, Loop, Tie};
use crate::plan::unknown::Unknown;
use nalgebra::{DMatrix, RowDVector};

impl Search<'_> {
    /// A loop that has as many unknowns as equations; of one that only slides, and may be held more than once, without the ties that follow
    /// from what else holds it.
    pub(super) fn square(&self, mut found: Loop) -> Option<Loop> {
        if self.is_square(&found) {
            return Some(found);
        }
        let only_slides = found.connections().all(|connection| connection.slides());
        if !self.model.allow.redundant || found.ties.is_empty() || !only_slides {
            return None;
        }
        let mut joints: Vec<JointId> = found.connections().map(|slide| slide.joint).collect();
        joints.sort_unstable();
        joints.dedup();
        let rings = found.rings.iter();
        let mut rows: Vec<RowDVector<f64>> =
            rings.flat_map(|ring| self.sums(ring, &joints)).collect();
        let mut known = rank(&rows);
        found.ties.retain(|tie| {
            rows.push(row_of(tie, &joints));
            let is_new = rank(&rows) > known;
            if is_new {
                known += 1;
            } else {
                rows.pop();
            }
            is_new
        });
        self.is_square(&found).then_some(found)
    }

    /// The displacements round a ring, in two directions. Slides that do not stay parallel have any directions.
    fn sums(&self, ring: &[Connection], joints: &[JointId]) -> [RowDVector<f64>; 2] {
        /// An angle of which no whole multiple is a whole number of half turns, so that slides get different directions.
        const ANGLE: f64 = 1.0;
        let mut sums = [(); 2].map(|()| RowDVector::zeros(joints.len()));
        for connection in ring {
            let place = joints.iter().position(|joint| *joint == connection.joint);
            let heading = self.structure.parallels.of(connection.joint);
            let (Some(place), Some(heading)) = (place, heading) else {
                continue;
            };
            let declared = self.model.ends(connection.joint) == self.link_of(*connection);
            let sign = if declared == heading.forwards { 1.0 } else { -1.0 };
            #[expect(clippy::cast_precision_loss, reason = "there are not so many slides")]
            let (sin, cos) = (ANGLE * heading.number as f64).sin_cos();
            sums[0][place] += sign * cos;
            sums[1][place] += sign * sin;
        }
        sums
    }
}

/// Returns the equation of a tie in these displacements, as a row.
fn row_of(tie: &Tie, joints: &[JointId]) -> RowDVector<f64> {
    let place =
        |unknown: Unknown| joints.iter().position(|joint| unknown == Unknown::Slide(*joint));
    let mut row = RowDVector::<f64>::zeros(joints.len());
    if let Some(place) = place(tie.of) {
        row[place] += 1.0;
    }
    for (unknown, part) in &tie.parts {
        if let Some(place) = place(*unknown) {
            row[place] -= float_of(part);
        }
    }
    let greatest = row.amax();
    row / greatest
}

fn rank(rows: &[RowDVector<f64>]) -> usize {
    DMatrix::from_rows(rows).rank(1e-9)
}
