//! A planetary gear set with two motors: hold one wheel, or turn both.
//!
//! Run it with `cargo run --example gears`. Ratios are exact: the compiler works them out in fractions.

use mech_runtime::{Blocked, mechanism};
use std::f64::consts::TAU;

mechanism! {
    /// A sun with 30 teeth, a ring with 66, and planets with 18 on the carrier between them. One planet stands for all.
    struct Planetary;
    const MODULE = 0.1; // pitch diameter for each tooth
    ground { point shaft = (0, 0); }
    link sun { point shaft = (0, 0); }
    link ring { point shaft = (0, 0); }
    link carrier { point shaft = (0, 0); point pin = ((30 + 18) / 2 * MODULE, 0); }
    link planet { point pin = (0, 0); }
    joint sun_axle = revolute(ground.shaft, sun.shaft);
    joint ring_axle = revolute(ground.shaft, ring.shaft);
    joint carrier_axle = revolute(ground.shaft, carrier.shaft);
    joint planet_axle = revolute(carrier.pin, planet.pin);
    joint inner = gear(sun, planet, 30 : 18);
    joint outer = gear(planet, ring, 18 : -66); // negative: the ring's teeth point inwards
    motor sun_axle;
    motor ring_axle;
}

fn main() -> Result<(), Blocked<[f64; 2]>> {
    let tidy = |number: f64| (number * 1000.0).round() / 1000.0 + 0.0; // never `-0.000`
    println!("Turns of each part:\n");
    println!("                             sun     ring  carrier   planet on carrier");
    for (case, sun, ring) in [
        ("the ring is held", 3.2, 0.0),
        ("the sun is held", 0.0, 1.0),
        ("both turn together", 1.0, 1.0),
        ("the carrier stands still", 11.0, -5.0),
        ("a differential", 2.0, -0.5),
    ] {
        let mut gears = Planetary::new();
        gears.move_to([sun * TAU, ring * TAU])?;
        let carrier = tidy(gears.carrier_axle() / TAU);
        let planet = tidy(gears.planet_axle() / TAU);
        println!("{case:24} {sun:7.3}  {ring:7.3}  {carrier:7.3}  {planet:18.3}");
    }
    Ok(())
}
