//! Motion under forces by the laws of Newton and Euler, on the joints' equations, in steps of Runge and Kutta: a judge of `simulate`.

use super::Judge;
use mech_compiler::model::{AxisId, Between, JointId, JointKind, LinkId};
use nalgebra::{DMatrix, DVector};

/// A mechanism that moves under gravity, springs and dampers. Its motors are free.
#[derive(Clone, Debug)]
pub struct Fall<'j> {
    judge: &'j Judge<'j>,
    place: DVector<f64>,
    /// The rates of the motors.
    pub rates: Vec<f64>,
    /// What is added to the coordinates of joints that turn, for their whole turns.
    turns: Vec<f64>,
    /// How fast links have moved at most, as parts of the rate of a motor that moves alone, both in units: it grows without bound towards
    /// a dead point.
    pub gain: f64,
}

/// How a state changes: the rates of all links, and the second rates of the motors.
struct Change {
    place: DVector<f64>,
    rates: Vec<f64>,
    gain: f64,
}

impl<'j> Fall<'j> {
    /// At the judge's start, with these rates of the motors and these coordinates of all joints that turn.
    #[must_use]
    pub fn new(judge: &'j Judge<'j>, rates: &[f64], angles: &[f64]) -> Self {
        let place = judge.start().0;
        let turns = angles.iter().enumerate().map(|(joint, angle)| {
            let joint = JointId::new(joint);
            if judge.is_angle(joint) { angle - judge.coordinate(&place, joint).value } else { 0.0 }
        });
        Self { judge, turns: turns.collect(), place, rates: rates.to_vec(), gain: 0.0 }
    }

    /// The values of the motors.
    #[must_use]
    pub fn motors(&self) -> Vec<f64> {
        let motors = self.judge.model.motors.iter().zip(&self.judge.offsets);
        let value = |(motor, offset): (&mech_compiler::model::Motor, &f64)| {
            (self.judge.coordinate(&self.place, motor.joint).value + offset)
                * self.scale(motor.joint)
        };
        motors.map(value).collect()
    }

    /// A step of time. None where nothing can be told.
    #[must_use]
    pub fn step(&mut self, time: f64) -> Option<()> {
        let first = self.change(&self.place, &self.rates)?;
        let on = |change: &Change, time: f64| {
            let place = &self.place + &change.place * time;
            let rates = self.rates.iter().zip(&change.rates);
            let rates: Vec<f64> = rates.map(|(rate, second)| rate + time * second).collect();
            self.change(&place, &rates)
        };
        let second = on(&first, 0.5 * time)?;
        let third = on(&second, 0.5 * time)?;
        let fourth = on(&third, time)?;
        let all = [(&first, 1.0), (&second, 2.0), (&third, 2.0), (&fourth, 1.0)];
        for (change, weight) in all {
            self.place += &change.place * (time * weight / 6.0);
            for (rate, second) in self.rates.iter_mut().zip(&change.rates) {
                *rate += time * weight / 6.0 * second;
            }
            self.gain = self.gain.max(change.gain);
        }
        self.close()
    }

    /// The scene's measure of a joint's coordinate.
    fn scale(&self, joint: JointId) -> f64 {
        if self.judge.is_angle(joint) { 1.0 } else { self.judge.unit }
    }

    /// The derivatives of all equations by the places of links, those of the motors last.
    fn slopes(&self, place: &DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
        let none = vec![0.0; self.judge.model.motors.len()];
        let all = self.judge.equations(place, [&none, &none]);
        let columns = all.slopes.ncols() - 1;
        (all.slopes.columns(0, columns).into_owned(), all.residuals)
    }

