//! Limits of what is measured on a way, and whether an answer to one is true.

use super::subject::{Named, Subject};
use super::sweep::{Sweep, slope};
use mech_compiler::model::MotorId;
use mech_compiler::structure::Witness;
use mech_test_support::Dice;

/// A value is known to this part of the size of what is measured.
const ROUNDING: f64 = 1e-9;

/// A place that breaks a limit has the value that is told, to this part of the size.
const ALIKE: f64 = 1e-7;

/// Limits are so far from the true extreme, at least and at most: as a part of what the quantity makes.
const MARGINS: [f64; 2] = [1e-3, 0.5];

/// What samples tell so badly that no limit may be nearer than this is not asked.
const LEAST_MOST: f64 = 0.1;

/// What is bounded of a subject.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure {
    Value,
    Least,
    Greatest,
    Swing,
    Mean,
    Rms,
    /// How fast it changes with the motor.
    Slope,
}

impl Measure {
    /// Any of them: half of them the subject itself, and few of those that are found slowly.
    fn any(dice: &mut Dice) -> Self {
        if dice.once_in(2) {
            return Self::Value;
        }
        let mean = if dice.once_in(2) { Self::Mean } else { Self::Rms };
        *dice.pick(&[Self::Least, Self::Greatest, Self::Swing, Self::Slope, mean])
    }

    /// Whether it sums up the motion.
    fn sums_up(self) -> bool {
        !matches!(self, Self::Value | Self::Slope)
    }

    /// The text of it.
    fn of(self, subject: &str, motor: &str) -> String {
        match self {
            Self::Value => subject.to_owned(),
            Self::Least => format!("min({subject})"),
            Self::Greatest => format!("max({subject})"),
            Self::Swing => format!("swing({subject})"),
            Self::Mean => format!("mean({subject})"),
            Self::Rms => format!("rms({subject})"),
            Self::Slope => format!("d({subject}, {motor})"),
        }
    }
}

/// What samples tell of a quantity.
pub(super) struct Truth {
    /// Its least and its greatest value.
    extremes: [f64; 2],
    /// How wide it may be beside which limits are chosen.
    wide: f64,
    /// How much the samples may be wrong.
    doubt: f64,
}

impl Truth {
    /// What the samples of a subject tell on some steps; none if they do not tell it well.
    pub(super) fn of(
        sweep: &Sweep<'_>,
        number: usize,
        measure: Measure,
        [low, high]: [usize; 2],
    ) -> Option<Self> {
        let values = &sweep.values(number)[low..=high];
        let [least, greatest] = extremes(values.iter().copied());
        let wide = greatest - least;
        let size = sweep.model.size().max(1.0);
        let sure = |value: f64, doubt: f64| Self {
            extremes: [value; 2],
            wide: value.abs().max(wide),
            doubt,
        };
        let truth = match measure {
            Measure::Value => Self { extremes: [least, greatest], wide, doubt: 0.0 },
            Measure::Least | Measure::Greatest | Measure::Swing => {
                let value = match measure {
                    Measure::Least => least,
                    Measure::Greatest => greatest,
                    _ => wide,
                };
                // A swing has two.
                sure(value, 2.0 * bend(values))
            }
            Measure::Mean => {
                let [mean, doubt] = mean(values.to_vec());
                sure(mean, doubt)
            }
            Measure::Rms => {
                let [mean, doubt] = mean(values.iter().map(|value| value * value).collect());
                let value = mean.sqrt();
                sure(value, doubt / value)
            }
            Measure::Slope => {
                let around = &sweep.values(number)[low.checked_sub(2)?..];
                let slopes = around.windows(9).take(high - low - 3);
                let slopes: Vec<[f64; 2]> = slopes
                    .map(|nine| slope(nine.try_into().expect("nine"), sweep.step()))
                    .collect();
                let doubts = slopes.iter().map(|[_, doubt]| *doubt);
                let doubt = doubts.fold(0.0, f64::max);
                let extremes = extremes(slopes.iter().map(|[slope, _]| *slope));
                Self { extremes, wide: extremes[1] - extremes[0], doubt }
            }
        };
        let is_moving = wide > 1e-6 * size && truth.wide > 1e-6 && wide < 100.0 * size;
        (is_moving && truth.least_margin() < LEAST_MOST).then_some(truth)
    }

    /// How near a limit may be to an extreme, as a part of what the quantity makes, so that samples tell whether it is kept.
    fn least_margin(&self) -> f64 {
        MARGINS[0].max(20.0 * self.doubt / self.wide)
    }

