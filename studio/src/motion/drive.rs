//! A motion of all motors: one of them alone, or all by their laws.

use super::lead::stopped_on_path;
use super::obstacle::{motor_name, obstacle};
use super::reach::{Reach, limits};
use super::setting::{motor_of, posed, show_value};
use super::trajectory::Trajectory;
use super::{Goal, Mover, Setting, Span, shown};
use crate::failure::{Failure, FailureKind};
use mech_compiler::Compiled;
use mech_compiler::model::{Model, MotorId};
use mech_compiler::program::Position;
use std::f64::consts::TAU;

/// A motion of all motors.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Drive {
    /// The values of all motors before it, in radians or scene units.
    base: Vec<f64>,
    kind: Kind,
    /// Its ends: values of the motor in radians or scene units, or times.
    ends: [f64; 2],
    /// Which of them nobody has said: the mechanism goes no farther.
    found: [bool; 2],
    /// Where the point of `follow` was led before it, and the values of all motors before that: these do not tell how it is assembled there.
    led: Option<(Goal, Vec<f64>)>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
enum Kind {
    /// This motor alone.
    Motor(MotorId),
    /// All motors by their laws of time, with the time after which they are back, if that is known.
    Laws(Option<f64>),
}

/// The state of the motors at a moment.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Moment {
    /// The value that drives the motion: of its motor in radians or scene units, or the time.
    pub(crate) by: f64,
    /// The time since the motion began, in seconds; not finite where the motor rests. By laws it is that of the laws.
    pub(crate) time: f64,
    /// The values of all motors.
    pub(crate) values: Vec<f64>,
    /// Their rates, and their second rates.
    pub(crate) rates: [Vec<f64>; 2],
}

impl Drive {
    /// The motion of one motor, the others as they are set; or that by the laws of the motors, if no motor is named and some have laws.
    ///
    /// Without a span a motor goes through its declared range, or round once, or as far as the mechanism lets it. Laws go on until all
    /// motors are back, or for a unit of time if they never are or are stopped before. Without a name the first motor moves that no setting
    /// puts at a value.
    pub(crate) fn new(
        model: &Model,
        compiled: &Compiled,
        motor: Option<&str>,
        span: Span,
        settings: &[Setting],
    ) -> Result<Self, Failure> {
        let base = set(model, compiled, settings)?;
        if motor.is_none() && model.has_laws() {
            return Ok(Self::by_laws(model, compiled, &base, span));
        }
        let motor = moving_motor(model, motor, settings)?;
        let [from, to] =
            [span.from, span.to].map(|end| end.map(|end| end.of(model, motor)).transpose());
        let (ends, found) = match (from?, to?) {
            (Some(from), Some(to)) => ([from, to], [false; 2]),
            (from, to) => {
                let reach = Reach::of(model, compiled, motor, &base)?;
                let ([low, high], [is_low, is_high]) = (reach.ends, reach.is_stopped());
                (
                    [from.unwrap_or(low), to.unwrap_or(high)],
                    [from.is_none() && is_low, to.is_none() && is_high],
                )
            }
        };
        Ok(Self { base, kind: Kind::Motor(motor), ends, found, led: None })
    }

    /// The motion of one motor through a reach that is known, the others as they are.
    pub(crate) fn through(motor: MotorId, base: &[f64], reach: &Reach) -> Self {
        Self {
            base: base.to_vec(),
            kind: Kind::Motor(motor),
            ends: reach.ends,
            found: reach.is_stopped(),
            led: None,
        }
    }

    /// The first motor where it is set, or where it stands: it moves, but gets nowhere.
    pub(crate) fn standing(
        model: &Model,
        compiled: &Compiled,
        settings: &[Setting],
    ) -> Result<Self, Failure> {
        let base = set(model, compiled, settings)?;
        let motor = moving_motor(model, None, &[])?;
        Ok(Self {
            ends: [base[motor.index()]; 2],
            base,
            kind: Kind::Motor(motor),
            found: [false; 2],
            led: None,
        })
    }

