//! The motion of a link through one period.

use super::number::{Number, decimals_of_factor};
use super::place::Place;
use core::f64::consts::{PI, TAU};
use core::fmt::Write;
use core::iter;
use std::{string::String, vec, vec::Vec};

/// The error of a moving figure between key frames, in pixels.
const TOLERANCE: f64 = 0.07;

/// Decimals of the lengths in a key frame, in pixels; and the least decimals of its time, in percent.
const DECIMALS: usize = 2;
const DECIMALS_OF_TIME: usize = 4;

/// The places of a link's frame at equidistant moments of a period. At the end of the period it is where it began.
#[derive(Clone, Debug)]
pub(super) struct Track {
    places: Vec<Place>,
    extent: f64,
}

/// A place with an angle that counts whole turns.
#[derive(Clone, Copy)]
struct Key {
    x: f64,
    y: f64,
    angle: f64,
}

impl Track {
    pub(super) const fn new(places: Vec<Place>) -> Self {
        let extent = 0.0;
        Self { places, extent }
    }

    /// Adds the place of the next moment.
    pub(super) fn push(&mut self, place: Place) {
        self.places.push(place);
    }

    pub(super) fn places(&self) -> &[Place] {
        &self.places
    }

    /// The place at the first moment.
    pub(super) fn first(&self) -> Place {
        self.places.first().copied().unwrap_or(Place::PICTURE)
    }

    /// Notes that a figure on it reaches so many pixels from the origin.
    pub(super) fn carry(&mut self, extent: f64) {
        self.extent = self.extent.max(extent);
    }

    /// Whether no figure on it visibly moves.
    pub(super) fn is_still(&self) -> bool {
        let keys = self.keys();
        let first = keys.first().copied();
        first.is_none_or(|first| {
            keys.iter()
                .all(|key| self.between(first, *key) < TOLERANCE / 10.0)
        })
    }

    /// The distance, in pixels, of a figure on it from straight lines between moments.
    pub(super) fn coarseness(&self) -> f64 {
        let keys = self.keys();
        // The last key is the first again, where a motion that does not close would leap.
        let inner = keys.len().saturating_sub(1);
        let bends = keys
            .iter()
            .take(inner)
            .zip(keys.iter().skip(1))
            .zip(keys.iter().skip(2).take(inner.saturating_sub(2)));
        // The sagitta of a parabola is an eighth of its second difference.
        bends
            .map(|((before, key), after)| self.between(middle(*before, *after, 0.5), *key) / 4.0)
            .fold(0.0, f64::max)
    }

    /// The distance, in pixels, of a figure on it from where another track has it. Each moment of that track is later by a share `late` of
    /// the time between two moments.
    pub(super) fn deviation(&self, later: &Self, late: f64) -> f64 {
        let keys = self.keys();
        // The last key is the first again, where a motion that does not close would leap.
        let steps = keys
            .iter()
            .zip(keys.iter().skip(1))
            .take(keys.len().saturating_sub(2));
        steps
            .zip(later.keys())
            .map(|((before, after), key)| {
                let expected = middle(*before, *after, late);
                let turn = (key.angle - expected.angle + PI).rem_euclid(TAU) - PI;
                let angle = expected.angle + turn;
                self.between(expected, Key { angle, ..key })
            })
            .fold(0.0, f64::max)
    }

    /// The distance from one key to another of the farthest figure.
    fn between(&self, one: Key, other: Key) -> f64 {
        let shift = (other.x - one.x).hypot(other.y - one.y);
        shift + self.extent * (other.angle - one.angle).abs()
    }

    /// A key for each moment, and one for the end of the period.
    fn keys(&self) -> Vec<Key> {
        let mut angle = None;
        let round = self.places.iter().chain(self.places.first());
        let keys = round.map(|place| {
            let principal = place.sin.atan2(place.cos);
            let angle = *angle.insert(angle.map_or(principal, |last: f64| {
                last + (principal - last + PI).rem_euclid(TAU) - PI
            }));
            let Place { x, y, .. } = *place;
            Key { x, y, angle }
        });
        keys.collect()
    }

    /// Writes it as key frames of CSS, as few as possible.
    pub(super) fn write_keyframes(&self, text: &mut String, name: &str) {
        let keys = self.keys();
        let last = keys.len().saturating_sub(1);
        let decimals = decimals_of_factor(self.extent).saturating_sub(3);
        // A figure that moves far in a period moves far in a small part of it.
        let steps = keys.iter().zip(keys.iter().skip(1));
        let length = steps.map(|(one, next)| self.between(*one, *next)).sum();
        let decimals_of_time = decimals_of_factor(length)
            .saturating_sub(4)
            .max(DECIMALS_OF_TIME);
        let turns = keys.iter().any(|key| key.angle != 0.0);
        // Writing to a `String` cannot fail.
        let _ = write!(text, "@keyframes {name}{{");
        for index in self.key_frames(&keys) {
            let Some(Key { x, y, angle }) = keys.get(index).copied() else {
                continue;
            };
            let _ = if index == last {
                write!(text, "to")
            } else {
                write!(
                    text,
                    "{}%",
                    Number(100.0 * share(index, last), decimals_of_time)
                )
            };
            let [x, y] = [x, y].map(|pixels| Number(pixels, DECIMALS));
            let _ = write!(text, "{{transform:translate({x}px,{y}px)");
            if turns {
                let degrees = Number(angle.to_degrees(), decimals);
                let _ = write!(text, " rotate({degrees}deg)");
            }
            text.push('}');
        }
        text.push_str("}\n");
    }

    /// The keys between which straight lines are near enough to all others. Intervals are split at their worst key.
    fn key_frames(&self, keys: &[Key]) -> Vec<usize> {
        let last = keys.len().saturating_sub(1);
        let mut frames = vec![0];
        let mut open = vec![(0, last)];
        while let Some((from, to)) = open.pop() {
            let (Some(&one), Some(&other)) = (keys.get(from), keys.get(to)) else {
                continue;
            };
            let inner = iter::zip(from.., keys.iter().take(to).skip(from)).skip(1);
            let deviations = inner.map(|(index, key)| {
                let expected = middle(one, other, share(index - from, to - from));
                (index, self.between(expected, *key))
            });
            let worst = deviations.max_by(|(_, a), (_, b)| a.total_cmp(b));
            match worst.filter(|(_, deviation)| *deviation > TOLERANCE) {
                Some((index, _)) => open.extend([(index, to), (from, index)]),
                None if to > from => frames.push(to),
                None => {}
            }
        }
        frames
    }
}

/// A key on the straight line between two others.
fn middle(one: Key, other: Key, share: f64) -> Key {
    let between = |one: f64, other: f64| one + (other - one) * share;
    Key {
        x: between(one.x, other.x),
        y: between(one.y, other.y),
        angle: between(one.angle, other.angle),
    }
}

/// The time of a moment, in percent of the period.
pub(super) fn percent(index: usize, count: usize) -> Number {
    Number(100.0 * share(index, count), DECIMALS_OF_TIME)
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
pub(super) fn share(index: usize, count: usize) -> f64 {
    index as f64 / count.max(1) as f64
}
