//! A four-bar linkage as a picture, with the path of its coupler point, and as a picture that moves.
//!
//! Run it with `cargo run --example picture`, then open `target/picture.png` and, in a browser, `target/picture.svg`.

use mech_runtime::files::{Sheet, animate};
use mech_runtime::{HeapSmooth, Mechanism, Overlay, mechanism};
use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::time::Duration;

mechanism! {
    /// Each bar has a colour of its own. The trace keeps the last 180 places of the coupler point.
    struct FourBar;
    ground { point left = (0, 0); point right = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); bar [(0, 0), (1, 0)] width 0.4 on plane 3; }
    link coupler {
        point left = (0, 0); point right = (3.5, 0); point tracer = (1.5, 1.75);
        polygon [(0, 0), (3.5, 0), (1.5, 1.75)] on plane 1;
        bar [(0, 0), (3.5, 0)] width 0.4 on plane 1;
    }
    link rocker { point shaft = (0, 0); point pin = (3, 0); bar [(0, 0), (3, 0)] width 0.4 on plane 2; }
    joint a = revolute(ground.left, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.right, rocker.shaft);
    motor a;
    start { coupler near 50 deg; }
    effects { overlay; trace coupler.tracer 180; }
}

fn main() -> Result<(), Box<dyn Error>> {
    let (width, height) = (640, 480);
    let mut four_bar = FourBar::new();
    for degrees in (0..=400).step_by(2) {
        four_bar.move_to([f64::from(degrees).to_radians()])?;
    }
    let mut picture = HeapSmooth::of::<FourBar>(width, height)?;
    four_bar.draw(&mut picture);
    four_bar.draw_overlay(&mut picture, &Overlay::new());
    fs::create_dir_all("target")?;
    fs::write("target/picture.png", picture.png()?)?;

    let sheet = Sheet::new(width, height).look_at(FourBar::view(width, height));
    let turn = animate::<FourBar>(&sheet, Duration::from_secs(4), |phase| [phase * TAU])?;
    fs::write("target/picture.svg", turn)?;
    println!("open target/picture.png and target/picture.svg");
    Ok(())
}
