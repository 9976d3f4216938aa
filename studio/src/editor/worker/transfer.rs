//! Tasks and findings on their way to a worker with which the window shares no memory, and back.
//!
//! A snapshot is large. It is sent once, by whoever has made it, and is known by its number from then on.

use super::{Finding, Held, Hold, Led, Previewed, Task, Undone, Work};
use crate::document::{Document, Listing, Reading};
use crate::edit::{Applied, Refusal};
use crate::editor::Gesture;
use crate::editor::curves::{Curves, Wanted};
use crate::editor::order::{Made, Order};
use crate::editor::path::Path;
use crate::editor::range::MotorRange;
use crate::editor::snapshot::Snapshot;
use crate::failure::Failure;
use crate::mend::Mending;
use crate::play::{Derived, Mechanism, Prepared};
use crate::quantity::Table;
use crate::text::Replacement;
use mech_compiler::Compiled;
use mech_compiler::model::Model;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;

/// A text with the number of the mechanism in it.
#[derive(Serialize, Deserialize)]
pub(super) struct Text {
    document: Document,
    index: usize,
}

/// A task on its way.
#[derive(Serialize, Deserialize)]
pub(super) enum Call {
    Try(u64, Text, Gesture),
    Read(Text),
    Ghost(usize, Text),
    Preview(u64, Text, bool, BTreeSet<Derived>),
    Hold(Hold, Option<u64>, Text),
    Lead(u64, [f64; 2]),
    Measure(Option<u64>, Text, Wanted),
    Export(Order),
    Ask(Text, String),
    Derive(u64, Option<u64>, Text, Derived),
}

/// A snapshot on its way, with its number.
#[derive(Serialize, Deserialize)]
pub(super) struct Sent {
    number: u64,
    text: Text,
    reading: Option<Reading>,
    listing: Listing,
    failure: Option<Failure>,
}

/// A mechanism on its way.
#[derive(Serialize, Deserialize)]
pub(super) struct SentMechanism(Model, Compiled, Prepared);

/// How a mechanism of a known snapshot is played.
#[derive(Serialize, Deserialize)]
pub(super) struct SentPlayed(Prepared, Vec<MotorRange>, Vec<Path>);

/// A gesture that was accepted: its title, its replacements, its notes, and the snapshot after it.
#[derive(Serialize, Deserialize)]
pub(super) struct SentGesture(String, Vec<Replacement>, Vec<String>, Sent);

/// A finding on its way.
#[derive(Serialize, Deserialize)]
pub(super) enum Reply {
    Tried(u64, Result<Box<SentGesture>, Refusal>),
    Read(Box<Sent>),
    Ghost(usize, Box<Sent>),
    NotHeld(u64, Refusal),
    Led(Box<Led>),
    Previewed(u64, Option<String>, Option<Box<SentMechanism>>, Vec<Path>),
    Moves(u64, Result<Box<SentPlayed>, Failure>),
    Mended(u64, Result<Vec<Mending>, Failure>),
    Reported(u64, Result<String, Failure>),
    Measured(u64, Wanted, Result<Table, Failure>, Vec<Failure>),
    Made(String, Result<Made, Failure>),
    Answered(String, String, Result<(), Failure>),
    Derived(u64, Derived, Option<Box<Compiled>>),
    Undone(Undone, Failure),
    Begun(Work),
    Ended(Work),
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

    /// The snapshot with this number; one that is not known any more is made again from its text.
    fn of(&self, number: Option<u64>, Text { document, index }: Text) -> Arc<Snapshot> {
        let known = number.and_then(|number| self.of_number(number)).cloned();
        known.unwrap_or_else(|| Arc::new(Snapshot::of(document, index)))
    }

