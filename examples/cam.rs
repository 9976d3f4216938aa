//! A cam opens a valve, keeps it open, and shuts it.
//!
//! Run it with `cargo run --example cam`. The motion is differentiated at compile time. What is expected of the contact is proved there.

use mech_runtime::{Blocked, mechanism};

mechanism! {
    /// Lengths are in millimetres, the time in seconds. The motor follows a law of the time `t`.
    struct Valve;
    ground { point shaft = (0, 0); line guide = (0, 30) -> (0, 1); }
    link camshaft { point shaft = (0, 0); }
    link valve { line stem = (0, 30) -> (0, 1); point foot = (0, 25); }
    joint turn = revolute(ground.shaft, camshaft.shaft);
    joint lift = prismatic(ground.guide, valve.stem);
    joint profile = cam(turn, lift, dwell 60 deg, rise 9 over 75 deg with modified_sine, dwell 20 deg,
        return over 95 deg with polynomial_345, dwell) roller valve.foot radius 6;
    motor turn = 1500 rpm * t;
    effects { velocity; acceleration; }
    expect pressure(profile) < 30 deg, "the guide may jam";
    expect curvature(profile) < 1 / 6, "the disc would be undercut";
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
        let bar: String = (0..18).filter(|&n| f64::from(n) < 2.0 * lift).map(|_| '█').collect();
        println!("{degrees:7}° {lift:11.3} {speed:13.3} {acceleration:16.1}          {bar}");
    }
    Ok(())
}
