//! Boxes: a range for each variable.

use crate::certify::Interval;

/// Ranges cut into boxes, at most so many.
pub(super) fn boxes(ranges: &[Interval], most: usize) -> Vec<Vec<Interval>> {
    let wide = ranges.iter().filter(|range| range.width() > 0.0).count();
    let mut parts = 1_usize;
    let affords = |parts: usize| {
        // More than 32 bits hold is unaffordable either way.
        let wide = u32::try_from(wide).unwrap_or(u32::MAX);
        parts.checked_pow(wide).is_some_and(|all| all <= most)
    };
    while wide > 0 && affords(parts + 1) {
        parts += 1;
    }
    let mut boxes = vec![Vec::new()];
    for range in ranges {
        let own = if range.width() > 0.0 { parts } else { 1 };
        let mut next = Vec::with_capacity(boxes.len() * own);
        for before in boxes {
            for part in 0..own {
                #[expect(clippy::cast_precision_loss, reason = "a few hundred parts")]
                let at = |part: usize| {
                    range.low() + (range.high() - range.low()) * (part as f64 / own as f64)
                };
                let mut place: Vec<Interval> = before.clone();
                let high = if part + 1 == own { range.high() } else { at(part + 1) };
                place.push(Interval::new(at(part), high));
                next.push(place);
            }
        }
        boxes = next;
    }
    boxes
}