    /// How far a limit is from an extreme: of any order of magnitude.
    fn slack(&self, dice: &mut Dice) -> f64 {
        let [least, most] = [self.least_margin(), MARGINS[1]].map(f64::ln);
        self.wide * dice.between(least, most).exp()
    }
}

fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, greatest], value| {
        [least.min(value), greatest.max(value)]
    })
}

/// By how much an extreme between two samples may exceed them.
fn bend(values: &[f64]) -> f64 {
    let bends = values.windows(3).map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
    // A kink does so by a little less, a parabola by a fifth of that.
    0.6 * bends.fold(0.0, f64::max)
}

/// The mean of values of which every two have a third in their middle, by Simpson's rule; and how much it is in doubt.
fn mean(values: Vec<f64>) -> [f64; 2] {
    let simpson = |values: &[f64]| {
        let pieces = values.windows(3).step_by(2);
        #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
        let count = pieces.len() as f64;
        pieces.map(|piece| (piece[0] + 4.0 * piece[1] + piece[2]) / 6.0).sum::<f64>() / count
    };
    let fine = simpson(&values);
    let rough: Vec<f64> = values.into_iter().step_by(2).collect();
    [fine, (fine - simpson(&rough)).abs()]
}

/// A limit on one side, or on both.
#[derive(Clone, Copy, Debug)]
struct Limits {
    least: Option<f64>,
    greatest: Option<f64>,
}

impl Limits {
    /// Near to extremes: about half of them are kept.
    fn any([least, greatest]: [f64; 2], truth: &Truth, dice: &mut Dice) -> Self {
        let mut beside = |extreme: f64| {
            let slack = truth.slack(dice);
            extreme + if dice.once_in(2) { slack } else { -slack }
        };
        let (low, high) = (beside(least), beside(greatest));
        let [has_low, has_high] = *dice.pick(&[[true, false], [false, true], [true, true]]);
        Self {
            least: has_low.then_some(low),
            greatest: (has_high && !(has_low && high < low)).then_some(high),
        }
    }

    /// Whether a value is beyond them by more than it is in doubt.
    fn are_broken(self, value: f64, doubt: f64) -> bool {
        self.least.is_some_and(|least| value < least - doubt)
            || self.greatest.is_some_and(|greatest| value > greatest + doubt)
    }

    fn text(self, is_angle: bool) -> String {
        let number = |value: f64| {
            if is_angle { format!("{} deg", value.to_degrees()) } else { format!("{value}") }
        };
        match (self.least.map(number), self.greatest.map(number)) {
            (Some(least), Some(greatest)) => format!("in {least} ..= {greatest}"),
            (Some(least), None) => format!(">= {least}"),
            (None, Some(greatest)) => format!("<= {greatest}"),
            (None, None) => String::new(),
        }
    }
}

/// A requirement, and what samples tell of what it bounds.
pub(super) struct Question<'s, 'm> {
    sweep: &'s Sweep<'m>,
    subject: Subject,
    number: usize,
    measure: Measure,
    span: [usize; 2],
    truth: Truth,
    limits: Limits,
    /// It as a statement.
    pub(super) text: String,
}

impl<'s, 'm> Question<'s, 'm> {
    /// About anything on any part of a way; none if samples do not tell it well.
    pub(super) fn any(
        sweep: &'s Sweep<'m>,
        subjects: &[Named],
        span: [usize; 2],
        dice: &mut Dice,
    ) -> Option<Self> {
        let number = dice.below(subjects.len());
        let (name, subject) = &subjects[number];
        let measure = Measure::any(dice);
        if measure.sums_up() && !sweep.is_only_way {
            return None;
        }
        let truth = Truth::of(sweep, number, measure, span)?;
        let limits = Limits::any(truth.extremes, &truth, dice);
        let motor = |motor: usize| &sweep.model.joint(sweep.model.motors[motor].joint).name;
        let others = (0..sweep.from.len()).filter(|other| *other != sweep.motor);
        let others = others.map(|other| format!("{} = {}", motor(other), sweep.from[other]));
        let others: Vec<String> = others.collect();
        let at = if others.is_empty() { "" } else { " at " };
        let is_angle = subject.is_angle(sweep.model) && measure != Measure::Slope;
        let own = motor(sweep.motor);
        let text = format!(
            "expect {} {} for {own} in {} ..= {}{at}{};",
            measure.of(name, own),
            limits.text(is_angle),
            sweep.at(span[0]),
            sweep.at(span[1]),
            others.join(", ")
        );
        Some(Self { sweep, subject: *subject, number, measure, span, truth, limits, text })
    }

