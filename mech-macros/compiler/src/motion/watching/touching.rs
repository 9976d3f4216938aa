//! Whether a loop has dead points only. Where its discriminant goes straight through zero, the loop does not close beyond, so that is no
//! change point.

use super::domain::Domain;
use crate::certify::Interval;
use crate::certify::always::halves;
use crate::certify::cone::{Cuts, Variable};
use crate::certify::slope::Slopes;
use crate::program::ClosedForm;

/// The range of the variable is looked at in so many parts at most.
const MOST_PARTS: usize = 512;

/// Whether a loop has dead points only. That can be told only of a loop with one variable, which moves on as long as the motors do. There
/// the discriminant goes through zero instead of touching it.
pub(super) fn only_ends(domain: &Domain<'_>, closed: &ClosedForm) -> bool {
    let outputs = [closed.discriminant, closed.tolerance, closed.sine, closed.rounding_square];
    let Some(cone) = domain.cutter.cone(&outputs, &Cuts::ALONE) else {
        return false;
    };
    let goes_on = match cone.variables[..] {
        [Variable::Angle(angle)] => domain.cutter.parts(angle).is_some(),
        [Variable::Input(_)] => true,
        _ => false,
    };
    if !goes_on {
        return false;
    }
    let [discriminant, tolerance, sine, rounding_square] =
        [0, 1, 2, 3].map(|output| cone.outputs[output]);
    let mut slopes = Slopes::new(&cone);
    let mut waiting: Vec<Vec<Interval>> =
        vec![cone.variables.iter().map(|variable| domain.of_variable(*variable)).collect()];
    for _ in 0..MOST_PARTS {
        let Some(place) = waiting.pop() else {
            return true;
        };
        slopes.run(&place);
        // Where pins meet but for rounding, the tolerance vanishes with their distance: what rounding hides of the sine does not.
        let hidden = slopes.value(rounding_square).high();
        let is_seen = slopes.value(sine).square().low() > hidden;
        let is_open = slopes.value(discriminant).high() < -slopes.value(tolerance).abs().high();
        let is_away = is_seen || is_open;
        if is_away || !slopes.slope(discriminant, 0).contains(0.0) {
            continue;
        }
        match halves(&place, 0) {
            Some(halves) => waiting.extend(halves),
            None => return false,
        }
    }
    waiting.is_empty()
}