    /// The same with the point of `follow` led to a place, from where the motors are set.
    pub(crate) fn led(
        model: &Model,
        compiled: &Compiled,
        settings: &[Setting],
        goal: &Goal,
    ) -> Result<Self, Failure> {
        let standing = Self::standing(model, compiled, settings)?;
        let mut machine = posed(Mover::new(model, compiled), model, compiled, settings)?;
        goal.lead(model, compiled, &mut machine)?;
        let at = machine.position();
        let whole = at.motors.iter().zip(&at.turns);
        let whole = whole.map(|(value, turns)| value + TAU * f64::from(*turns));
        let base: Vec<f64> = whole.take(model.motors.len()).collect();
        let end = standing.motor().map_or(0.0, |motor| base[motor.index()]);
        Ok(Self { ends: [end; 2], led: Some((goal.clone(), standing.base)), base, ..standing })
    }

    /// The values of all motors before it, as they are set.
    pub(crate) fn settings(&self, model: &Model) -> Vec<Setting> {
        let values = model.motor_ids().map(|motor| {
            let value = shown(model, model.motor(motor).joint, self.base[motor.index()]);
            Setting::from((motor_name(model, motor).to_owned(), value))
        });
        values.collect()
    }

    fn by_laws(model: &Model, compiled: &Compiled, base: &[f64], span: Span) -> Self {
        /// So many steps are made to see whether anything stops the motion.
        const STEPS: u32 = 360;
        let from = span.from.map_or(0.0, |end| end.number);
        let drive = |period: Option<f64>| {
            let to = span.to.map_or(from + period.unwrap_or(1.0), |end| end.number);
            Self {
                base: base.to_vec(),
                kind: Kind::Laws(period),
                ends: [from, to],
                found: [false; 2],
                led: None,
            }
        };
        let round = drive(model.period());
        if span.to.is_some() || round.kind == Kind::Laws(None) {
            return round;
        }
        let parts = (0..=STEPS).map(|number| f64::from(number) / f64::from(STEPS));
        let parts: Vec<f64> = parts.collect();
        let is_free = round.visit(model, compiled, &parts, |_, _| Ok(())).is_ok();
        if is_free { round } else { drive(None) }
    }

    /// The times that it takes, if these are not until all motors are back.
    pub(crate) fn open_times(&self) -> Option<[f64; 2]> {
        (self.kind == Kind::Laws(None)).then_some(self.ends)
    }

    /// Does something with this motion. At ends that were found, rounding decides what is possible: so it is done a hair inside them, and
    /// again farther inside if that fails.
    pub(crate) fn attempt<R>(
        &self,
        mut done: impl FnMut(&Self) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        /// Parts of the way between the ends.
        const HAIRS: [f64; 7] = [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3];
        let mut last = None;
        for hair in HAIRS {
            match done(&self.inside(hair)) {
                Err(failure)
                    if failure.kind() == FailureKind::Mechanism && self.found != [false; 2] =>
                {
                    last = Some(failure);
                }
                done => return done,
            }
        }
        Err(last.unwrap_or_else(|| Failure::internal("nothing was attempted")))
    }

    /// The same motion, with those of its ends that were found moved inwards by this part. An end where the motor stands stays.
    fn inside(&self, hair: f64) -> Self {
        let [from, to] = self.ends;
        let width = hair * (to - from);
        let moved = [from + width, to - width];
        let is_start = |end: f64| self.motor().is_some_and(|one| self.base[one.index()] == end);
        let end = |side: usize| {
            if self.found[side] && !is_start(self.ends[side]) {
                moved[side]
            } else {
                self.ends[side]
            }
        };
        Self { ends: [end(0), end(1)], ..self.clone() }
    }

    /// The motor that moves alone, if one does.
    pub(crate) fn motor(&self) -> Option<MotorId> {
        match self.kind {
            Kind::Motor(motor) => Some(motor),
            Kind::Laws(_) => None,
        }
    }

    /// Whether its end is its beginning: whole turns.
    pub(crate) fn is_cyclic(&self, model: &Model) -> bool {
        let Kind::Motor(motor) = self.kind else {
            return true;
        };
        let whole = (self.ends[1] - self.ends[0]) / TAU;
        model.turns(model.motor(motor).joint)
            && whole != 0.0
            && (whole - whole.round()).abs() < 1e-9
    }

