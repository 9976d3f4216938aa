//! Snapshots: the compiler's findings on a text.

use super::drawing::Drawing;
use super::placement::Pose;
use super::range::{MotorRange, Path, ranges, whole_paths};
use crate::dialogue::state;
use crate::document::{Declaration, Document, Listing, Message, Reading};
use crate::edit::{Known, Workspace};
use crate::failure::Failure;
use crate::mend::{Mending, mendings};
use crate::play::Mechanism;
use mech_compiler::Compiled;
use mech_compiler::model::{LinkId, Model};
use std::sync::Arc;

#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Snapshot {
    pub(crate) document: Document,
    /// The number of the mechanism in it.
    pub(crate) index: usize,
    /// The mechanism, and what is wrong with it; none if the text has no mechanism.
    pub(crate) reading: Option<Arc<Reading>>,
    /// The names and numbers in the text.
    pub(crate) listing: Listing,
    /// A failure of the compiler itself.
    pub(crate) failure: Option<Failure>,
}

impl Snapshot {
    pub(crate) fn of(document: Document, index: usize) -> Self {
        let declaration = document.declarations().get(index);
        let found = declaration.map(|declaration| read(&document, declaration));
        let (reading, listing, failure) = match found {
            None => (None, Listing::default(), None),
            Some(Ok((reading, listing))) => (Some(Arc::new(reading)), listing, None),
            Some(Err(failure)) => (None, Listing::default(), Some(failure)),
        };
        Self { document, index, reading, listing, failure }
    }

    /// The same, where the mechanism was analysed already.
    pub(crate) fn analysed(document: Document, index: usize, reading: Reading) -> Self {
        let declaration = document.declarations().get(index);
        let listing = declaration.map(|declaration| document.listing(declaration));
        let (listing, failure) = match listing.transpose() {
            Ok(listing) => (listing.flatten().unwrap_or_default(), None),
            Err(failure) => (Listing::default(), Some(failure)),
        };
        Self { document, index, reading: Some(Arc::new(reading)), listing, failure }
    }

    /// Whether it is of this text, and of the same mechanism in it.
    pub(crate) fn is_of(&self, workspace: &Workspace) -> bool {
        self.index == workspace.index() && self.document.source().text() == workspace.text()
    }

    /// Whether the text can be read as a mechanism, even one that does not move yet.
    pub(crate) fn is_readable(&self) -> bool {
        self.reading.as_ref().is_some_and(|reading| match &reading.result {
            Ok(_) => true,
            Err(faults) => !faults.diagnoses.is_empty(),
        })
    }

    /// The mechanism in its file, if its text is right.
    pub(crate) fn known(&self) -> Option<Known<'_>> {
        let reading = self.reading.as_ref().filter(|_| self.is_readable())?;
        Some(Known { document: &self.document, index: self.index, reading, listing: &self.listing })
    }

    /// The compiled mechanism, if it moves.
    pub(crate) fn compiled(&self) -> Option<&Compiled> {
        self.reading.as_ref()?.result.as_deref().ok()
    }

    /// The mechanism, and what it was compiled to, if it moves.
    pub(crate) fn moving(&self) -> Option<(&Model, &Compiled)> {
        let model = &self.reading.as_ref()?.model;
        Some((model, self.compiled()?))
    }

    /// Says in a line whether the mechanism moves.
    pub(crate) fn verdict(&self) -> String {
        match &self.reading {
            Some(reading) => state(reading),
            None => "Draw a bar, or open a file.".to_owned(),
        }
    }

    /// Returns the messages on the faults, with their places.
    pub(crate) fn messages(&self) -> &[Message] {
        let faults = self.reading.as_ref().and_then(|reading| reading.result.as_ref().err());
        faults.map_or(&[], |faults| &faults.messages)
    }

    /// The mechanism as it starts, or as its joints want it. If it does not move, links that rested before stay there. If it is not seen at
    /// the start, they stay where they were.
    pub(crate) fn drawing(&self, before: Option<&Drawing>, is_moved: bool) -> Option<Drawing> {
        let reading = self.reading.as_ref()?;
        let model = &reading.model;
        let known = |pose: fn(&Drawing, LinkId) -> Pose| {
            let links = model.link_ids();
            let known = links.map(|link| {
                let before = before?;
                let link = before.link(&model.link(link).name)?;
                Some(pose(before, link))
            });
            known.collect::<Vec<Option<Pose>>>()
        };
        let Ok(compiled) = &reading.result else {
            return Some(Drawing::new(model.clone(), known(Drawing::rest)));
        };
        let mut drawing = Drawing::new(model.clone(), starts(model, compiled));
        if is_moved {
            drawing.set_poses(known(Drawing::pose));
        }
        Some(drawing)
    }

    /// The mechanism to be played; none if it does not move.
    pub(crate) fn played(&self) -> Option<Result<Played, Failure>> {
        let (model, compiled) = self.moving()?;
        Some(played(model, compiled))
    }

    /// The whole paths of traced points; none if it does not move.
    pub(crate) fn paths(&self) -> Vec<Path> {
        let moving = self.moving();
        let found = moving.and_then(|(model, compiled)| traced(model, compiled).ok());
        found.map(|(_, paths)| paths).unwrap_or_default()
    }

    /// The repairs of what is wrong, the likeliest first.
    pub(crate) fn mendings(&self) -> Result<Vec<Mending>, Failure> {
        let declaration = self.document.declarations().get(self.index);
        let (Some(declaration), Some(reading)) = (declaration, &self.reading) else {
            return Ok(Vec::new());
        };
        if reading.result.is_ok() && !reading.model.requirements.is_empty() {
            let proved = self.document.prove(declaration)?;
            return mendings(&self.document, declaration, &proved);
        }
        mendings(&self.document, declaration, reading)
    }
}

/// A mechanism to be played, how far its motors go, and the whole paths of its traced points.
pub(crate) type Played = (Mechanism, Vec<MotorRange>, Vec<Path>);

fn played(model: &Model, compiled: &Compiled) -> Result<Played, Failure> {
    let mechanism = Mechanism::new(model.clone(), compiled.clone())?;
    let (ranges, paths) = traced(model, compiled)?;
    Ok((mechanism, ranges, paths))
}

/// Finds the ranges of the motors, and the whole paths of traced points.
fn traced(model: &Model, compiled: &Compiled) -> Result<(Vec<MotorRange>, Vec<Path>), Failure> {
    let ranges = ranges(model, compiled)?;
    let points: Vec<_> = model.traces.iter().map(|trace| trace.point).collect();
    let paths = whole_paths(model, compiled, &ranges, &points);
    Ok((ranges, paths))
}

fn read(document: &Document, declaration: &Declaration) -> Result<(Reading, Listing), Failure> {
    let reading = document.analyse(declaration)?;
    let listing = document.listing(declaration)?.unwrap_or_default();
    Ok((reading, listing))
}

/// The poses of all links at the start, as far as they are shown.
fn starts(model: &Model, compiled: &Compiled) -> Vec<Option<Pose>> {
    let start = &compiled.program.start.poses;
    let links = model.link_ids();
    links.map(|link| Some(start[compiled.program.place_of(link)?].into())).collect()
}
