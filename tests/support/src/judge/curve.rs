//! The curve of solutions of one straight move of the motors, followed by its arc length.

use super::{Judge, Place};
use nalgebra::{DMatrix, DVector};

/// How a curve ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// At the target.
    Arrives,
    /// At this part of the move the motors turn back: a dead point.
    Stops(f64),
    /// From this part on links go far away, as if to infinity.
    RunsAway(f64),
    /// Why it was not followed any farther than this part.
    GivesUp(f64, &'static str),
}

/// A point of a curve.
#[derive(Clone, Debug)]
struct Knot {
    at: DVector<f64>,
    tangent: DVector<f64>,
    /// The arc length up to here.
    arc: f64,
    /// The least singular value of the equations and the tangent: how far from where curves cross.
    sigma: f64,
}

/// The curve that a mechanism follows when its motors move straight to a target.
#[derive(Debug)]
pub struct Curve<'j> {
    judge: &'j Judge<'j>,
    from: Vec<f64>,
    direction: Vec<f64>,
    length: f64,
    knots: Vec<Knot>,
    /// How the curve ends.
    pub end: End,
    /// The least distance at which it went by a place where curves nearly cross.
    pub nearest: f64,
    /// The parts of the move at which it went straight through a crossing.
    pub crossings: Vec<f64>,
}

/// More knots than these are too many.
const MOST_KNOTS: usize = 60_000;
/// Links that are so many units away run away: their slides become parallel.
const FARTHEST: f64 = 200.0;
/// No step is longer than this, in radians or units; and between its ends the curve turns by no more than this.
const LONGEST: f64 = 0.4;
/// Curves that come so near to each other cross but for rounding.
const CROSSING: f64 = 2e-6;

impl<'j> Curve<'j> {
    /// Follows the move from a place, where the motors have the first values, to the second values.
    #[must_use]
    pub fn new(judge: &'j Judge<'j>, place: &Place, motors: [&[f64]; 2]) -> Self {
        let [from, to] = motors.map(|values| judge.scaled(values));
        let by: Vec<f64> = from.iter().zip(&to).map(|(from, to)| to - from).collect();
        let length = by.iter().fold(0.0_f64, |most, by| most.max(by.abs()));
        let direction = by.iter().map(|by| by / length.max(f64::MIN_POSITIVE)).collect();
        let mut curve = Self {
            judge,
            from,
            direction,
            length,
            knots: Vec::new(),
            end: End::Arrives,
            nearest: f64::INFINITY,
            crossings: Vec::new(),
        };
        let mut at = place.0.clone();
        let way = at.len() - 1;
        at[way] = 0.0;
        curve.end = match curve.first(&at) {
            Some(knot) => {
                curve.knots.push(knot);
                curve.follow()
            }
            None => End::GivesUp(0.0, "it starts where curves cross, or not on a curve"),
        };
        curve
    }

    fn equations(&self, at: &DVector<f64>) -> super::equations::Equations {
        self.judge.equations(at, [&self.from, &self.direction])
    }

    /// The first point: its tangent is what all equations leave free.
    fn first(&self, at: &DVector<f64>) -> Option<Knot> {
        let slopes = self.equations(at).slopes;
        let columns = slopes.ncols();
        let mut square = DMatrix::zeros(slopes.nrows().max(columns), columns);
        square.rows_mut(0, slopes.nrows()).copy_from(&slopes);
        let svd = square.svd(false, true);
        let least = svd.singular_values.imin();
        let others = svd.singular_values.iter().enumerate().filter(|(number, _)| *number != least);
        let sigma = others.map(|(_, value)| *value).fold(f64::INFINITY, f64::min);
        let mut tangent = svd.v_t?.row(least).transpose();
        let way = columns - 1;
        if sigma < CROSSING || tangent[way].abs() < 1e-9 {
            return None;
        }
        if tangent[way] < 0.0 {
            tangent = -tangent;
        }
        let (at, _) = self.correct(at, &tangent)?;
        Some(Knot { at, tangent, arc: 0.0, sigma })
    }

