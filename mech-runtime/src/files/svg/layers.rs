//! Layers: figures that move together.

use super::columns::columns;
use super::figure::{Figure, Seen};
use super::place::Place;
use super::trace::whole_path;
use super::track::Track;
use std::sync::Arc;
use std::{vec, vec::Vec};

/// All figures of one period, from back to front.
pub(super) struct Layers {
    pub(super) tracks: Vec<Track>,
    pub(super) layers: Vec<Layer>,
}

/// The track of figures that stand still in the picture.
const PICTURE: usize = 0;

/// Neighbouring figures of one kind.
pub(super) enum Layer {
    /// Figures that move on one track, in its frame.
    Rigid { track: usize, figures: Vec<Figure> },
    /// Figures that change their form: at each moment those that are visible, in the picture.
    Changing(Vec<Vec<Figure>>),
}

impl Layers {
    /// The layers of all moments of a period.
    pub(super) fn of(moments: &[Vec<Seen>]) -> Self {
        let mut layers = Self {
            tracks: Vec::new(),
            layers: Vec::new(),
        };
        let still = vec![Place::PICTURE; moments.len()];
        layers.tracks.push(Track::new(still));
        for column in columns(moments) {
            match column.iter().copied().collect::<Option<Vec<_>>>() {
                Some(always) => layers.add(&always),
                None => layers.add_changing(
                    column
                        .iter()
                        .map(|seen| seen.iter().map(|seen| seen.in_picture()).collect())
                        .collect(),
                ),
            }
        }
        layers
    }

    /// Adds a figure that is visible at each moment.
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
        let on_known = || {
            let tracks = self.tracks.iter().enumerate();
            let mut fixed = tracks
                .filter_map(|(index, track)| Some((index, rigid_in(&in_picture, track.places())?)));
            fixed.next()
        };
        if !first.figure.is_upright()
            && let Some((track, figure)) = on_known()
        {
            return self.add_rigid(track, figure);
        }
        let farthest = in_picture.first().map_or(0, Figure::farthest);
        let places: Vec<_> = in_picture
            .iter()
            .map(|figure| figure.own_place(farthest))
            .collect();
        if let Some(figure) = rigid_in(&in_picture, &places) {
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
        if let Some(path) = whole_path(&moments) {
            return self.add_rigid(PICTURE, path);
        }
        if let Some(Layer::Changing(last)) = self.layers.last_mut() {
            for (last, more) in last.iter_mut().zip(moments) {
                last.extend(more);
            }
        } else {
            self.layers.push(Layer::Changing(moments));
        }
    }

    /// The greatest distance, in pixels, of a figure from straight lines between moments.
    pub(super) fn coarseness(&self) -> f64 {
        self.tracks
            .iter()
            .map(Track::coarseness)
            .fold(0.0, f64::max)
    }
}

/// The figure in a frame at these places, if it is the same there at every moment.
fn rigid_in(in_picture: &[Figure], places: &[Place]) -> Option<Figure> {
    let mut relative = in_picture
        .iter()
        .zip(places)
        .map(|(figure, place)| figure.map(|point| place.relative(point)));
    let first = relative.next()?;
    relative
        .all(|figure| figure.is_same(&first))
        .then_some(first)
}
