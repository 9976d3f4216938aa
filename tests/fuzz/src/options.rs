//! What the command line asks for.

use crate::target::Target;
use std::path::PathBuf;
use std::time::Duration;

/// What the command line asks for.
#[derive(Clone)]
pub(crate) struct Options {
    pub(crate) task: Task,
    pub(crate) targets: Vec<Target>,
    /// How many texts each target takes.
    pub(crate) count: Option<u64>,
    /// How long each target takes texts.
    pub(crate) time: Option<Duration>,
    pub(crate) seed: u64,
    /// A text that takes longer is a finding.
    pub(crate) limit: Duration,
    /// Folders with more texts.
    pub(crate) folders: Vec<PathBuf>,
}

/// What is done.
#[derive(Clone)]
pub(crate) enum Task {
    /// Texts are mangled, and tried by processes beside this one.
    Rounds,
    /// This is such a process.
    Worker(Lot),
    /// One text is tried.
    Text(Target),
}

/// The texts that a process tries.
#[derive(Clone)]
pub(crate) struct Lot {
    pub(crate) first: u64,
    pub(crate) count: u64,
    /// The file that has the number of the text that is tried.
    pub(crate) at: PathBuf,
}

impl Options {
    /// Reads the words of the command line.
    pub(crate) fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            task: Task::Rounds,
            targets: Vec::new(),
            count: None,
            time: None,
            seed: 1,
            limit: Duration::from_secs(2),
            folders: Vec::new(),
        };
        while let Some(word) = words.next() {
            let mut next = || words.next().ok_or(format!("something follows `{word}`"));
            match &*word {
                "--count" => options.count = Some(number(&next()?)?),
                "--seconds" => options.time = Some(Duration::from_secs(number(&next()?)?)),
                "--seed" => options.seed = number(&next()?)?,
                "--limit" => options.limit = Duration::from_secs(number(&next()?)?),
                "--corpus" => options.folders.push(PathBuf::from(next()?)),
                "--text" => options.task = Task::Text(Target::named(&next()?)?),
                "--worker" => {
                    let (first, count) = (number(&next()?)?, number(&next()?)?);
                    let at = PathBuf::from(next()?);
                    options.task = Task::Worker(Lot { first, count, at });
                }
                target => options.targets.push(Target::named(target)?),
            }
        }
        if options.targets.is_empty() {
            options.targets = Target::ALL.to_vec();
        }
        if options.count.is_none() && options.time.is_none() {
            options.count = Some(1000);
        }
        Ok(options)
    }
}

fn number(word: &str) -> Result<u64, String> {
    word.parse().map_err(|_| format!("`{word}` is no whole number"))
}
