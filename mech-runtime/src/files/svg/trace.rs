//! Lines that tell where a point has been.

use super::figure::Figure;
use std::vec::Vec;

/// How far from a trace its own end of the moment before may be: traces leave out steps of half a pixel.
const NEAR: f64 = 0.75;
/// Places of a trace that are nearer to each other than this, in pixels, are not told apart.
const STEP: f64 = 0.5;

/// Whether all of a line is on the way is asked at so many moments: that tells traces from springs.
const ASKED: usize = 16;

/// If what is seen moment by moment is one line that always goes on from where it ended, does not go away, and is all on the way of
/// its end: that whole way in one period.
pub(super) fn whole_way(moments: &[Vec<Figure>]) -> Option<Figure> {
    let seen = moments.iter().skip_while(|moment| moment.is_empty());
    let lines = seen.map(|moment| match moment.as_slice() {
        [line] => Some((line, line.line()?)),
        _ => None,
    });
    let lines: Vec<_> = lines.collect::<Option<_>>()?;
    let &(first, begin) = lines.first()?;
    let has_length = lines.iter().any(|(_, points)| points.len() > 2);
    let mut pairs = lines.iter().zip(lines.iter().skip(1));
    let goes_on = pairs.all(|((one, before), (other, now))| {
        one.is_akin(other) && before.last().is_some_and(|end| is_on(*end, now))
    });
    if !(has_length && goes_on) {
        return None;
    }
    // One that was there before the first moment has been round already.
    let is_new = lines.len() < moments.len();
    let mut way = Vec::new();
    let begun = extend(&mut way, if is_new { begin } else { &[] });
    let ends = lines.iter().filter_map(|(_, points)| points.last());
    let gone = extend(&mut way, ends);
    // It begins with a step, and goes many more.
    if gone == 0.0 || gone < begun {
        return None;
    }
    way.extend(way.first().copied());
    let asked = lines.iter().rev().step_by(lines.len().div_ceil(ASKED));
    let mut points = asked.flat_map(|(_, points)| *points);
    let is_way = points.all(|&point| is_on(point, &way));
    is_way.then(|| first.through(way))
}

/// Goes on through those places that can be told apart; tells how far that is.
fn extend<'a>(way: &mut Vec<[f64; 2]>, places: impl IntoIterator<Item = &'a [f64; 2]>) -> f64 {
    let mut length = 0.0;
    for &place in places {
        let step = way.last().map(|&last| distance(last, place));
        if step.is_none_or(|step| step >= STEP) {
            length += step.unwrap_or_default();
            way.push(place);
        }
    }
    length
}

fn is_on(point: [f64; 2], line: &[[f64; 2]]) -> bool {
    let mut parts = line.iter().zip(line.iter().skip(1));
    parts.any(|(&from, &to)| {
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let square = x * x + y * y;
        let share = if square > 0.0 {
            ((point[0] - from[0]) * x + (point[1] - from[1]) * y) / square
        } else {
            0.0
        };
        let share = share.clamp(0.0, 1.0);
        distance(point, [from[0] + share * x, from[1] + share * y]) < NEAR
    })
}

fn distance([x, y]: [f64; 2], [to_x, to_y]: [f64; 2]) -> f64 {
    (to_x - x).hypot(to_y - y)
}
