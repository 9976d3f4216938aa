//! The piston of an engine at 3000 revolutions a minute: its travel, speed and acceleration.
//!
//! Run it with `cargo run --example slider_crank`.

use mech_runtime::{Blocked, mechanism};
use std::f64::consts::TAU;

mechanism! {
    /// Lengths are in metres. At 0° the piston is at its top dead centre, from where the bore is measured.
    struct SliderCrank;
    const CRANK = 0.045;
    const ROD = 0.145;
    ground { point shaft = (0, 0); line bore = (CRANK + ROD, 0) -> (-1, 0); }
    link crank { point shaft = (0, 0); point pin = (CRANK, 0); }
    link rod { point big_end = (0, 0); point small_end = (ROD, 0); }
    link piston { point pin = (0, 0); line axis = (0, 0) -> (-1, 0); }
    joint turn = revolute(ground.shaft, crank.shaft);
    joint big_end = revolute(crank.pin, rod.big_end);
    joint small_end = revolute(rod.small_end, piston.pin);
    joint slide = prismatic(ground.bore, piston.axis);
    motor turn;
    start { turn = 0 deg; rod near 0 deg; }
    effects { velocity; acceleration; }
}

fn main() -> Result<(), Blocked> {
    let speed = 3000.0 / 60.0 * TAU; // of the crank, in radians per second
    let tidy = |number: f64| (number * 100.0).round() / 100.0 + 0.0; // never `-0.00`
    let mut engine = SliderCrank::new();
    println!("crank   travel (mm)   speed (m/s)   acceleration (m/s²)");
    for degrees in (0..=360).step_by(30) {
        engine.move_with([f64::from(degrees).to_radians()], [speed], [0.0])?;
        let travel = 1000.0 * engine.slide();
        let (speed, acceleration) = (tidy(engine.slide_rate()), engine.slide_acceleration());
        println!("{degrees:4}° {travel:12.2} {speed:13.2} {acceleration:17.0}");
    }
    Ok(())
}
