//! Whether two machines report the same.

use crate::error::Error;
use crate::report::{Subject, Things};
use std::fmt;

/// So many units in the last place poses may differ.
const MOST_ULPS: u64 = 2;

/// How far two machines agree.
#[derive(Debug, Default)]
pub(crate) struct Summary {
    poses: usize,
    others: usize,
    /// The greatest distance of two numbers that should be one, in units in the last place of their precision.
    ulps: u64,
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { poses, others, ulps } = self;
        if *poses > 0 {
            write!(f, "{poses} positions at most {ulps} ulp from this machine's, ")?;
        }
        write!(f, "{others} other answers the same bits")
    }
}

/// Compares what two machines reported.
pub(crate) fn compare(there: &Things, here: &Things) -> Result<Summary, Error> {
    let mut summary = Summary::default();
    if let Some(subject) = there.keys().find(|subject| !here.contains_key(subject)) {
        return Err(differs(subject, "is not reported here"));
    }
    for (subject, expected) in here {
        let Some(found) = there.get(subject) else {
            return Err(differs(subject, "is not reported there"));
        };
        if found.len() != expected.len() {
            return Err(differs(subject, "is not reported as often as here"));
        }
        for (step, (found, expected)) in found.iter().zip(expected).enumerate() {
            if found.len() != expected.len() || expected.is_empty() && subject.what == "pose" {
                return Err(differs(subject, &format!("is blocked at step {step}")));
            }
            for (found, expected) in found.iter().zip(expected) {
                let ulps = if subject.what == "pose" {
                    distance(*found, *expected, &subject.precision)
                } else {
                    u64::from(found != expected) * u64::MAX
                };
                if ulps > MOST_ULPS {
                    let what = format!("at {step}: {found:016x} there, {expected:016x} here");
                    return Err(differs(subject, &what));
                }
                summary.ulps = summary.ulps.max(ulps);
            }
            match &*subject.what {
                "pose" => summary.poses += 1,
                _ => summary.others += 1,
            }
        }
    }
    Ok(summary)
}

fn differs(subject: &Subject, what: &str) -> Error {
    let Subject { what: thing, name, precision } = subject;
    Error::Differs(format!("{thing} of {name} in {precision} {what}"))
}

/// How many units in the last place lie between two numbers, of which these are the bits as `f64`.
fn distance(a: u64, b: u64, precision: &str) -> u64 {
    let [a, b] = [a, b].map(f64::from_bits);
    // From the least number to the greatest in whole numbers.
    let order = |bits: i64| {
        if bits < 0 { i64::MIN.wrapping_sub(bits) } else { bits }
    };
    let [a, b] = if precision == "f32" {
        #[expect(clippy::cast_possible_truncation, reason = "it was an f32")]
        let bits = |number: f64| (number as f32).to_bits().cast_signed();
        [a, b].map(|number| match bits(number) {
            negative @ ..0 => i64::from(i32::MIN.wrapping_sub(negative)),
            bits => i64::from(bits),
        })
    } else {
        [a, b].map(|number| order(number.to_bits().cast_signed()))
    };
    a.abs_diff(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulps_are_counted_across_zero_and_in_both_precisions() {
        let bits = |number: f64| number.to_bits();
        assert_eq!(distance(bits(0.0), bits(-0.0), "f64"), 0);
        assert_eq!(distance(bits(1.0), bits(1.0 + f64::EPSILON), "f64"), 1);
        let next = f64::from(1.0 + f32::EPSILON);
        assert_eq!(distance(bits(1.0), bits(next), "f32"), 1);
        assert_eq!(distance(bits(-1.0), bits(-next), "f32"), 1);
        let least = f64::from_bits(1);
        assert_eq!(distance(bits(least), bits(-least), "f64"), 2);
        assert!(distance(bits(1.0), bits(-1.0), "f32") > 1 << 30);
    }

    #[test]
    fn what_differs_is_reported() {
        let parsed = |text: &str| crate::report::things(text).expect("it is well formed");
        let here = parsed("pose a f64 3ff0000000000000\npicture a f64 7");
        let near = parsed("pose a f64 3ff0000000000001\npicture a f64 7");
        let summary = compare(&near, &here).expect("it is near enough");
        assert_eq!((summary.poses, summary.others, summary.ulps), (1, 1, 1));
        for other in [
            "pose a f64 3ff0000000000003\npicture a f64 7",
            "pose a f64 3ff0000000000000\npicture a f64 8",
            "pose a f64\npicture a f64 7",
            "pose a f64 3ff0000000000000",
            "pose a f64 3ff0000000000000\npicture a f64 7\npicture b f64 7",
            "pose a f64 3ff0000000000000\npose a f64 3ff0000000000000\npicture a f64 7",
        ] {
            assert!(compare(&parsed(other), &here).is_err(), "{other}");
        }
    }
}