    /// Counts the whole turns of the motion, or the periods of laws; one if there are no whole ones.
    pub(crate) fn turns(&self, model: &Model) -> u32 {
        let one = match self.kind {
            Kind::Motor(_) => TAU,
            Kind::Laws(period) => period.unwrap_or(f64::INFINITY),
        };
        let turns = ((self.ends[1] - self.ends[0]) / one).abs().round();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few turns, else the most"
        )]
        let turns = turns as u32;
        if self.is_cyclic(model) { turns.max(1) } else { 1 }
    }

    /// The same over so many turns, or periods of laws, that everything comes back to where it was, behind gears, too; as it is, if nothing
    /// like that is found.
    pub(crate) fn completed(self, model: &Model, compiled: &Compiled) -> Self {
        /// So many turns are tried.
        const MOST: u32 = 64;
        if self.kind == Kind::Laws(None) {
            return self;
        }
        let [from, to] = self.ends;
        // Rounding would hide what comes back.
        let mut machine = Mover::exact(compiled);
        if !self.is_cyclic(model) || self.move_to(model, compiled, &mut machine, 0.0).is_err() {
            return self;
        }
        let start = machine.position().poses;
        for turns in 1..=MOST {
            let part = f64::from(turns);
            if self.move_to(model, compiled, &mut machine, part).is_err() {
                return self;
            }
            if are_near(&start, &machine.position().poses) {
                let ends = [from, from + (to - from) * part];
                return Self { ends, ..self };
            }
        }
        self
    }

    /// The value that drives the motion, after a part of it.
    fn by(&self, part: f64) -> f64 {
        let [from, to] = self.ends;
        from + (to - from) * part
    }

    /// The moments after a part of the motion where the motor moves at each of these rates; by laws they are the same.
    pub(crate) fn moments(
        &self,
        model: &Model,
        compiled: &Compiled,
        part: f64,
        rates: [f64; 2],
    ) -> [Moment; 2] {
        let [first, second] = rates;
        let moment = self.moment(model, compiled, part, first);
        let other = match self.kind {
            Kind::Motor(_) => self.moment(model, compiled, part, second),
            Kind::Laws(_) => moment.clone(),
        };
        [moment, other]
    }

    /// Computes the moment after a part of the motion, 0 to 1, where the motor moves at this rate; by laws at theirs.
    pub(crate) fn moment(
        &self,
        model: &Model,
        compiled: &Compiled,
        part: f64,
        rate: f64,
    ) -> Moment {
        let by = self.by(part);
        let [from, _] = self.ends;
        let time = match self.kind {
            Kind::Motor(_) => (by - from) / rate,
            Kind::Laws(_) => by,
        };
        let mut values = self.base.clone();
        let mut rates = [vec![0.0; values.len()], vec![0.0; values.len()]];
        match (self.kind, &compiled.timing) {
            (Kind::Motor(motor), _) => {
                values[motor.index()] = by;
                rates[0][motor.index()] = rate;
            }
            (Kind::Laws(_), Some(timing)) => {
                let params: Vec<f64> = model.params.values().collect();
                for (law, found) in timing.motors.iter().zip(timing.at(by, &params)) {
                    let motor = law.motor.index();
                    values[motor] = found[0];
                    rates[0][motor] = found[1];
                    rates[1][motor] = found[2];
                }
            }
            (Kind::Laws(_), None) => {
                if let Some(trajectory) = Trajectory::of(model, compiled) {
                    let there = trajectory.follow(&self.base, by);
                    (values, rates) = (trajectory.values(&there), trajectory.rates(&there));
                }
            }
        }
        Moment { by, time, values, rates }
    }

    /// Moves a mechanism to a part of the motion.
    pub(crate) fn move_to(
        &self,
        model: &Model,
        compiled: &Compiled,
        machine: &mut Mover<'_>,
        part: f64,
    ) -> Result<(), Failure> {
        let by = self.by(part);
        let trajectory = Trajectory::of(model, compiled);
        let values = if let (Kind::Laws(_), Some(trajectory)) = (self.kind, trajectory) {
            let there = trajectory.follow(&self.base, by);
            if let Some(why) = there.stop {
                return Err(stopped_on_path(model, compiled, by, why));
            }
            trajectory.values(&there)
        } else {
            self.moment(model, compiled, part, 0.0).values
        };
        machine.move_to(&values).map_err(|stop| {
            let why = obstacle(model, compiled, stop);
            Failure::mechanism(match self.kind {
                Kind::Motor(motor) => {
                    let joint = model.motor(motor).joint;
                    let value = show_value(model, joint, by);
                    let name = motor_name(model, motor);
                    format!(
                        "motor `{name}` cannot come to {value}: {why}{}",
                        limits(model, compiled, motor, &self.base)
                    )
                }
                Kind::Laws(_) => format!("the motors cannot follow their laws at t = {by}: {why}"),
            })
        })
    }

    /// Looks at a mechanism in these parts of the motion, each with its number. A motor goes from where it stands first up, then down:
    /// so it comes last to the ends of what is possible, beyond which nothing would go on from there.
    pub(crate) fn visit(
        &self,
        model: &Model,
        compiled: &Compiled,
        parts: &[f64],
        mut look: impl FnMut(usize, &Position<f64>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let mut machine = Mover::new(model, compiled);
        if let Some((goal, before)) = &self.led {
            machine
                .move_to(before)
                .map_err(|stop| Failure::mechanism(obstacle(model, compiled, stop)))?;
            goal.lead(model, compiled, &mut machine)?;
            let at = machine.position();
            return (0..parts.len()).try_for_each(|number| look(number, &at));
        }
        let mut visit = |machine: &mut Mover<'_>, numbers: &[usize]| {
            numbers.iter().try_for_each(|&number| {
                self.move_to(model, compiled, machine, parts[number])?;
                look(number, &machine.position())
            })
        };
        let all: Vec<usize> = (0..parts.len()).collect();
        let Some(motor) = self.motor().filter(|_| machine.move_to(&self.base).is_ok()) else {
            return visit(&mut machine, &all);
        };
        let start = machine.position();
        let ahead = |number: usize| {
            let [from, to] = self.ends;
            from + (to - from) * parts[number] - self.base[motor.index()]
        };
        let (mut up, mut down): (Vec<usize>, Vec<usize>) =
            all.into_iter().partition(|&number| ahead(number) >= 0.0);
        let nearer = |a: &usize, b: &usize| ahead(*a).abs().total_cmp(&ahead(*b).abs());
        up.sort_by(nearer);
        down.sort_by(nearer);
        visit(&mut machine, &up)?;
        machine.put_back(&start);
        visit(&mut machine, &down)
    }
}

