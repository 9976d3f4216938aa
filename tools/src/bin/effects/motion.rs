//! The cost of accuracy in motion under forces: the drift of energy against the time of a step.

use mech_runtime::{GaussLegendre, mechanism};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::time::Instant;

mechanism! {
    /// A four-bar that turns right round, in gravity, with a spring.
    struct CrankRocker;
    ground { point o = (0, 0); point p = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 5 at (0.1, 0.05) inertia 2; }
    link coupler { point left = (0, 0); point right = (4, 0); mass 1 at (2, 0.3) inertia 0.8; }
    link rocker { point pin = (2.5, 0); point shaft = (0, 0); mass 0.5 at (1.2, 0) inertia 0.2; }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    motor a;
    start { coupler near 40 deg; }
    gravity (0, -9.81);
    spring soft = torsional(d) stiffness 3 rest 110 deg;
    effects { dynamics; }
}

/// The initial rate of the crank, in radians per second: about a turn in 0.8 seconds.
const RATE: f64 = 8.0;
/// The approximate duration of a turn, in seconds.
const TURN: f64 = 0.8;

/// The table of methods and steps.
///
/// # Errors
/// If the mechanism stops.
pub(crate) fn section(turns: u32) -> Result<String, String> {
    let mut text = format!(
        "## Motion under forces (a four-bar in gravity, with a spring)\n\n\
         The crank starts with a rate and is left alone for {turns} turns. **Drift** is the greatest difference of its energy from \
         that at the start, as a part of the kinetic energy. **Lag** is how far the crank is then from where order 6 with 800 steps \
         a turn has it, in radians. The default is order 4.\n\n| method | steps a turn | drift | lag | ns a step | µs a turn \
         |\n|---|---|---|---|---|---|\n"
    );
    let end = f64::from(turns) * TURN;
    let exact = follow(GaussLegendre::Order6, 800, end)?;
    for (name, method) in [
        ("order 2", GaussLegendre::Order2),
        ("order 4", GaussLegendre::Order4),
        ("order 6", GaussLegendre::Order6),
    ] {
        for steps in [50, 100, 200, 400] {
            let found = follow(method, steps, end)?;
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {name} | {steps} | {:.1e} | {:.1e} | {:.0} | {:.0} |",
                found.drift,
                (found.angle - exact.angle).abs(),
                found.nanoseconds,
                found.nanoseconds * f64::from(steps) / 1000.0
            );
        }
    }
    Ok(text + "\n")
}

/// A result.
struct Followed {
    drift: f64,
    angle: f64,
    nanoseconds: f64,
}

fn follow(method: GaussLegendre, steps: u32, end: f64) -> Result<Followed, String> {
    let stopped = |blocked: mech_runtime::Blocked| blocked.to_string();
    let mut machine = CrankRocker::new();
    machine.set_rates([RATE]).map_err(stopped)?;
    let energy = |machine: &CrankRocker| machine.energy().map_err(stopped);
    let [kinetic, potential] = energy(&machine)?;
    let step = TURN / f64::from(steps);
    let mut drift: f64 = 0.0;
    let (mut count, mut spent) = (0.0, 0.0);
    while count * step < end - 0.5 * step {
        let start = Instant::now();
        machine.simulate_by(method, step, [0.0]).map_err(stopped)?;
        spent += start.elapsed().as_secs_f64();
        count += 1.0;
        let [now, there] = energy(&machine)?;
        drift = drift.max((now + there - kinetic - potential).abs());
    }
    let [angle] = machine.motors();
    if angle < TAU {
        return Err("the crank does not turn round".to_owned());
    }
    Ok(Followed { drift: drift / kinetic, angle, nanoseconds: spent / count * 1e9 })
}
