//! The motion of a point along its path, and of the motors that follow it.

use super::Mover;
use mech_compiler::model::{Inverse, Model};
use mech_compiler::program::{LinkRates, Position, Timing};
use mech_compiler::{Compiled, InverseMechanism, Unreachable};
use mech_core::Pose;
use mech_runtime::{Acceleration, Velocity};
use std::f64::consts::TAU;

/// A point that is led along a path.
#[derive(Clone, Copy)]
pub(super) struct Trajectory<'m> {
    model: &'m Model,
    compiled: &'m Compiled,
    led: &'m Inverse,
    inverted: &'m InverseMechanism,
    timing: &'m Timing,
}

/// Where a point on its path has brought a mechanism.
pub(super) struct Followed {
    position: Position<f64>,
    /// What is given there, with its rates and second rates.
    given: Vec<[f64; 3]>,
    /// The obstacle, if the point did not come there.
    pub(super) stop: Option<Unreachable>,
}

impl<'m> Trajectory<'m> {
    /// That of a mechanism; none without a path.
    pub(super) fn of(model: &'m Model, compiled: &'m Compiled) -> Option<Self> {
        let inverted = compiled.inverse.as_deref()?;
        Some(Self {
            model,
            compiled,
            led: model.inverse.as_ref()?,
            inverted,
            timing: inverted.compiled.timing.as_ref()?,
        })
    }

    /// Leads the point from where the motors have these values to where the path begins, and along it until a time.
    pub(super) fn follow(self, base: &[f64], time: f64) -> Followed {
        /// In so many steps it goes along.
        const STEPS: u32 = 16;
        let Self { model, compiled, .. } = self;
        let params: Vec<f64> = model.params.values().collect();
        let period = model.period();
        let end = period.map_or(time, |period| time.rem_euclid(period));
        let mut machine = Mover::new(model, compiled);
        let mut inverse = Mover::new(&self.inverted.model, &self.inverted.compiled);
        // Motors that were not set as they can be have no way from there.
        let mut stop = machine.move_to(base).err().map(Unreachable::Stopped);
        for step in 0..=STEPS {
            let time = end * f64::from(step) / f64::from(STEPS);
            let given = self.timing.at(time, &params).into_iter();
            let place: Vec<f64> = given.map(|[value, ..]| value).collect();
            stop = stop.or_else(|| machine.lead(model, compiled, &mut inverse, &place).err());
        }
        Followed { position: machine.position(), given: self.timing.at(end, &params), stop }
    }

    /// The values of the motors there, over whole turns.
    pub(super) fn values(self, there: &Followed) -> Vec<f64> {
        let at = &there.position;
        let whole = at.motors.iter().zip(&at.turns);
        let values = whole.map(|(value, turns)| value + TAU * f64::from(*turns));
        values.take(self.model.motors.len()).collect()
    }

    /// The rates and second rates of the motors there, at which what is given has its own, if those of links are computed.
    pub(super) fn rates(self, there: &Followed) -> [Vec<f64>; 2] {
        let Followed { position, given, .. } = there;
        let rest = vec![0.0; self.model.motors.len()];
        let Some(moving) = &self.compiled.moving else {
            return [rest.clone(), rest];
        };
        let mut machine = Mover::of(self.model, moving);
        machine.put_back(position);
        let link = moving.stored.iter().position(|link| *link == self.led.link);
        let rates_of = |rates: [&[f64]; 2]| -> Option<[Vec<f64>; 2]> {
            let found = machine.motion(rates).ok()?;
            Some(self.rates_of_given(&found, link?, Pose::from(position.poses[link?])))
        };
        let columns = self.led.motors.iter().map(|motor| {
            let mut unit = rest.clone();
            unit[motor.index()] = 1.0;
            rates_of([&unit, &rest]).map(|[first, _]| first)
        });
        // Where rates are not determined, they are no numbers, which is told where they are used.
        let unknown = || vec![f64::NAN; rest.len()];
        let Some(columns) = columns.collect::<Option<Vec<Vec<f64>>>>() else {
            return [unknown(), unknown()];
        };
        let solve = |mut wanted: Vec<f64>| {
            let rows = (0..wanted.len()).map(|row| columns.iter().map(move |column| column[row]));
            let mut rows: Vec<Vec<f64>> = rows.map(Iterator::collect).collect();
            mech_core::dense::solve(&mut rows, &mut wanted);
            let mut all = rest.clone();
            for (motor, rate) in self.led.motors.iter().zip(wanted) {
                all[motor.index()] = rate;
            }
            all
        };
        let first = solve(given.iter().map(|[_, first, _]| *first).collect());
        let unforced = rates_of([&first, &rest]);
        let second = unforced.map_or_else(unknown, |[_, unforced]| {
            let wanted = given.iter().zip(unforced);
            solve(wanted.map(|([.., second], one)| second - one).collect())
        });
        [first, second]
    }

    /// The rates and second rates of what is given, from those of its link: without accelerations, the latter are zero.
    fn rates_of_given(self, rates: &LinkRates<f64>, link: usize, pose: Pose<f64>) -> [Vec<f64>; 2] {
        let point = self.led.point;
        let at = point.map_or([0.0; 2], |point| self.model.axis(point).at);
        let [angular, x, y] = rates.velocities[link];
        let velocity = Velocity { angular, x, y };
        let [vx, vy] = velocity.of_point(pose, at);
        let second = rates.accelerations.as_ref().map_or([0.0; 3], |all| {
            let [angular, x, y] = all[link];
            let acceleration = Acceleration { angular, x, y };
            let [ax, ay] = acceleration.of_point(pose, velocity.angular, at);
            [ax, ay, angular]
        });
        let first = [vx, vy, angular];
        let count = self.led.given().len();
        [first, second].map(|rates| rates[..count].to_vec())
    }
}
