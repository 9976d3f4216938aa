//! A press: the nearer its dead point, the less torque at the crank holds ten kilonewtons at the ram.
//!
//! Run it with `cargo run --example forces`.

use mech_runtime::{Blocked, mechanism};

mechanism! {
    /// Lengths are in metres, masses in kilograms. The crank is at the bottom: at 0° the ram is as low as it goes.
    struct Press;
    ground { point shaft = (0, 0); line guide = (0, 0) -> (0, -1); }
    link crank { point shaft = (0, 0); point pin = (0, -0.08); mass 6 at (0, -0.03); }
    link rod { point crank_pin = (0, 0); point ram_pin = (0, -0.3); mass 4 at (0, -0.15); }
    link ram { point pin = (0, 0); line axis = (0, 0) -> (0, -1); mass 40; }
    joint turn = revolute(ground.shaft, crank.shaft);
    joint elbow = revolute(crank.pin, rod.crank_pin);
    joint wrist = revolute(rod.ram_pin, ram.pin);
    joint slide = prismatic(ground.guide, ram.axis);
    motor turn in -90 deg ..= 0 deg;
    start { turn = -90 deg; rod near 0 deg; }
    gravity (0, -9.81);
    load workpiece = force(ram.pin);
    effects { force; }
}

fn main() -> Result<(), Blocked> {
    let mut press = Press::new();
    press.set_workpiece([0.0, 10_000.0])?; // the workpiece pushes upwards, in newtons
    println!(
        "crank   height (mm)   torque (N·m)   ram force per torque (1/m)   force in the rod (N)"
    );
    for degrees in [-90, -75, -60, -45, -30, -15, -10, -5, -2] {
        let [torque] = press.hold_at([f64::from(degrees).to_radians()])?;
        let height = 1000.0 * (0.38 - press.slide());
        let [advantage] = press.workpiece_advantage([0.0, 1.0])?;
        let forces = press.forces([0.0], [0.0])?;
        let pin = forces.reactions[1]; // of `elbow`, the second joint
        let rod = pin.x.hypot(pin.y);
        println!("{degrees:4}° {height:13.2} {torque:14.1} {advantage:20.1} {rod:27.0}");
    }
    Ok(())
}
