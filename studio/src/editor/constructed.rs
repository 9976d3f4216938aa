//! What a lecture constructs, at the present pose.

use super::plotted::Plotted;
use super::selection::Selection;
use super::settings::{Settings, Visible};
use super::sight::Sight;
use super::snapshot::Snapshot;
use crate::construction::{Board, Construction};
use crate::quantity::load_numbers;
use std::sync::Arc;

/// What is wanted of it, as the plotted motor moves, as far as what it needs is known; none if nothing is wanted or moves.
pub(super) fn board(
    sight: &Sight,
    snapshot: &Arc<Snapshot>,
    plotted: &Plotted,
    settings: &Settings,
    selection: &Selection,
) -> Option<Board> {
    let whole = [
        (Visible::Centres, Construction::Centres),
        (Visible::VelocityPolygon, Construction::Velocities),
        (Visible::AccelerationPolygon, Construction::Accelerations),
        (Visible::FreeBodies, Construction::Forces),
    ];
    let wanted = whole.into_iter().filter(|(what, _)| settings.shows(*what));
    let mut constructions: Vec<Construction> = wanted.map(|(_, wanted)| wanted).collect();
    if settings.shows(Visible::InflectionCircles) {
        constructions.extend(selection.links().map(Construction::Inflection));
    }
    let centrodes = plotted.centrodes(snapshot, settings, selection);
    if constructions.is_empty() && centrodes.is_empty() {
        return None;
    }
    let (motor, _) = plotted.motor_of(&sight.playing.ranges)?;
    let reading = snapshot.reading.as_ref();
    let loads = reading.and_then(|it| load_numbers(&it.model, &plotted.loads(snapshot)).ok());
    let mechanism = sight.seen_player()?.mechanism();
    let loads = loads.unwrap_or_default();
    mechanism.constructed(&constructions, centrodes, motor, &loads)
}