    /// Forgets all: the other side knows none of them any more.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

impl Text {
    fn of(snapshot: &Snapshot) -> Self {
        Self {
            document: snapshot.document.clone(),
            index: snapshot.index,
        }
    }
}

impl Call {
    pub(super) fn of(task: Task, known: &Known) -> Option<Self> {
        Some(match task {
            Task::Try {
                number,
                document,
                index,
                gesture,
            } => Self::Try(number, Text { document, index }, gesture),
            Task::Read { document, index } => Self::Read(Text { document, index }),
            Task::Ghost {
                number,
                document,
                index,
            } => Self::Ghost(number, Text { document, index }),
            Task::Preview {
                number,
                document,
                index,
                has_bodies,
                needs,
            } => Self::Preview(number, Text { document, index }, has_bodies, needs),
            Task::Hold(hold, Held::Known(snapshot)) => {
                Self::Hold(*hold, known.number_of(&snapshot), Text::of(&snapshot))
            }
            Task::Hold(hold, Held::Text(document, index)) => {
                Self::Hold(*hold, None, Text { document, index })
            }
            Task::Lead { number, to } => Self::Lead(number, to),
            Task::Measure { snapshot, wanted } => {
                Self::Measure(known.number_of(&snapshot), Text::of(&snapshot), wanted)
            }
            Task::Export(order) => Self::Export(*order),
            Task::Ask {
                document,
                index,
                line,
            } => Self::Ask(Text { document, index }, line),
            Task::Derive {
                number,
                snapshot,
                what,
            } => {
                let known = known.number_of(&snapshot);
                Self::Derive(number, known, Text::of(&snapshot), what)
            }
            // The worker gives these to itself.
            Task::Move(_) | Task::Mend(_) | Task::Report(_) => return None,
        })
    }

    pub(super) fn task(self, known: &Known) -> Task {
        match self {
            Self::Try(number, Text { document, index }, gesture) => Task::Try {
                number,
                document,
                index,
                gesture,
            },
            Self::Read(Text { document, index }) => Task::Read { document, index },
            Self::Ghost(number, Text { document, index }) => Task::Ghost {
                number,
                document,
                index,
            },
            Self::Preview(number, Text { document, index }, has_bodies, needs) => Task::Preview {
                number,
                document,
                index,
                has_bodies,
                needs,
            },
            Self::Hold(hold, number, text) => {
                let held = match number.and_then(|number| known.of_number(number)) {
                    Some(snapshot) => Held::Known(snapshot.clone()),
                    None => Held::Text(text.document, text.index),
                };
                Task::Hold(Box::new(hold), held)
            }
            Self::Lead(number, to) => Task::Lead { number, to },
            Self::Measure(number, text, wanted) => Task::Measure {
                snapshot: known.of(number, text),
                wanted,
            },
            Self::Export(order) => Task::Export(Box::new(order)),
            Self::Derive(number, of, text, what) => Task::Derive {
                number,
                snapshot: known.of(of, text),
                what,
            },
            Self::Ask(Text { document, index }, line) => Task::Ask {
                document,
                index,
                line,
            },
        }
    }
}

impl Sent {
    fn of(number: u64, snapshot: &Snapshot) -> Self {
        Self {
            number,
            text: Text::of(snapshot),
            reading: snapshot.reading.as_deref().cloned(),
            listing: snapshot.listing.clone(),
            failure: snapshot.failure.clone(),
        }
    }

    fn snapshot(self) -> (u64, Snapshot) {
        let Text { document, index } = self.text;
        let snapshot = Snapshot {
            document,
            index,
            reading: self.reading.map(Arc::new),
            listing: self.listing,
            failure: self.failure,
        };
        (self.number, snapshot)
    }

