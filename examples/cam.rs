//! A cam opens a valve for half a turn and keeps it shut for the other half.
//!
//! Run it with `cargo run --example cam`. The law of the cam is differentiated at compile time.

use mech_runtime::{Blocked, mechanism};

mechanism! {
    /// Lengths are in millimetres, the time in seconds. The motor follows a law of the time `t`.
    struct Valve;
    const LIFT = 9;
    const TURNS_PER_SECOND = 25;
    ground { point shaft = (0, 0); line guide = (0, 30) -> (0, 1); }
    link camshaft { point shaft = (0, 0); }
    link valve { line stem = (0, 0) -> (0, 1); }
    joint turn = revolute(ground.shaft, camshaft.shaft);
    joint lift = prismatic(ground.guide, valve.stem);
    joint profile = cam(turn, lift, LIFT * max(0, sin(q)) * max(0, sin(q))); // `q` is the angle of the shaft
    motor turn = 2 * PI * TURNS_PER_SECOND * t;
    effects { velocity; acceleration; }
}

fn main() -> Result<(), Blocked> {
    let tidy = |number: f64| (number * 1000.0).round() / 1000.0 + 0.0; // never `-0.000`
    let mut valve = Valve::new();
    println!("camshaft   lift (mm)   speed (m/s)   acceleration (m/s²)   lift");
    for degrees in (0..=360).step_by(15) {
        valve.at_time(f64::from(degrees) / 360.0 / 25.0)?;
        let lift = valve.lift();
        let speed = tidy(valve.lift_rate() / 1000.0);
        let acceleration = tidy(valve.lift_acceleration() / 1000.0);
        let bar: String = (0..18)
            .filter(|&n| f64::from(n) < 2.0 * lift)
            .map(|_| '█')
            .collect();
        println!("{degrees:7}° {lift:11.3} {speed:13.3} {acceleration:16.1}          {bar}");
    }
    Ok(())
}
