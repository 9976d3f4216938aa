//! The turns of a motor after which everything is as it was.

use crate::certify::cone::Cuts;
use crate::model::{Model, MotorId};
use crate::motion::watching::Domain;
use crate::program::{Program, Value};

/// A motor that has to make more turns than this until everything has turned as a whole needs a range.
const MOST_TURNS: f64 = 64.0 * std::f64::consts::TAU;

/// The turn of a motor after which some values are what they were; none if it slides, or if there is none that could be looked through.
pub(super) fn round_of(
    model: &Model,
    program: &Program,
    (loops, motor): (usize, usize),
    found: &[Value],
) -> Option<f64> {
    if !model.turns(model.motor(MotorId::new(motor)).joint) {
        return None;
    }
    let domain = Domain::new(model, program, loops);
    // An angle that a law makes turns with all that the law is made from.
    let whole = Cuts { through: &|_| true, own: None, into: &|_| true };
    let read = domain.read(found, &whole);
    let period = domain.period(motor, &read);
    period.filter(|period| *period < MOST_TURNS)
}
