//! The process that tries texts. Whatever kills it, another one goes on.

use crate::corpus::Corpus;
use crate::finding::Finding;
use crate::mangle::mangled;
use crate::options::{Lot, Options};
use crate::target::Target;
use crate::watch;
use fastrand::Rng;
use std::fs::File;
use std::io::{self, Read, Seek, Write};
use std::time::{Duration, Instant};

/// The text of this number.
pub(crate) fn text(corpus: &Corpus, seed: u64, number: u64) -> String {
    mangled(corpus, &mut Rng::with_seed(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ number))
}

/// Tries texts, and tells what it finds, a line each.
pub(crate) fn run(options: &Options, lot: &Lot) -> Result<(), String> {
    let target = options.targets[0];
    let corpus = target.corpus(&options.folders)?;
    let mut at = File::create(&lot.at).map_err(|error| error.to_string())?;
    watch::begin(options.limit);
    let begin = Instant::now();
    let (mut longest, mut slowest, mut understood) = (Duration::ZERO, lot.first, 0);
    for number in lot.first..lot.first + lot.count {
        let noted = at.rewind().and_then(|()| at.write_all(&number.to_le_bytes()));
        noted.map_err(|error| error.to_string())?;
        let text = text(&corpus, options.seed, number);
        let (found, time) = watch::watch(number, || target.examine(&text));
        if time > longest {
            (longest, slowest) = (time, number);
        }
        match found {
            Ok(is_understood) => understood += u64::from(is_understood),
            Err(finding) => println!("found {number} {finding}"),
        }
    }
    let computed = watch::computed(begin).as_millis();
    println!("tried {slowest} {} {understood} {computed}", longest.as_micros());
    Ok(())
}

/// Tries the text in the standard input, and tells what it finds.
pub(crate) fn try_standard_input(options: &Options, target: Target) -> Result<(), String> {
    let mut text = String::new();
    let read = io::stdin().read_to_string(&mut text);
    read.map_err(|error| error.to_string())?;
    watch::begin(options.limit);
    match watch::watch(0, || target.examine(&text)) {
        (Ok(_), time) => println!("fine {}", time.as_micros()),
        (Err(finding), _) => println!("found 0 {finding}"),
    }
    Ok(())
}

/// Reads a line about a finding: the number of the text, and what was found.
pub(crate) fn found(line: &str) -> Option<(u64, Finding)> {
    let (number, what) = line.strip_prefix("found ")?.split_once(' ')?;
    Some((number.parse().ok()?, Finding::new(what)))
}
