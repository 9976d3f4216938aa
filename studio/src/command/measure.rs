//! What tables and plots have in common: what is measured, and in which motion.

use super::assignment::Assignment;
use crate::job;
use crate::motion::{Setting, Span, Typed, read_value};
use crate::quantity::{Load, Units};
use clap::Args;

/// What is measured, and in which motion.
#[derive(Args, Clone, Debug)]
pub(super) struct Measure {
    /// What is measured, as described below; without, the coordinates of all joints.
    #[arg(value_name = "QUANTITY")]
    quantities: Vec<String>,
    /// Shows all over this quantity, as `coupler.tip.x` or `t`; without, over what the mechanism is driven by.
    #[arg(long, value_name = "QUANTITY")]
    over: Option<String>,
    /// The motor that moves; without, the first, or all by their laws.
    #[arg(long, value_name = "NAME")]
    motor: Option<String>,
    /// Where it begins: in degrees, scene units, or, with laws, seconds.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: Option<Typed>,
    /// Where it ends.
    ///
    /// Without, motors with laws go on until all are back, or for a unit of time if they never are.
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: Option<Typed>,
    /// How many steps it takes.
    #[arg(long, value_name = "COUNT", default_value_t = job::Measure::STEPS, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    steps: u32,
    /// How fast the motor moves, in radians or scene units per second: without, 1, and forces are those at rest. By laws, motors have
    /// their own rates.
    #[arg(long, value_name = "VALUE", allow_negative_numbers = true, value_parser = read_value)]
    rate: Option<f64>,
    /// Puts another motor at a value, in degrees if it turns: `--at a=30`.
    #[arg(long, value_name = "MOTOR=VALUE")]
    at: Vec<Setting>,
    /// Gives a constant or a param another value than in the file: `--set size=2`.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(super) set: Vec<Assignment>,
    /// Puts a load on it: the parts of a force, as `--load push=-100,0`, or a torque, as `--load brake=5`.
    #[arg(long, value_name = "NAME=VALUE", allow_negative_numbers = true)]
    load: Vec<Load>,
    /// How a scene unit is called.
    #[arg(long, value_name = "UNIT", default_value = "unit")]
    length: String,
    /// How a unit of force is called.
    #[arg(long, value_name = "UNIT", default_value = "force")]
    force: String,
}

/// What can be measured, below the help of both commands.
pub(super) const QUANTITIES: &str = "\
Quantities:
  b                         the coordinate of joint b
  coupler                   the angle of link coupler in the scene
  coupler.tip               both coordinates of a point; coupler.tip.x is one of them
  distance(p.a, q.b)        the distance of two points, of a point and a line, or of a place, as (1, 2)
  clear(bucket, boom)       the least distance of what is painted of two links; zero where they overlap
  angle(crank, coupler)     the angle from one link to another
  velocity:coupler.tip      its velocity; also of a joint or a link; .x, .y and .norm are parts of it
  acceleration:coupler.tip  its acceleration
  torque:a                  what motor a exerts so that the mechanism moves so: a torque, or a force
  power:a                   its torque times its rate, which `--rate` gives; laws have their own
  reaction:b                the force that the first link of joint b exerts on the second; also .norm, .torque
  reaction:ground           the force that the ground gets in all; .torque is its moment about the origin
  shaking:force             the part of it by which the inertia of all links shakes the ground, also .norm
  shaking:moment            the moment of that about the origin
  advantage(push, a)        the mechanical advantage of motor a over a load, in the direction that `--load` gives
  transmission              the transmission angles of all dyads
  d(b, a)                   the influence coefficient: the rate of b if motor a alone moves, at a rate of 1
  centre(crank, rod)        the instant centre of two links, or of a link and the ground; empty at infinity
  pressure(c)               the pressure angle of cam c, which has a roller
  curvature(c)              the curvature of the curve on which its middle runs; positive where it is convex
  t                         the time since the motion began

They are those of `expect`, and may be in expressions, as `b - 2 * a`, `velocity:p.a.norm / velocity:q.b.norm`.
Constants and params of the mechanism are known by their names, as in `p.a.x - LENGTH`.
Angles are in degrees, their rates in radians. Velocities are those at a rate of 1, torques and reactions
those at rest, unless `--rate` says another. Loads are zero unless `--load` gives them. A cell is empty
where a value is not determined, as a velocity at a dead point.";

impl Measure {
    /// The same as a job has it.
    pub(super) fn job(&self) -> job::Measure {
        job::Measure {
            quantities: self.quantities.clone(),
            over: self.over.clone(),
            motor: self.motor.clone(),
            span: Span { from: self.from, to: self.to },
            steps: self.steps,
            rate: self.rate,
            at: self.at.clone(),
            reach: None,
            loads: self.load.clone(),
            units: Units { length: self.length.clone(), force: self.force.clone() },
            dwell: None,
        }
    }
}
