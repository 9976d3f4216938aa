//! The mechanisms in both precisions, over their whole motion.

use mech_gallery::crane::LuffingCrane;
use mech_gallery::rocker_arm::RockerArm;
use mech_gallery::{Exhibited, Visitor, visit_f32, visit_f64};
use mech_runtime::{Pose, Real};
use std::collections::HashSet;
use std::f64::consts::TAU;

/// Moments of a motion; at the last it is where it began.
const MOMENTS: u32 = 360;

/// What a mechanism did.
struct Seen {
    slug: &'static str,
    name: &'static str,
    source: &'static str,
    /// Half the longer side of what is seen of it.
    size: f64,
    /// Motors and poses, moment by moment.
    moments: Vec<(Vec<f64>, Vec<Pose<f64>>)>,
}

impl Seen {
    /// How far its points are from those of another at most, in parts of its size: within a circle of that size about each link's
    /// origin.
    fn off(&self, moment: usize, other: &Self, other_moment: usize) -> f64 {
        let [(_, poses), (_, others)] = [&self.moments[moment], &other.moments[other_moment]];
        assert_eq!(poses.len(), others.len());
        let off = |(a, b): (&Pose<f64>, &Pose<f64>)| {
            let turned = (a.cos - b.cos).hypot(a.sin - b.sin) * self.size;
            (turned + (a.x - b.x).hypot(a.y - b.y)) / self.size
        };
        poses.iter().zip(others).map(off).fold(0.0, f64::max)
    }
}

impl Seen {
    /// How far its points move at most for a unit of a motor, in parts of its size.
    fn gain(&self) -> f64 {
        let gains = (1..self.moments.len()).filter_map(|moment| {
            let [(now, _), (before, _)] = [&self.moments[moment], &self.moments[moment - 1]];
            let motors = now.iter().zip(before);
            let moved = motors.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            (moved > 1e-3).then(|| self.off(moment, self, moment - 1) / moved)
        });
        gains.fold(0.0, f64::max)
    }
}

#[derive(Default)]
struct Spectator(Vec<Seen>);

impl Visitor for Spectator {
    fn visit<M: Exhibited>(&mut self) {
        let mut mechanism = M::new();
        let moments = (0..=MOMENTS).map(|moment| {
            let motors = M::motion(Real::from_f64(f64::from(moment) / f64::from(MOMENTS)));
            mechanism.move_to(motors).expect("it moves");
            let poses = mechanism.poses().iter().map(|pose| Pose {
                cos: pose.cos.to_f64(),
                sin: pose.sin.to_f64(),
                x: pose.x.to_f64(),
                y: pose.y.to_f64(),
            });
            let motors = motors.as_ref().iter().map(|motor| motor.to_f64());
            (motors.collect(), poses.collect())
        });
        let moments = moments.collect();
        let [low, high] = M::EXTENT.map(|corner| corner.map(Real::to_f64));
        self.0.push(Seen {
            slug: M::SLUG,
            name: M::NAME,
            source: M::SOURCE,
            size: (high[0] - low[0]).max(high[1] - low[1]) / 2.0,
            moments,
        });
    }
}

fn watch_all() -> [Vec<Seen>; 2] {
    let [mut double, mut single] = [Spectator::default(), Spectator::default()];
    visit_f64(&mut double);
    visit_f32(&mut single);
    [double.0, single.0]
}

#[test]
fn both_precisions_are_of_the_same_mechanisms() {
    let [double, single] = watch_all();
    assert_eq!(double.len(), single.len());
    let mut slugs = HashSet::new();
    for (double, single) in double.iter().zip(&single) {
        assert_eq!(
            (double.slug, double.name, double.source),
            (single.slug, single.name, single.source)
        );
        assert!(slugs.insert(double.slug), "two are called `{}`", double.slug);
        let declaration = format!("pub struct {};", double.name);
        assert!(double.source.contains(&declaration), "{}", double.slug);
    }
}

/// Motors are where they should be, and poses follow: as exactly as that precision can. A phase is rounded, and motors are off by what
/// they move meanwhile; poses are off by what that moves them.
#[test]
fn single_precision_makes_the_same_motion() {
    let [double, single] = watch_all();
    let mut worst = 0.0_f64;
    for (double, single) in double.iter().zip(&single) {
        let gain = double.gain();
        for (moment, ((exact, _), (rounded, _))) in
            double.moments.iter().zip(&single.moments).enumerate()
        {
            let next = &double.moments[(moment + 1).min(double.moments.len() - 1)].0;
            let last = &double.moments[moment.saturating_sub(1)].0;
            let mut moved = 0.0_f64;
            for (motor, (&exact, &rounded)) in exact.iter().zip(rounded).enumerate() {
                let speed = (next[motor] - last[motor]).abs() * f64::from(MOMENTS);
                // A turn is rounded before its sine is taken.
                let most = f64::from(f32::EPSILON) * (exact.abs() + TAU + speed);
                let off = (rounded - exact).abs();
                assert!(off <= most, "{} at {moment}: {off:e}", double.slug);
                // What gears make of it is rounded, too.
                moved = moved.max(off + f64::from(f32::EPSILON) * exact.abs());
            }
            let off = single.off(moment, double, moment);
            let most = 5e-6 + gain * moved;
            assert!(off < most, "{} at {moment}: {off:e}", double.slug);
            worst = worst.max(off);
        }
    }
    println!("single precision is at most {worst:e} of a size off");
}

/// A film that is shown again and again does not jump.
#[test]
fn motions_end_where_they_begin() {
    let [double, _] = watch_all();
    for seen in &double {
        let last = seen.moments.len() - 1;
        let off = seen.off(last, seen, 0);
        assert!(off < 1e-14, "{}: {off:e}", seen.slug);
        // And it moves: half way it is elsewhere.
        assert!(seen.off(last / 3, seen, 0) > 1e-2, "{}", seen.slug);
    }
}

/// What needs a sine is where the standard library's would have it, to the last bits.
#[test]
fn swaying_motors_follow_sines() {
    for moment in 0..=MOMENTS {
        let phase = f64::from(moment) / f64::from(MOMENTS);
        let turn = phase * TAU;
        let [luff] = LuffingCrane::motion(phase);
        assert!((luff - (0.96 + 0.32 * turn.sin())).abs() < 1e-15);
        let [crank, shoulder, wrist] = RockerArm::motion(phase);
        assert_eq!(crank, turn);
        assert!((shoulder - (-1.35 + 0.55 * (turn + 0.6).sin())).abs() < 1e-15);
        assert!((wrist - (-0.45 + 0.6 * (2.0 * turn).cos())).abs() < 1e-15);
    }
}
