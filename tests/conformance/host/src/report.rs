//! What the firmware printed.

use crate::error::Error;
use std::collections::BTreeMap;

/// What is reported on: `pose` or `picture`, the mechanism and its precision.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Subject {
    /// The kind of answer.
    pub what: String,
    /// The mechanism.
    pub name: String,
    /// Its precision.
    pub precision: String,
}

/// What was reported, in order: the bits of numbers.
pub type Things = BTreeMap<Subject, Vec<Vec<u64>>>;

/// Reads lines of a subject and its words.
pub(crate) fn things(text: &str) -> Result<Things, Error> {
    let mut things = Things::new();
    for line in text.lines() {
        let wrong = || Error::Line { text: line.to_owned() };
        let mut words = line.split_whitespace().map(str::to_owned);
        let (Some(what), Some(name), Some(precision)) = (words.next(), words.next(), words.next())
        else {
            return Err(wrong());
        };
        let words = words.map(|word| u64::from_str_radix(&word, 16).map_err(|_| wrong()));
        let subject = Subject { what, name, precision };
        things.entry(subject).or_default().push(words.collect::<Result<_, _>>()?);
    }
    Ok(things)
}
