//! Arrows over the drawing: velocities, accelerations and forces at the present pose.

use super::plotted::Plotted;
use super::settings::{Settings, Visible};
use super::sight::Sight;
use super::snapshot::Snapshot;
use crate::play::{Derived, Layer, Layers, Mechanism, Player, Rates};
use crate::quantity::load_numbers;
use std::collections::BTreeSet;

/// The quantity that an arrow shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowKind {
    /// The velocity of a point.
    Velocity,
    /// The acceleration of a point.
    Acceleration,
    /// The force that the first link of a joint exerts on the second.
    Force,
}

/// An arrow over the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// The quantity that it shows.
    pub kind: ArrowKind,
    /// Where it begins, in the scene.
    pub place: [f64; 2],
    /// The value of the quantity, while the plotted motor moves by 1 radian or scene unit in a second, and the others rest.
    pub vector: [f64; 2],
    /// The length of the arrow, in scene units for each unit of the quantity.
    pub scale: f64,
}

/// The length of a velocity or an acceleration of 1, in scene units: at 1 radian in a second, half of the crank.
const RATE: f64 = 0.5;
/// The length of the longest arrow of its kind, at most, as a part of the size of the mechanism.
const LONGEST: f64 = 0.3;

/// What the wanted arrows need that is computed besides positions: those of the window, and those of the player.
pub(super) fn needs(sight: &Sight, settings: &Settings) -> BTreeSet<Derived> {
    let layers = sight.player().map(Player::layers).into_iter();
    let layers = layers.flat_map(Layers::shown).filter_map(Layer::derived);
    let visible = settings.visible.iter();
    layers.chain(visible.filter_map(|what| what.derived())).collect()
}

/// The arrows that are wanted, at the present pose, as far as what they need is known.
pub(super) fn arrows(
    sight: &Sight,
    snapshot: &Snapshot,
    plotted: &Plotted,
    settings: &Settings,
) -> Vec<Arrow> {
    let (Some(player), Some((motor, _))) =
        (sight.seen_player(), plotted.motor_of(&sight.playing.ranges))
    else {
        return Vec::new();
    };
    let mechanism = player.mechanism();
    let mut first = vec![0.0; mechanism.motors().len()];
    if let Some(rate) = first.get_mut(motor) {
        *rate = 1.0;
    }
    let rates = Rates { first, second: Vec::new() };
    let mut arrows = Vec::new();
    if settings.shows(Visible::Velocities) || settings.shows(Visible::Accelerations) {
        let points = mechanism.point_rates(&rates);
        if settings.shows(Visible::Velocities) {
            let vectors = points.iter().map(|point| (point.place, point.velocity));
            arrows.extend(scaled(ArrowKind::Velocity, vectors.collect(), mechanism));
        }
        if settings.shows(Visible::Accelerations) {
            let vectors =
                points.iter().filter_map(|point| Some((point.place, point.acceleration?)));
            arrows.extend(scaled(ArrowKind::Acceleration, vectors.collect(), mechanism));
        }
    }
    if settings.shows(Visible::Forces) {
        let reading = snapshot.reading.as_ref();
        let loads = reading.and_then(|it| load_numbers(&it.model, &plotted.loads(snapshot)).ok());
        let loads = loads.unwrap_or_default();
        let reactions = mechanism.reactions(&rates, &loads);
        arrows.extend(scaled(ArrowKind::Force, reactions, mechanism));
    }
    arrows
}

/// Arrows of one kind. Those of rates have a fixed scale, as long as they fit; forces have units of their own, so that the longest counts.
fn scaled(
    kind: ArrowKind,
    vectors: Vec<([f64; 2], [f64; 2])>,
    mechanism: &Mechanism,
) -> Vec<Arrow> {
    let [low, high] = mechanism.bounds();
    let most = LONGEST * (high[0] - low[0]).max(high[1] - low[1]);
    let longest = vectors.iter().map(|(_, [x, y])| x.hypot(*y)).fold(0.0, f64::max);
    if longest == 0.0 || !longest.is_finite() {
        return Vec::new();
    }
    let fit = most / longest;
    let scale = if kind == ArrowKind::Force { fit } else { fit.min(RATE) };
    let arrow = |(place, vector)| Arrow { kind, place, vector, scale };
    vectors.into_iter().map(arrow).collect()
}
