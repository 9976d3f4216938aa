//! Rows that are worth their price: no other is both cheaper and more exact.

use crate::measurement::{Figures, Measurement, Row, Step};
use crate::method::Method;

/// The ratio below which times and errors count as the same, because clocks are not more exact.
const SAME: f64 = 1.04;

/// The rows at a step that are worth their price, from the cheapest to the most exact.
pub(crate) fn frontier(measurement: &Measurement, step: Step) -> Vec<&Row> {
    let rows = measurement.rows.iter().filter(|row| row.step == step);
    let priced: Vec<(&Row, Figures)> =
        rows.filter_map(|row| Some((row, *row.outcome.as_ref().ok()?))).collect();
    let points: Vec<Figures> = priced.iter().map(|(_, figures)| *figures).collect();
    let best = best(&points).into_iter();
    best.map(|index| priced[index].0).collect()
}

/// Whether a row is worth its price at its step.
pub(crate) fn is_worth(measurement: &Measurement, row: &Row) -> bool {
    let frontier = frontier(measurement, row.step);
    frontier.into_iter().any(|other| std::ptr::eq(other, row))
}

/// The methods that are worth their price in no mechanism, in no precision and at no step.
pub(crate) fn never_worth(measurements: &[Measurement]) -> Vec<Method> {
    let worth = |method: &Method| {
        measurements.iter().any(|measurement| {
            let mut rows = measurement.rows.iter();
            rows.any(|row| row.method == *method && is_worth(measurement, row))
        })
    };
    let methods = Method::ALL.into_iter();
    methods.filter(|method| !worth(method)).collect()
}

/// The points that no other beats, the cheapest first. Of equal points, the first.
fn best(points: &[Figures]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| points[a].nanoseconds.total_cmp(&points[b].nanoseconds));
    let mut best: Vec<usize> = Vec::new();
    for index in order {
        let point = points[index];
        let Some(last) = best.last_mut() else {
            best.push(index);
            continue;
        };
        let known = points[*last];
        let as_cheap = point.nanoseconds <= known.nanoseconds * SAME;
        if point.error * SAME < known.error {
            best.push(index);
        } else if as_cheap && point.error <= known.error * SAME && index < *last {
            *last = index;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn best_of(points: &[(f64, f64)]) -> Vec<usize> {
        let figures = |&(nanoseconds, error): &(f64, f64)| Figures { error, nanoseconds };
        best(&points.iter().map(figures).collect::<Vec<_>>())
    }

    #[test]
    fn what_is_beaten_is_left_out() {
        assert_eq!(best_of(&[]), []);
        assert_eq!(best_of(&[(9.0, 1.0), (5.0, 3.0), (7.0, 4.0), (12.0, 0.5)]), [1, 0, 3]);
    }

    #[test]
    fn the_first_of_equals_stays() {
        assert_eq!(best_of(&[(5.1, 1.0), (5.0, 1.01)]), [0]);
        assert_eq!(best_of(&[(5.0, 1.01), (5.1, 1.0)]), [0]);
    }
}
