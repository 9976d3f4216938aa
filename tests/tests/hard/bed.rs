//! A test bed: moves a mechanism and holds each position against its declaration.

use mech_compiler::model::{Axis, JointKind, Method, Model};
use mech_runtime::{Blocked, Cause, Mechanism, Reached, Real};
use mech_test_support::{in_f64, lengths, model, with_ground, worst_gap, worst_stretch};

/// A gap of this many units of rounding of the size passes for closed, in each coordinate.
const ROUNDING: f64 = 64.0;

/// A mechanism on the test bed.
#[derive(Clone)]
pub(crate) struct Bed<M> {
    pub(crate) mechanism: M,
    model: Model,
    lengths: f64,
    /// The worst that was seen, in units of what is allowed.
    worst: f64,
}

/// Where it stopped and why.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stuck {
    pub(crate) cause: Cause,
    pub(crate) reached: Vec<f64>,
}

impl<M: Mechanism> Bed<M> {
    /// One unit of rounding of its numbers.
    pub(crate) const EPSILON: f64 = <M::Scalar as Real>::EPSILON;

    pub(crate) fn new(text: &str) -> Self {
        let model = model(text);
        let mut bed = Self {
            mechanism: M::new(),
            lengths: lengths(&model).sum(),
            model,
            worst: 0.0,
        };
        bed.assert_whole();
        bed
    }

    /// The same mechanism as it was assembled.
    pub(crate) fn fresh(&self) -> Self {
        let mut bed = self.clone();
        bed.mechanism = M::new();
        bed
    }

    /// The values of the motors.
    pub(crate) fn motors(&self) -> Vec<f64> {
        self.mechanism
            .motors()
            .as_ref()
            .iter()
            .map(|value| Real::to_f64(*value))
            .collect()
    }

    /// The value of the only motor.
    pub(crate) fn motor(&self) -> f64 {
        self.motors()[0]
    }

    fn motors_of(&self, values: &[f64]) -> M::Motors {
        let mut motors = self.mechanism.motors();
        for (motor, value) in motors.as_mut().iter_mut().zip(values) {
            *motor = <M::Scalar as Real>::from_f64(*value);
        }
        motors
    }

    /// Moves it; wherever it then is, it is whole, and if it did not move, nothing changed.
    pub(crate) fn go(&mut self, values: &[f64]) -> Result<(), Stuck> {
        let before = self.bits();
        let result = self.mechanism.move_to(self.motors_of(values));
        if result.is_err() {
            assert_eq!(self.bits(), before, "a refused move changes nothing");
        }
        self.assert_whole();
        result.map_err(|blocked| stuck::<M>(&blocked))
    }

    /// Moves it, which must succeed.
    #[track_caller]
    pub(crate) fn must(&mut self, values: &[f64]) {
        if let Err(stuck) = self.go(values) {
            panic!("from {:?} to {values:?}: {stuck:?}", self.motors());
        }
    }

    /// Moves it as far as it goes towards these values; gives why not all the way.
    pub(crate) fn toward(&mut self, values: &[f64]) -> Option<Stuck> {
        let reached = self.mechanism.move_toward(self.motors_of(values));
        self.assert_whole();
        match reached.expect("values are finite") {
            Reached::Target => None,
            Reached::Limit(blocked) => {
                let stuck = stuck::<M>(&blocked);
                assert_eq!(stuck.reached, self.motors(), "it says where it is");
                Some(stuck)
            }
        }
    }

    /// The pose of a link.
    pub(crate) fn pose(&self, link: &str) -> [f64; 4] {
        let at = M::LINKS.iter().position(|name| *name == link);
        in_f64(self.mechanism.poses())[at.expect("the link is declared")]
    }

    /// Where a point of a link is in the scene.
    pub(crate) fn point(&self, link: &str, [u, v]: [f64; 2]) -> [f64; 2] {
        let [cos, sin, x, y] = self.pose(link);
        [x + cos * u - sin * v, y + sin * u + cos * v]
    }