    /// What it bounds, in a word or two.
    pub(super) fn kind(&self) -> String {
        let subject = format!("{:?}", self.subject);
        let subject = subject.split('(').next().unwrap_or_default();
        format!("{:?} of {subject}", self.measure)
    }

    fn size(&self) -> f64 {
        let [least, greatest] = self.truth.extremes;
        let size = self.sweep.model.size().max(1.0);
        size.max(least.abs()).max(greatest.abs())
    }

    /// What is wrong if it is proved: samples that break it.
    pub(super) fn refute_proof(&self) -> Result<(), String> {
        let doubt = self.truth.doubt + ROUNDING * self.size();
        let mut extremes = self.truth.extremes.into_iter();
        match extremes.find(|extreme| self.limits.are_broken(*extreme, doubt)) {
            Some(extreme) => Err(format!("proved, but it is {extreme}")),
            None => Ok(()),
        }
    }

    /// What is wrong with a witness: it is elsewhere, is not reached, or does not break it.
    pub(super) fn refute(&self, witness: &Witness) -> Result<(), String> {
        let places = witness.places.iter().map(|place| self.goal(&place.motors));
        let places: Vec<Vec<f64>> = places.collect::<Result<_, _>>()?;
        let measured = self.measure_at(&places);
        let (value, doubt) = measured.ok_or_else(|| format!("{places:?} do not show it"))?;
        let wrong = |what: &str| Err(format!("{value} at {places:?} {what}: {witness:?}"));
        let alike = ALIKE * self.size();
        let alike = match (self.measure, witness.proved) {
            // Beside a change point rounding spoils the slope that is told, by its precision over the square of the sine. Whether it breaks
            // the limit is measured.
            (Measure::Slope, _) => 1e-2 * value.abs().max(1.0),
            // A mean is told by its bounds, which are as near to each other as the requirement needs.
            // Where no other limit is proved, these are as near as the time allowed; samples tell whether it breaks its limit.
            (Measure::Mean | Measure::Rms, None) => 0.1 * self.size(),
            (Measure::Mean | Measure::Rms, Some(proved)) => {
                alike.max((proved - witness.value).abs())
            }
            _ => alike,
        };
        if (value - witness.value).abs() > alike + doubt {
            return wrong("is not what is told");
        }
        if !self.limits.are_broken(value, -doubt) {
            return wrong("does not break it");
        }
        let [least, greatest] = self.truth.extremes;
        let is_worse = witness.proved.is_some_and(|proved| {
            let doubt = self.truth.doubt + ROUNDING * self.size();
            let beyond = if witness.is_upper { greatest - proved } else { proved - least };
            beyond > doubt
        });
        if is_worse {
            return wrong(&format!("is said to be the worst of {least} to {greatest}"));
        }
        Ok(())
    }

    /// The values of all motors at a place that is told.
    fn goal(&self, place: &[(MotorId, f64)]) -> Result<Vec<f64>, String> {
        let mut goal = self.sweep.program.start.motors.clone();
        for (motor, value) in place {
            goal[motor.index()] = *value;
        }
        let own = goal[self.sweep.motor];
        let [low, high] = self.span.map(|step| self.sweep.at(step));
        if own < low || own > high {
            return Err(format!("{own} is not between {low} and {high}"));
        }
        Ok(goal)
    }

    /// What the quantity is where places show it, and how much that is in doubt.
    fn measure_at(&self, places: &[Vec<f64>]) -> Option<(f64, f64)> {
        let sweep = self.sweep;
        let near = |place: &[f64]| {
            let step = sweep.nearest(place[sweep.motor]);
            sweep.values(self.number)[step]
        };
        let at = |place: &[f64]| sweep.visit(self.subject, place, near(place));
        match (self.measure, places) {
            (Measure::Value | Measure::Least | Measure::Greatest, [place]) => {
                Some((at(place)?, 0.0))
            }
            (Measure::Swing, [first, second]) => Some((at(second)? - at(first)?, 0.0)),
            (Measure::Slope, [place]) => {
                let [slope, doubt] = sweep.slope_at(self.subject, place, near(place))?;
                Some((slope, doubt + ROUNDING * self.size()))
            }
            (Measure::Mean | Measure::Rms, []) => {
                let [value, _] = self.truth.extremes;
                Some((value, self.truth.doubt))
            }
            _ => None,
        }
    }
}
