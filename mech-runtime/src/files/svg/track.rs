//! The motion of a link through one period.

use super::number::{Number, digits, share};
use super::place::Place;
use core::fmt::Write;
use core::iter;
use std::{string::String, vec, vec::Vec};

/// The error of a moving figure between key frames, in pixels.
const TOLERANCE: f64 = 0.07;

/// Decimals of the lengths in a key frame, in pixels; and of its time, in percent.
const DECIMALS: usize = 2;
const DECIMALS_OF_TIME: usize = 4;

/// The places of a link's frame at equidistant moments of a period, and of what it carries, how far that reaches from the origin.
pub(super) struct Track<'a> {
    pub(super) places: &'a [Place],
    pub(super) reach: f64,
    /// The attribute by which a group moves on it, if it moves.
    pub(super) class: String,
}

impl<'a> Track<'a> {
    /// A track that carries nothing yet.
    pub(super) const fn new(places: &'a [Place]) -> Self {
        Self { places, reach: 0.0, class: String::new() }
    }

    /// Whether no figure on it visibly moves.
    pub(super) fn is_still(&self) -> bool {
        let mut pairs = self.places.first().into_iter().cycle().zip(self.places);
        pairs.all(|(first, place)| first.distance(*place, self.reach) < TOLERANCE / 10.0)
    }

    /// Writes it as key frames of CSS, as few as possible.
    pub(super) fn write_keyframes(&self, text: &mut String, name: &str) {
        // At the end of the period it is where it began.
        let ends = self.places.first().zip(self.places.last());
        let end = ends.map(|(first, last)| first.after(*last));
        let keys: Vec<_> = self.places.iter().copied().chain(end).collect();
        let last = keys.len().saturating_sub(1);
        // A figure that moves far in a period moves far in a small part of it.
        let steps = keys.iter().zip(keys.iter().skip(1));
        let length = steps.map(|(one, next)| one.distance(*next, self.reach));
        let decimals_of_time = digits(length.sum()).max(DECIMALS_OF_TIME);
        let turns = keys.iter().any(|key| key.is_turned());
        let angle = turns.then(|| (digits(self.reach) + 1, "deg"));
        // Writing to a `String` cannot fail.
        let _ = write!(text, "@keyframes {name}{{");
        for index in self.key_frames(&keys) {
            let Some(place) = keys.get(index) else {
                continue;
            };
            let _ = match Number(100.0 * share(index, last), decimals_of_time) {
                _ if index == last => write!(text, "to"),
                percent => write!(text, "{percent}%"),
            };
            text.push_str("{transform:");
            place.write(text, (DECIMALS, "px"), angle);
            text.push('}');
        }
        text.push_str("}\n");
    }

    /// The keys between which straight lines are near enough to all others. Intervals are split at their worst key.
    fn key_frames(&self, keys: &[Place]) -> Vec<usize> {
        let mut frames = vec![0];
        let mut open = vec![(0, keys.len().saturating_sub(1))];
        while let Some((from, to)) = open.pop() {
            let (Some(&one), Some(&other)) = (keys.get(from), keys.get(to)) else {
                continue;
            };
            let inner = iter::zip(from.., keys.iter().take(to).skip(from)).skip(1);
            let deviations = inner.map(|(index, key)| {
                let expected = one.between(other, share(index - from, to - from));
                (index, expected.distance(*key, self.reach))
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
