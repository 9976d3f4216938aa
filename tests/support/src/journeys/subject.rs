//! From the text of a mechanism to what can be moved and judged.

use crate::judge::{Curve, End, Judge, Place};
use crate::{size, with_ground};
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, Model};
use mech_compiler::program::Position;
use mech_compiler::program::Real;
use mech_compiler::syntax::parse;
use mech_compiler::{Compiled, compile, reporter};

/// A mechanism that compiles.
pub struct Subject {
    /// Its text.
    pub text: String,
    /// What the text declares.
    pub model: Model,
    /// What the compiler makes of it.
    pub compiled: Compiled,
}

impl Subject {
    /// Reads and compiles a text.
    ///
    /// # Errors
    /// What the compiler says.
    pub fn read(text: &str) -> Result<Self, String> {
        let tokens = text.parse().map_err(|error| format!("no text of a mechanism: {error}"))?;
        let parsed = parse(tokens);
        if let Some(error) = parsed.errors.first() {
            return Err(format!("no text of a mechanism: {}", error.text));
        }
        let model = parsed.model;
        let compiled = compile(&model).map_err(|wrong| {
            let messages: Vec<String> =
                wrong.iter().map(|one| reporter::text(one, &model)).collect();
            messages.join("; ")
        })?;
        Ok(Self { text: text.to_owned(), model, compiled })
    }

    /// The mechanism of a text that is right.
    ///
    /// # Panics
    /// If it is not.
    #[must_use]
    pub fn of(text: &str) -> Self {
        Self::read(text).unwrap_or_else(|why| panic!("{why}\n{text}"))
    }

    /// The mechanism of a text in which a word stands for a number or a ratio.
    ///
    /// # Panics
    /// If it is not right.
    #[must_use]
    pub fn with(text: &str, word: &str, value: &str) -> Self {
        Self::of(&text.replace(word, value))
    }

    /// A length that poses are measured by.
    #[must_use]
    pub fn extent(&self, poses: &[[f64; 4]]) -> f64 {
        let far = poses.iter().map(|[_, _, x, y]| x.hypot(*y));
        far.fold(size(&self.model), f64::max).max(1e-9)
    }

    /// By how much all gears together make what a motor turns greater, at most.
    #[must_use]
    pub fn gain(&self) -> f64 {
        let gains = self.model.joints.iter().map(|joint| match joint.kind {
            JointKind::Gear { ratio, .. } | JointKind::Belt { ratio, .. } => {
                let [a, b] = ratio.sizes().map(f64::abs);
                (a / b).max(b / a)
            }
            _ => 1.0,
        });
        gains.product()
    }

    /// The judge at a position.
    #[must_use]
    pub fn judge_at(&self, at: &Position<f64>) -> Judge<'_> {
        Judge::new(&self.model, &self.compiled.structure.rollings, &self.poses(at), &at.motors)
    }

    /// The poses of all links, the ground first.
    #[must_use]
    pub fn poses<T: Real>(&self, at: &Position<T>) -> Vec<[f64; 4]> {
        let poses: Vec<[f64; 4]> = at.poses.iter().map(|pose| pose.map(T::to_f64)).collect();
        with_ground(&self.model, &poses)
    }

    /// The judge where the mechanism is assembled.
    #[must_use]
    pub fn judge(&self) -> Judge<'_> {
        self.judge_at(Machine::<f64>::new(&self.compiled.program).position())
    }

    /// Whether a motor slides.
    #[must_use]
    pub fn slides(&self, motor: usize) -> bool {
        matches!(self.model.joint(self.model.motors[motor].joint).kind, JointKind::Prismatic(..))
    }
}

/// All that one motor can do from the start, to both sides; or one move of several motors, as parts of it.
pub struct Track<'j> {
    judge: &'j Judge<'j>,
    start: f64,
    reach: f64,
    /// To greater values, and to lesser ones.
    sides: Vec<Curve<'j>>,
}

/// What the judge says of a value of the motor.
pub enum Judged {
    /// There the links are so, where rounding is so many times more than itself.
    Reached(Vec<[f64; 4]>, f64),
    /// It stops before, at this value.
    Beyond(f64),
    /// Links are too far away to be judged.
    Far,
    /// The judge does not know.
    Unknown,
}

impl<'j> Track<'j> {
    /// Follows the motor to both sides.
    #[must_use]
    pub fn new(judge: &'j Judge<'j>, start: f64, reach: f64) -> Self {
        let side = |by: f64| Curve::new(judge, &judge.start(), [&[start], &[start + by]]);
        Self { judge, start, reach, sides: vec![side(reach), side(-reach)] }
    }

    /// Follows one move.
    #[must_use]
    pub fn of_move(judge: &'j Judge<'j>, place: &Place, motors: [&[f64]; 2]) -> Self {
        Self { judge, start: 0.0, reach: 1.0, sides: vec![Curve::new(judge, place, motors)] }
    }

    /// Where a move leads.
    #[must_use]
    pub fn target(&self) -> Option<Place> {
        Some(self.sides[0].at(1.0)?.0)
    }

    fn side(&self, value: f64) -> (&Curve<'j>, f64) {
        let by = value - self.start;
        (&self.sides[usize::from(by < 0.0).min(self.sides.len() - 1)], by.abs() / self.reach)
    }

    /// What it says of a value.
    #[must_use]
    pub fn judge(&self, value: f64) -> Judged {
        let (curve, part) = self.side(value);
        let end = match curve.end {
            End::Arrives => 1.0,
            End::Stops(end) | End::RunsAway(end) | End::GivesUp(end, _) => end,
        };
        if part <= end
            && let Some((place, condition)) = curve.at(part)
        {
            return Judged::Reached(self.judge.poses(&place), condition);
        }
        match curve.end {
            End::Stops(end) => {
                Judged::Beyond(self.start + end * self.reach * (value - self.start).signum())
            }
            End::RunsAway(_) => Judged::Far,
            _ => Judged::Unknown,
        }
    }

    /// The values at which it goes through crossings.
    #[must_use]
    pub fn crossings(&self) -> Vec<f64> {
        let sides = self.sides.iter().zip([1.0, -1.0]);
        let values = sides.flat_map(|(side, sign)| {
            side.crossings.iter().map(move |part| self.start + sign * part * self.reach)
        });
        values.collect()
    }

    /// How near it comes to where curves cross without going through.
    #[must_use]
    pub fn nearest(&self) -> f64 {
        self.sides.iter().map(|side| side.nearest).fold(f64::INFINITY, f64::min)
    }

    /// Why it is not known farther, if it is not.
    #[must_use]
    pub fn gave_up(&self) -> Option<&'static str> {
        self.sides.iter().find_map(|side| match side.end {
            End::GivesUp(_, why) => Some(why),
            _ => None,
        })
    }
}

/// How far a pose is off another: in radians, or as a part of this length.
#[must_use]
pub fn off(a: &[f64; 4], b: &[f64; 4], extent: f64) -> f64 {
    let turned = (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
    turned.max((a[2] - b[2]).hypot(a[3] - b[3]) / extent)
}

/// How far poses are apart.
#[must_use]
pub fn apart(a: &[[f64; 4]], b: &[[f64; 4]], extent: f64) -> f64 {
    let off = |(a, b): (&[f64; 4], &[f64; 4])| off(a, b, extent);
    a.iter().zip(b).map(off).fold(0.0, f64::max)
}
