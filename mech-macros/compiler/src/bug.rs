//! Internal errors: what can only be wrong with the compiler itself. Every room may raise one; `guard` makes an error of it.

use crate::cancel::Cancelled;
use std::any::Any;
use std::fmt::Arguments;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// The beginning of the message of an internal error, wherever it is read.
const BEFORE: &str = "internal error in mech: ";
/// The end of that message.
const AFTER: &str = "; please report this with the mechanism";

/// Ends the analysis, because an invariant of our own is broken and any answer might be wrong.
///
/// The macro turns this into an error at the mechanism, with its text.
macro_rules! bug {
    ($($what:tt)+) => {
        $crate::bug::broken(::std::format_args!($($what)+))
    };
}
pub(crate) use bug;

/// Panics with a message that names itself.
#[cold]
#[track_caller]
pub(crate) fn broken(what: Arguments<'_>) -> ! {
    panic!("{BEFORE}{what}{AFTER}")
}

/// The result of some work of the compiler, or the invariant that is broken, in words. Work that is stopped unwinds through here.
///
/// # Errors
/// If the work panics: whatever a user may write, that is a mistake of the compiler's.
pub fn catch<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    // Nothing that the work changes is read after it.
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        if panic.is::<Cancelled>() {
            resume_unwind(panic);
        }
        broken_in(panic.as_ref())
    })
}

/// Returns what a panic says is broken: the whole message, if it is not from [`bug!`] (as of an index beyond its list).
fn broken_in(panic: &(dyn Any + Send)) -> String {
    let text = match (panic.downcast_ref::<String>(), panic.downcast_ref::<&str>()) {
        (Some(text), _) => text.as_str(),
        (None, Some(text)) => text,
        (None, None) => "a panic that says nothing",
    };
    let named = text.strip_prefix(BEFORE);
    let named = named.and_then(|text| text.strip_suffix(AFTER));
    named.unwrap_or(text).to_owned()
}