    /// Newton's method from a guess, across a direction. Gives how far the guess was off.
    fn correct(&self, guess: &DVector<f64>, across: &DVector<f64>) -> Option<(DVector<f64>, f64)> {
        let mut at = guess.clone();
        let mut last = f64::INFINITY;
        for _ in 0..10 {
            let system = System::new(self.equations(&at), across, across.dot(&(&at - guess)))?;
            let change = system.solve()?;
            let size = change.norm();
            at -= change;
            // Near a crossing rounding keeps corrections from vanishing.
            if size < 1e-14 * (1.0 + at.amax()) || size >= 0.5 * last && size < 1e-8 {
                let off = (&at - guess).norm();
                return Some((at, off));
            }
            if size > 4.0 * last.min(1.0) {
                return None;
            }
            last = size;
        }
        None
    }

    /// The curve continued from one of its knots by an arc length: cubic, from three tangents that are not too near each other.
    fn predict(&self, base: usize, step: f64) -> DVector<f64> {
        let now = &self.knots[base];
        let before = |arc: f64| self.knots[..base].iter().rev().find(|knot| knot.arc <= arc);
        let mut at = &now.at + &now.tangent * step;
        let Some(second) = before(now.arc - 0.5 * step) else {
            return at;
        };
        let a = now.arc - second.arc;
        let slope = (&now.tangent - &second.tangent) / a;
        at += &slope * (step * step / 2.0);
        if let Some(third) = before(second.arc - 0.5 * step) {
            let b = second.arc - third.arc;
            let bend = (slope - (&second.tangent - &third.tangent) / b) / (a + b);
            at += bend * (step.powi(3) / 3.0 + a * step * step / 2.0);
        }
        at
    }

    /// A step from a knot, and by how much it is too long to be sure that it stays on the curve: the correction is small beside the
    /// distance of other curves, and the curve does not turn much.
    fn attempt(&self, base: usize, step: f64) -> Option<(Knot, f64)> {
        let now = &self.knots[base];
        let (at, off) = self.correct(&self.predict(base, step), &now.tangent)?;
        let system = System::new(self.equations(&at), &now.tangent, 0.0)?;
        let (tangent, sigma) = (system.tangent()?, system.least());
        let turned = (&tangent - &now.tangent).norm();
        let gone = (&at - &now.at).norm();
        let excess = (off / (0.1 * sigma.min(step))).cbrt().max(turned / LONGEST);
        let knot = Knot { at, tangent, arc: now.arc + gone, sigma };
        (gone > 0.5 * step && gone < 2.0 * step).then_some((knot, excess))
    }

    /// A step from a knot, if it is sure; else by how much it is too long.
    fn step(&self, base: usize, step: f64) -> Result<(Knot, f64), f64> {
        match self.attempt(base, step) {
            Some((knot, excess)) if excess <= 1.0 => Ok((knot, excess)),
            Some((_, excess)) => Err(excess.max(1.5)),
            None => Err(4.0),
        }
    }

    /// How far links have gone from where they were.
    fn far(&self, knot: usize) -> f64 {
        let gone = &self.knots[knot].at - &self.knots[0].at;
        let places = gone.as_slice().chunks_exact(3);
        places.map(|place| place[0].hypot(place[1])).fold(0.0, f64::max)
    }

