//! The figures that all moments show in the same order, and the changes between them.

use super::drawing::Part;
use super::element::Figure;
use super::place::Place;
use core::mem;
use std::{vec, vec::Vec};

/// Places of a trace that are nearer to each other than this, in pixels, count as one.
const STEP: f64 = 0.5;

/// All figures of a period, from back to front.
#[derive(Clone, Debug)]
pub(super) struct Layers {
    pub(super) all: Vec<Layer>,
    /// The changes in front of all layers.
    pub(super) front: Vec<Change>,
}

/// A figure that all moments show, and what changes between the layer behind it and this one.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    pub(super) behind: Vec<Change>,
    pub(super) figure: Figure,
    pub(super) places: Vec<Place>,
}

/// The number of a moment, and what it shows.
pub(super) type Change = (usize, Part);

impl Layers {
    pub(super) const fn new() -> Self {
        Self { all: Vec::new(), front: Vec::new() }
    }

    /// Adds the moment of this number. A layer that is not found in it changes, and so does what is no layer. But a trace is shown at all
    /// moments, whenever it begins.
    pub(super) fn add(&mut self, number: usize, moment: Vec<Part>) {
        let mut moment = moment.into_iter();
        let mut changes = Vec::new();
        for mut layer in mem::take(&mut self.all) {
            append(&mut changes, layer.behind);
            let mut parts = moment.as_slice().iter();
            let found = parts.position(|part| part.figure.element == layer.figure.element);
            if let Some(index) = found {
                for part in moment.by_ref().take(index) {
                    self.meet(number, part, &mut changes);
                }
                layer.behind = mem::take(&mut changes);
                if let Some(part) = moment.next() {
                    layer.see(&part);
                }
                self.all.push(layer);
            } else {
                let Layer { figure, places, .. } = layer;
                let parts = places.into_iter().map(|place| Part { figure: figure.clone(), place });
                changes.extend(parts.enumerate());
            }
        }
        append(&mut changes, mem::take(&mut self.front));
        for part in moment {
            self.meet(number, part, &mut changes);
        }
        self.front = changes;
    }

    /// Adds what is not known from the moments before.
    fn meet(&mut self, number: usize, part: Part, changes: &mut Vec<Change>) {
        let Part { mut figure, place } = part;
        if number > 0 && figure.trace.is_empty() {
            changes.push((number, Part { figure, place }));
            return;
        }
        if number == 0 {
            // A trace that is visible at the first moment has made a whole period already.
            figure.trace.drain(..figure.trace.len().saturating_sub(1));
        }
        self.all.push(Layer {
            behind: mem::take(changes),
            figure,
            places: vec![place; number + 1],
        });
    }
}

impl Layer {
    /// Adds the place at the next moment, and that to which its trace came.
    fn see(&mut self, Part { figure, place }: &Part) {
        let last = self.places.last().copied().unwrap_or(*place);
        self.places.push(place.after(last));
        self.figure.reach = self.figure.reach.max(figure.reach);
        let trace = &mut self.figure.trace;
        if let (Some(&[x, y]), Some(&[to_x, to_y])) = (trace.last(), figure.trace.last())
            && (to_x - x).hypot(to_y - y) >= STEP
        {
            trace.push([to_x, to_y]);
        }
    }
}

fn append(changes: &mut Vec<Change>, more: Vec<Change>) {
    if changes.is_empty() {
        *changes = more;
    } else {
        changes.extend(more);
    }
}
