//! Makes a text smaller as long as the same is found about it.

use crate::finding::Finding;
use crate::options::Options;
use crate::pieces::{statements, words};
use crate::target::Target;
use crate::worker::found;
use std::io::Write;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How long a text is made smaller.
const PATIENCE: Duration = Duration::from_mins(1);

/// What is found about a text, in a process of its own.
pub(crate) fn finding(options: &Options, target: Target, text: &str) -> Option<Finding> {
    let program = std::env::current_exe().ok()?;
    let mut process = Command::new(program)
        .args(["--limit", &options.limit.as_secs().to_string(), "--text"])
        .arg(target.name())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    // It may end before it has read everything.
    let _ = process.stdin.take()?.write_all(text.as_bytes());
    let output = process.wait_with_output().ok()?;
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let told = said.lines().find_map(found).map(|(_, finding)| finding);
    let killed = (!output.status.success()).then(|| Finding::new(output.status));
    told.or(killed)
}

/// The least text about which the same kind of thing is found; none if nothing is found about it alone.
pub(crate) fn least(options: &Options, target: Target, text: &str) -> Option<(String, Finding)> {
    let first = finding(options, target, text)?;
    let kind = first.kind();
    let mut least = (text.to_owned(), first);
    let begin = Instant::now();
    let ends = target.language().ends;
    let pieces_of = |text: &str, is_fine: bool| -> Vec<String> {
        let pieces = if is_fine { words(text) } else { statements(text, ends) };
        pieces.into_iter().map(str::to_owned).collect()
    };
    for is_fine in [false, true] {
        let mut size = pieces_of(&least.0, is_fine).len().div_ceil(2);
        while size > 0 {
            let mut at = 0;
            loop {
                let mut pieces = pieces_of(&least.0, is_fine);
                if at >= pieces.len() || begin.elapsed() > PATIENCE {
                    break;
                }
                let end = (at + size).min(pieces.len());
                pieces.drain(at..end);
                let smaller = pieces.concat();
                match finding(options, target, &smaller) {
                    Some(same) if same.kind() == kind => least = (smaller, same),
                    _ => at += size,
                }
            }
            size /= 2;
        }
    }
    Some(least)
}