    fn follow(&mut self) -> End {
        if self.length == 0.0 {
            return End::Arrives;
        }
        let way = self.knots[0].at.len() - 1;
        let (mut step, mut pace) = (1e-3_f64, 0.05_f64);
        // How near other curves have come by now, while they come nearer.
        let mut dip = f64::INFINITY;
        while self.knots.len() < MOST_KNOTS {
            let base = self.knots.len() - 1;
            let (value, slope) = (self.knots[base].at[way], self.knots[base].tangent[way]);
            let part = (value / self.length).clamp(0.0, 1.0);
            // How far other curves are, if they come nearer as fast as they did.
            let room = self.knots[base].sigma / pace;
            if room < CROSSING || room < 10.0 * CROSSING && step < 0.02 * room {
                if !self.pass(base, room) {
                    return End::GivesUp(part, "curves cross, and it is not clear how it goes on");
                }
                dip = f64::INFINITY;
                (step, pace) = (self.knots.last().map_or(1e-3, |knot| 0.3 * knot.sigma), 0.05);
            } else {
                // It ends at the target, with one knot behind it.
                if value >= self.length {
                    return End::Arrives;
                }
                if self.far(base) > FARTHEST + 10.0 * self.length {
                    return End::RunsAway(part);
                }
                let rest = (self.length - value) / slope.max(1e-3) + 1e-3;
                step = step.min(LONGEST).min(0.5 * room).min(rest);
                match self.step(base, step) {
                    Ok((knot, excess)) => {
                        let (before, gone) =
                            (self.knots[base].sigma, knot.arc - self.knots[base].arc);
                        pace = ((knot.sigma - before).abs() / gone).max(0.8 * pace).max(0.05);
                        if knot.sigma < before {
                            dip = knot.sigma / pace;
                        } else {
                            self.nearest = self.nearest.min(dip);
                        }
                        step *= (0.8 / excess.max(0.2)).clamp(0.5, 2.5);
                        self.knots.push(knot);
                    }
                    Err(excess) => {
                        step *= (0.8 / excess).clamp(0.1, 0.6);
                        if step < 1e-10 {
                            return End::GivesUp(part, "no step is short enough");
                        }
                        continue;
                    }
                }
            }
            let last = self.knots.len() - 1;
            if self.knots[last].tangent[way] <= 0.0
                && (self.knots[last].at[way] < self.length
                    || self.knots[base.min(last)].at[way] < self.length)
            {
                if let Some(turn) = self.turn(last) {
                    if turn < self.length {
                        return End::Stops(turn / self.length);
                    }
                    return End::Arrives;
                }
                return End::GivesUp(part, "the motors turn back, but it is not clear where");
            }
        }
        End::GivesUp(
            self.knots.last().map_or(0.0, |knot| knot.at[way] / self.length),
            "there are too many knots",
        )
    }

    /// Goes straight through a crossing that is about as far as `room` behind a knot, from a knot before it to behind it.
    fn pass(&mut self, near: usize, room: f64) -> bool {
        let crossing = self.knots[near].arc + room;
        for distance in [3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2] {
            let Some(base) =
                self.knots[..=near].iter().rposition(|knot| crossing - knot.arc >= distance)
            else {
                break;
            };
            let step = 2.0 * (crossing - self.knots[base].arc);
            if let Ok((knot, _)) = self.step(base, step) {
                let at = &self.knots[near].at;
                self.crossings.push(at[at.len() - 1] / self.length);
                self.knots.truncate(base + 1);
                self.knots.push(knot);
                return true;
            }
        }
        false
    }

    /// Where the motors turn back between the last two knots: the last becomes that point.
    fn turn(&mut self, last: usize) -> Option<f64> {
        let way = self.knots[last].at.len() - 1;
        let (mut low, mut high) = (
            (0.0, self.knots[last - 1].tangent[way]),
            (self.knots[last].arc - self.knots[last - 1].arc, self.knots[last].tangent[way]),
        );
        let mut best = self.knots[last].clone();
        for round in 0..60 {
            if high.0 - low.0 < 1e-13 || best.tangent[way].abs() < 1e-13 {
                break;
            }
            let secant = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
            let middle = if round % 3 == 2 { f64::midpoint(low.0, high.0) } else { secant };
            // The whole step was sure: a part of it is, even if it seems a little too long.
            let Some((knot, _)) =
                self.attempt(last - 1, middle).filter(|(_, excess)| *excess < 2.0)
            else {
                break;
            };
            let side = (middle, knot.tangent[way]);
            if side.1 > 0.0 {
                low = side;
            } else {
                high = side;
            }
            best = knot;
        }
        let turn = best.at[way];
        let clear = best.tangent[way].abs() < 1e-6;
        self.knots[last] = best;
        clear.then_some(turn)
    }

    /// The point of the curve between two knots at which the move has come so far: beside a turning point, where a small part of a move is a
    /// long way on the curve. Points are sought by their arc length, and corrected across the curve.
    fn beside_turning_point(
        &self,
        [low, high]: [&Knot; 2],
        between: &impl Fn(f64) -> DVector<f64>,
        goal: f64,
    ) -> Option<DVector<f64>> {
        let way = low.at.len() - 1;
        let on_curve = |t: f64| {
            let across = (&low.tangent * (1.0 - t) + &high.tangent * t).normalize();
            Some(self.correct(&between(t), &across)?.0)
        };
        let (mut a, mut b) = (0.0, 1.0);
        for _ in 0..50 {
            let middle = f64::midpoint(a, b);
            if on_curve(middle)?[way] < goal {
                a = middle;
            } else {
                b = middle;
            }
        }
        on_curve(a)
    }

