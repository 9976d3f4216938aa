//! The way of a link through one period.

use super::number::{Number, decimals_of_factor};
use super::place::Place;
use core::f64::consts::{PI, TAU};
use core::fmt::Write;
use core::iter;
use std::{string::String, vec, vec::Vec};

/// How far a moving figure may be from where it should be for want of key frames, in pixels.
const TOLERANCE: f64 = 0.07;

/// Decimals of what is given in pixels of a key frame; and of its time in percent, at least.
const DECIMALS: usize = 2;
const DECIMALS_OF_TIME: usize = 4;

/// Where a link's frame is at each moment of a period, the moments equally far apart; and at its end, where it is at its beginning.
#[derive(Clone, Debug)]
pub(super) struct Track {
    places: Vec<Place>,
    extent: f64,
}

/// A place with a number for the angle, which goes on beyond whole turns.
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

    /// Goes on to a place.
    pub(super) fn go_on(&mut self, place: Place) {
        self.places.push(place);
    }

    pub(super) fn places(&self) -> &[Place] {
        &self.places
    }

    /// Where it is in the beginning.
    pub(super) fn first(&self) -> Place {
        self.places.first().copied().unwrap_or(Place::PICTURE)
    }

    /// Knows that something that reaches so many pixels from the origin moves on it.
    pub(super) fn carry(&mut self, extent: f64) {
        self.extent = self.extent.max(extent);
    }

    /// Whether nothing on it is seen to move.
    pub(super) fn is_still(&self) -> bool {
        let keys = self.keys();
        let first = keys.first().copied();
        first.is_none_or(|first| {
            keys.iter()
                .all(|key| self.between(first, *key) < TOLERANCE / 10.0)
        })
    }

    /// How far, in pixels, something on it may be from a straight way between two moments.
    pub(super) fn coarseness(&self) -> f64 {
        let keys = self.keys();
        // The last one is the first again, where a motion that does not close would leap.
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

    /// How far, in pixels, something on it may be from where another track has it, each of whose moments is so much of the time to the
    /// next later than its own.
    pub(super) fn deviation(&self, later: &Self, late: f64) -> f64 {
        let keys = self.keys();
        // Where the last one is the first again, a motion that does not close would leap.
        let ways = keys
            .iter()
            .zip(keys.iter().skip(1))
            .take(keys.len().saturating_sub(2));
        ways.zip(later.keys())
            .map(|((before, after), key)| {
                let expected = middle(*before, *after, late);
                let turn = (key.angle - expected.angle + PI).rem_euclid(TAU) - PI;
                let angle = expected.angle + turn;
                self.between(expected, Key { angle, ..key })
            })
            .fold(0.0, f64::max)
    }

    /// The way from one key to the other of what is farthest out.
    fn between(&self, one: Key, other: Key) -> f64 {
        let way = (other.x - one.x).hypot(other.y - one.y);
        way + self.extent * (other.angle - one.angle).abs()
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

    /// Writes it as key frames of CSS, as few as will do.
    pub(super) fn write_keyframes(&self, text: &mut String, name: &str) {
        let keys = self.keys();
        let last = keys.len().saturating_sub(1);
        let decimals = decimals_of_factor(self.extent).saturating_sub(3);
        // What goes far in a period goes far in a small part of it.
        let steps = keys.iter().zip(keys.iter().skip(1));
        let way = steps.map(|(one, next)| self.between(*one, *next)).sum();
        let decimals_of_time = decimals_of_factor(way)
            .saturating_sub(4)
            .max(DECIMALS_OF_TIME);
        let turns = keys.iter().any(|key| key.angle != 0.0);
        // Writing to a `String` cannot fail.
        let _ = write!(text, "@keyframes {name}{{");
        for index in self.thinned(&keys) {
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

    /// The keys between which straight ways are near enough to all others: by halving at the worst.
    fn thinned(&self, keys: &[Key]) -> Vec<usize> {
        let last = keys.len().saturating_sub(1);
        let mut kept = vec![0];
        let mut open = vec![(0, last)];
        while let Some((from, to)) = open.pop() {
            let (Some(&one), Some(&other)) = (keys.get(from), keys.get(to)) else {
                continue;
            };
            let inner = iter::zip(from.., keys.iter().take(to).skip(from)).skip(1);
            let deviations = inner.map(|(index, key)| {
                let way = middle(one, other, share(index - from, to - from));
                (index, self.between(way, *key))
            });
            let worst = deviations.max_by(|(_, a), (_, b)| a.total_cmp(b));
            match worst.filter(|(_, deviation)| *deviation > TOLERANCE) {
                Some((index, _)) => open.extend([(index, to), (from, index)]),
                None if to > from => kept.push(to),
                None => {}
            }
        }
        kept
    }
}

/// A key on the straight way between two others.
fn middle(one: Key, other: Key, share: f64) -> Key {
    let between = |one: f64, other: f64| one + (other - one) * share;
    Key {
        x: between(one.x, other.x),
        y: between(one.y, other.y),
        angle: between(one.angle, other.angle),
    }
}

/// When a moment is, in percent of the period.
pub(super) fn percent(index: usize, count: usize) -> Number {
    Number(100.0 * share(index, count), DECIMALS_OF_TIME)
}

#[expect(clippy::cast_precision_loss, reason = "a few thousand")]
pub(super) fn share(index: usize, count: usize) -> f64 {
    index as f64 / count.max(1) as f64
}
