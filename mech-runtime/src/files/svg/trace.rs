//! Traces: lines that show where a point has been.

use super::figure::Figure;
use std::vec::Vec;

/// The distance of a trace from its own end at the moment before: traces leave out steps of half a pixel.
const NEAR: f64 = 0.75;
/// Places of a trace that are nearer to each other than this, in pixels, count as one.
const STEP: f64 = 0.5;

/// The number of moments at which the whole line must lie on the path. That distinguishes traces from springs.
const ASKED: usize = 16;

/// The whole path of a trace in one period. `None` if the moments show anything else. A trace is one line that stays visible, continues
/// from its last end, and lies on the path of its end.
pub(super) fn whole_path(moments: &[Vec<Figure>]) -> Option<Figure> {
    let seen = moments.iter().skip_while(|moment| moment.is_empty());
    let lines = seen.map(|moment| match moment.as_slice() {
        [line] => Some((line, line.line()?)),
        _ => None,
    });
    let lines: Vec<_> = lines.collect::<Option<_>>()?;
    let &(first, begin) = lines.first()?;
    let has_length = lines.iter().any(|(_, points)| points.len() > 2);
    let mut pairs = lines.iter().zip(lines.iter().skip(1));
    let continues = pairs.all(|((one, before), (other, now))| {
        one.is_akin(other) && before.last().is_some_and(|end| is_on(*end, now))
    });
    if !(has_length && continues) {
        return None;
    }
    // A trace that is visible at the first moment has made a whole period already.
    let is_new = lines.len() < moments.len();
    let mut path = Vec::new();
    let initial = extend(&mut path, if is_new { begin } else { &[] });
    let ends = lines.iter().filter_map(|(_, points)| points.last());
    let added = extend(&mut path, ends);
    // It begins with a step, and many more follow.
    if added == 0.0 || added < initial {
        return None;
    }
    path.extend(path.first().copied());
    let asked = lines.iter().rev().step_by(lines.len().div_ceil(ASKED));
    let mut points = asked.flat_map(|(_, points)| *points);
    let is_path = points.all(|&point| is_on(point, &path));
    is_path.then(|| first.through(path))
}

/// Adds the places that differ visibly. Returns the length that they add.
fn extend<'a>(path: &mut Vec<[f64; 2]>, places: impl IntoIterator<Item = &'a [f64; 2]>) -> f64 {
    let mut length = 0.0;
    for &place in places {
        let step = path.last().map(|&last| distance(last, place));
        if step.is_none_or(|step| step >= STEP) {
            length += step.unwrap_or_default();
            path.push(place);
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
