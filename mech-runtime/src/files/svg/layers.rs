//! What moves together.

use super::figure::Figure;
use super::place::Place;
use super::track::Track;
use std::sync::Arc;
use std::{vec, vec::Vec};

/// Something that is seen at one moment: a figure, and where it is.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    pub(super) figure: Arc<Figure>,
    pub(super) place: Place,
}

impl Seen {
    /// The figure in the picture.
    fn in_picture(&self) -> Figure {
        self.figure.carried(|point| self.place.apply(point))
    }
}

/// All that is seen in one period, from back to front.
pub(super) struct Layers {
    pub(super) tracks: Vec<Track>,
    pub(super) layers: Vec<Layer>,
}

/// Neighbours that are treated alike.
pub(super) enum Layer {
    /// Figures that move on one track, in its frame.
    Rigid { track: usize, figures: Vec<Figure> },
    /// What changes its form: at each moment what is seen of it, in the picture.
    Changing(Vec<Vec<Figure>>),
}

impl Layers {
    /// Of all moments of a period.
    pub(super) fn of(moments: &[Vec<Seen>]) -> Self {
        let mut layers = Self {
            tracks: Vec::new(),
            layers: Vec::new(),
        };
        let Some(first) = moments.first() else {
            return layers;
        };
        layers
            .tracks
            .push(Track::new(vec![Place::PICTURE; moments.len()]));
        let [before, after] = alike(first, moments);
        let columns = |from_end: bool, count: usize| {
            (0..count).map(move |index| {
                let column = moments.iter().filter_map(move |moment| {
                    let index = if from_end {
                        moment.len().checked_sub(count)? + index
                    } else {
                        index
                    };
                    moment.get(index)
                });
                column.collect::<Vec<_>>()
            })
        };
        for column in columns(false, before) {
            layers.add(&column);
        }
        let between = moments.iter().map(|moment| {
            let end = moment.len().saturating_sub(after);
            let between = moment.get(before..end).unwrap_or_default();
            between.iter().map(Seen::in_picture).collect()
        });
        layers.add_changing(between.collect());
        for column in columns(true, after) {
            layers.add(&column);
        }
        layers
    }

    /// Adds something that is seen at each moment.
    fn add(&mut self, column: &[&Seen]) {
        let Some(first) = column.first() else {
            return;
        };
        let in_picture: Vec<_> = column.iter().map(|seen| seen.in_picture()).collect();
        let is_same = |seen: &&Seen| {
            Arc::ptr_eq(&seen.figure, &first.figure) || seen.figure.is_same(&first.figure)
        };
        if column.iter().all(is_same) {
            let places: Vec<_> = column.iter().map(|seen| seen.place).collect();
            let track = self.track(places);
            return self.add_rigid(track, Figure::clone(&first.figure));
        }
        let on_known = self
            .tracks
            .iter()
            .position(|track| fixed(&in_picture, track.places()).is_some());
        if let Some(track) = on_known
            && let Some(figure) = self
                .tracks
                .get(track)
                .and_then(|track| fixed(&in_picture, track.places()))
        {
            return self.add_rigid(track, figure);
        }
        let farthest = in_picture.first().map_or(0, Figure::farthest);
        let places: Vec<_> = in_picture
            .iter()
            .map(|figure| figure.own_place(farthest))
            .collect();
        if let Some(figure) = fixed(&in_picture, &places) {
            let track = self.track(places);
            return self.add_rigid(track, figure);
        }
        self.add_changing(in_picture.into_iter().map(|figure| vec![figure]).collect());
    }

    /// The track through these places.
    fn track(&mut self, places: Vec<Place>) -> usize {
        let known = self
            .tracks
            .iter()
            .position(|track| track.places() == places);
        known.unwrap_or_else(|| {
            self.tracks.push(Track::new(places));
            self.tracks.len() - 1
        })
    }

    fn add_rigid(&mut self, track: usize, figure: Figure) {
        if let Some(track) = self.tracks.get_mut(track) {
            track.carry(figure.extent());
        }
        match self.layers.last_mut() {
            Some(Layer::Rigid {
                track: last,
                figures,
            }) if *last == track => figures.push(figure),
            _ => self.layers.push(Layer::Rigid {
                track,
                figures: vec![figure],
            }),
        }
    }

    fn add_changing(&mut self, moments: Vec<Vec<Figure>>) {
        if moments.iter().all(Vec::is_empty) {
            return;
        }
        if let Some(Layer::Changing(last)) = self.layers.last_mut() {
            for (last, more) in last.iter_mut().zip(moments) {
                last.extend(more);
            }
        } else {
            self.layers.push(Layer::Changing(moments));
        }
    }

    /// How far, in pixels, anything may be from a straight way between two moments.
    pub(super) fn coarseness(&self) -> f64 {
        self.tracks
            .iter()
            .map(Track::coarseness)
            .fold(0.0, f64::max)
    }
}

/// How many figures in the beginning, and how many in the end, are of the same kind at all moments.
fn alike(first: &[Seen], moments: &[Vec<Seen>]) -> [usize; 2] {
    let least = moments.iter().map(Vec::len).min().unwrap_or_default();
    let most = moments.iter().map(Vec::len).max().unwrap_or_default();
    if least == most {
        return [least, 0];
    }
    let is_akin = |one: &Seen, other: &Seen| one.figure.is_akin(&other.figure);
    let before = moments
        .iter()
        .map(|moment| {
            first
                .iter()
                .zip(moment)
                .take_while(|(one, other)| is_akin(one, other))
                .count()
        })
        .min()
        .unwrap_or_default();
    let after = moments
        .iter()
        .map(|moment| {
            let pairs = first.iter().rev().zip(moment.iter().rev());
            pairs.take_while(|(one, other)| is_akin(one, other)).count()
        })
        .min()
        .unwrap_or_default();
    [before, after.min(least - before)]
}

/// The figure in a frame that is at these places, if it is the same in it at every moment.
fn fixed(in_picture: &[Figure], places: &[Place]) -> Option<Figure> {
    let mut relative = in_picture
        .iter()
        .zip(places)
        .map(|(figure, place)| figure.carried(|point| place.relative(point)));
    let first = relative.next()?;
    relative
        .all(|figure| figure.is_same(&first))
        .then_some(first)
}
