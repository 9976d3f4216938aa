//! Tasks and findings on their way to a worker with which the window shares no memory, and back.
//!
//! A snapshot is large. It is sent once, by whoever has made it, and is known by its number from then on.

use super::{Finding, Held, Hold, Task, Text, Undone, Use};
use crate::edit::{Applied, Refusal};
use crate::editor::curves::Curves;
use crate::editor::range::{MotorRange, Path};
use crate::editor::snapshot::Snapshot;
use crate::failure::Failure;
use crate::job::Measure;
use crate::mend::Mending;
use crate::play::{Mechanism, Prepared};
use crate::quantity::Table;
use crate::report::Behaviour;
use crate::text::Replacement;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::sync::Arc;

/// A task on its way.
#[derive(Serialize, Deserialize)]
pub(super) enum Call {
    Plain(Task),
    Hold(Box<Hold>, Named),
    Of(Named, Use),
}

/// A snapshot by its number, if it has one, and its text: one that is not known any more is made again from that.
#[derive(Serialize, Deserialize)]
pub(super) struct Named(Option<u64>, Text);

/// How a mechanism of a known snapshot is played.
type SentPlayed = (Prepared, Vec<MotorRange>, Vec<Path>);

/// A gesture that was accepted: its title, its replacements, its notes, and the snapshot after it with its number.
type SentGesture = (String, Vec<Replacement>, Vec<String>, u64, Arc<Snapshot>);

/// A finding on its way. Snapshots that are sent have a number, and those that are known have nothing else.
#[derive(Serialize, Deserialize)]
pub(super) enum Reply {
    Plain(Finding),
    Tried(u64, Result<Box<SentGesture>, Refusal>),
    Read(u64, Arc<Snapshot>),
    Moves(u64, Result<Box<SentPlayed>, Failure>),
    Mended(u64, Result<Vec<Mending>, Failure>),
    Reported(u64, Result<Behaviour, Failure>),
    Measured(u64, Measure, Result<Table, Failure>, Vec<Failure>),
}

/// The snapshots that both sides know, by their numbers: only the last ones are asked for again.
#[derive(Default)]
pub(super) struct Known(VecDeque<(u64, Arc<Snapshot>)>);

impl Known {
    /// The number of snapshots that are kept.
    const KEPT: usize = 3;

    fn note(&mut self, number: u64, snapshot: Arc<Snapshot>) {
        self.0.push_back((number, snapshot));
        if self.0.len() > Self::KEPT {
            self.0.pop_front();
        }
    }

    fn number_of(&self, snapshot: &Arc<Snapshot>) -> Option<u64> {
        let mut known = self.0.iter();
        let found = known.find(|(_, one)| Arc::ptr_eq(one, snapshot));
        found.map(|(number, _)| *number)
    }

    fn of_number(&self, number: u64) -> Option<&Arc<Snapshot>> {
        let found = self.0.iter().find(|(one, _)| *one == number);
        found.map(|(_, snapshot)| snapshot)
    }

    fn name(&self, snapshot: &Arc<Snapshot>) -> Named {
        let text = Text { document: snapshot.document.clone(), index: snapshot.index };
        Named(self.number_of(snapshot), text)
    }

    fn find(&self, Named(number, text): Named) -> Result<Arc<Snapshot>, Text> {
        let known = number.and_then(|number| self.of_number(number));
        known.cloned().ok_or(text)
    }

    /// Forgets all: the other side knows none of them any more.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

impl Call {
    pub(super) fn of(task: Task, known: &Known) -> Option<Self> {
        Some(match task {
            Task::Hold(hold, Held::Known(snapshot)) => Self::Hold(hold, known.name(&snapshot)),
            Task::Hold(hold, Held::Text(text)) => Self::Hold(hold, Named(None, text)),
            // The worker gives these to itself.
            Task::Of(_, Use::Move | Use::Mend | Use::Report) => return None,
            Task::Of(snapshot, what) => Self::Of(known.name(&snapshot), what),
            plain => Self::Plain(plain),
        })
    }