/// The values of all motors as they are set; others are at their start.
fn set(model: &Model, compiled: &Compiled, settings: &[Setting]) -> Result<Vec<f64>, Failure> {
    let mut values = compiled.program.start.motors[..model.motors.len()].to_vec();
    for setting in settings {
        let (motor, value) = setting.resolve(model)?;
        values[motor.index()] = value;
    }
    Ok(values)
}

/// The motor of this name; without one the first that no setting puts at a value, as two cannot say where it is.
fn moving_motor(
    model: &Model,
    name: Option<&str>,
    settings: &[Setting],
) -> Result<MotorId, Failure> {
    let is_put = |motor: MotorId| {
        let mut settings = settings.iter();
        settings.any(|one| one.motor == motor_name(model, motor))
    };
    if model.motors.is_empty() {
        return Err(Failure::mechanism("the mechanism has no motor"));
    }
    let Some(name) = name else {
        let free = model.motor_ids().find(|&motor| !is_put(motor));
        return free.ok_or_else(|| {
            Failure::usage("`--at` puts every motor at a value, so that none can move")
        });
    };
    let motor = motor_of(model, name)?;
    if is_put(motor) {
        return Err(Failure::usage(format!(
            "motor `{name}` moves, so `--at` cannot put it at a value; say where with `--from` and `--to`"
        )));
    }
    Ok(motor)
}

/// Whether links with these poses are seen at the same places.
fn are_near(a: &[[f64; 4]], b: &[[f64; 4]]) -> bool {
    const NEAR: f64 = 1e-6;
    let size = a.iter().flatten().fold(1.0, |size: f64, part| size.max(part.abs()));
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.into_iter().all(|(a, b)| (a - b).abs() < NEAR * size)
}
