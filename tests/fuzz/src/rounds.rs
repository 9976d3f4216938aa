//! Lets processes try texts, target by target, and tells what they found.

use crate::finding::Finding;
use crate::minimise::least;
use crate::options::Options;
use crate::target::Target;
use crate::worker::{found, text};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How many texts a process tries.
const LOT: u64 = 2000;

/// Tries texts for all targets; whether nothing was found.
pub(crate) fn run(options: &Options) -> Result<bool, String> {
    let mut is_fine = true;
    for target in &options.targets {
        let mut round = Round::new(options, *target);
        round.run()?;
        is_fine &= round.tell()?;
    }
    Ok(is_fine)
}

struct Round<'o> {
    options: &'o Options,
    target: Target,
    /// The file in which a process notes what it tries.
    at: PathBuf,
    count: u64,
    /// How many of them were understood.
    understood: u64,
    /// How many were tried by processes that came to their end, and how long these computed.
    whole: u64,
    computed: Duration,
    /// The longest time of a text that was fine, in microseconds, and its number.
    longest: (u64, u64),
    /// For each kind of finding the first, and how many there are.
    findings: BTreeMap<String, (u64, Finding, u64)>,
}

impl<'o> Round<'o> {
    fn new(options: &'o Options, target: Target) -> Self {
        let name = format!("mech-fuzz-{}-{}", target.name(), std::process::id());
        Self {
            options,
            target,
            at: std::env::temp_dir().join(name),
            count: 0,
            understood: 0,
            whole: 0,
            computed: Duration::ZERO,
            longest: (0, 0),
            findings: BTreeMap::new(),
        }
    }

    fn run(&mut self) -> Result<(), String> {
        let begin = Instant::now();
        let goes_on = |count: u64, time: Duration| {
            self.options.count.is_none_or(|most| count < most)
                && self.options.time.is_none_or(|most| time < most)
        };
        while goes_on(self.count, begin.elapsed()) {
            let left = self.options.count.map_or(LOT, |most| most - self.count);
            self.count += self.lot(left.min(LOT))?;
        }
        // There is none where nothing was tried.
        let _ = fs::remove_file(&self.at);
        Ok(())
    }

    /// Lets a process try texts; how many it has tried.
    fn lot(&mut self, count: u64) -> Result<u64, String> {
        let program = std::env::current_exe().map_err(|error| error.to_string())?;
        let mut command = Command::new(program);
        let options = self.options;
        command
            .args(["--seed", &options.seed.to_string()])
            .args(["--limit", &options.limit.as_secs().to_string()]);
        for folder in &options.folders {
            command.arg("--corpus").arg(folder);
        }
        command
            .args(["--worker", &self.count.to_string(), &count.to_string()])
            .arg(&self.at)
            .arg(self.target.name());
        let output = command.stdin(Stdio::null()).output();
        let output = output.map_err(|error| error.to_string())?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut is_whole = false;
        for line in said.lines() {
            if let Some((number, finding)) = found(line) {
                self.note(number, finding);
            } else if let Some(tried) = line.strip_prefix("tried ") {
                is_whole = true;
                let numbers = tried.split(' ').filter_map(|number| number.parse().ok());
                if let [number, time, understood, computed] = numbers.collect::<Vec<u64>>()[..] {
                    self.longest = self.longest.max((time, number));
                    self.understood += understood;
                    self.whole += count;
                    self.computed += Duration::from_millis(computed);
                }
            }
        }
        if is_whole {
            return Ok(count);
        }
        if output.status.code() == Some(2) {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        let number = noted(&self.at).ok_or("a process has ended before its first text")?;
        // One that ended by itself has said why.
        if !output.status.success() {
            self.note(number, Finding::new(output.status));
        }
        Ok(number + 1 - self.count)
    }

    fn note(&mut self, number: u64, finding: Finding) {
        let kind = finding.kind();
        self.findings.entry(kind).or_insert((number, finding, 0)).2 += 1;
    }

    /// Tells what was found; whether nothing was.
    fn tell(&self) -> Result<bool, String> {
        let corpus = self.target.corpus(&self.options.folders)?;
        let (longest, slowest) = self.longest;
        #[expect(clippy::cast_precision_loss, reason = "a rate has few digits")]
        let rate = self.whole as f64 / self.computed.as_secs_f64().max(f64::MIN_POSITIVE);
        println!(
            "{}: {} texts, {} % understood, {rate:.0} a second of one core; the longest took {:.3} s (number {slowest})",
            self.target.name(),
            self.count,
            100 * self.understood / self.whole.max(1),
            Duration::from_micros(longest).as_secs_f64(),
        );
        let mut is_fine = true;
        for (number, finding, count) in self.findings.values() {
            if finding.is_known() {
                println!("  known, {count} times: {finding} (number {number})");
                continue;
            }
            let whole = text(&corpus, self.options.seed, *number);
            let Some((text, finding)) = least(self.options, self.target, &whole) else {
                println!("  not again: {finding} (number {number})");
                continue;
            };
            is_fine = false;
            println!("  {count} times: {finding} (number {number}), least text:\n{text}\n  --");
        }
        Ok(is_fine)
    }
}

/// The number of the text that was tried last.
fn noted(at: &Path) -> Option<u64> {
    let bytes = fs::read(at).ok()?;
    Some(u64::from_le_bytes(bytes.try_into().ok()?))
}
