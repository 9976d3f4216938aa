//! The paths of traced points.

use super::place_of;
use crate::failure::Failure;
use mech_compiler::Compiled;
use mech_compiler::model::{Model, Precision, Trace as Declared};
use mech_runtime::{Canvas, Trace};
use std::collections::VecDeque;

/// The most places that are drawn of a path: as many as can be declared.
const MOST: usize = 1 << 14;

/// For each trace that is declared the last places of its point.
#[derive(Clone, Default)]
pub(crate) struct Paths {
    precision: Precision,
    all: Vec<Path>,
}

#[derive(Clone)]
struct Path {
    /// The number of the link's pose, and the point in its frame.
    link: usize,
    at: [f64; 2],
    /// The number of places that are recorded.
    length: usize,
    places: VecDeque<[f64; 2]>,
}

impl Paths {
    /// No places yet of the points whose traces a mechanism declares.
    ///
    /// # Errors
    /// If one of them has no pose, which is a mistake of ours: whatever is shown, traced links are.
    pub(crate) fn new(model: &Model, compiled: &Compiled) -> Result<Self, Failure> {
        let path = |trace: &Declared| {
            let axis = model.axis(trace.point);
            let link = compiled.program.place_of(axis.link);
            Ok(Path {
                link: link.ok_or_else(|| Failure::internal("a traced link has no pose"))?,
                at: axis.at,
                length: trace.length,
                places: VecDeque::new(),
            })
        };
        let paths: Result<_, Failure> = model.traces.iter().map(path).collect();
        Ok(Self { precision: model.precision, all: paths? })
    }

    /// The same, of which nothing is forgotten, however short a trace is declared.
    pub(crate) fn whole(mut self) -> Self {
        for path in &mut self.all {
            path.length = MOST;
        }
        self
    }

    /// Whether nothing is traced.
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Forgets all places.
    pub(crate) fn clear(&mut self) {
        for path in &mut self.all {
            path.places.clear();
        }
    }

    /// Records where the points are when the moving links have these poses.
    pub(crate) fn record(&mut self, poses: &[[f64; 4]]) {
        for path in &mut self.all {
            if let Some(pose) = poses.get(path.link) {
                if path.places.len() >= path.length {
                    path.places.pop_front();
                }
                let place = place_of(self.precision, *pose, path.at);
                path.places.push_back(place);
            }
        }
    }

    /// Draws the path of a trace by its number.
    pub(crate) fn draw(&self, trace: usize, canvas: &mut impl Canvas<f64>, color: u8) {
        let Some(path) = self.all.get(trace) else {
            return;
        };
        let mut drawn = Box::new(Trace::<f64, MOST>::new());
        for place in &path.places {
            drawn.push(*place);
        }
        drawn.draw(canvas, color);
    }
}