    /// Holds a point of a link against where it should be, by the conditioning of the position: the sine of the transmission
    /// angle. At a dead point half of the digits are left.
    #[track_caller]
    pub(crate) fn assert_at(&mut self, (link, at): (&str, [f64; 2]), should: [f64; 2], sine: f64) {
        let is = self.point(link, at);
        let off = (is[0] - should[0]).hypot(is[1] - should[1]);
        let rounding = ROUNDING * Self::EPSILON;
        let most = rounding * self.size() / sine.abs().max(rounding.sqrt());
        self.worst = self.worst.max(off / most);
        assert!(
            off <= most,
            "at {:?} it is at {is:?} instead of {should:?}: off by {off:e}, more than {most:e} (sine {sine:e})",
            self.motors()
        );
    }

    /// The lengths that rounding is relative to: of the links, and of the coordinates of what they are joined by.
    pub(crate) fn size(&self) -> f64 {
        let poses = self.all_poses();
        let at = |axis: &Axis| {
            let ([u, v], [cos, sin, x, y]) = (axis.at, poses[axis.link.index()]);
            (x + cos * u - sin * v).hypot(y + sin * u + cos * v)
        };
        let joined = self.model.joints.iter().map(|joint| match joint.kind {
            JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) => {
                let (a, b) = (at(self.model.axis(a)), at(self.model.axis(b)));
                a.max(b)
            }
            _ => 0.0,
        });
        self.lengths + joined.sum::<f64>()
    }

    fn all_poses(&self) -> Vec<[f64; 4]> {
        with_ground(&self.model, &in_f64(self.mechanism.poses()))
    }

    fn bits(&self) -> Vec<u64> {
        let poses = in_f64(self.mechanism.poses()).into_iter().flatten();
        poses.chain(self.motors()).map(f64::to_bits).collect()
    }

    /// Its pins are where they should be, and its links as long as they were declared.
    #[track_caller]
    pub(crate) fn assert_whole(&mut self) {
        let poses = self.all_poses();
        assert!(
            poses.iter().flatten().all(|number| number.is_finite()),
            "at {:?} a pose is not finite",
            self.motors()
        );
        let part = match self.model.method {
            Some(Method::Linear) => 1e-2,
            // Each round but the first squares a thousandth. Of a loop's size, a link that two rings share is counted twice.
            Some(Method::NewtonSteps(rounds)) => {
                let promised = 2.0 * 1e-3_f64.powi(1 << (rounds - 1).min(4));
                promised.max(ROUNDING * Self::EPSILON)
            }
            _ => ROUNDING * Self::EPSILON,
        };
        // A linear step turns to first order: what it promises for gaps, it promises for lengths.
        let longest = match self.model.method {
            Some(Method::Linear) => part,
            _ => 16.0 * Self::EPSILON,
        };
        let stretch = worst_stretch(&poses);
        assert!(
            stretch <= longest,
            "at {:?} a link is stretched by {:.0} eps",
            self.motors(),
            stretch / Self::EPSILON
        );
        let gap = worst_gap(&self.model, &poses);
        let most = std::f64::consts::SQRT_2 * part * self.size();
        self.worst = self.worst.max(gap / most);
        assert!(
            gap <= most,
            "at {:?} there is a gap of {gap:e}, more than {most:e}",
            self.motors()
        );
    }
}

/// What a bed saw is printed: `--nocapture` shows it.
impl<M> Drop for Bed<M> {
    fn drop(&mut self) {
        let test = std::thread::current();
        println!(
            "{}: {:.3} of what is allowed",
            test.name().unwrap_or(""),
            self.worst
        );
    }
}

fn stuck<M: Mechanism>(blocked: &Blocked<M::Motors>) -> Stuck {
    let reached = blocked.reached.as_ref().iter();
    Stuck {
        cause: blocked.cause,
        reached: reached.map(|value| Real::to_f64(*value)).collect(),
    }
}