    pub(super) fn task(self, known: &Known) -> Task {
        match self {
            Self::Plain(task) => task,
            Self::Hold(hold, named) => {
                let held = known.find(named).map_or_else(Held::Text, Held::Known);
                Task::Hold(hold, held)
            }
            Self::Of(named, what) => {
                let again = |text: Text| Arc::new(Snapshot::of(text.document, text.index));
                Task::Of(known.find(named).unwrap_or_else(again), what)
            }
        }
    }
}

impl Reply {
    /// The finding to be sent. Snapshots are numbered; what is about one that nobody knows any more is not sent.
    pub(super) fn of(finding: Finding, known: &mut Known, count: &mut u64) -> Option<Self> {
        let mut numbered = |snapshot: &Arc<Snapshot>| {
            *count += 1;
            known.note(*count, snapshot.clone());
            *count
        };
        Some(match finding {
            Finding::Tried(number, tried) => Self::Tried(
                number,
                tried.map(|(applied, snapshot)| {
                    // The snapshot has its document and its reading, too.
                    let Applied { title, edits, notes, .. } = applied;
                    Box::new((title, edits, notes, numbered(&snapshot), snapshot))
                }),
            ),
            Finding::Read(snapshot) => Self::Read(numbered(&snapshot), snapshot),
            Finding::Moves(snapshot, played) => Self::Moves(
                known.number_of(&snapshot)?,
                played.map(|(mechanism, ranges, paths)| {
                    Box::new((mechanism.into_prepared(), ranges, paths))
                }),
            ),
            Finding::Mended(snapshot, found) => Self::Mended(known.number_of(&snapshot)?, found),
            Finding::Reported(snapshot, found) => {
                Self::Reported(known.number_of(&snapshot)?, found)
            }
            Finding::Measured(curves) => {
                let Curves { snapshot, wanted, table, missing } = *curves;
                match known.number_of(&snapshot) {
                    Some(number) => Self::Measured(number, wanted, table, missing),
                    None => Self::Plain(Finding::Undone(Undone::Measure, outdated())),
                }
            }
            Finding::Exported(Err(failure)) => Self::Plain(Finding::Undone(Undone::Else, failure)),
            // A worker writes no file.
            Finding::Exported(Ok(_)) => return None,
            plain => Self::Plain(plain),
        })
    }

    /// The finding that was sent; none if it is about something that nobody knows any more.
    pub(super) fn finding(self, known: &mut Known) -> Option<Finding> {
        Some(match self {
            Self::Plain(finding) => finding,
            Self::Tried(number, tried) => {
                let tried = match tried {
                    Ok(tried) => {
                        let (title, edits, notes, count, snapshot) = *tried;
                        known.note(count, snapshot.clone());
                        let applied = Applied {
                            title,
                            edits,
                            notes,
                            document: snapshot.document.clone(),
                            reading: snapshot.reading.as_deref()?.clone(),
                        };
                        Ok((applied, snapshot))
                    }
                    Err(refusal) => Err(refusal),
                };
                Finding::Tried(number, Box::new(tried))
            }
            Self::Read(number, snapshot) => {
                known.note(number, snapshot.clone());
                Finding::Read(snapshot)
            }
            Self::Moves(number, played) => {
                let snapshot = known.of_number(number)?.clone();
                let played = played.and_then(|played| {
                    let (prepared, ranges, paths) = *played;
                    let (model, compiled) = snapshot
                        .moving()
                        .ok_or_else(|| Failure::internal("what does not move is to be played"))?;
                    let mechanism = Mechanism::of(model.clone(), compiled.clone(), prepared)?;
                    Ok((mechanism, ranges, paths))
                });
                Finding::Moves(snapshot, Box::new(played))
            }
            Self::Mended(number, found) => Finding::Mended(known.of_number(number)?.clone(), found),
            Self::Reported(number, found) => {
                Finding::Reported(known.of_number(number)?.clone(), found)
            }
            Self::Measured(number, wanted, table, missing) => match known.of_number(number) {
                Some(snapshot) => Finding::Measured(Box::new(Curves {
                    snapshot: snapshot.clone(),
                    wanted,
                    table,
                    missing,
                })),
                None => Finding::Undone(Undone::Measure, outdated()),
            },
        })
    }
}

/// The failure of a measurement whose text is gone.
fn outdated() -> Failure {
    Failure::mechanism("the text has changed while it was measured")
}

pub(super) fn bytes_of(sent: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let bytes = postcard::to_stdvec(sent);
    bytes.map_err(|error| Failure::internal(format!("it cannot be sent: {error}")))
}

pub(super) fn read<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, Failure> {
    let read = postcard::from_bytes(bytes);
    read.map_err(|error| Failure::internal(format!("what was sent cannot be read: {error}")))
}