    fn noted(self, known: &mut Known) -> Arc<Snapshot> {
        let (number, snapshot) = self.snapshot();
        let snapshot = Arc::new(snapshot);
        known.note(number, snapshot.clone());
        snapshot
    }
}

impl Reply {
    /// The finding to be sent. Snapshots are numbered; what is about one that nobody knows any more is not sent.
    pub(super) fn of(finding: Finding, known: &mut Known, count: &mut u64) -> Option<Self> {
        let mut sent = |snapshot: &Arc<Snapshot>| {
            *count += 1;
            known.note(*count, snapshot.clone());
            Sent::of(*count, snapshot)
        };
        Some(match finding {
            Finding::Tried(number, tried) => Self::Tried(
                number,
                tried.map(|(applied, snapshot)| {
                    // The snapshot has its document and its reading, too.
                    let Applied {
                        title,
                        edits,
                        notes,
                        ..
                    } = applied;
                    Box::new(SentGesture(title, edits, notes, sent(&snapshot)))
                }),
            ),
            Finding::Read(snapshot) => Self::Read(Box::new(sent(&snapshot))),
            Finding::Ghost(number, snapshot) => {
                Self::Ghost(number, Box::new(Sent::of(0, &snapshot)))
            }
            Finding::NotHeld(number, refusal) => Self::NotHeld(number, refusal),
            Finding::Led(led) => Self::Led(led),
            Finding::Previewed(previewed) => {
                let Previewed {
                    number,
                    fault,
                    mechanism,
                    paths,
                } = *previewed;
                let mechanism = mechanism.map(|mechanism| {
                    let (model, compiled, prepared) = mechanism.into_parts();
                    Box::new(SentMechanism(model, compiled, prepared))
                });
                Self::Previewed(number, fault, mechanism, paths)
            }
            Finding::Moves(snapshot, played) => Self::Moves(
                known.number_of(&snapshot)?,
                played.map(|(mechanism, ranges, paths)| {
                    let (_, _, prepared) = mechanism.into_parts();
                    Box::new(SentPlayed(prepared, ranges, paths))
                }),
            ),
            Finding::Mended(snapshot, found) => Self::Mended(known.number_of(&snapshot)?, found),
            Finding::Reported(snapshot, found) => {
                Self::Reported(known.number_of(&snapshot)?, found)
            }
            Finding::Measured(curves) => {
                let Curves {
                    snapshot,
                    wanted,
                    table,
                    missing,
                } = *curves;
                match known.number_of(&snapshot) {
                    Some(number) => Self::Measured(number, wanted, table, missing),
                    None => Self::Undone(Undone::Measure, outdated()),
                }
            }
            Finding::Made(path, made) => Self::Made(path, made),
            Finding::Exported(Err(failure)) => Self::Undone(Undone::Else, failure),
            // A worker writes no file.
            Finding::Exported(Ok(_)) => return None,
            Finding::Derived {
                number,
                what,
                found,
            } => Self::Derived(number, what, found),
            Finding::Answered { line, said, done } => Self::Answered(line, said, done),
            Finding::Undone(undone, failure) => Self::Undone(undone, failure),
            Finding::Begun(work) => Self::Begun(work),
            Finding::Ended(work) => Self::Ended(work),
        })
    }

    /// The finding that was sent; none if it is about something that nobody knows any more.
    pub(super) fn finding(self, known: &mut Known) -> Option<Finding> {
        Some(match self {
            Self::Tried(number, tried) => {
                let tried = match tried {
                    Ok(tried) => {
                        let SentGesture(title, edits, notes, sent) = *tried;
                        let snapshot = sent.noted(known);
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
            Self::Read(sent) => Finding::Read(sent.noted(known)),
            Self::Ghost(number, sent) => Finding::Ghost(number, sent.snapshot().1),
            Self::NotHeld(number, refusal) => Finding::NotHeld(number, refusal),
            Self::Led(led) => Finding::Led(led),
            Self::Previewed(number, fault, mechanism, paths) => {
                let mechanism = mechanism.and_then(|sent| {
                    let SentMechanism(model, compiled, prepared) = *sent;
                    Mechanism::of(model, compiled, prepared).ok()
                });
                Finding::Previewed(Box::new(Previewed {
                    number,
                    fault,
                    mechanism,
                    paths,
                }))
            }
            Self::Moves(number, played) => {
                let snapshot = known.of_number(number)?.clone();
                let played = played.and_then(|played| {
                    let SentPlayed(prepared, ranges, paths) = *played;
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
            Self::Measured(number, wanted, table, missing) => {
                let Some(snapshot) = known.of_number(number).cloned() else {
                    return Some(Finding::Undone(Undone::Measure, outdated()));
                };
                Finding::Measured(Box::new(Curves {
                    snapshot,
                    wanted,
                    table,
                    missing,
                }))
            }
            Self::Made(path, made) => Finding::Made(path, made),
            Self::Derived(number, what, found) => Finding::Derived {
                number,
                what,
                found,
            },
            Self::Answered(line, said, done) => Finding::Answered { line, said, done },
            Self::Undone(undone, failure) => Finding::Undone(undone, failure),
            Self::Begun(work) => Finding::Begun(work),
            Self::Ended(work) => Finding::Ended(work),
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
