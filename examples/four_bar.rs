//! A four-bar linkage: the crank turns round and round, the rocker swings to and fro.
//!
//! Run it with `cargo run --example four_bar`. Then delete the line `motor a;` and read what the compiler says.

use mech_runtime::{Blocked, mechanism};

mechanism! {
    /// A crank-rocker, declared as it is drawn: each joint stands at its place in the drawing.
    struct FourBar;
    link crank;
    link coupler { point tip = (2.5, 3); }
    link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;
}

fn main() -> Result<(), Blocked> {
    let mut four_bar = FourBar::new();
    println!("Angles are measured from the drawing.\n");
    println!("  crank    rocker    coupler point");
    for degrees in (0..=360).step_by(30) {
        four_bar.move_to([f64::from(degrees).to_radians()])?;
        let rocker = four_bar.d().to_degrees();
        let tip = four_bar.coupler_tip();
        println!("{degrees:6}°  {rocker:7.2}°    ({:6.3}, {:6.3})", tip.x, tip.y);
    }
    Ok(())
}