    /// Where the links are at a part of the move that the curve reaches, how badly conditioned that is, and how sure.
    #[must_use]
    pub fn at(&self, part: f64) -> Option<(Place, f64)> {
        let goal = part * self.length;
        let way = self.knots.first()?.at.len() - 1;
        let after = self.knots.partition_point(|knot| knot.at[way] < goal);
        let [low, high] = match (after, self.knots.get(after)) {
            (0, _) => {
                return Some((Place(self.knots[0].at.clone()), 1.0 / self.knots[0].sigma.min(1.0)));
            }
            (_, None) => return None,
            (_, Some(high)) => [&self.knots[after - 1], high],
        };
        // Between knots a cubic, in which the place is sought; then Newton's method at that value of the motors.
        let span = high.arc - low.arc;
        let between = |t: f64| {
            let (u, v) = (t * t * (3.0 - 2.0 * t), t * (1.0 - t));
            &low.at * (1.0 - u)
                + &high.at * u
                + (&low.tangent * ((1.0 - t) * v) - &high.tangent * (t * v)) * span
        };
        let (mut a, mut b) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = f64::midpoint(a, b);
            if between(middle)[way] < goal {
                a = middle;
            } else {
                b = middle;
            }
        }
        let guess = between(a);
        let small = 1e-4;
        let slope = (between((a + small).min(1.0))[way] - between((a - small).max(0.0))[way])
            / (span * small);
        let condition = 1.0 / low.sigma.min(high.sigma).min(slope.abs()).clamp(1e-12, 1.0);
        let mut across = DVector::zeros(way + 1);
        across[way] = 1.0;
        let corrected = self.correct(&guess, &across).filter(|(_, off)| off * condition < 0.1);
        let mut found = match corrected {
            Some((found, _)) => found,
            None => self.beside_turning_point([low, high], &between, goal).unwrap_or(guess),
        };
        found[way] = 0.0;
        Some((Place(found), condition))
    }
}

/// The equations at a point with one more, that it is not moved along a direction; as triangular system.
struct System {
    upper: DMatrix<f64>,
    right: DVector<f64>,
    last: DVector<f64>,
}

impl System {
    fn new(all: super::equations::Equations, across: &DVector<f64>, off: f64) -> Option<Self> {
        let (rows, columns) = all.slopes.shape();
        if rows + 1 < columns {
            return None;
        }
        let mut matrix = all.slopes.insert_row(rows, 0.0);
        matrix.set_row(rows, &across.transpose());
        let mut right = all.residuals.push(off);
        let mut last = DVector::zeros(rows + 1);
        last[rows] = 1.0;
        let qr = matrix.qr();
        qr.q_tr_mul(&mut right);
        qr.q_tr_mul(&mut last);
        Some(Self {
            upper: qr.r(),
            right: right.rows(0, columns).into_owned(),
            last: last.rows(0, columns).into_owned(),
        })
    }

    fn solve(&self) -> Option<DVector<f64>> {
        let found = self.upper.solve_upper_triangular(&self.right)?;
        found.iter().all(|one| one.is_finite()).then_some(found)
    }

    fn tangent(&self) -> Option<DVector<f64>> {
        let found = self.upper.solve_upper_triangular(&self.last)?;
        found.iter().all(|one| one.is_finite()).then(|| found.normalize())
    }

    /// Its least singular value, by inverse iteration.
    fn least(&self) -> f64 {
        let mut part = 0.37;
        let mut vector = DVector::from_fn(self.upper.ncols(), |_, _| {
            part = (part + 0.618_033_988_7_f64).fract();
            part - 0.5
        })
        .normalize();
        let mut least = 0.0;
        for _ in 0..4 {
            let Some(half) = self.upper.tr_solve_upper_triangular(&vector) else {
                return 0.0;
            };
            let Some(next) = self.upper.solve_upper_triangular(&half) else {
                return 0.0;
            };
            least = 1.0 / next.norm().sqrt();
            vector = next.normalize();
        }
        if f64::is_finite(least) { least } else { 0.0 }
    }
}