    /// Lets the joints close again; the motors stay where they are.
    fn close(&mut self) -> Option<()> {
        let motors = self.judge.model.motors.len();
        for _ in 0..2 {
            let (slopes, mut off) = self.slopes(&self.place);
            let rows = off.len();
            off.rows_mut(rows - motors, motors).fill(0.0);
            let change = least_squares(&slopes, &DMatrix::from_columns(&[off]))?;
            let columns = change.nrows();
            let mut closed = self.place.rows_mut(0, columns);
            closed -= change.column(0);
        }
        self.place.iter().all(|one| one.is_finite()).then_some(())
    }

    fn change(&self, place: &DVector<f64>, rates: &[f64]) -> Option<Change> {
        let (judge, model) = (self.judge, self.judge.model);
        let motors = model.motors.len();
        let (slopes, _) = self.slopes(place);
        let (rows, columns) = slopes.shape();
        // How links move for a unit rate of each motor.
        let mut units = DMatrix::zeros(rows, motors);
        for (number, motor) in model.motors.iter().enumerate() {
            units[(rows - motors + number, number)] = 1.0 / self.scale(motor.joint);
        }
        let ways = least_squares(&slopes, &units)?;
        let moved = &ways * DVector::from_column_slice(rates);
        // How the slopes change on the way, and what accelerates links while the motors do not.
        let size = moved.amax().max(1e-9);
        let difference = |by: f64| {
            let mut there = place.clone();
            let mut part = there.rows_mut(0, columns);
            part += &moved * (by / size);
            self.slopes(&there).0
        };
        let near = difference(1e-3) - difference(-1e-3);
        let far = difference(2e-3) - difference(-2e-3);
        let bend = (near * 8.0 - far) * (size / 12e-3);
        let turning = least_squares(&slopes, &DMatrix::from_columns(&[-(bend * &moved)]))?;
        let (mut inertia, mut drive) = (DMatrix::zeros(motors, motors), DVector::zeros(motors));
        let unit = judge.unit;
        for link in model.link_ids().filter(|link| *link != LinkId::GROUND) {
            let Some(mass) = model.link(link).mass else {
                continue;
            };
            let first = 3 * link.index() - 3;
            let arm = self.arm(place, link, mass.center);
            let by_motor = |number: usize| of_point(&ways.column(number).into_owned(), first, arm);
            let turn = moved[first + 2];
            let own = of_point(&turning.column(0).into_owned(), first, arm);
            let own = [0, 1].map(|part| own[part] - turn * turn * arm[part]);
            let gravity = model.actions.gravity.unwrap_or_default();
            for k in 0..motors {
                let at = by_motor(k);
                let turned = ways[(first + 2, k)];
                for l in 0..motors {
                    let other = by_motor(l);
                    inertia[(k, l)] +=
                        mass.mass * unit * unit * (at[0] * other[0] + at[1] * other[1])
                            + mass.inertia * turned * ways[(first + 2, l)];
                }
                let force = [0, 1].map(|part| mass.mass * (gravity[part] - unit * own[part]));
                drive[k] += unit * (at[0] * force[0] + at[1] * force[1])
                    - mass.inertia * turned * turning[(first + 2, 0)];
            }
        }
        let acting = self.acting(place, &moved);
        drive += ways.transpose() * acting;
        let seconds = inertia.cholesky()?.solve(&drive);
        let gain = model.motors.iter().enumerate().fold(0.0_f64, |most, (number, motor)| {
            most.max(ways.column(number).amax() * self.scale(motor.joint))
        });
        let mut change = DVector::zeros(columns + 1);
        change.rows_mut(0, columns).copy_from(&moved);
        seconds.iter().all(|one| one.is_finite()).then(|| Change {
            place: change,
            rates: seconds.as_slice().to_vec(),
            gain,
        })
    }

    /// From the centre of a link to one of its points, in the scene, in units.
    fn arm(&self, place: &DVector<f64>, link: LinkId, point: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = Judge::place(place, link)[2].sin_cos();
        let center = self.judge.centers[link.index()];
        let [x, y] = [0, 1].map(|part| (point[part] - center[part]) / self.judge.unit);
        [cos * x - sin * y, sin * x + cos * y]
    }

