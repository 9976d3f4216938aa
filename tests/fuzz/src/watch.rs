//! Watches how long a text takes, and what panics.

use crate::finding::Finding;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::exit;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// The last panic: some are caught where they happen, and are findings all the same.
static PANIC: Mutex<Option<Finding>> = Mutex::new(None);

/// How often the watch looks at the clocks.
const LOOK: Duration = Duration::from_millis(50);

/// What waits does not compute. On a machine with other work, neither does what is not waiting; so it has so many times longer.
const WAITING: u32 = 30;

/// The number of the present text.
static NUMBER: AtomicU64 = AtomicU64::new(0);

/// How long this process has computed; on other systems than Linux, how long it has run.
pub(crate) fn computed(begin: Instant) -> Duration {
    let told = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The twelfth and the thirteenth after the name, in hundredths of a second.
    let numbers = told.rsplit(')').next().unwrap_or_default().split(' ');
    let numbers = numbers.skip(12).take(2).map(str::parse::<u64>);
    match numbers.collect::<Result<Vec<u64>, _>>().as_deref() {
        Ok([user, system]) => Duration::from_millis(10 * (user + system)),
        _ => begin.elapsed(),
    }
}

/// Ends this process if it computes longer than this for a text, and tells for which.
pub(crate) fn begin(limit: Duration) {
    thread::spawn(move || {
        let begin = Instant::now();
        let (mut number, mut clock, mut since) = (u64::MAX, begin, Duration::ZERO);
        loop {
            let now = NUMBER.load(Ordering::Relaxed);
            let time = computed(begin);
            if now != number {
                (number, clock, since) = (now, Instant::now(), time);
            } else if time.saturating_sub(since) > limit || clock.elapsed() > WAITING * limit {
                println!("found {number} takes too long");
                exit(0);
            }
            thread::sleep(LOOK);
        }
    });
}

/// What is found about a text with this number, and how long that takes.
pub(crate) fn watch(
    number: u64,
    work: impl FnOnce() -> Result<bool, Finding>,
) -> (Result<bool, Finding>, Duration) {
    NUMBER.store(number, Ordering::Relaxed);
    std::panic::set_hook(Box::new(|panic| {
        let said = panic.payload_as_str().unwrap_or_default();
        let place = panic.location().map(ToString::to_string);
        let finding = Finding::new(format!("{} says: {said}", place.unwrap_or_default()));
        if let Ok(mut last) = PANIC.lock() {
            *last = Some(finding);
        }
    }));
    let start = Instant::now();
    let found = catch_unwind(AssertUnwindSafe(work));
    let time = start.elapsed();
    let panic = PANIC.lock().ok().and_then(|mut last| last.take());
    let found = match (panic, found) {
        (Some(panic), _) => Err(panic),
        (None, Ok(found)) => found,
        (None, Err(_)) => Err(Finding::new("panics")),
    };
    (found, time)
}