    /// What springs and dampers do to all links: a force and a moment about the centre for each, in units of length.
    fn acting(&self, place: &DVector<f64>, moved: &DVector<f64>) -> DVector<f64> {
        let (judge, model) = (self.judge, self.judge.model);
        let mut all = DVector::zeros(moved.len());
        let springs = model.actions.springs.iter();
        let springs = springs.map(|spring| (spring.between, spring.stiffness, spring.rest, 0.0));
        let dampers = model.actions.dampers.iter();
        let dampers = dampers.map(|damper| (damper.between, 0.0, 0.0, damper.damping));
        for (between, stiffness, rest, damping) in springs.chain(dampers) {
            match between {
                Between::Points(a, b) => {
                    let ends = [a, b].map(|axis| self.point(place, moved, axis));
                    let [apart, fast] = [0, 1].map(|kind| {
                        [0, 1].map(|part| judge.unit * (ends[1][kind][part] - ends[0][kind][part]))
                    });
                    let length = apart[0].hypot(apart[1]).max(1e-300);
                    let along = apart.map(|part| part / length);
                    let rate = fast[0] * along[0] + fast[1] * along[1];
                    let pull = stiffness * (length - rest) + damping * rate;
                    for (axis, [_, _, arm], sign) in [(a, ends[0], 1.0), (b, ends[1], -1.0)] {
                        let link = model.axis(axis).link;
                        if link != LinkId::GROUND {
                            let first = 3 * link.index() - 3;
                            let force = along.map(|part| sign * pull * judge.unit * part);
                            all[first] += force[0];
                            all[first + 1] += force[1];
                            all[first + 2] += arm[0] * force[1] - arm[1] * force[0];
                        }
                    }
                }
                Between::Joint(joint) => {
                    let JointKind::Revolute(a, b) = model.joint(joint).kind else {
                        panic!("a spring turns revolutes");
                    };
                    let angle = judge.coordinate(place, joint).value + self.turns[joint.index()];
                    let turn = |axis: AxisId| match model.axis(axis).link {
                        LinkId::GROUND => 0.0,
                        link => moved[3 * link.index() - 1],
                    };
                    let torque = stiffness * (angle - rest) + damping * (turn(b) - turn(a));
                    for (axis, torque) in [(a, torque), (b, -torque)] {
                        let link = model.axis(axis).link;
                        if link != LinkId::GROUND {
                            all[3 * link.index() - 1] += torque;
                        }
                    }
                }
            }
        }
        all
    }

    /// Place, velocity and arm of a point.
    fn point(&self, place: &DVector<f64>, moved: &DVector<f64>, axis: AxisId) -> [[f64; 2]; 3] {
        let axis = self.judge.model.axis(axis);
        let link = axis.link;
        if link == LinkId::GROUND {
            return [axis.at.map(|part| part / self.judge.unit), [0.0; 2], [0.0; 2]];
        }
        let arm = self.arm(place, link, axis.at);
        let [x, y, _] = Judge::place(place, link);
        [[x + arm[0], y + arm[1]], of_point(moved, 3 * link.index() - 3, arm), arm]
    }
}

/// The part of a point in how its link moves.
fn of_point(moved: &DVector<f64>, first: usize, arm: [f64; 2]) -> [f64; 2] {
    let turn = moved[first + 2];
    [moved[first] - turn * arm[1], moved[first + 1] + turn * arm[0]]
}

/// What fulfils these equations best, of which there may be more than needed.
fn least_squares(slopes: &DMatrix<f64>, right: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let columns = slopes.ncols();
    let qr = slopes.clone().qr();
    let mut turned = right.clone();
    qr.q_tr_mul(&mut turned);
    let found = qr.r().solve_upper_triangular(&turned.rows(0, columns).into_owned())?;
    found.iter().all(|one| one.is_finite()).then_some(found)
}
